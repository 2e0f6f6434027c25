!> A duct: the surface through faired outlines at stations, in order. Outlines with points of
!> different number are brought to one number of vertices, exactly; one that runs clockwise is
!> turned, one that begins elsewhere than the one before it is begun at its point nearest to that in
!> direction. None of this moves an outline.
module body_duct
    use base_error, only: cause, error_type, fail
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use base_text, only: to_text
    use body_outline, only: find_outline, outline_type
    use body_panel, only: panel_type
    use deck_body_card, only: blame, warn
    use deck_duct, only: asked_duct_type => duct_type, first_outline
    use deck_job, only: body_type, name_length
    use geom_bezier, only: bezier_point
    use geom_bspline_surface, only: surface_point
    use geom_fairing_curve, only: uniform_segments
    use geom_ring_loft, only: new_ring_loft, ring_loft_surface, ring_loft_type
    use geom_ring_spline, only: refined_ring, ring_from, ring_unlikeness, turned_ring
    implicit none (type, external)
    private

    public :: duct_type, duct_outline_type, build_ducts, new_duct

    !> An outline of a duct.
    type :: duct_outline_type
        character(name_length) :: name = ''     !! its name
        real(dp) :: sta = 0.0_dp                !! its station, deck units
        integer :: points = 0                   !! measured
        logical :: is_turned = .false.          !! its points run clockwise, the duct does not
        integer :: first = 1                    !! the measured point with which it begins
    end type duct_outline_type

    !> A duct.
    type :: duct_type
        character(name_length) :: name = ''                     !! of its card
        type(duct_outline_type), allocatable :: outline(:)      !! from the foremost to the last
        type(ring_loft_type) :: loft                            !! the surface as rings
        type(panel_type) :: panel                               !! the same as a panel
    end type duct_type

    !> Vertices of a ring at most.
    integer, parameter :: most_vertices = 720
    !> Outlines are taken as they begin, unless another beginning is so much more like: by this
    !> factor, and where they are no more unlike than circles begun 15 degrees apart.
    real(dp), parameter :: more_like = 0.5_dp, like_enough = 0.034_dp
    !> An area below this part of the square of the size of an outline is none.
    real(dp), parameter :: least_area = 1.0e-9_dp
    !> Points of an outline at which its distance from the surface is measured, to each segment.
    integer, parameter :: points_each = 4

