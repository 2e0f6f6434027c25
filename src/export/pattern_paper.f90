!> The paper that patterns are printed on.
module export_pattern_paper
    use base_error, only: cause, error_type, fail
    use base_kinds, only: dp
    use export_pattern_number, only: inches
    use export_settings, only: settings_type
    implicit none (type, external)
    private

    public :: paper_type, find_paper

    !> What paper may be.
    type, public :: paper_list
        integer :: fitted = 0   !! as large as the pattern
        integer :: roll = 1     !! of one width, as long as the pattern
        integer :: sheets = 2   !! of one size: the pattern is tiled
    end type paper_list

    !> The kinds by name.
    type(paper_list), parameter, public :: paper_kind = paper_list()

    !> Paper.
    type :: paper_type
        integer :: kind = 0             !! one of `paper_kind%...`
        real(dp) :: size(2) = 0.0_dp    !! of a sheet upright, width and height; of a roll its width
        real(dp) :: margin = 0.5_dp     !! that can't be printed, and a little more, in
        real(dp) :: overlap = 0.5_dp    !! of tiles, in
        logical :: is_upright = .false. !! it can't be used across
    end type paper_type

    !> Inches of a millimetre.
    real(dp), parameter :: mm = 1.0_dp/25.4_dp
    !> Sheets (ISO 216; ANSI/ASME Y14.1), and the margin of printers at home, in.
    character(*), parameter :: names(4) = [character(7) :: 'a4', 'letter', 'a3', 'tabloid']
    real(dp), parameter :: sizes(2, 4) = reshape([210.0_dp*mm, 297.0_dp*mm, 8.5_dp, 11.0_dp, &
        297.0_dp*mm, 420.0_dp*mm, 11.0_dp, 17.0_dp], [2, 4]), printer_margin = 0.4_dp
    !> The narrowest roll, and overlaps that can be glued and leave something of a sheet: in.
    real(dp), parameter :: narrowest_roll = 8.0_dp, least_overlap = 0.25_dp, most_overlap = 2.0_dp

contains

    !> Finds the paper asked for. Fails with `cause%usage` where it can't be: a name that is none,
    !> a roll too narrow, an overlap too small or too large.
    pure subroutine find_paper(settings, inch, paper, error)
        type(settings_type), intent(in) :: settings         !! what is asked for
        real(dp), intent(in) :: inch                        !! inches of a unit of its lengths
        type(paper_type), intent(out) :: paper              !! where there is no error
        type(error_type), allocatable, intent(out) :: error !! see above
        integer :: which

        if (.not. allocated(settings%paper)) return
        if (settings%paper == '') return
        if (settings%paper == 'roll') then
            paper%kind = paper_kind%roll
            paper%size(1) = inch*settings%roll_width
            paper%is_upright = .true.
            if (paper%size(1) < narrowest_roll) call fail(error, cause%usage, 'a roll '// &
                inches(paper%size(1))//' in wide; it takes '//inches(narrowest_roll)//' in or more')
        else
            which = findloc(names == settings%paper, .true., dim=1)
            if (which == 0) then
                call fail(error, cause%usage, 'paper '//settings%paper// &
                    '; there are a4, letter, a3, tabloid and roll')
                return
            end if
            paper%kind = paper_kind%sheets
            paper%size = sizes(:, which)
            paper%margin = printer_margin
        end if
        if (allocated(error)) return
        if (settings%overlap > 0.0_dp) paper%overlap = inch*settings%overlap
        if (paper%overlap < least_overlap .or. paper%overlap > most_overlap) &
            call fail(error, cause%usage, 'tiles that overlap by '//inches(paper%overlap)// &
            ' in; it takes '//inches(least_overlap)//' to '//inches(most_overlap)//' in')
    end subroutine find_paper

end module export_pattern_paper
