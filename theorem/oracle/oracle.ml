(* Answers requests on a pipe (docs/subjects.md) by the counts that Coverage, extracted from the
   specification, gives. What is written here, and trusted: reading decimals, and multiplying all
   coordinates by one power of two so that they are integers. *)

let words line = List.filter (fun w -> w <> "") (String.split_on_char ' ' line)

(* A finite double is digits * 2^exponent. *)
let decode x =
  let fraction, exponent = Float.frexp x in
  if x = 0. then (Z.zero, 0) else (Z.of_float (Float.ldexp fraction 53), exponent - 53)

let scale least (digits, exponent) =
  if Z.equal digits Z.zero then Z.zero else Z.shift_left digits (exponent - least)

let point x y = { Coverage.px = x; Coverage.py = y }

let draw id width height vertices triangles =
  let finite = List.filter (List.for_all (fun k -> List.for_all Float.is_finite vertices.(k))) triangles in
  let places = Array.map (fun v -> if List.for_all Float.is_finite v then List.map decode v else []) vertices in
  let used = List.concat_map (fun t -> List.concat_map (fun k -> places.(k)) t) finite in
  (* The least is -1 at most: pixel centres are halves. *)
  let least = List.fold_left (fun e (_, f) -> min e f) (-1) used in
  let corner k =
    match places.(k) with
    | [ x; y ] -> point (scale least x) (scale least y)
    | _ -> failwith "a vertex has two coordinates" in
  let triangle = function
    | [ a; b; c ] -> { Coverage.corner_a = corner a; corner_b = corner b; corner_c = corner c }
    | _ -> failwith "a triangle has three corners" in
  let mesh = List.map triangle finite in
  let centre i = Z.shift_left (Z.of_int ((2 * i) + 1)) (-1 - least) in
  print_string ("counts " ^ id ^ "\n");
  for j = 0 to height - 1 do
    let count i = Z.to_string (Coverage.counts mesh (point (centre i) (centre j))) in
    print_string (String.concat " " (List.init width count) ^ "\n")
  done;
  flush stdout

let () =
  try
    while true do
      match words (read_line ()) with
      | "draw" :: id :: width :: height :: _ :: _ :: vertices :: triangles :: _ ->
        let read f = f (words (read_line ())) in
        let two = function x :: y :: _ -> [ float_of_string x; float_of_string y ] | _ -> failwith "vertex" in
        let v = Array.init (int_of_string vertices) (fun _ -> read two) in
        let t = List.init (int_of_string triangles) (fun _ -> read (List.map int_of_string)) in
        draw id (int_of_string width) (int_of_string height) v t
      | _ -> failwith "not a request"
    done
  with End_of_file -> ()
