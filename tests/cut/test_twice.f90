!> The second way finds how far a point is from the surface, also where the first way is made wrong.
program test_twice
    use base_kinds, only: dp
    use body_body, only: body_type
    use cut_outline, only: cut_type
    use cut_plane, only: waterline_plane
    use cut_twice, only: distance_between_ways, largest_disagreement
    use support_bodies, only: ellipsoid, nose_of_the_book
    use support_cutting, only: by_number, cut_of
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(body_type) :: body
    type(cut_type) :: cut

    body = ellipsoid([5.0_dp, 5.0_dp, 5.0_dp], 0.0_dp, 0.0_dp)
    cut = cut_of(body, by_number(waterline_plane(3.0_dp), 9))
    call tap%near(largest_disagreement(body, cut%plane, cut%outlines), 0.0_dp, 1.0e-14_dp, &
        'both ways agree on a sphere')
    cut%outlines(1)%points(5)%at(2) = cut%outlines(1)%points(5)%at(2) + 1.0e-6_dp
    call tap%near(distance_between_ways(body, cut%plane, cut%outlines(1)%points(5)), 1.0e-6_dp, &
        1.0e-14_dp, &
        'a point a millionth off is told to be')
    call tap%near(largest_disagreement(body, cut%plane, cut%outlines), 1.0e-6_dp, 1.0e-14_dp, &
        'and is the largest')
    cut%outlines(1)%points(5)%at(2) = cut%outlines(1)%points(5)%at(2) + 1.0e-3_dp
    call tap%ok(distance_between_ways(body, cut%plane, cut%outlines(1)%points(5)) > 0.9e-3_dp, &
        'one out of the bracket is not passed over')
    cut = cut_of(nose_of_the_book(), by_number(waterline_plane(-16.0_dp), 25))
    call tap%ok(cut%disagreement > 0.0_dp .and. cut%disagreement < 1.0e-13_dp, &
        'they agree on the book''s nose')
    call tap%finish()
end program test_twice
