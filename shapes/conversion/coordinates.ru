# One node has the numbers of a pose, and one those of an inertia.

DELETE { ?part ?property ?value }
INSERT { ?whole ?property ?value }
WHERE {
    ?part geom-coord:of-pose|dyn-coord:of-inertia ?described .
    BIND (IRI(CONCAT(STR(?described), "/coordinates")) AS ?whole)
    ?part ?property ?value .
}
