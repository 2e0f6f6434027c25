!> Faces before they are sewn: each with its bonds, the sides of its loop, which say what curve each
!> side is, which way it is run through and between which corners. Bonds of one key that are run
!> through in opposite ways become one edge.
module export_shell_panels
    use base_kinds, only: dp
    use base_text, only: compact
    use body_body, only: body_type
    use export_shell, only: face_type
    use export_shell_fit, only: rib_spline, track_spline
    use export_shell_ribs, only: ends_type, ribs_type
    use export_shell_rows, only: form
    use export_shell_stretch, only: stretch_type
    use export_shell_surfaces, only: fitted_type
    use geom_bspline, only: bspline_type
    use geom_bspline_surface, only: mirrored_surface
    implicit none (type, external)
    private

    public :: panel_type, bond_type, key_type, panels_of, mirrored_panel, station_words
    public :: operator(==)

    !> What a curve of a model is.
    type :: key_type
        integer :: stretch = 0              !! of a track; 0: a rib
        integer :: number = 0               !! of the track in its stretch, or of the rib
        logical :: is_port = .false.        !! its mirror image; not where this is itself
        integer :: side = 0                 !! of a rib where skin fore and aft are not sewn: 1 that
                                            !! of the skin aft of it, 2 fore of it
    end type key_type

    !> A side of a panel, or a point, which has no curve.
    type :: bond_type
        type(key_type) :: key               !! what it is
        type(bspline_type) :: curve         !! along the key's way; no poles: a point
        integer :: corner(2) = 0            !! from where to where the curve leads, in `ribs_type`
        logical :: is_forward = .true.      !! the loop runs as the curve does
        logical :: is_port = .false.        !! of a face of the mirrored half
        integer :: end = 0                  !! of a rib: 1 the face begins there, 2 it ends
    end type bond_type

    !> A face and its loop.
    type :: panel_type
        type(face_type) :: face                     !! without sides
        type(bond_type), allocatable :: bonds(:)    !! counter-clockwise, seen from outside
    end type panel_type

    interface operator(==)
        module procedure are_one
    end interface operator(==)

