!> The cuts that the cards of a body ask for. Several threads may make them side by side: they stand
!> in the order of the deck, and what is wrong with them is said in that order.
module api_computed_cuts
    use api_requests, only: requests_of
    use base_error, only: error_type
    use base_fault, only: fault_list_type
    use base_kinds, only: dp, i64
    use base_memory, only: has_little_memory
    use base_text, only: to_text
    use body_body, only: body_type
    use body_panel, only: panel_type
    use cut_outline, only: cut_type, has_panels, keep_cuts, room_of
    use cut_panel, only: cut_skin
    use cut_request, only: cut_fact, request_type
    use deck_body_card, only: blame, warn
    use deck_job, only: asked_cut_type => cut_type
    implicit none (type, external)
    private

    public :: make_cuts, say, how_type, made_type

    !> How cuts are made.
    type :: how_type
        integer :: facts = cut_fact%all     !! what is worked out for each point
        logical :: is_shared = .false.      !! by all threads that OpenMP gives
        integer :: room = 2048              !! that the cuts of a body may fill, MiB: with more, a
                                            !! step was surely mistyped
    end type how_type

    !> Cuts that were made.
    type :: made_type
        type(cut_type), allocatable :: cuts(:)  !! in the order of the deck
        integer, allocatable :: cards(:)        !! which card each is of
    end type made_type

    !> A cut asked for.
    type :: wish_type
        integer :: card = 0                     !! which card asks for it
        type(request_type) :: request           !! what it asks
        logical :: is_made = .false.            !! there is a cut
        type(error_type), allocatable :: error  !! why there is none
    end type wish_type

    !> What a card asks for.
    type :: list_type
        type(request_type), allocatable :: requests(:)  !! in the order of the card
        type(fault_list_type) :: faults                 !! what is wrong with it
    end type list_type

    !> Cuts made before it is seen whether there is room for more.
    integer, parameter :: batch = 256
    !> Bytes in a MiB.
    integer(i64), parameter :: mebibyte = 2_i64**20

