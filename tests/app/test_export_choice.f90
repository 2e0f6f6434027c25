!> Cuts chosen by number, by the name of their card, by their name in the file.
program test_export_choice
    use app_export_choice, only: choose_cuts
    use app_options, only: argument_type
    use base_error, only: cause, error_type
    use base_kinds, only: dp
    use base_text, only: to_text
    use cut_outline, only: cut_type
    use cut_plane, only: station_plane, waterline_plane
    use export_drawing, only: shape_type
    use export_drawing_name, only: cut_name
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(cut_type) :: cuts(4), many(20), none(0)
    integer :: i

    cuts(1)%plane = station_plane(0.0_dp)
    cuts(2)%plane = station_plane(20.0_dp)
    cuts(3)%plane = waterline_plane(-16.0_dp)
    cuts(3)%name = 'FLOOR'
    cuts(4)%plane = station_plane(4.0_dp)
    cuts(4)%name = 'FLOOR'
    call tap%same(chosen('', cuts), '1234', 'without a word all are chosen')
    call tap%same(chosen('2', cuts), '2', 'a number')
    call tap%same(chosen('4', cuts), '4', 'a number is none of a station')
    call tap%same(chosen('sta_20', cuts), '2', 'a name in the file')
    call tap%same(chosen('wl_-16_Floor', cuts), '3', 'with that of its card')
    call tap%same(chosen('floor', cuts), '34', 'the name of a card may mean several')
    call tap%same(chosen('3,1,FLOOR', cuts), '134', 'several words in the order of the deck')
    call tap%same(chosen('5', cuts), 'no cut of the deck has this name or number; its cuts '// &
        'are: 1 STA_0, 2 STA_20, 3 WL_-16_FLOOR, 4 STA_4_FLOOR', 'a number beyond')
    call tap%same(chosen('1,STA', cuts), 'no cut of the deck has this name or number; its cuts '// &
        'are: 1 STA_0, 2 STA_20, 3 WL_-16_FLOOR, 4 STA_4_FLOOR', 'part of a name')
    call tap%same(chosen('1', none), 'the deck has no cut', 'a deck without cuts')
    call tap%same(chosen('', none), '', 'of which none is asked')
    do i = 1, size(many)
        many(i)%plane = station_plane(real(10*i, dp))
    end do
    call tap%has(chosen('x', many), '12 STA_120 and so on to 20', 'of many cuts some are listed')
    call tap%finish()

contains

    !> The numbers of the cuts chosen, or what is said behind the word.
    function chosen(list, of) result(text)
        character(*), intent(in) :: list    !! words with commas between them
        type(cut_type), intent(in) :: of(:) !! the cuts
        character(:), allocatable :: text
        type(argument_type), allocatable :: words(:)
        type(argument_type) :: word
        type(shape_type) :: shapes(size(of))
        type(error_type), allocatable :: error
        logical, allocatable :: is_chosen(:)
        integer :: i

        allocate (words(0))
        word%text = ''
        do i = 1, len(list)
            if (list(i:i) /= ',') word%text = word%text//list(i:i)
            if (list(i:i) /= ',' .and. i < len(list)) cycle
            words = [words, word]
            word%text = ''
        end do
        do i = 1, size(of)
            shapes(i)%name = trim(cut_name(of(i)))
            shapes(i)%number = i
        end do
        call choose_cuts(words, shapes, of%name, is_chosen, error)
        text = ''
        if (allocated(error)) then
            if (error%cause == cause%usage) text = error%message(index(error%message, ': ') + 2:)
        else
            do i = 1, size(is_chosen)
                if (is_chosen(i)) text = text//to_text(i)
            end do
        end if
    end function chosen

end program test_export_choice
