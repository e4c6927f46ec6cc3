(* Answers requests on a pipe (docs/subjects.md) by the counts that Coverage, extracted from the
   specifications of window and of clip space, gives; with --values by fragments (values.ml). What
   is written here, and trusted: reading decimals, and multiplying all coordinates by one power of
   two so that they are integers. *)

let words line = List.filter (fun w -> w <> "") (String.split_on_char ' ' line)

open Values

(* The triangles whose numbers are all finite, and the counts at the centre of a pixel. *)
let counts_in_window corners =
  let used = List.concat (List.concat corners) in
  (* The least is -1 at most: pixel centres are halves. *)
  let least = List.fold_left (fun e (_, f) -> min e f) (-1) used in
  let point = function
    | [ x; y ] -> { Coverage.px = scale least x; Coverage.py = scale least y }
    | _ -> failwith "a vertex has two coordinates" in
  let triangle = function
    | [ a; b; c ] -> { Coverage.corner_a = point a; corner_b = point b; corner_c = point c }
    | _ -> failwith "a triangle has three corners" in
  let mesh = List.map triangle corners in
  let centre i = Z.shift_left (Z.of_int ((2 * i) + 1)) (-1 - least) in
  fun i j -> Coverage.counts mesh { Coverage.px = centre i; Coverage.py = centre j }

let counts_in_clip corners =
  let least = List.fold_left (fun e (_, f) -> min e f) 0 (List.concat (List.concat corners)) in
  let vertex = function
    | [ x; y; w ] -> { Coverage.vx = scale least x; vy = scale least y; vw = scale least w }
    | _ -> failwith "a vertex has three coordinates" in
  let face = function
    | [ a; b; c ] -> { Coverage.vertex_a = vertex a; vertex_b = vertex b; vertex_c = vertex c }
    | _ -> failwith "a triangle has three corners" in
  let surface = List.map face corners in
  fun i j -> Coverage.seen_counts surface (ray i j)

(* What is said of each sample, row by row. *)
let answer head width height said =
  print_string (head ^ "\n");
  for j = 0 to height - 1 do
    print_string (String.concat " " (List.init width (fun i -> said i j)) ^ "\n")
  done;
  flush stdout

let draw_counts id width height space vertices triangles =
  let place k = match vertices.(k) with
    | [ x; y; _; w ] -> if space = "clip" then [ x; y; w ] else [ x; y ]
    | _ -> failwith "a vertex has four coordinates" in
  let is_finite k = List.for_all Float.is_finite (place k) in
  let finite = List.filter (List.for_all is_finite) triangles in
  let corners = List.map (List.map (fun k -> List.map decode (place k))) finite in
  let counts = (if space = "clip" then counts_in_clip else counts_in_window) corners in
  answer ("counts " ^ id) width height (fun i j -> Z.to_string (counts i j))

let draw_values id width height space vertices triangles channels wants =
  let numbered = List.mapi (fun n ids -> (n, corners space vertices ids)) triangles in
  let sample = sample space numbered channels wants in
  if wants = [ "coverage" ] then
    answer ("counts " ^ id) width height (fun i j -> if sample i j = [ "-1" ] then "0" else "1")
  else
    let kind = if wants = [ "primitive-ids" ] then "primitive-ids " else "fragments " in
    answer (kind ^ id) width height (fun i j -> String.concat " " (sample i j))

(* With --values, fragments are shown. *)
let shows_values = Array.mem "--values" Sys.argv

(* The words after NAME= of a request's line, by commas. *)
let option name default options =
  let prefix = name ^ "=" in
  match List.find_opt (String.starts_with ~prefix) options with
  | None -> default
  | Some word ->
    let from = String.length prefix in
    String.split_on_char ',' (String.sub word from (String.length word - from))

let () =
  try
    while true do
      match words (read_line ()) with
      | "draw" :: id :: width :: height :: _ :: space :: vertices :: triangles :: options ->
        let read f = f (words (read_line ())) in
        let lines count f = List.init (int_of_string count) (fun _ -> read f) in
        let v = Array.of_list (lines vertices (List.map float_of_string)) in
        let channels = lines (List.hd (option "channels" [ "0" ] options)) (function
          | _ :: kind :: _ :: numbers -> (kind, Array.of_list (List.map float_of_string numbers))
          | _ -> failwith "channel") in
        let t = lines triangles (List.map int_of_string) in
        let width, height = (int_of_string width, int_of_string height) in
        if shows_values then
          draw_values id width height space v t channels
            (option "wants" [ "primitive-ids"; "barycentrics"; "depths" ] options)
        else draw_counts id width height space v t
      | _ -> failwith "not a request"
    done
  with End_of_file -> ()