contains

    !> Makes the cuts of some cards. Those for which there is no room are not made: an error of the
    !> card whose turn it was.
    subroutine make_cuts(body, panels, asked, how, made, faults)
        type(body_type), intent(in) :: body                     !! finished
        type(panel_type), intent(in) :: panels(:)               !! its patches, then its ducts
        type(asked_cut_type), intent(in) :: asked(:)            !! the cards
        type(how_type), intent(in) :: how                       !! facts, threads
        type(made_type), intent(out) :: made                    !! the cuts
        type(fault_list_type), intent(inout) :: faults          !! what is wrong is added
        type(list_type) :: lists(size(asked))
        type(wish_type), allocatable :: wishes(:)
        integer :: i, k, first, last, tried

        do i = 1, size(asked)
            call requests_of(asked(i), lists(i)%requests, lists(i)%faults)
        end do
        call join(lists, how%facts, wishes)
        allocate (made%cuts(size(wishes)), made%cards(0))
        call make_batches(body, panels, how, wishes, made%cuts, tried)
        first = 1
        do i = 1, size(asked)
            do k = 1, lists(i)%faults%count
                call faults%add(lists(i)%faults%item(k))
            end do
            last = first + size(lists(i)%requests) - 1
            call say_cuts(asked(i), wishes(first:min(last, tried)), made%cuts(first:), faults)
            if (first <= tried + 1 .and. tried < last) &
                call blame_for_room(asked(i), tried + 1, size(wishes), how%room, faults)
            first = last + 1
        end do
        made%cards = pack(wishes%card, wishes%is_made)
        if (.not. all(wishes%is_made)) call keep_cuts(wishes%is_made, made%cuts)
    end subroutine make_cuts

    !> The wishes of all cards in their order. Where an inside of the skin is asked for it takes
    !> the normals of the points.
    pure subroutine join(lists, facts, wishes)
        type(list_type), intent(in) :: lists(:)                     !! one a card
        integer, intent(in) :: facts                                !! one of `cut_fact%...`
        type(wish_type), allocatable, intent(out) :: wishes(:)      !! see above
        integer :: i, k, count

        allocate (wishes(sum([(size(lists(i)%requests), i=1, size(lists))])))
        count = 0
        do i = 1, size(lists)
            do k = 1, size(lists(i)%requests)
                count = count + 1
                wishes(count)%card = i
                wishes(count)%request = lists(i)%requests(k)
                wishes(count)%request%facts = facts
                if (wishes(count)%request%skin > 0.0_dp) &
                    wishes(count)%request%facts = max(facts, cut_fact%bevel)
            end do
        end do
    end subroutine join

    !> Makes cuts until all are made, or there is no room for the next.
    subroutine make_batches(body, panels, how, wishes, cuts, tried)
        type(body_type), intent(in) :: body             !! finished
        type(panel_type), intent(in) :: panels(:)       !! its patches, then its ducts
        type(how_type), intent(in) :: how               !! room, threads
        type(wish_type), intent(inout) :: wishes(:)     !! what is asked
        type(cut_type), intent(inout) :: cuts(:)        !! one for each
        integer, intent(out) :: tried                   !! how many there was room for
        integer(i64) :: room
        integer :: first, last, i
        logical :: is_shared

        is_shared = how%is_shared .and. .not. has_little_memory()
        room = 0_i64
        tried = 0
        do first = 1, size(wishes), batch
            last = min(first + batch - 1, size(wishes))
            !$omp parallel do default(none) shared(body, panels, wishes, cuts, first, last) &
            !$omp schedule(dynamic, 1) if (is_shared .and. last > first)
            do i = first, last
                call make_one(body, panels, wishes(i), cuts(i))
            end do
            !$omp end parallel do
            do i = first, last
                room = room + room_of(cuts(i))
                if (room > int(how%room, i64)*mebibyte) then
                    wishes(i:last)%is_made = .false.
                    return
                end if
                tried = i
            end do
        end do
    end subroutine make_batches

    !> Makes one cut.
    pure subroutine make_one(body, panels, wish, cut)
        type(body_type), intent(in) :: body             !! finished
        type(panel_type), intent(in) :: panels(:)       !! its patches, then its ducts
        type(wish_type), intent(inout) :: wish          !! what is asked; gets what came of it
        type(cut_type), intent(inout) :: cut            !! the cut
        call cut_skin(body, panels, wish%request, cut, wish%error)
        wish%is_made = .not. allocated(wish%error)
    end subroutine make_one

    !> Says what is wrong with the cuts of a card; what is wrong with several of them in the same
    !> way, once.
    subroutine say_cuts(asked, wishes, cuts, faults)
        type(asked_cut_type), intent(in) :: asked       !! the card
        type(wish_type), intent(in) :: wishes(:)        !! its cuts
        type(cut_type), intent(in) :: cuts(:)           !! one for each, and perhaps others
        type(fault_list_type), intent(inout) :: faults  !! gets it
        character(:), allocatable :: said
        integer :: i, k

        said = ''
        do i = 1, size(wishes)
            if (allocated(wishes(i)%error)) then
                call say(asked, wishes(i)%error%message, .true., said, faults)
                cycle
            end if
            do k = 1, size(cuts(i)%notes)
                call say(asked, cuts(i)%notes(k)%message, cuts(i)%notes(k)%is_error, said, faults)
            end do
            if (max(wishes(i)%request%skin, wishes(i)%request%arcs) > 0.0_dp &
                .and. has_panels(cuts(i)) .and. cuts(i)%patches > 0) call say(asked, &
                'SKIN and ARCS are of sections; outlines on patches are their outside, as curves', &
                .false., said, faults)
        end do
    end subroutine say_cuts

    !> Says on the card of a cut what has not been said of it.
    subroutine say(asked, message, is_error, said, faults)
        type(asked_cut_type), intent(in) :: asked           !! the card
        character(*), intent(in) :: message                 !! what is wrong
        logical, intent(in) :: is_error                     !! not a warning
        character(:), allocatable, intent(inout) :: said    !! all so far, each with a line end
        type(fault_list_type), intent(inout) :: faults      !! gets it

        if (index(said, message//new_line('a')) > 0) return
        said = said//message//new_line('a')
        if (is_error) then
            call blame(asked%card, 1, message, faults)
        else
            call warn(asked%card, 1, message, faults)
        end if
    end subroutine say

    !> Says that there is no room for a cut and those behind.
    subroutine blame_for_room(asked, number, count, room, faults)
        type(asked_cut_type), intent(in) :: asked       !! the card whose turn it was
        integer, intent(in) :: number                   !! which cut
        integer, intent(in) :: count                    !! of how many of the body
        integer, intent(in) :: room                     !! that all may fill, MiB
        type(fault_list_type), intent(inout) :: faults  !! gets it
        call blame(asked%card, 1, 'cut '//to_text(number)//' of the '//to_text(count)// &
            ' of this body would take more than '//to_text(room)//' MiB with those before; it '// &
            'and those behind are left out: take a longer step or fewer points, or cut the '// &
            'rest in a deck of its own', faults)
    end subroutine blame_for_room

end module api_computed_cuts
