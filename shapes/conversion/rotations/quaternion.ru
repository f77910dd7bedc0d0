# A rotation as a unit quaternion, to 15 decimals, from roll, pitch and yaw about fixed axes.
#
# Source: Diebel, Representing Attitude, 2006, section 8.11.

DELETE {
    ?numbers a kin:EulerAngles , kin:Extrinsic ;
        qudt:unit ?unit ;
        kin:axes-sequence ?sequence ;
        kin:alpha ?alpha ; kin:beta ?beta ; kin:gamma ?gamma .
} INSERT {
    ?numbers a kin:Quaternion ;
        qudt:unit unit:UNITLESS ;
        kin:qx ?qx ;
        kin:qy ?qy ;
        kin:qz ?qz ;
        kin:qw ?qw .
} WHERE {
    FILTER NOT EXISTS { ?numbers a kin:Quaternion , kin:EulerAngles }
    ?numbers a kin:EulerAngles ;
        qudt:unit ?unit ;
        kin:axes-sequence ?sequence ;
        kin:alpha ?alpha ;
        kin:beta ?beta ;
        kin:gamma ?gamma .
    FILTER (?unit IN (unit:RAD, unit:DEG))
    BIND (IF(?unit = unit:DEG, math:pi() / 360, 0.5e0) AS ?half)
    BIND (math:cos(?half * ?alpha) AS ?ca)
    BIND (math:sin(?half * ?alpha) AS ?sa)
    BIND (math:cos(?half * ?beta) AS ?cb)
    BIND (math:sin(?half * ?beta) AS ?sb)
    BIND (math:cos(?half * ?gamma) AS ?cg)
    BIND (math:sin(?half * ?gamma) AS ?sg)
    BIND (ROUND(1e15 * (?sa * ?cb * ?cg - ?ca * ?sb * ?sg)) / 1e15 + 0 AS ?qx)
    BIND (ROUND(1e15 * (?ca * ?sb * ?cg + ?sa * ?cb * ?sg)) / 1e15 + 0 AS ?qy)
    BIND (ROUND(1e15 * (?ca * ?cb * ?sg - ?sa * ?sb * ?cg)) / 1e15 + 0 AS ?qz)
    BIND (ROUND(1e15 * (?ca * ?cb * ?cg + ?sa * ?sb * ?sg)) / 1e15 + 0 AS ?qw)
}
