!> How clear a component is of the inside of the skin. The inside of the skin is the surface moved
!> inward by the thickness t; as a point inside at the distance d from the surface has the distance
!> d - t from it, the clearance of a point is its depth less t: the distance from the surface,
!> positive inside of the body and negative outside. The clearance of a sphere is that of its centre
!> less the radius, and that of a box the least of all its points.
module cut_clearance
    use base_kinds, only: dp
    use base_tolerances, only: decimal_noise, ulp
    use body_body, only: body_type
    use cut_clearance_depth, only: depth_of, depth_type
    use cut_clearance_map, only: map_type
    use cut_clearance_nearest, only: box_type
    implicit none (type, external)
    private

    public :: component_type, clearance_type, check_clearance

    !> The kinds of component, numbered as on the cards.
    type, public :: component_list
        integer :: point = 1    !! a point
        integer :: sphere = 2   !! a centre and a radius
        integer :: box = 3      !! two opposite corners, faces along the axes
    end type component_list

    !> The kinds by name.
    type(component_list), parameter, public :: component_kind = component_list()

    !> A component that must keep clear.
    type :: component_type
        integer :: kind = 1             !! one of `component_kind%...`
        character(8) :: name = ''       !! or blank
        real(dp) :: at(3) = 0.0_dp      !! point, centre or corner: STA, BL, WL, deck units
        real(dp) :: other(3) = 0.0_dp   !! of a box: the opposite corner
        real(dp) :: radius = 0.0_dp     !! of a sphere, deck units
        real(dp) :: clearance = 0.0_dp  !! asked for, deck units
        real(dp) :: skin = 0.0_dp       !! thickness of skin, deck units
    end type component_type

    !> How clear a component is.
    type :: clearance_type
        integer :: kind = 1                 !! one of `component_kind%...`
        character(8) :: name = ''           !! or blank
        real(dp) :: asked = 0.0_dp          !! clearance asked for, deck units
        logical :: has_gap = .false.        !! false: the body has no skin to be near to
        real(dp) :: gap = 0.0_dp            !! from the inside of the skin, deck units; negative
                                            !! where it is pierced
        logical :: is_short = .true.        !! the gap is less than asked
        real(dp) :: nearest(3) = 0.0_dp     !! on the outside of the skin: STA, BL, WL, deck units
        real(dp) :: inner(3) = 0.0_dp       !! below it on the inside of the skin
        real(dp) :: normal(3) = 0.0_dp      !! outward there; zero where there is none
        real(dp) :: touching(3) = 0.0_dp    !! point of the component nearest to the skin, or
                                            !! farthest beyond it
        integer :: section = 0              !! place in the body's list of sections
        logical :: is_abreast = .false.     !! all of it is within the stations of the body
        logical :: is_certain = .false.     !! normal and section do not disagree
        character(:), allocatable :: note   !! where something is to be said of it
    end type clearance_type

contains

    !> Checks a component.
    pure subroutine check_clearance(body, map, component, clearance)
        type(body_type), intent(in) :: body             !! finished
        type(map_type), intent(in) :: map               !! its samples
        type(component_type), intent(in) :: component   !! what must be clear
        type(clearance_type), intent(out) :: clearance  !! how clear it is
        type(depth_type) :: found
        type(box_type) :: box
        real(dp) :: noise

        clearance%kind = component%kind
        clearance%name = component%name
        clearance%asked = component%clearance
        box = box_of(component)
        found = depth_of(body, map, box)
        clearance%has_gap = found%foot%exists
        if (.not. clearance%has_gap) then
            clearance%note = 'the body has no skin'
            return
        end if
        clearance%gap = found%depth - component%radius - component%skin
        noise = decimal_noise*ulp*maxval(abs([found%foot%at, found%foot%touching]))
        clearance%is_short = clearance%gap < component%clearance - noise
        clearance%nearest = found%foot%at
        clearance%normal = found%foot%normal
        clearance%inner = found%foot%at - component%skin*found%foot%normal
        clearance%touching = touching_of(component, found)
        clearance%section = found%foot%section
        clearance%is_certain = found%is_certain
        clearance%is_abreast = box%lower(1) - component%radius >= minval(body%sections%from) &
            .and. box%upper(1) + component%radius <= maxval(body%sections%to)
        call remark(clearance)
    end subroutine check_clearance

    !> The box of a component; a sphere is its centre here.
    pure type(box_type) function box_of(component) result(box)
        type(component_type), intent(in) :: component !! any
        box = box_type(component%at, component%at)
        if (component%kind /= component_kind%box) return
        box = box_type(min(component%at, component%other), max(component%at, component%other))
    end function box_of

    !> The point of a component that is nearest to the skin, or farthest beyond it.
    pure function touching_of(component, found) result(touching)
        type(component_type), intent(in) :: component   !! what was checked
        type(depth_type), intent(in) :: found           !! its depth
        real(dp) :: touching(3), way(3)

        touching = found%foot%touching
        way = sign(1.0_dp, found%depth)*(found%foot%at - touching)
        if (norm2(way) > 0.0_dp) then
            touching = touching + component%radius*way/norm2(way)
        else
            touching = touching + component%radius*found%foot%normal
        end if
    end function touching_of

    !> Says what is to be said of a clearance.
    pure subroutine remark(clearance)
        type(clearance_type), intent(inout) :: clearance !! complete
        if (.not. clearance%is_abreast) then
            clearance%note = 'it extends beyond the stations of the body'
        else if (.not. clearance%is_certain) then
            clearance%note = 'the skin at the nearest point and the section at the station do '// &
                'not agree on which side it is; the section was believed'
        end if
    end subroutine remark

end module cut_clearance
