!> Tests of what a receipt says of curves and faces.
program test_entity
    use base_kinds, only: dp
    use export_drawing, only: curve_type
    use export_entity, only: curve_entity, face_entity
    use export_receipt, only: entity_type
    use export_shell, only: face_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(curve_type) :: curve
    type(face_type) :: face
    type(entity_type) :: entity

    curve%spline%degree = 1
    curve%spline%knot = [0.0_dp, 0.0_dp, 1.0_dp, 3.0_dp, 3.0_dp]
    curve%spline%weight = [1.0_dp, 1.0_dp, 1.0_dp]
    curve%error = 0.25_dp
    curve%worst = [1.0_dp, 2.0_dp, 3.0_dp]
    entity = curve_entity(curve, 'STA_20', 'LINE')
    call tap%same(entity%name//'|'//entity%kind, 'STA_20|LINE', 'a curve has name and kind')
    call tap%ok(entity%points == 3 .and. entity%spans == 2, 'poles and spans are counted')
    call tap%near(entity%error + entity%worst(3), 3.25_dp, 0.0_dp, 'its error and where')
    call tap%ok(entity%has_place .and. .not. entity%is_exact, 'a fitted curve has a worst place')
    curve%is_exact = .true.
    entity = curve_entity(curve, 'STA_20', 'LINE')
    call tap%ok(entity%is_exact .and. .not. entity%has_place, 'an exact one has none')

    face%name = 'UPPER'
    allocate (face%surface%weight(2, 3))
    face%spans = 4
    face%error = 0.5_dp
    face%worst = [1.0_dp, 2.0_dp, 3.0_dp]
    entity = face_entity(face, 'SURFACE')
    call tap%same(entity%name//'|'//entity%kind, 'UPPER|SURFACE', 'a face has name and kind')
    call tap%ok(entity%points == 6 .and. entity%spans == 4, 'poles and spans of its surface')
    call tap%near(entity%error + entity%worst(3), 3.5_dp, 0.0_dp, 'its error and where too')
    call tap%ok(entity%has_place .and. .not. entity%is_exact, 'a fitted face has a worst place')
    face%is_flat = .true.
    face%is_exact = .true.
    entity = face_entity(face, 'PLANE')
    call tap%ok(entity%points == 0 .and. entity%spans == 0, 'a plane has no poles')
    call tap%ok(entity%is_exact .and. .not. entity%has_place, 'and is exact')
    call tap%finish()
end program test_entity