contains

    !> True for the keys of one curve.
    elemental logical function are_one(first, second)
        type(key_type), intent(in) :: first     !! a key
        type(key_type), intent(in) :: second    !! another
        are_one = first%stretch == second%stretch .and. first%number == second%number .and. &
            (first%is_port .eqv. second%is_port) .and. first%side == second%side
    end function are_one

    !> The panels of a fitted stretch, in the order of its slots. The loop of one begins with its
    !> start line and goes on, where dS/du x dS/dv points out of the body, around the aft end, along
    !> its finish line, around the fore end; else the other way.
    pure subroutine panels_of(body, stretch, fitted, ribs, which, panels)
        type(body_type), intent(in) :: body                         !! whole
        type(stretch_type), intent(in) :: stretch                   !! of it
        type(fitted_type), intent(in) :: fitted                     !! its surfaces
        type(ribs_type), intent(in) :: ribs                         !! of all stretches
        integer, intent(in) :: which                                !! number of the stretch
        type(panel_type), allocatable, intent(out) :: panels(:)     !! its faces
        type(bond_type) :: loop(4)
        integer :: k

        allocate (panels(size(stretch%slots)))
        do k = 1, size(panels)
            panels(k)%face = new_face(body, stretch, fitted, k)
            associate (slot => stretch%slots(k), face => panels(k)%face)
                if (slot%number == 0) &
                    call make_flat(ribs%ends(which), slot%track, ribs%corner, face)
                loop(1) = track_bond(1)
                loop(2) = rib_bond(2)
                loop(3) = track_bond(2)
                loop(4) = rib_bond(1)
                loop(3:4)%is_forward = .not. loop(3:4)%is_forward
                if (.not. face%is_outward) then
                    loop%is_forward = .not. loop%is_forward
                    loop = loop([1, 4, 3, 2])
                end if
            end associate
            panels(k)%bonds = loop
        end do
    contains
        !> The side along a track, aft.
        pure type(bond_type) function track_bond(end) result(bond)
            integer, intent(in) :: end !! 1: the start line, 2: the finish line
            associate (track => stretch%slots(k)%track(end))
                bond%key = key_type(stretch=which, number=track)
                bond%curve = track_spline(fitted%fit, track)
                bond%corner = ribs%ends(which)%corner(:, track)
            end associate
        end function track_bond

        !> The side along a rib, from the start line to the finish line.
        pure type(bond_type) function rib_bond(end) result(bond)
            integer, intent(in) :: end !! 1: fore, 2: aft
            integer :: rib
            rib = ribs%ends(which)%rib(end, k)
            bond%end = end
            bond%corner = ribs%ends(which)%corner(end, stretch%slots(k)%track)
            if (rib == 0) return
            bond%key = key_type(number=rib)
            bond%corner = ribs%rib(rib)%corner
            bond%is_forward = ribs%ends(which)%is_forward(end, k)
            bond%curve = rib_spline(ribs%rib(rib)%rows, ribs%corner(1, bond%corner(1)), &
                merge(form%line, fitted%form(k), ribs%rib(rib)%is_straight))
        end function rib_bond
    end subroutine panels_of

    !> The face of a slot; of a wall it has but the name.
    pure type(face_type) function new_face(body, stretch, fitted, k) result(face)
        type(body_type), intent(in) :: body         !! whole
        type(stretch_type), intent(in) :: stretch   !! of it
        type(fitted_type), intent(in) :: fitted     !! its surfaces
        integer, intent(in) :: k                    !! which slot

        face%section = ''
        face%name = 'WALL'
        associate (slot => stretch%slots(k))
            face%is_outward = slot%outward < 0.0_dp
            if (slot%number > 0) then
                face%section = trim(body%sections(slot%number)%name)
                face%name = face%section
                if (slot%section%is_port) face%name = face%section//' P'
                face%surface = fitted%surface(k)
                face%error = fitted%miss(k)%distance
                face%worst = fitted%miss(k)%at
                face%spans = size(fitted%span_miss)
                face%is_exact = fitted%is_exact(k)
            end if
        end associate
        face%name = face%name//' STA '//station_words(stretch%pace%from)//' TO '// &
            station_words(stretch%pace%to)
    end function new_face

    !> Makes a wall of a face.
    pure subroutine make_flat(ends, track, corners, face)
        type(ends_type), intent(in) :: ends         !! of its stretch
        integer, intent(in) :: track(2)             !! where it begins and finishes
        real(dp), intent(in) :: corners(:, :)       !! of `ribs_type`
        type(face_type), intent(inout) :: face      !! knows which way is out
        real(dp) :: rise

        rise = sum(corners(3, ends%corner(:, track(2))) - corners(3, ends%corner(:, track(1))))
        face%is_flat = .true.
        face%is_exact = .true.
        face%origin = corners(:, ends%corner(1, track(1)))
        face%normal = [0.0_dp, sign(1.0_dp, merge(-rise, rise, face%is_outward)), 0.0_dp]
    end subroutine make_flat

    !> The mirror image of a panel in BL 0: the same curves and surface but for the sign of BL, the
    !> loop run through the other way, its first side first again.
    pure type(panel_type) function mirrored_panel(panel) result(image)
        type(panel_type), intent(in) :: panel !! of the starboard half
        integer :: i

        image = panel
        image%face%is_port = .true.
        image%face%is_outward = .not. panel%face%is_outward
        i = len(panel%face%section) + 1
        image%face%name = panel%face%section//' P'//panel%face%name(i:)
        image%face%worst(2) = 0.0_dp - panel%face%worst(2)
        image%face%surface = mirrored_surface(panel%face%surface)
        image%bonds = image%bonds([1, 4, 3, 2])
        do i = 1, size(image%bonds)
            associate (bond => image%bonds(i))
                bond%is_forward = .not. bond%is_forward
                bond%is_port = .true.
                if (.not. allocated(bond%curve%pole)) cycle
                bond%key%is_port = any(abs(bond%curve%pole(2, :)) > 0.0_dp)
                bond%curve%pole(2, :) = 0.0_dp - bond%curve%pole(2, :)
            end associate
        end do
    end function mirrored_panel

    !> A station in a name: `14`, `-30`, `7.25`.
    pure function station_words(sta) result(words)
        real(dp), intent(in) :: sta !! deck units
        character(:), allocatable :: words
        words = compact(sta)
        if (words(len(words):) == '.') words = words(:len(words) - 1)
    end function station_words

end module export_shell_panels
