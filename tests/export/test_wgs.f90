!> Tests of LaWGS files, read back list-directed as the standard says.
program test_wgs
    use base_kinds, only: dp
    use base_output, only: output_type
    use export_network, only: networks_type
    use export_receipt, only: receipt_type
    use export_wgs, only: write_wgs
    use support_nets, only: two_nets
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(output_type) :: out, long
    type(receipt_type) :: receipt
    type(networks_type) :: networks
    character(80) :: words
    integer :: unit, object(4), symmetry
    real(dp) :: moved(9), points(3, 2, 3), other(3, 2, 2)

    call write_wgs(two_nets(), out, receipt)
    open (newunit=unit, status='scratch', action='readwrite')
    write (unit, '(a)', advance='no') out%text()
    rewind (unit)
    read (unit, *) words
    call tap%same(trim(words), "UNITS=MM DECK a.crd PILOT'S SEAT", &
        'the title, with units and an apostrophe')
    read (unit, *) words
    call tap%same(trim(words), 'UPPER', 'an object has a name')
    read (unit, *) object, moved, symmetry
    call tap%ok(all(object == [1, 3, 2, 0]), 'a number, contours, points, no local symmetry')
    call tap%ok(all(abs(moved - [0.0_dp, 0.0_dp, 0.0_dp, 0.0_dp, 0.0_dp, 0.0_dp, 1.0_dp, 1.0_dp, &
        1.0_dp]) <= 0.0_dp), 'not turned, not moved, at scale 1')
    call tap%ok(symmetry == 1, 'half a body is symmetric about the plane of x and z')
    read (unit, *) points
    networks = two_nets()
    call tap%ok(all(abs(points - networks%list(1)%points) <= 0.0_dp), &
        'points read back exactly, contour by contour')
    read (unit, *) words
    read (unit, *) object, moved, symmetry
    call tap%ok(all(object == [2, 2, 2, 0]) .and. symmetry == 0, 'a whole object is not symmetric')
    read (unit, *) other
    call tap%near(other(3, 2, 2), -1.0_dp, 0.0_dp, 'to the last point')
    close (unit)
    call tap%ok(receipt%count == 2, 'the receipt has an entity for each')
    networks%title = 'A TITLE OF MORE THAN EIGHTY CHARACTERS IS CUT, BECAUSE THE STANDARD HAS '// &
        'NO ROOM FOR IT'
    call write_wgs(networks, long, receipt)
    call tap%ok(index(long%text(), new_line('a')) == 83, 'a title has up to 80 characters')
    call tap%finish()
end program test_wgs
