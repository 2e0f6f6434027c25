!> A deck of an ellipsoid about the origin, 5 long forward and aft, whose half-breadth B and half
!> height C vary: what it measures is known in closed form. Shoulders are at 3-4-5 points.
module support_ellipsoid
    use base_fault, only: fault_list_type
    use support_job_deck, only: words_of
    use support_tap, only: tap_type
    use sweep_study, only: new_study, study_type
    implicit none (type, external)
    private

    public :: ellipsoid_text, ellipsoid_study

contains

    !> The deck, with cards of a sweep behind it.
    pure function ellipsoid_text(vary_b, vary_c, cards) result(text)
        character(*), intent(in) :: vary_b  !! range of B: `1.,3.,5`
        character(*), intent(in) :: vary_c  !! range of C
        character(*), intent(in) :: cards   !! their lines with `|` between them
        character(:), allocatable :: text
        integer :: i

        text = 'CLOSE|LINE,MHB,SIDE,0.|LINE,MHB,PLAN|'// &
            '-5.,0.,999.999,-3.,1.6,0.,2.,0.|VARY,Y3,B,'//vary_b//'|VARY,TIED,Y2,B,.8|'// &
            '0.,2.,0.,3.,1.6,5.,0.,999.999|VARY,TIED,Y1,B|VARY,TIED,Y2,B,.8|'// &
            'LINE,UCL,SIDE|'// &
            '-5.,0.,999.999,-3.,1.6,0.,2.,0.|VARY,Y3,C,'//vary_c//'|VARY,TIED,Y2,C,.8|'// &
            '0.,2.,0.,3.,1.6,5.,0.,999.999|VARY,TIED,Y1,C|VARY,TIED,Y2,C,.8|'// &
            'LINE,LCL,SIDE|'//line('C', -1)//'LINE,USH,SIDE|'//line('C', 8)// &
            'LINE,USH,PLAN|'//line('B', 6)//'LINE,LSH,SIDE|'//line('C', -8)// &
            'LINE,LSH,PLAN,USH|'// &
            'SECTION,UPPER,UCL,USH,MHB,0.,999.999|SECTION,LOWER,LCL,LSH,MHB,0.,999.999|'// &
            'STATION,0.|'//cards
        do i = 1, len(text)
            if (text(i:i) == '|') text(i:i) = new_line('a')
        end do
    end function ellipsoid_text

    !> Both cards of a line whose half axis is some tenths of a variable (-1: the variable, down).
    pure function line(name, tenths) result(text)
        character, intent(in) :: name   !! B or C
        integer, intent(in) :: tenths   !! see above
        character(:), allocatable :: text
        character(5) :: whole, part

        select case (tenths)
        case (-1)
            whole = '-1.'
            part = '-.8'
        case (8)
            whole = '.8'
            part = '.64'
        case (-8)
            whole = '-.8'
            part = '-.64'
        case default
            whole = '.6'
            part = '.48'
        end select
        text = '-5.,0.,999.999,-3.,1.,0.,2.,0.|VARY,TIED,Y3,'//name//','//trim(whole)// &
            '|VARY,TIED,Y2,'//name//','//trim(part)//'|0.,2.,0.,3.,1.,5.,0.,999.999|'// &
            'VARY,TIED,Y1,'//name//','//trim(whole)//'|VARY,TIED,Y2,'//name//','//trim(part)//'|'
    end function line

    !> The sweep of a deck that is in order.
    function ellipsoid_study(text, tap) result(study)
        character(*), intent(in) :: text        !! the deck
        type(tap_type), intent(inout) :: tap    !! counts a failure where it is not in order
        type(study_type) :: study
        type(fault_list_type) :: faults
        call new_study(text, study, faults)
        if (faults%count > 0) call tap%ok(.false., words_of(faults))
    end function ellipsoid_study

end module support_ellipsoid
