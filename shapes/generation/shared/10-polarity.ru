# A joint moves its child as the parent sees it.  One that the model counts the other way round, from child to
# parent, and one whose axis is left-handed, move along the opposite axis.

DELETE { ?axis ?component ?number }
INSERT { ?axis ?component ?opposite }
WHERE {
    ?joint gen:axis ?axis .
    ?axis ?component ?number .
    OPTIONAL { ?joint kin:handedness ?hand . FILTER (STRENDS(STR(?hand), "LeftHanded")) }
    FILTER (BOUND(?hand) != EXISTS { ?joint gen:turned ?turned })
    BIND (0.0e0 - ?number AS ?opposite)
}
