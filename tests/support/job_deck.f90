!> Body decks for tests: a deck as one text with `|` between its lines, its job, its faults in
!> words.
module support_job_deck
    use base_error, only: error_type
    use base_fault, only: fault_list_type, severity
    use base_text, only: to_text
    use deck_job, only: job_type
    use deck_job_reader, only: read_job
    use deck_kind, only: opening_type, read_opening
    use deck_source, only: source_type
    implicit none (type, external)
    private

    public :: job_of, faults_of, words_of

    !> Two control lines and a section, five lines, to put in front of cards under test.
    character(*), parameter, public :: body_text = &
        'LINE,TOP,SIDE,5.|LINE,SHL,SIDE,4.|LINE,SHL,PLAN,4.|LINE,MHB,SIDE,0.|LINE,MHB,PLAN,5.|'// &
        'SECTION,UP,TOP,SHL,MHB,0.,999.999|'

contains

    !> Reads a deck.
    subroutine job_of(deck, job, faults)
        character(*), intent(in) :: deck                !! its lines with `|` between them
        type(job_type), intent(out) :: job              !! the job
        type(fault_list_type), intent(out) :: faults    !! what is wrong with it
        type(source_type) :: source
        type(opening_type) :: opening
        type(error_type), allocatable :: error
        character(:), allocatable :: text
        integer :: i

        text = deck
        do i = 1, len(text)
            if (text(i:i) == '|') text(i:i) = new_line('a')
        end do
        call source%from_text(text)
        call read_opening(source, opening, faults, error)
        call read_job(source, opening%heading, job, faults, error)
    end subroutine job_of

    !> What is wrong with a deck, in words.
    function faults_of(deck) result(words)
        character(*), intent(in) :: deck !! its lines with `|` between them
        character(:), allocatable :: words
        type(job_type) :: job
        type(fault_list_type) :: faults
        call job_of(deck, job, faults)
        words = words_of(faults)
    end function faults_of

    !> Faults in words, one behind the other: `3:9-16 error: what is wrong|`.
    function words_of(faults) result(words)
        type(fault_list_type), intent(in) :: faults !! the faults
        character(:), allocatable :: words
        integer :: i

        words = ''
        do i = 1, faults%count
            associate (fault => faults%item(i))
                words = words//to_text(fault%line)//':'//to_text(fault%first)//'-'// &
                    to_text(fault%last)//' '
                words = words//trim(merge('error  ', 'warning', fault%severity == severity%error))
                words = words//': '//fault%message//'|'
            end associate
        end do
    end function words_of

end module support_job_deck
