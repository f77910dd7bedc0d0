"""Structure and numbers of robots, computed once from the closed graph for rules and pictures.

Whatever format a robot is written in, it is a composable model here: stated as one, or lifted. What
SPARQL cannot compute is computed in steps, each from the steps before it:

1. `predicate_index` reads the store, each property once.
2. Numbers: `units` and `quantity` bring them to SI, `rotation` makes matrices of Euler angles,
   quaternions and direction cosines.
3. Places: `spatial_relations` joins numbers to relations between frames, `frame_placement` gives
   each frame one point and one rotation on its body. `orientation_graph`, `loop_closure` and
   `coordinate_agreement` tell whether what is stated several times agrees.
4. Structure: `mechanism` has bodies, joints and the bodies that each joint joins; `link_trees` and
   `joint_trees` the trees that joints make of them, `connected_components` the pieces of chains,
   `assembly` what is welded together.
5. Masses: `inertia`, `mass_distribution`, `parallel_axis`, and `body_shapes` for comparison.
6. What is wrong on the whole: `drift` between descriptions, `mirror_symmetry`, `planning_groups`,
   `schedule_order`, names that lead nowhere.

`fact_context` makes each of these when it is first asked for. From it, `fact_kinds` makes the facts
that rules ask for (the table is in `shapes/README.md`), and `robot_structures` the links and joints
of `kinlint.structure`, which pictures and outlines show. A fact says numbers and relations, never
that anything is wrong: that is for rules to say.
"""
