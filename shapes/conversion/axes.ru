# An axis along x, y or z of the frame that sees it is that vector of the frame.

INSERT { ?axis ir:replaced-by ?vector }
WHERE {
    VALUES (?property ?x ?y ?z) {
        (geom:vector-x 1 0 0)
        (geom:vector-y 0 1 0)
        (geom:vector-z 0 0 1)
    }
    ?axis a geom-coord:DirectionCoordinate ;
        geom:start ?origin ;
        geom-coord:as-seen-by ?frame .
    ?frame geom:origin ?origin ;
        ?property ?vector .
    ?axis geom-coord:x ?x1 ; geom-coord:y ?y1 ; geom-coord:z ?z1 .
    FILTER (?x1 = ?x && ?y1 = ?y && ?z1 = ?z)
    FILTER NOT EXISTS {
        ?axis geom-coord:x ?x2 ; geom-coord:y ?y2 ; geom-coord:z ?z2 .
        FILTER (?x2 != ?x || ?y2 != ?y || ?z2 != ?z)
    }
}
