(* Answers requests on a pipe (docs/subjects.md) by the counts that Coverage, extracted from the
   specifications of window and of clip space, gives. What is written here, and trusted: reading
   decimals, and multiplying all coordinates by one power of two so that they are integers. *)

let words line = List.filter (fun w -> w <> "") (String.split_on_char ' ' line)

(* A finite double is digits * 2^exponent. *)
let decode x =
  let fraction, exponent = Float.frexp x in
  if x = 0. then (Z.zero, 0) else (Z.of_float (Float.ldexp fraction 53), exponent - 53)

let scale least (digits, exponent) =
  if Z.equal digits Z.zero then Z.zero else Z.shift_left digits (exponent - least)

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
  (* The ray through the centre of a pixel, times two. *)
  let ray i j = { Coverage.vx = Z.of_int ((2 * i) + 1); vy = Z.of_int ((2 * j) + 1); vw = Z.of_int 2 } in
  fun i j -> Coverage.seen_counts surface (ray i j)

let draw id width height space vertices triangles =
  let finite = List.filter (List.for_all (fun k -> List.for_all Float.is_finite vertices.(k))) triangles in
  let corners = List.map (List.map (fun k -> List.map decode vertices.(k))) finite in
  let counts = (if space = "clip" then counts_in_clip else counts_in_window) corners in
  print_string ("counts " ^ id ^ "\n");
  for j = 0 to height - 1 do
    print_string (String.concat " " (List.init width (fun i -> Z.to_string (counts i j))) ^ "\n")
  done;
  flush stdout

let () =
  try
    while true do
      match words (read_line ()) with
      | "draw" :: id :: width :: height :: _ :: space :: vertices :: triangles :: _ ->
        let read f = f (words (read_line ())) in
        let numbers = function
          | x :: y :: _ :: w :: _ ->
            List.map float_of_string (if space = "clip" then [ x; y; w ] else [ x; y ])
          | _ -> failwith "vertex" in
        let v = Array.init (int_of_string vertices) (fun _ -> read numbers) in
        let t = List.init (int_of_string triangles) (fun _ -> read (List.map int_of_string)) in
        draw id (int_of_string width) (int_of_string height) space v t
      | _ -> failwith "not a request"
    done
  with End_of_file -> ()
