!> What of a deck goes into a file: its cuts and control lines as curves, its bodies.
module app_export_parts
    use base_kinds, only: dp
    use body_body, only: body_type
    use body_panel, only: panel_type
    use export_drawing, only: drawing_type
    implicit none (type, external)
    private

    public :: parts_type, station_type, begin_parts

    !> A station that the deck cuts.
    type :: station_type
        integer :: body = 0             !! which body, in the order of `bodies`
        real(dp) :: sta = 0.0_dp        !! deck units
    end type station_type

    !> The parts.
    type :: parts_type
        type(drawing_type) :: drawing               !! cuts and lines, or cards, as curves
        type(body_type), allocatable :: bodies(:)   !! those with sections; in units of the deck
        type(panel_type), allocatable :: panels(:)  !! patches with their images; units of the deck
        integer, allocatable :: owner(:)            !! of each: body whose mesh has it and its
                                                    !! image; -1: such an image; 0: it stands
                                                    !! alone
        type(station_type), allocatable :: stations(:) !! in the order of the deck
        real(dp) :: factor = 1.0_dp                 !! units of the file in one of the deck
        logical :: is_body_deck = .false.           !! the deck is one of bodies
        logical :: is_faulty = .false.              !! a card was in error
    end type parts_type

contains

    !> Parts of a deck before any are there.
    pure subroutine begin_parts(deck, title, units, parts)
        character(*), intent(in) :: deck            !! its name, without folders
        character(*), intent(in) :: title           !! of it, or nothing
        character(*), intent(in) :: units           !! of it: INCHES, MM or FEET
        type(parts_type), intent(out) :: parts      !! without curves and bodies
        parts%drawing%deck = deck
        parts%drawing%title = title
        parts%drawing%units = units
        allocate (parts%drawing%cuts(0), parts%drawing%lines(0), parts%bodies(0), &
            parts%panels(0), parts%owner(0), parts%stations(0))
    end subroutine begin_parts

end module app_export_parts
