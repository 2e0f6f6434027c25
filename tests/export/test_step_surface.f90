!> Surfaces of STEP files: their text, worked by hand.
program test_step_surface
    use base_kinds, only: dp
    use export_shell, only: face_type, skin_model_type
    use export_step_surface, only: add_surface, surface_word
    use export_step_text, only: step_file_type
    use geom_bspline_surface, only: bspline_surface_type
    use support_sewn, only: ball_skin, box_skin
    use support_step_records, only: record_named, record_type, records_of, refers_back
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap

    call check_plane()
    call check_plain()
    call check_rational()
    call tap%finish()

contains

    subroutine check_plane()
        type(step_file_type) :: file
        type(record_type), allocatable :: records(:)
        type(skin_model_type) :: skin
        integer :: number

        skin = box_skin([0.0_dp, -1.0_dp, -2.0_dp], [10.0_dp, 1.0_dp, 3.0_dp])
        call add_surface(file, skin%faces(6), number)
        records = records_of(file%text())
        call tap%same(record_named(records, number), 'PLANE('''',#4)', 'a cap is on a plane')
        call tap%same(record_named(records, 1), 'CARTESIAN_POINT('''',(10.,1.,3.))', &
            'through its point')
        call tap%same(record_named(records, 2), 'DIRECTION('''',(1.,0.,0.))', &
            'across its normal')
        call tap%same(surface_word(skin%faces(6)), 'PLANE', 'and called so')
        call tap%same(surface_word(skin%faces(1)), 'B_SPLINE_SURFACE_WITH_KNOTS', &
            'a side of equal weights is a plain spline')
    end subroutine check_plane

    !> A surface with two poles along u and three along v, which closes along v.
    subroutine check_plain()
        type(step_file_type) :: file
        type(record_type), allocatable :: records(:)
        type(face_type) :: face
        integer :: number, i, j

        face%name = 'SIDE'
        face%surface%degree = [1, 2]
        face%surface%u_knot = [0.0_dp, 0.0_dp, 3.0_dp, 3.0_dp]
        face%surface%v_knot = [0.0_dp, 0.0_dp, 0.0_dp, 1.0_dp, 1.0_dp, 1.0_dp]
        allocate (face%surface%pole(3, 2, 3), face%surface%weight(2, 3))
        face%surface%weight = 1.0_dp
        do j = 1, 3
            do i = 1, 2
                face%surface%pole(:, i, j) = [real(i, dp), real(merge(1, 0, j == 2), dp), 0.0_dp]
            end do
        end do
        call add_surface(file, face, number)
        records = records_of(file%text())
        call tap%ok(refers_back(records), 'instances in order')
        call tap%same(record_named(records, number), 'B_SPLINE_SURFACE_WITH_KNOTS(''SIDE'',1,2,'// &
            '((#1,#2,#3),(#4,#5,#6)),.UNSPECIFIED.,.F.,.T.,.F.,(2,2),(3,3),(0.,3.),(0.,1.),'// &
            '.UNSPECIFIED.)', 'degrees, poles and knots along u come before those along v')
        call tap%same(record_named(records, 2), 'CARTESIAN_POINT('''',(1.,1.,0.))', &
            'poles run along v first')
        call tap%same(record_named(records, 4), 'CARTESIAN_POINT('''',(2.,0.,0.))', &
            'then along u')
    end subroutine check_plain

    subroutine check_rational()
        type(step_file_type) :: file
        type(record_type), allocatable :: records(:)
        type(skin_model_type) :: skin
        integer :: number

        skin = ball_skin(2.0_dp)
        skin%faces(1)%surface%weight = reshape([1.0_dp, 0.5_dp, 1.0_dp, 0.75_dp, 0.25_dp, &
            0.75_dp, 1.0_dp, 0.5_dp, 1.0_dp], [3, 3])
        call add_surface(file, skin%faces(1), number)
        records = records_of(file%text())
        call tap%same(record_named(records, number), '(BOUNDED_SURFACE()B_SPLINE_SURFACE(2,2,'// &
            '((#1,#2,#3),(#4,#5,#6),(#7,#8,#9)),.UNSPECIFIED.,.F.,.F.,.F.)'// &
            'B_SPLINE_SURFACE_WITH_KNOTS((3,3),(3,3),(0.,1.),(0.,1.),.UNSPECIFIED.)'// &
            'GEOMETRIC_REPRESENTATION_ITEM()RATIONAL_B_SPLINE_SURFACE(((1.,0.75,1.),'// &
            '(0.5,0.25,0.5),(1.,0.75,1.)))REPRESENTATION_ITEM(''FACE 1'')SURFACE())', &
            'a rational spline is many entities at once, in the order of the alphabet')
        call tap%same(surface_word(skin%faces(1)), 'RATIONAL_B_SPLINE_SURFACE', 'its word')
    end subroutine check_rational

end program test_step_surface
