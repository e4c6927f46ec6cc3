(* What Coverage, extracted from the specifications of clip space and of values, shows at a sample.
   What is written here, and trusted: decoding doubles, multiplying by powers of two so that all are
   integers, and rounding a quotient of two integers to the nearest double. *)
module C = Coverage

(* A finite double is digits * 2^exponent. *)
let decode x =
  let fraction, exponent = Float.frexp x in
  if x = 0. then (Z.zero, 0) else (Z.of_float (Float.ldexp fraction 53), exponent - 53)

let scale least (digits, exponent) =
  if Z.equal digits Z.zero then Z.zero else Z.shift_left digits (exponent - least)

(* Finite numbers times 2^shift, and the shift; nothing if one is not finite. *)
let integers numbers =
  if not (List.for_all Float.is_finite numbers) then None
  else
    let decoded = List.map decode numbers in
    let least = List.fold_left (fun e (_, f) -> min e f) 0 decoded in
    Some (List.map (scale least) decoded, -least)

(* The double nearest to n / d, ties to even. *)
let nearest (n, d) =
  let size, over = (Z.abs n, Z.abs d) in
  let quotient shift =
    let over = Z.shift_left over (max (-shift) 0) in
    let q, r = Z.div_rem (Z.shift_left size (max shift 0)) over in
    (q, Z.compare (Z.shift_left r 1) over) in
  if Z.equal d Z.zero then Float.nan
  else if Z.equal n Z.zero then 0.
  else
    (* At most one bit more than 53, or the step of the least subnormal. *)
    let wide = 53 - (Z.numbits size - Z.numbits over) in
    let shift = min 1074 (if Z.numbits (fst (quotient wide)) <= 53 then wide else wide - 1) in
    let q, half = quotient shift in
    let q = if half > 0 || (half = 0 && Z.is_odd q) then Z.succ q else q in
    let x = Float.ldexp (Z.to_float q) (-shift) in
    if Z.sign n * Z.sign d < 0 then -.x else x

let text quotient = Printf.sprintf "%.17g" (nearest quotient)

let vertex vx vy vw = { C.vx; vy; vw }

(* The ray through the centre of a pixel, times two, and a pixel to the right and downward. *)
let ray i j = vertex (Z.of_int ((2 * i) + 1)) (Z.of_int ((2 * j) + 1)) (Z.of_int 2)
let steps = [ vertex (Z.of_int 2) Z.zero Z.zero; vertex Z.zero (Z.of_int 2) Z.zero ]

(* A triangle: its vertices times 2^shift, their z, and their indices. *)
type corners =
  { a : C.vertex; b : C.vertex; c : C.vertex; shift : int; z : float list; ids : int list }

let shifted k x = Z.shift_left x k

(* A channel's value and its derivatives, as far as they are numbers. *)
let value t p (kind, numbers) =
  let plane = Z.mul (C.det t.a t.b t.c) p.C.vw in
  let h = C.horizon t.a t.b t.c p in
  match (kind, if kind = "inverse-w" then Some ([], 0) else integers numbers) with
  | "flat", Some _ -> [ Printf.sprintf "%.17g" (List.hd numbers); "0"; "0" ]
  | "inverse-w", _ ->
    let n at = shifted t.shift (C.combined t.a t.b t.c at Z.one Z.one Z.one) in
    List.map (fun at -> text (n at, plane)) (p :: steps)
  | "linear", Some ([ x; y; z ], u) ->
    List.map (fun at -> text (C.on_screen t.a t.b t.c at x y z, shifted u plane)) (p :: steps)
  | "perspective", Some ([ x; y; z ], u) ->
    text (C.combined t.a t.b t.c p x y z, shifted u h)
    :: List.map
         (fun s -> text (C.slope t.a t.b t.c p s x y z, shifted u (Z.mul h h)))
         steps
  | _ -> [ "nan"; "nan"; "nan" ]

let barycentrics t p =
  let h = C.horizon t.a t.b t.c p in
  List.map (fun beta -> text (beta t.a t.b t.c p, h)) [ C.beta_a; C.beta_b; C.beta_c ]

let depth space t p =
  match integers t.z with
  | Some ([ x; y; z ], k) ->
    let n = C.combined t.a t.b t.c p x y z in
    if space = "clip" then
      text (shifted t.shift n, shifted k (Z.mul (C.det t.a t.b t.c) p.C.vw))
    else text (n, shifted k (C.horizon t.a t.b t.c p))
  | _ -> "nan"

(* The corners of a triangle; nothing if one is not finite. [vertices] are x, y, z, w. *)
let corners space vertices ids =
  let used = List.concat_map (fun k -> match vertices.(k) with
    | [ x; y; _; w ] -> [ x; y; (if space = "clip" then w else 1.) ]
    | _ -> failwith "a vertex has four coordinates") ids in
  match integers used with
  | Some ([ ax; ay; aw; bx; by; bw; cx; cy; cw ], shift) ->
    let z = List.map (fun k -> List.nth vertices.(k) 2) ids in
    Some { a = vertex ax ay aw; b = vertex bx by bw; c = vertex cx cy cw; shift; z; ids }
  | _ -> None

(* The words of one sample: the last of the triangles that covers it, and what is wanted of that. *)
let sample space triangles channels wants i j =
  let p = ray i j in
  let covers t =
    Z.sign (C.seen_counts [ { C.vertex_a = t.a; vertex_b = t.b; vertex_c = t.c } ] p) > 0 in
  let visible = List.fold_left (fun found (index, t) ->
    match t with Some t when covers t -> Some (index, t) | _ -> found) None triangles in
  match visible with
  | None -> [ "-1" ]
  | Some (index, t) ->
    let if_wanted word words = if List.mem word wants then words () else [] in
    let of_channel (kind, numbers) =
      let at = if kind = "inverse-w" then [] else List.map (fun k -> numbers.(k)) t.ids in
      let words = value t p (kind, at) in
      if List.mem "derivatives" wants then words else [ List.hd words ] in
    string_of_int index
    :: if_wanted "barycentrics" (fun () -> barycentrics t p)
    @ if_wanted "depths" (fun () -> [ depth space t p ])
    @ if_wanted "values" (fun () -> List.concat_map of_channel channels)
