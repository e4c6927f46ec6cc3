"""The program that the command starts: hands its pipe to the process that has the function.

usage: _relay.py SOCKET. Begun with -S and -E: nothing but the standard library, in milliseconds.
"""

import os
import signal
import socket
import sys

with socket.socket(socket.AF_UNIX) as host:
    host.connect(sys.argv[1])
    socket.send_fds(host, [str(os.getpgrp()).encode()], [0, 1])
    os.close(0)
    os.close(1)
    status = host.recv(16)  # of the process that draws, when it ends; nothing: the host is gone
code = int(status) if status else 1
if code < 0:
    if -code not in (signal.SIGKILL, signal.SIGSTOP):  # these two have no other action
        signal.signal(-code, signal.SIG_DFL)
    os.kill(os.getpid(), -code)
sys.exit(code)
