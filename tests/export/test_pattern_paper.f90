!> Tests of paper.
program test_pattern_paper
    use base_error, only: error_type
    use base_kinds, only: dp
    use export_pattern_paper, only: find_paper, paper_kind, paper_type
    use export_settings, only: settings_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(settings_type) :: settings
    type(paper_type) :: paper
    type(error_type), allocatable :: error

    call find_paper(settings, 1.0_dp, paper, error)
    call tap%ok(.not. allocated(error) .and. paper%kind == paper_kind%fitted, &
        'without a word paper is as large as the pattern')
    call try('', 1.0_dp)
    call tap%ok(.not. allocated(error) .and. paper%kind == paper_kind%fitted, 'so it is for none')
    call try('letter', 1.0_dp)
    call tap%ok(paper%kind == paper_kind%sheets .and. &
        all(abs(paper%size - [8.5_dp, 11.0_dp]) < 1.0e-12_dp), 'letter is 8.5 by 11')
    call tap%near(paper%overlap, 0.5_dp, 1.0e-12_dp, 'tiles overlap by half an inch')
    call try('a4', 1.0_dp)
    call tap%ok(all(abs(25.4_dp*paper%size - [210.0_dp, 297.0_dp]) < 1.0e-12_dp), &
        'A4 is 210 by 297 mm')
    call try('a3', 1.0_dp)
    call tap%ok(all(abs(25.4_dp*paper%size - [297.0_dp, 420.0_dp]) < 1.0e-12_dp), 'A3 twice that')
    call try('tabloid', 1.0_dp)
    call tap%ok(all(abs(paper%size - [11.0_dp, 17.0_dp]) < 1.0e-12_dp), 'tabloid is 11 by 17')
    settings%roll_width = 914.4_dp
    settings%overlap = 12.7_dp
    call try('roll', 1.0_dp/25.4_dp)
    call tap%ok(paper%kind == paper_kind%roll, 'a roll is a roll')
    call tap%near(paper%size(1), 36.0_dp, 1.0e-12_dp, 'of 914.4 mm')
    call try('a4', 1.0_dp/25.4_dp)
    call tap%near(paper%overlap, 0.5_dp, 1.0e-12_dp, 'overlaps are in the unit of the drawing')
    settings%roll_width = 5.0_dp
    call try('roll', 1.0_dp)
    call tap%ok(allocated(error), 'a roll of 5 in is refused')
    if (allocated(error)) call tap%same(error%message, &
        'a roll 5.000 in wide; it takes 8.000 in or more', 'with what would do')
    call try('foolscap', 1.0_dp)
    call tap%ok(allocated(error), 'other paper is refused')
    if (allocated(error)) call tap%same(error%message, &
        'paper foolscap; there are a4, letter, a3, tabloid and roll', 'with what there is')
    call try('a4', 1.0_dp)
    call tap%ok(allocated(error), 'an overlap of 12.7 in is refused')
    settings%overlap = 0.1_dp
    call try('a4', 1.0_dp)
    call tap%ok(allocated(error), 'and one of a tenth')
    call tap%finish()

contains

    !> Looks for paper.
    subroutine try(name, inch)
        character(*), intent(in) :: name    !! of the paper
        real(dp), intent(in) :: inch        !! inches of a unit
        settings%paper = name
        call find_paper(settings, inch, paper, error)
    end subroutine try

end program test_pattern_paper
