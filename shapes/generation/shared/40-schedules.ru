# The operators of each schedule in their order; a slot with coordinates stands for the relation that they are of.

INSERT {
    <https://w3id.org/kinlint/generation#program> gen:schedule ?schedule .
    ?schedule gen:iri ?name .
} WHERE {
    ?schedule algo:trigger-chain ?list .
    BIND (STR(?schedule) AS ?name)
} ;

INSERT {
    ?schedule gen:step ?step .
    ?step gen:order ?index ;
        gen:operator ?operator .
    ?operator gen:iri ?name .
} WHERE {
    { SELECT ?schedule ?operator ?cell (COUNT(?before) AS ?index) WHERE {
        ?schedule algo:trigger-chain/rdf:rest* ?before .
        ?before rdf:rest* ?cell .
        ?cell rdf:first ?operator .
    } GROUP BY ?schedule ?operator ?cell }
    BIND (IRI(CONCAT("urn:kinlint:step:", STR(?index), ":", STR(?schedule))) AS ?step)
    BIND (STR(?operator) AS ?name)
} ;

INSERT {
    ?operator gen:kind ?kind ;
        ?slot ?relation .
    ?program gen:pose ?relation .
    ?relation gen:iri ?name .
} WHERE {
    VALUES (?type ?kind ?property ?slot) {
        (kc-op:ForwardPositionKinematics "forward-position-kinematics" kc-op:cartesian-space-motion gen:out)
        (geom-op:ComposePose "compose-pose" geom-op:in1 gen:first)
        (geom-op:ComposePose "compose-pose" geom-op:in2 gen:second)
        (geom-op:ComposePose "compose-pose" geom-op:composite gen:out)
    }
    ?program gen:schedule/gen:step/gen:operator ?operator .
    ?operator a ?type ;
        ?property ?datum .
    OPTIONAL { ?datum kin:coordinate-of ?described }
    BIND (COALESCE(?described, ?datum) AS ?relation)
    BIND (STR(?relation) AS ?name)
} ;

# The motion of a joint is the pose of its attachments to each other.

INSERT {
    ?operator gen:moves ?joint ;
        gen:at ?position ;
        gen:backwards ?backwards .
    ?program gen:input ?position .
    ?position gen:iri ?name .
} WHERE {
    ?program gen:schedule/gen:step/gen:operator ?operator .
    ?operator kc-op:joint ?joint ;
        kc-op:joint-space-motion ?position ;
        gen:out ?pose .
    ?joint gen:child/^kin:on-body ?frame .
    ?pose geom-rel:of|geom-rel:with-respect-to ?frame .
    ?joint kc:between-attachments ?frame .
    BIND (EXISTS { ?pose geom-rel:with-respect-to ?frame } AS ?backwards)
    BIND (STR(?position) AS ?name)
} ;

# What no operator computes has to be stated.

INSERT { ?pose gen:given true }
WHERE {
    ?program gen:pose ?pose .
    ?pose gen:value ?value .
    FILTER NOT EXISTS { ?operator gen:out ?pose }
}
