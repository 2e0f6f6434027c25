!> Bodies at random must be the same surface in every guise: lines given from aft, sections from the
!> other end, mirrored in each of the three planes, 1000 in from the datum, in other units, with
!> conics split in two, to port. Points, outward normals and curvatures are compared; a sign that is
!> wrong somewhere shows here.
program test_random_body
    use base_decimal, only: decimal_type, new_grid
    use base_error, only: error_type
    use base_kinds, only: dp, i64
    use base_text, only: to_text
    use body_body, only: body_type
    use body_gap, only: section_gaps
    use body_skin, only: normal_curvature, skin_at, skin_type
    use cut_make, only: make_cut
    use cut_outline, only: cut_type
    use cut_plane, only: plane_through
    use cut_request, only: cut_rule, request_type
    use geom_place, only: mirrored, place_at, place_type
    use support_random, only: random_type
    use support_random_body, only: body_of, guise_type, random_sketch, sketch_type
    use support_tap, only: tap_type
    implicit none (type, external)

    !> Largest differences between two guises, in the unit of the first.
    type :: worst_type
        real(dp) :: point = 0.0_dp      !! inches
        real(dp) :: normal = 0.0_dp     !! radians
        real(dp) :: curvature = 0.0_dp  !! 1/inches
        real(dp) :: cut = 0.0_dp        !! inches
    end type worst_type

    integer, parameter :: bodies = 300, points_each = 12, guises = 11
    !> Coordinates of 1000 and more are good to 1E-13 in; slopes to that over the length of a conic,
    !> curvatures to that again.
    real(dp), parameter :: point_noise = 1.0e-11_dp, normal_noise = 1.0e-11_dp, &
        curvature_noise = 1.0e-11_dp, cut_noise = 1.0e-9_dp
    type(tap_type) :: tap
    type(guise_type) :: guise(guises)
    type(worst_type) :: worst(guises)
    integer :: i, used

    guise = guise_list()
    call compare_bodies()
    call tap%ok(used > 200, to_text(used)//' random bodies have a section at every station')
    do i = 1, guises
        call tap%near(worst(i)%point, 0.0_dp, point_noise, trim(guise(i)%name)//': points')
        call tap%near(worst(i)%normal, 0.0_dp, normal_noise, trim(guise(i)%name)//': normals')
        call tap%near(worst(i)%curvature, 0.0_dp, curvature_noise, &
            trim(guise(i)%name)//': curvatures')
        call tap%near(worst(i)%cut, 0.0_dp, cut_noise, trim(guise(i)%name)//': plane cuts')
    end do
    call tap%finish()

contains

    !> All guises.
    function guise_list() result(list)
        type(guise_type) :: list(guises)
        list%name = [character(32) :: 'lines given from aft', 'sections given from the side', &
            'mirrored in BL 0', 'mirrored in WL 0', 'mirrored in STA 0', 'turned about BL 0', &
            '1000 in off', 'in millimetres', 'in a large unit', 'conics split in two', 'to port']
        list(1)%has_lines_reversed = .true.
        list(2)%has_sections_reversed = .true.
        list(3)%mirror(2) = -1.0_dp
        list(4)%mirror(3) = -1.0_dp
        list(5)%mirror(1) = -1.0_dp
        list(6)%mirror = [-1.0_dp, -1.0_dp, 1.0_dp]
        list(7)%shift = [1000.0_dp, 0.0_dp, -1000.0_dp]
        list(8)%scale = 25.4_dp
        list(9)%scale = 0.125_dp
        list(10)%is_split = .true.
        list(11)%is_port = .true.
        list(11)%mirror(2) = -1.0_dp
    end function guise_list

    !> Compares every guise of every body with its first.
    subroutine compare_bodies()
        type(random_type) :: random
        type(sketch_type) :: sketch
        type(body_type) :: body, other
        integer :: number, k

        used = 0
        do number = 1, bodies
            call random_sketch(random, sketch)
            call body_of(sketch, guise_type(), body)
            if (size(section_gaps(body, body%sections(1))) > 0) cycle
            used = used + 1
            do k = 1, guises
                call body_of(sketch, guise(k), other)
                call compare_skin(random, body, other, k)
                if (mod(number, 50) == 0) call compare_cut(random, body, other, k)
            end do
        end do
    end subroutine compare_bodies

    !> Compares two guises at some points.
    subroutine compare_skin(random, body, other, k)
        type(random_type), intent(inout) :: random      !! the stream
        type(body_type), intent(in) :: body             !! the first guise
        type(body_type), intent(in) :: other            !! another
        integer, intent(in) :: k                        !! which
        type(skin_type) :: skin, seen
        type(place_type) :: place
        real(dp) :: sta, way(3), left(3)
        integer :: i

        do i = 1, points_each
            sta = random%between(body%sections(1)%from, body%sections(1)%to)
            place = place_at(random%between(0.02_dp, 0.98_dp))
            skin = skin_at(body%lines, body%sections(1), sta, place)
            if (guise(k)%has_sections_reversed) place = mirrored(place)
            sta = guise(k)%mirror(1)*guise(k)%scale*sta + guise(k)%shift(1)
            seen = skin_at(other%lines, other%sections(1), sta, place)
            call take(worst(k)%point, norm2(in_first(seen%at, k) - skin%at))
            call take(worst(k)%normal, norm2(guise(k)%mirror*seen%normal - skin%normal))
            ! The waterline through the point, seen from above: outward is to one side of it.
            way = [-skin%normal(2), skin%normal(1), 0.0_dp]/norm2(skin%normal(:2))
            left = [-way(2), way(1), 0.0_dp]
            call take(worst(k)%curvature, guise(k)%scale* &
                normal_curvature(seen, guise(k)%mirror*way, guise(k)%mirror*left) - &
                normal_curvature(skin, way, left))
        end do
    end subroutine compare_skin

    !> Compares the cuts of two guises with the same plane, points at every 5 in of STA.
    subroutine compare_cut(random, body, other, k)
        type(random_type), intent(inout) :: random      !! the stream
        type(body_type), intent(in) :: body             !! the first guise
        type(body_type), intent(in) :: other            !! another
        integer, intent(in) :: k                        !! which
        type(cut_type) :: cut, seen
        real(dp) :: through(3), normal(3)
        integer :: i

        through = [random%between(0.0_dp, 50.0_dp), 8.0_dp, -8.0_dp]
        normal = [random%between(0.3_dp, 1.0_dp), random%between(-1.0_dp, 1.0_dp), &
            random%between(-1.0_dp, 1.0_dp)]
        call cut_with(body, through, normal, decimal_type(5_i64, 0), cut)
        call cut_with(other, guise(k)%mirror*guise(k)%scale*through + guise(k)%shift, &
            guise(k)%mirror*normal, decimal_type(nint(5000.0_dp*guise(k)%scale, i64), -3), seen)
        if (size(seen%outlines) /= size(cut%outlines)) then
            call take(worst(k)%cut, huge(1.0_dp))
            return
        end if
        do i = 1, size(cut%outlines)
            call compare_outlines(cut, seen, i, k)
        end do
    end subroutine compare_cut

    !> Cuts a body with a plane.
    subroutine cut_with(body, through, normal, step, cut)
        type(body_type), intent(in) :: body             !! finished
        real(dp), intent(in) :: through(3)              !! a point of the plane, deck units
        real(dp), intent(in) :: normal(3)               !! of it
        type(decimal_type), intent(in) :: step          !! of STA, deck units
        type(cut_type), intent(out) :: cut              !! the cut
        type(request_type) :: request
        type(body_type) :: half
        type(error_type), allocatable :: error

        half = body
        half%is_symmetric = .false.
        call plane_through(through, normal, request%plane, error)
        if (allocated(error)) error stop 'a random plane is none'
        request%rule = cut_rule%step
        call new_grid(decimal_type(), step, request%grid, error)
        if (allocated(error)) error stop 'a random step is none'
        call make_cut(half, request, cut, error)
        if (allocated(error)) error stop 'a random plane cannot be cut'
    end subroutine cut_with

    !> Each point of an outline must be one of the other cut.
    subroutine compare_outlines(cut, seen, number, k)
        type(cut_type), intent(in) :: cut       !! of the first guise
        type(cut_type), intent(in) :: seen      !! of another
        integer, intent(in) :: number           !! of the outline
        integer, intent(in) :: k                !! which guise
        real(dp) :: nearest
        integer :: i, j, p

        do p = 1, size(cut%outlines(number)%points)
            nearest = huge(1.0_dp)
            do i = 1, size(seen%outlines)
                do j = 1, size(seen%outlines(i)%points)
                    nearest = min(nearest, norm2(in_first(seen%outlines(i)%points(j)%at, k) &
                        - cut%outlines(number)%points(p)%at))
                end do
            end do
            call take(worst(k)%cut, nearest)
        end do
    end subroutine compare_outlines

    !> A point of a guise as the first has it.
    function in_first(at, k) result(moved)
        real(dp), intent(in) :: at(3)   !! STA, BL, WL of the guise
        integer, intent(in) :: k        !! which guise
        real(dp) :: moved(3)
        moved = guise(k)%mirror*(at - guise(k)%shift)/guise(k)%scale
    end function in_first

    !> Keeps the largest of errors. One that is no number counts as huge.
    subroutine take(largest, error)
        real(dp), intent(inout) :: largest  !! so far
        real(dp), intent(in) :: error       !! another
        if (.not. abs(error) <= largest) largest = abs(error)
    end subroutine take

end program test_random_body
