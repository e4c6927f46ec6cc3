const modulesOfPage = modules(); globalThis.rasterproof = {modules: modulesOfPage};
