!> The roots of the 1970 program, against figures of the book.
program test_root
    use audit_curve, only: frame_type, quantity_type
    use audit_reading, only: sort
    use audit_root, only: root_of_1970, root_room, short
    use base_kinds, only: dp
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(frame_type), parameter :: plain = frame_type()
    real(dp), parameter :: circle(6) = [1.0_dp, 0.0_dp, 1.0_dp, 0.0_dp, 0.0_dp, -25.0_dp]
    type(quantity_type) :: top, left
    real(dp) :: root

    call tap%near(short(1.0_dp), 1.0_dp, 0.0_dp, 'one is one')
    call tap%near(short(16.0_dp**3 + 15.9_dp/16.0_dp**2), 16.0_dp**3 + 15.0_dp/16.0_dp**2, &
        0.0_dp, '6 hexadecimal figures of a number above 16**3 end with 16**-2')
    call tap%near(short(0.1_dp), real(int(z'199999'), dp)/16.0_dp**6, 0.0_dp, &
        'a tenth is .199999 in hexadecimal figures, cut off')
    call tap%near(short(0.0_dp), 0.0_dp, 0.0_dp, 'zero is zero')

    top = quantity_type(sort%ordinate, along=3.1_dp, near=3.9_dp, shift=100.0_dp)
    root = root_of_1970(circle, plain, top, 0.001_dp)
    call tap%ok(root <= sqrt(25.0_dp - 3.1_dp**2) .and. &
        root > sqrt(25.0_dp - 3.1_dp**2) - 2.0e-5_dp, 'the root is too small, by little')
    call tap%near(root_room(circle, plain, top, 0.001_dp), &
        -1.5_dp*sqrt(25.0_dp - 3.1_dp**2)/2.0_dp**20, 1.0e-15_dp, 'it is drawn to the other one')
    left = quantity_type(sort%abscissa, along=3.1_dp, near=-3.9_dp, shift=100.0_dp)
    root = root_of_1970(circle, plain, left, 0.001_dp)
    call tap%ok(root >= -sqrt(25.0_dp - 3.1_dp**2) .and. &
        root < -sqrt(25.0_dp - 3.1_dp**2) + 2.0e-5_dp, 'the lesser root is drawn the other way')
    call tap%near(root_room(circle, plain, top, 1.0e-6_dp), -1.0e-7_dp, 1.0e-15_dp, &
        'no more than a tenth of a unit is allowed for it')
    call tap%finish()
end program test_root