contains

    !> Builds the ducts of a body. One that can't be built is said of its card and left out; so is
    !> one of whose outlines it was said already.
    pure subroutine build_ducts(asked, outlines, ducts, faults)
        type(body_type), intent(in) :: asked                    !! as the deck has it
        type(outline_type), intent(in) :: outlines(:)           !! its outlines, faired
        type(duct_type), allocatable, intent(out) :: ducts(:)   !! in the order of the deck
        type(fault_list_type), intent(inout) :: faults          !! what is wrong is added
        type(duct_type) :: duct
        type(outline_type), allocatable :: through(:)
        type(error_type), allocatable :: error
        integer, allocatable :: number(:)
        integer :: i, k, field

        allocate (ducts(0))
        do i = 1, size(asked%duct)
            associate (card => asked%duct(i))
                number = [(find_outline(outlines, asked%outline(card%outline(k))%name), &
                    k = 1, size(card%outline))]
                if (any(number == 0)) cycle
                through = outlines(number)
                call new_duct(card%name, through, duct, field, error)
                if (allocated(error)) then
                    call blame(card%card, merge(2, first_outline - 1 + field, field == 0), &
                        'duct '//trim(card%name)//': '//error%message, faults)
                    cycle
                end if
                call warn_of_begins(card, duct, faults)
                ducts = [ducts, duct]
            end associate
        end do
    end subroutine build_ducts

    !> Warns of outlines that begin elsewhere.
    pure subroutine warn_of_begins(card, duct, faults)
        type(asked_duct_type), intent(in) :: card       !! the card
        type(duct_type), intent(in) :: duct             !! the duct
        type(fault_list_type), intent(inout) :: faults  !! gets the warnings
        integer :: k

        do k = 2, size(duct%outline)
            associate (outline => duct%outline(k))
                if (outline%first == 1) cycle
                call warn(card%card, first_outline - 1 + k, trim(outline%name)//' begins '// &
                    'elsewhere than '//trim(duct%outline(k - 1)%name)//', which would wind the '// &
                    'duct; it is begun with its point '//to_text(outline%first), faults)
            end associate
        end do
    end subroutine warn_of_begins

    !> The duct through outlines, their stations rising.
    !>
    !> Fails with `cause%no_area` where an outline encloses none; with `cause%too_many` where rings
    !> of one number of vertices would have too many; and as `new_ring_loft`.
    pure subroutine new_duct(name, outlines, duct, number, error)
        character(*), intent(in) :: name                    !! of the card
        type(outline_type), intent(in) :: outlines(:)       !! two or more
        type(duct_type), intent(out) :: duct                !! where there is no error
        integer, intent(out) :: number                      !! which outline is wrong; 0: no one
        type(error_type), allocatable, intent(out) :: error !! see above
        real(dp), allocatable :: ring(:, :, :)
        integer :: k, vertices

        duct%name = name
        allocate (duct%outline(size(outlines)))
        do number = 1, size(outlines)
            call check_area(outlines(number), error)
            if (allocated(error)) return
        end do
        number = 0
        call find_vertices(outlines, vertices, error)
        if (allocated(error)) return
        allocate (ring(2, vertices, size(outlines)))
        do k = 1, size(outlines)
            call begin_outline(outlines(k), duct%outline(k))
            ring(:, :, k) = refined_ring(counter_clockwise(outlines(k)), &
                vertices/duct%outline(k)%points)
            if (k > 1) call find_begin(ring(:, :, k - 1), ring(:, :, k), duct%outline(k))
        end do
        call new_ring_loft(ring, duct%outline%sta, duct%loft, error)
        if (.not. allocated(error)) call put_panel(ring, duct)
    end subroutine new_duct

    !> Fails with `cause%no_area` where an outline encloses no area.
    pure subroutine check_area(outline, error)
        type(outline_type), intent(in) :: outline           !! faired
        type(error_type), allocatable, intent(out) :: error !! see above
        real(dp) :: size_of(2)
        size_of = maxval(outline%fairing%vertex, dim=2) - minval(outline%fairing%vertex, dim=2)
        if (abs(outline%fairing%area) > least_area*sum(size_of**2)) return
        call fail(error, cause%no_area, 'outline '//trim(outline%name)//' encloses no area; '// &
            'its points stand in a line or cross over')
    end subroutine check_area

    !> The vertices of a ring: the least common multiple of the numbers of points.
    !>
    !> Fails with `cause%too_many`.
    pure subroutine find_vertices(outlines, vertices, error)
        type(outline_type), intent(in) :: outlines(:)       !! faired
        integer, intent(out) :: vertices                    !! of each ring
        type(error_type), allocatable, intent(out) :: error !! see above
        integer :: k, more

        vertices = 1
        do k = 1, size(outlines)
            associate (points => size(outlines(k)%fairing%vertex, 2))
                more = points/common_divisor(vertices, points)
                if (vertices > most_vertices/more) then
                    call fail(error, cause%too_many, 'the outlines up to '// &
                        trim(outlines(k)%name)//' have numbers of points without a common '// &
                        'multiple up to '//to_text(most_vertices)//'; give all the same '// &
                        'number, or numbers like 12 and 18')
                    return
                end if
                vertices = vertices*more
            end associate
        end do
    end subroutine find_vertices

    !> The greatest common divisor, by Euclid's algorithm.
    pure integer function common_divisor(one, other) result(divisor)
        integer, intent(in) :: one      !! above zero
        integer, intent(in) :: other    !! above zero
        integer :: rest, next
        divisor = one
        rest = other
        do while (rest > 0)
            next = mod(divisor, rest)
            divisor = rest
            rest = next
        end do
    end function common_divisor

    !> What is known of an outline before it is compared with others.
    pure subroutine begin_outline(outline, item)
        type(outline_type), intent(in) :: outline       !! faired
        type(duct_outline_type), intent(out) :: item    !! the outline in the duct
        item%name = outline%name
        item%sta = outline%sta
        item%points = size(outline%fairing%vertex, 2)
        item%is_turned = outline%fairing%area < 0.0_dp
    end subroutine begin_outline

    !> The vertices of an outline, counter-clockwise from its first point.
    pure function counter_clockwise(outline) result(vertex)
        type(outline_type), intent(in) :: outline !! faired
        real(dp), allocatable :: vertex(:, :)
        allocate (vertex, source=outline%fairing%vertex)
        if (outline%fairing%area < 0.0_dp) vertex = turned_ring(vertex)
    end function counter_clockwise

    !> Begins a ring where it is most like the one before it, if it is much more so than as given.
    pure subroutine find_begin(before, ring, item)
        real(dp), intent(in) :: before(:, :)            !! the ring before it
        real(dp), intent(inout) :: ring(:, :)           !! with as many vertices
        type(duct_outline_type), intent(inout) :: item  !! gets its first point
        real(dp) :: unlike, least, given
        integer :: parts, point, best

        parts = size(ring, 2)/item%points
        given = ring_unlikeness(before, ring)
        least = given
        best = 0
        do point = 1, item%points - 1
            unlike = ring_unlikeness(before, ring_from(ring, 1 + parts*point))
            if (unlike >= least) cycle
            least = unlike
            best = point
        end do
        if (given <= like_enough .or. least >= more_like*given) return
        ring = ring_from(ring, 1 + parts*best)
        item%first = 1 + merge(item%points - best, best, item%is_turned)
    end subroutine find_begin

    !> Makes the panel of a duct, and measures how far it is from the outlines.
    pure subroutine put_panel(ring, duct)
        real(dp), intent(in) :: ring(:, :, :)       !! of the outlines
        type(duct_type), intent(inout) :: duct      !! gets its panel
        real(dp) :: v, length
        integer :: k

        duct%panel%name = duct%name
        duct%panel%surface = ring_loft_surface(duct%loft)
        duct%panel%is_round = .true.
        duct%panel%has_image = .not. all([(is_astride(ring(:, :, k)), k = 1, size(ring, 3))])
        length = 0.0_dp
        associate (along => duct%loft%along%length)
            do k = 1, size(ring, 3)
                v = length/sum(along)
                if (k == size(ring, 3)) v = 1.0_dp
                call measure_ring(ring(:, :, k), duct%outline(k)%sta, v, duct%panel)
                if (k < size(ring, 3)) length = length + along(k)
            end do
        end associate
    end subroutine put_panel

    !> True for a ring that has BL 0 inside of it.
    pure logical function is_astride(ring)
        real(dp), intent(in) :: ring(:, :) !! BL, WL of its vertices
        real(dp) :: bl(size(ring, 2))
        bl = (ring(1, :) + 4.0_dp*cshift(ring(1, :), 1) + cshift(ring(1, :), 2))/6.0_dp
        is_astride = minval(bl) < 0.0_dp .and. maxval(bl) > 0.0_dp
    end function is_astride

    !> Measures how far the surface is from a ring.
    pure subroutine measure_ring(ring, sta, v, panel)
        real(dp), intent(in) :: ring(:, :)          !! BL, WL of its vertices
        real(dp), intent(in) :: sta                 !! its station, deck units
        real(dp), intent(in) :: v                   !! where the surface has it
        type(panel_type), intent(inout) :: panel    !! gets its error, if larger
        real(dp), allocatable :: pole(:, :, :)
        real(dp) :: t, at(3), off
        integer :: i, k

        allocate (pole, source=uniform_segments(ring, .true.))
        do i = 1, size(pole, 3)
            do k = 0, points_each - 1
                t = real(k, dp)/real(points_each, dp)
                at = surface_point(panel%surface, (real(i - 1, dp) + t)/real(size(pole, 3), dp), v)
                off = norm2(at - [sta, bezier_point(pole(:, :, i), t)])
                if (off <= panel%error) cycle
                panel%error = off
                panel%worst = at
            end do
        end do
    end subroutine measure_ring

end module body_duct
