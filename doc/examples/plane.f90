!> Cuts the first body of a deck by any plane and prints the points:
!>
!>     plane DECK STA BL WL NX NY NZ
!>
!>     gfortran plane.f90 $(pkg-config --cflags --libs loft) -o plane
program plane
    use, intrinsic :: iso_fortran_env, only: dp => real64, error_unit
    use api_loft, only: at_plane, cut_deck, cut_type, deck_type, error_type, load_deck, point_type, &
        severity
    implicit none (type, external)

    type(deck_type) :: deck
    type(cut_type) :: cut
    type(error_type), allocatable :: error
    real(dp) :: number(6)
    integer :: i

    do i = 1, 6
        number(i) = number_of(word(i + 1))
    end do
    call load_deck(word(1), deck, error)
    if (.not. allocated(error)) then
        do i = 1, deck%faults%count
            associate (fault => deck%faults%item(i))
                write (error_unit, '(2a, i0, 4a)') word(1), ':', fault%line, ': ', &
                    merge('error  ', 'warning', fault%severity == severity%error), ': ', &
                    fault%message
            end associate
        end do
        call cut_deck(deck, at_plane(number(:3), number(4:)), cut, error)
    end if
    if (allocated(error)) then
        write (error_unit, '(2a)') 'plane: ', error%message
        stop 1
    end if
    print '(a)', 'section,sta,bl,wl,slope,curvature,bevel'
    do i = 1, size(cut%points)
        call print_point(cut%points(i), trim(cut%sections(cut%points(i)%section)))
    end do

contains

    !> Prints a point; a value that does not exist is an empty field.
    subroutine print_point(point, section)
        type(point_type), intent(in) :: point   !! of the cut
        character(*), intent(in) :: section     !! that it is of
        integer :: k

        write (*, '(a)', advance='no') section
        do k = 1, 3
            write (*, '(",", es24.16e3)', advance='no') point%at(k)
        end do
        call print_value(point%has_slope .and. .not. point%is_vertical, point%slope, &
            merge('inf', '   ', point%is_vertical))
        call print_value(point%has_curvature, point%curvature, '')
        call print_value(point%has_normal, point%bevel, '')
        print '()'
    end subroutine print_point

    !> Prints a value where it exists, else a word.
    subroutine print_value(exists, value, word)
        logical, intent(in) :: exists       !! there is a value
        real(dp), intent(in) :: value       !! the value
        character(*), intent(in) :: word    !! in its place
        if (exists) then
            write (*, '(",", es24.16e3)', advance='no') value
        else
            write (*, '(2a)', advance='no') ',', trim(word)
        end if
    end subroutine print_value

    !> A word of the command line, from 1.
    function word(number) result(text)
        integer, intent(in) :: number !! which
        character(:), allocatable :: text
        integer :: length
        call get_command_argument(number, length=length)
        allocate (character(length) :: text)
        call get_command_argument(number, text)
    end function word

    !> A word as a number.
    real(dp) function number_of(text)
        character(*), intent(in) :: text !! the word
        read (text, *) number_of
    end function number_of

end program plane
