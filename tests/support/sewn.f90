!> Skins made by hand: surfaces sewn where their corners and sides are the same numbers. A box and a
!> ball.
module support_sewn
    use base_exact, only: is_equal
    use base_kinds, only: dp
    use export_shell, only: edge_type, face_type, side_type, skin_model_type, &
        vertex_type
    use geom_bspline, only: bspline_type, reversed_spline
    use geom_bspline_surface, only: bspline_surface_type, edge_spline, surface_side
    implicit none (type, external)
    private

    public :: box_skin, ball_skin

    !> Directions of BL and WL a quarter of a turn apart, from the bottom to starboard.
    real(dp), parameter :: turn(2, 5) = reshape([0.0_dp, -1.0_dp, 1.0_dp, 0.0_dp, 0.0_dp, 1.0_dp, &
        -1.0_dp, 0.0_dp, 0.0_dp, -1.0_dp], [2, 5])

contains

    !> A box of four bilinear sides and two flat caps.
    function box_skin(low, high) result(skin)
        real(dp), intent(in) :: low(3)      !! its least corner: STA, BL, WL
        real(dp), intent(in) :: high(3)     !! its greatest corner
        type(skin_model_type) :: skin
        real(dp) :: ring(2, 5), corner(3, 2, 2)
        integer :: i

        ring = reshape([low(2), low(3), high(2), low(3), high(2), high(3), low(2), high(3), &
            low(2), low(3)], [2, 5])
        call start(skin)
        do i = 1, 4
            corner(:, 1, 1) = [low(1), ring(:, i)]
            corner(:, 2, 1) = [high(1), ring(:, i)]
            corner(:, 1, 2) = [low(1), ring(:, i + 1)]
            corner(:, 2, 2) = [high(1), ring(:, i + 1)]
            call sew(skin, bspline_surface_type([1, 1], [0.0_dp, 0.0_dp, 1.0_dp, 1.0_dp], &
                [0.0_dp, 0.0_dp, 1.0_dp, 1.0_dp], corner, reshape([1.0_dp, 1.0_dp, 1.0_dp, &
                1.0_dp], [2, 2])), .false.)
        end do
        call flat_face(skin, low, [-1.0_dp, 0.0_dp, 0.0_dp], 4)
        call flat_face(skin, high, [1.0_dp, 0.0_dp, 0.0_dp], 2)
        call close_shell(skin, .true.)
    end function box_skin

    !> A ball about the origin of eight octants, each shrunk to a point at the nose or the tail.
    function ball_skin(radius) result(skin)
        real(dp), intent(in) :: radius !! above zero
        type(skin_model_type) :: skin
        integer :: i

        call start(skin)
        do i = 1, 4
            call sew(skin, octant(radius, turn(:, i:i + 1), .true.), .false.)
            call sew(skin, octant(radius, turn(:, i:i + 1), .false.), .false.)
        end do
        call close_shell(skin, .true.)
    end function ball_skin

    !> An eighth of a sphere: quarters of circles as rational parabolas, turned about the STA axis
    !> ("The NURBS Book", 8.5).
    pure function octant(radius, between, is_fore) result(surface)
        real(dp), intent(in) :: radius          !! above zero
        real(dp), intent(in) :: between(2, 2)   !! directions in BL and WL
        logical, intent(in) :: is_fore          !! from the nose, else to the tail
        type(bspline_surface_type) :: surface
        real(dp) :: meridian(2, 3), around(2, 3), weight(3)
        integer :: i, j

        weight = [1.0_dp, sqrt(0.5_dp), 1.0_dp]
        around = reshape([between(:, 1), between(:, 1) + between(:, 2), between(:, 2)], [2, 3])
        meridian = radius*reshape([-1.0_dp, 0.0_dp, -1.0_dp, 1.0_dp, 0.0_dp, 1.0_dp], [2, 3])
        if (.not. is_fore) meridian = radius*reshape([0.0_dp, 1.0_dp, 1.0_dp, 1.0_dp, 1.0_dp, &
            0.0_dp], [2, 3])
        surface%degree = 2
        surface%u_knot = [0.0_dp, 0.0_dp, 0.0_dp, 1.0_dp, 1.0_dp, 1.0_dp]
        surface%v_knot = surface%u_knot
        allocate (surface%pole(3, 3, 3), surface%weight(3, 3))
        do j = 1, 3
            do i = 1, 3
                surface%pole(:, i, j) = [meridian(1, i), meridian(2, i)*around(:, j)]
                surface%weight(i, j) = weight(i)*weight(j)
            end do
        end do
    end function octant

    !> A skin of nothing.
    subroutine start(skin)
        type(skin_model_type), intent(inout) :: skin !! becomes empty
        allocate (skin%vertices(0), skin%edges(0), skin%faces(0), skin%shells(0))
    end subroutine start

    !> Adds a face.
    subroutine sew(skin, surface, is_outward)
        type(skin_model_type), intent(inout) :: skin        !! gets it
        type(bspline_surface_type), intent(in) :: surface   !! all of it is the face
        logical, intent(in) :: is_outward                   !! u x v points out
        type(face_type) :: face
        type(side_type) :: loop(4)
        integer :: i
        character(8) :: name

        do i = 1, 4
            loop(i) = side_of(skin, edge_spline(surface, i))
        end do
        loop(3:4)%is_forward = .not. loop(3:4)%is_forward
        if (.not. is_outward) then
            loop = loop(4:1:-1)
            loop%is_forward = .not. loop%is_forward
        end if
        write (name, '(a,i0)') 'FACE ', size(skin%faces) + 1
        face%name = trim(name)
        face%section = 'HAND'
        face%surface = surface
        face%is_outward = is_outward
        face%is_exact = .true.
        allocate (face%sides, source=loop)
        face%spans = 1
        call add_face(skin, face)
    end subroutine sew

    !> Adds a flat face over the sides of the four faces before it.
    subroutine flat_face(skin, origin, normal, side)
        type(skin_model_type), intent(inout) :: skin    !! gets it
        real(dp), intent(in) :: origin(3)               !! of the plane
        real(dp), intent(in) :: normal(3)               !! outward
        integer, intent(in) :: side                     !! one of `surface_side%...`
        type(face_type) :: face
        integer :: i
        character(8) :: name

        write (name, '(a,i0)') 'FACE ', size(skin%faces) + 1
        face%name = trim(name)
        face%section = ''
        face%is_flat = .true.
        face%origin = origin
        face%normal = normal
        face%is_exact = .true.
        allocate (face%sides(4))
        do i = 1, 4
            face%sides(i) = side_of(skin, edge_spline(skin%faces(i)%surface, side))
            if (side == surface_side%u_from) face%sides(i)%is_forward = &
                .not. face%sides(i)%is_forward
        end do
        if (side == surface_side%u_from) face%sides = face%sides(4:1:-1)
        call add_face(skin, face)
    end subroutine flat_face

    !> The side of a face that runs along a curve; edge and vertices are added where they are new.
    function side_of(skin, curve) result(side)
        type(skin_model_type), intent(inout) :: skin    !! gets them
        type(bspline_type), intent(in) :: curve         !! along growing u or v
        type(side_type) :: side
        integer :: i, ends(2)

        call find_vertex(skin, curve%pole(:, 1), ends(1))
        call find_vertex(skin, curve%pole(:, size(curve%weight)), ends(2))
        if (all(is_equal(curve%pole, spread(curve%pole(:, 1), 2, size(curve%weight))))) then
            side = side_type(0, .true., ends(1))
            return
        end if
        do i = 1, size(skin%edges)
            side = side_type(i, is_same(skin%edges(i)%curve, curve), 0)
            if (side%is_forward) return
            if (is_same(skin%edges(i)%curve, reversed_spline(curve))) return
        end do
        call add_edge(skin, curve, ends)
        side = side_type(size(skin%edges), .true., 0)
    end function side_of

    !> Adds an edge. (An array constructor of components that have splines leaves them half freed.)
    subroutine add_edge(skin, curve, ends)
        type(skin_model_type), intent(inout) :: skin    !! gets it
        type(bspline_type), intent(in) :: curve         !! in space
        integer, intent(in) :: ends(2)                  !! vertices
        type(edge_type), allocatable :: grown(:)
        integer :: last

        last = size(skin%edges) + 1
        allocate (grown(last))
        grown(:last - 1) = skin%edges
        grown(last)%curve = curve
        grown(last)%from = ends(1)
        grown(last)%to = ends(2)
        call move_alloc(grown, skin%edges)
    end subroutine add_edge

    !> Adds a face.
    subroutine add_face(skin, face)
        type(skin_model_type), intent(inout) :: skin    !! gets it
        type(face_type), intent(in) :: face             !! new
        type(face_type), allocatable :: grown(:)
        integer :: last

        last = size(skin%faces) + 1
        allocate (grown(last))
        grown(:last - 1) = skin%faces
        grown(last) = face
        call move_alloc(grown, skin%faces)
    end subroutine add_face

    !> The vertex at a place; it is added where it is new.
    subroutine find_vertex(skin, at, which)
        type(skin_model_type), intent(inout) :: skin    !! may get it
        real(dp), intent(in) :: at(3)                   !! STA, BL, WL
        integer, intent(out) :: which                   !! its number
        do which = 1, size(skin%vertices)
            if (all(is_equal(skin%vertices(which)%at, at))) return
        end do
        skin%vertices = [skin%vertices, vertex_type(at)]
    end subroutine find_vertex

    !> True where two curves have the same poles and weights.
    pure logical function is_same(p, q)
        type(bspline_type), intent(in) :: p !! any
        type(bspline_type), intent(in) :: q !! any
        is_same = size(p%weight) == size(q%weight)
        if (is_same) is_same = all(is_equal(p%pole, q%pole)) .and. &
            all(is_equal(p%weight, q%weight))
    end function is_same

    !> Makes one shell of all faces.
    subroutine close_shell(skin, is_closed)
        type(skin_model_type), intent(inout) :: skin    !! gets it
        logical, intent(in) :: is_closed                !! every edge is used twice
        integer :: i
        if (allocated(skin%shells)) deallocate (skin%shells)
        allocate (skin%shells(1))
        allocate (skin%shells(1)%faces(size(skin%faces)))
        skin%shells(1)%faces = [(i, i=1, size(skin%faces))]
        skin%shells(1)%is_closed = is_closed
    end subroutine close_shell

end module support_sewn
