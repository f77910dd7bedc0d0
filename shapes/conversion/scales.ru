# A mesh that is not scaled has no scale.

DELETE { ?shape kin:scale ?scale }
WHERE {
    ?shape kin:scale ?scale .
    ?scale rdf:first 1.0e0 ; rdf:rest/rdf:first 1.0e0 ; rdf:rest/rdf:rest/rdf:first 1.0e0 .
}
