!> The equations of a faired curve: a uniform cubic B-spline near measured points. With vertices V,
!> its points next to the measured ones are p(i) = (V(i) + 4 V(i+1) + V(i+2))/6, and
!>
!>     E2 = sum of integral |r''|**2 du,   E3 = sum of integral |r'''|**2 du
!>     D = sum of weight(i) |p(i) - q(i)|**2,   S = 1/2 sum of integral r x r' du
!>
!> are quadratic forms of the V. Points of the plane are taken as complex numbers z = x + i y. The
!> least of beta E2 + gamma E3 + D + lambda S is where
!>
!>     (H - i lambda W) z = b,   S = 1/2 Im(conj(z) . W z)
!>
!> with a real symmetric H and a real antisymmetric W: a Hermitian band. It is a least as long as
!> the matrix is positive definite, which Cholesky's factors tell.
!>
!> A curve that is held at its ends has its first and last p instead of its first and last V as
!> unknowns, and these are known. A closed curve is a ring of vertices; the ring is folded flat, so
!> that its matrix is a band too.
!>
!> Source: seed 002, equations (1) to (12), with (8) and the gradients corrected
!> (doc/theory-fairing.md); complex form, held ends and closed form are added.
module geom_fairing_system
    use base_error, only: error_type
    use base_kinds, only: dp
    use geom_lapack, only: solve_hermitian
    use geom_ring_band, only: folded
    implicit none (type, external)
    private

    public :: fairing_data_type, system_type, new_system, solve_system, form_area, turned
    public :: vertices_of, spline_energy, spline_area

    !> The ways a faired curve ends.
    type, public :: end_list
        integer :: free = 1     !! it begins and ends near the first and the last point
        integer :: held = 2     !! it begins and ends in them
        integer :: closed = 3   !! it is closed: behind the last point comes the first
    end type end_list
    type(end_list), parameter, public :: fairing_end = end_list()

    !> What is to be faired.
    type :: fairing_data_type
        real(dp), allocatable :: point(:, :)    !! measured, in order, deck units: (2, points)
        real(dp), allocatable :: weight(:)      !! of each: 0 for none
        real(dp) :: beta = 0.5_dp               !! share of E2 in the energy; the rest is of E3
        integer :: ends = 1                     !! one of `fairing_end%...`
    end type fairing_data_type

    !> The equations. Unknowns stand in their places along the band.
    type :: system_type
        integer, allocatable :: place(:)        !! of each vertex
        real(dp), allocatable :: stiff(:, :)    !! H: (width + 1, n), the diagonal last
        real(dp), allocatable :: turn(:, :)     !! W, upper half, in the same shape
        complex(dp), allocatable :: right(:)    !! b
        complex(dp), allocatable :: known(:)    !! first and last p where they are held
        integer :: ends = 1                     !! one of `fairing_end%...`
    end type system_type

    !> Shares of the vertices in a point, times 6.
    real(dp), parameter :: share(3) = [1.0_dp, 4.0_dp, 1.0_dp]/6.0_dp
    !> Integrals of b'' b'', b''' b''' and (b b' - b' b)/2 over a segment, b its four B-splines.
    real(dp), parameter :: bending(4, 4) = reshape([2.0_dp, -3.0_dp, 0.0_dp, 1.0_dp, &
        -3.0_dp, 6.0_dp, -3.0_dp, 0.0_dp, 0.0_dp, -3.0_dp, 6.0_dp, -3.0_dp, &
        1.0_dp, 0.0_dp, -3.0_dp, 2.0_dp], [4, 4])/6.0_dp
    real(dp), parameter :: jerk(4, 4) = reshape([1.0_dp, -3.0_dp, 3.0_dp, -1.0_dp, &
        -3.0_dp, 9.0_dp, -9.0_dp, 3.0_dp, 3.0_dp, -9.0_dp, 9.0_dp, -3.0_dp, &
        -1.0_dp, 3.0_dp, -3.0_dp, 1.0_dp], [4, 4])
    real(dp), parameter :: sweep(4, 4) = reshape([0.0_dp, -31.0_dp, -28.0_dp, -1.0_dp, &
        31.0_dp, 0.0_dp, -183.0_dp, -28.0_dp, 28.0_dp, 183.0_dp, 0.0_dp, -31.0_dp, &
        1.0_dp, 28.0_dp, 31.0_dp, 0.0_dp], [4, 4])/720.0_dp

contains

    !> The equations of the faired curve near points.
    pure type(system_type) function new_system(given) result(system)
        type(fairing_data_type), intent(in) :: given !! sound: see `fair` of `geom_fairing`
        integer :: points, count, width, i

        points = size(given%point, 2)
        system%ends = given%ends
        count = merge(points, points + 2, given%ends == fairing_end%closed)
        width = min(count - 1, merge(6, 3, given%ends == fairing_end%closed))
        allocate (system%place(count), system%known(0))
        system%place = [(i, i = 1, count)]
        if (given%ends == fairing_end%closed) system%place = folded(count)
        if (given%ends == fairing_end%held) system%known = &
            cmplx(given%point(1, [1, points]), given%point(2, [1, points]), dp)
        allocate (system%stiff(width + 1, count), source=0.0_dp)
        allocate (system%turn(width + 1, count), source=0.0_dp)
        allocate (system%right(count))
        system%right = (0.0_dp, 0.0_dp)
        do i = 1, segments_of(system)
            call add_segment(system, i, given%beta)
        end do
        do i = 1, points
            call add_point(system, i, cmplx(given%point(1, i), given%point(2, i), dp), &
                given%weight(i))
        end do
    end function new_system

    !> Segments of the curve.
    pure integer function segments_of(system) result(count)
        type(system_type), intent(in) :: system !! any
        count = size(system%place) - merge(0, 3, system%ends == fairing_end%closed)
    end function segments_of

    !> The places of vertices from a number on, around the ring where it is one.
    pure function places_from(system, first, count) result(place)
        type(system_type), intent(in) :: system !! any
        integer, intent(in) :: first            !! number of the first vertex
        integer, intent(in) :: count            !! how many vertices
        integer :: place(count)
        integer :: i
        place = system%place([(1 + modulo(first + i - 2, size(system%place)), i = 1, count)])
    end function places_from

    !> Adds the energy and the area of a segment.
    pure subroutine add_segment(system, number, beta)
        type(system_type), intent(inout) :: system  !! gets them
        integer, intent(in) :: number               !! of the segment, from 1
        real(dp), intent(in) :: beta                !! share of E2
        real(dp) :: change(4, 4), stiff(4, 4), turn(4, 4)
        integer :: i

        change = 0.0_dp
        do i = 1, 4
            change(i, i) = 1.0_dp
        end do
        if (system%ends == fairing_end%held) then
            if (number == 1) change(1, :3) = [6.0_dp, -4.0_dp, -1.0_dp]
            if (number == segments_of(system)) change(4, 2:) = [-1.0_dp, -4.0_dp, 6.0_dp]
        end if
        stiff = 2.0_dp*(beta*bending + (1.0_dp - beta)*jerk)
        stiff = matmul(transpose(change), matmul(stiff, change))
        turn = matmul(transpose(change), matmul(sweep, change))
        call add_block(places_from(system, number, 4), stiff, system%stiff)
        call add_block(places_from(system, number, 4), turn, system%turn)
    end subroutine add_segment

    !> Adds the pull of a measured point.
    pure subroutine add_point(system, number, at, weight)
        type(system_type), intent(inout) :: system  !! gets it
        integer, intent(in) :: number               !! of the point, from 1
        complex(dp), intent(in) :: at               !! the point
        real(dp), intent(in) :: weight              !! its weight
        integer :: place(3)
        real(dp) :: pull(3, 3)

        if (system%ends == fairing_end%held .and. (number == 1 .or. &
            number == size(system%place) - 2)) return
        place = places_from(system, number, 3)
        pull = 2.0_dp*weight*spread(share, 2, 3)*spread(share, 1, 3)
        call add_block(place, pull, system%stiff)
        system%right(place) = system%right(place) + scaled(at, 2.0_dp*weight*share)
    end subroutine add_point

    !> Adds a small matrix to the upper half of a band. A vertex may be there twice.
    pure subroutine add_block(place, block, band)
        integer, intent(in) :: place(:)         !! of its rows and columns
        real(dp), intent(in) :: block(:, :)     !! the matrix
        real(dp), intent(inout) :: band(:, :)   !! the diagonal last
        integer :: i, j, row

        do j = 1, size(place)
            do i = 1, size(place)
                if (place(i) > place(j)) cycle
                row = size(band, 1) + place(i) - place(j)
                band(row, place(j)) = band(row, place(j)) + block(i, j)
            end do
        end do
    end subroutine add_block

    !> The unknowns at a multiplier.
    !>
    !> Fails with `cause%singular` where there is no least: the multiplier is beyond the critical
    !> one, or the points leave the curve free.
    pure subroutine solve_system(system, lambda, z, error)
        type(system_type), intent(in) :: system             !! any
        real(dp), intent(in) :: lambda                      !! the multiplier
        complex(dp), intent(inout) :: z(:)                  !! right side, then unknowns
        type(error_type), allocatable, intent(out) :: error !! see above
        complex(dp) :: band(size(system%stiff, 1), size(z)), x(size(z), 1)
        integer :: first, last, i

        band = cmplx(system%stiff, -lambda*system%turn, dp)
        x(:, 1) = z
        first = 1
        last = size(z)
        if (system%ends == fairing_end%held) then
            do i = 1, size(band, 1) - 1
                x(1 + i, 1) = x(1 + i, 1) - conjg(band(size(band, 1) - i, 1 + i))*z(1)
                x(last - i, 1) = x(last - i, 1) - band(size(band, 1) - i, last)*z(last)
            end do
            first = 2
            last = last - 1
        end if
        call solve_hermitian(band(:, first:last), x(first:last, :), error)
        if (.not. allocated(error)) z(first:last) = x(first:last, 1)
    end subroutine solve_system

    !> W z.
    pure function turned(system, z) result(product)
        type(system_type), intent(in) :: system !! any
        complex(dp), intent(in) :: z(:)         !! unknowns
        complex(dp) :: product(size(z))
        integer :: i, j, rows

        product = (0.0_dp, 0.0_dp)
        rows = size(system%turn, 1)
        do j = 1, size(z)
            do i = max(1, j - rows + 1), j - 1
                product(i) = product(i) + scaled(z(j), system%turn(rows + i - j, j))
                product(j) = product(j) - scaled(z(i), system%turn(rows + i - j, j))
            end do
        end do
    end function turned

    !> A complex number times a real one.
    elemental complex(dp) function scaled(z, factor)
        complex(dp), intent(in) :: z        !! any
        real(dp), intent(in) :: factor      !! any
        scaled = cmplx(factor*real(z, dp), factor*aimag(z), dp)
    end function scaled

    !> The area of unknowns, deck units squared.
    pure real(dp) function form_area(system, z) result(area)
        type(system_type), intent(in) :: system !! any
        complex(dp), intent(in) :: z(:)         !! unknowns
        area = 0.5_dp*aimag(dot_product(z, turned(system, z)))
    end function form_area

    !> The vertices of unknowns, deck units, shape (2, vertices).
    pure function vertices_of(system, z) result(vertex)
        type(system_type), intent(in) :: system !! any
        complex(dp), intent(in) :: z(:)         !! unknowns
        real(dp) :: vertex(2, size(z))
        integer :: last

        last = size(z)
        vertex(1, :) = real(z(system%place), dp)
        vertex(2, :) = aimag(z(system%place))
        if (system%ends /= fairing_end%held) return
        vertex(:, 1) = 6.0_dp*vertex(:, 1) - 4.0_dp*vertex(:, 2) - vertex(:, 3)
        vertex(:, last) = 6.0_dp*vertex(:, last) - 4.0_dp*vertex(:, last - 1) &
            - vertex(:, last - 2)
    end function vertices_of

    !> E2 and E3 of a curve, deck units squared.
    pure function spline_energy(vertex, is_closed) result(energy)
        real(dp), intent(in) :: vertex(:, :)    !! deck units, shape (2, vertices)
        logical, intent(in) :: is_closed        !! behind the last vertex comes the first
        real(dp) :: energy(2)
        real(dp) :: four(2, 4)
        integer :: i, k, n

        n = size(vertex, 2)
        energy = 0.0_dp
        do i = 1, n - merge(0, 3, is_closed)
            four = vertex(:, [(1 + modulo(i + k - 1, n), k = 0, 3)])
            energy = energy + [sum(four*matmul(four, bending)), &
                sum((four(:, 4) - 3.0_dp*(four(:, 3) - four(:, 2)) - four(:, 1))**2)]
        end do
    end function spline_energy

    !> The area within a closed curve, positive where it runs counter-clockwise; of an open one, the
    !> area of the sector that it makes with the origin. Deck units squared.
    pure real(dp) function spline_area(vertex, is_closed) result(area)
        real(dp), intent(in) :: vertex(:, :)    !! deck units, shape (2, vertices)
        logical, intent(in) :: is_closed        !! behind the last vertex comes the first
        real(dp) :: four(2, 4)
        integer :: i, k, n

        n = size(vertex, 2)
        area = 0.0_dp
        do i = 1, n - merge(0, 3, is_closed)
            four = vertex(:, [(1 + modulo(i + k - 1, n), k = 0, 3)])
            area = area + dot_product(four(1, :), matmul(sweep, four(2, :)))
        end do
    end function spline_area

end module geom_fairing_system
