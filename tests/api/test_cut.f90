!> Cuts of a loaded deck: the points of a sphere are on it and on the plane; what can't be asked is
!> refused.
program test_cut
    use api_cut, only: asked_type, cut_asked, cut_listed, cut_type, find_body
    use api_deck, only: deck_type, read_deck
    use base_error, only: cause, error_type
    use base_kinds, only: dp
    use cut_plane, only: cut_kind
    use cut_request, only: cut_rule
    use deck_source, only: source_type
    use, intrinsic :: ieee_arithmetic, only: ieee_positive_inf, ieee_value
    use support_book, only: text_file
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(deck_type) :: deck
    type(cut_type) :: cut
    type(asked_type) :: asked, again
    type(error_type), allocatable :: error
    real(dp) :: middle(3), radius
    integer :: i

    call load('sphere')
    asked%kind = cut_kind%plane
    associate (line => deck%bodies(1)%body%lines(1))
        middle = [0.5_dp*(line%from + line%to), 0.0_dp, 0.0_dp]
        radius = 0.5_dp*(line%to - line%from)
    end associate
    asked%point = middle
    asked%normal = [1.0_dp, -2.0_dp, 0.5_dp]
    call cut_asked(deck, asked, cut, error)
    call tap%ok(.not. allocated(error) .and. size(cut%points) > 50, 'a plane cuts a sphere')
    call tap%ok(all([(abs(norm2(cut%points(i)%at - middle) - radius) < 1.0e-12_dp*radius, &
        i=1, size(cut%points))]), 'all points are on the sphere')
    call tap%ok(all([(abs(dot_product(cut%points(i)%at - middle, asked%normal)) < &
        1.0e-12_dp*radius, i=1, size(cut%points))]), 'and on the plane')
    call tap%ok(all([(maxval(abs(cut%points(i)%normal*radius - (cut%points(i)%at - middle))) < &
        1.0e-6_dp*radius .or. .not. cut%points(i)%has_normal, i=1, size(cut%points))]), &
        'normals point away from its middle')
    call tap%ok(all(abs(abs(cut%points%curvature) - 1.0_dp/radius) < 1.0e-6_dp/radius .or. &
        .not. cut%points%has_curvature), 'a great circle has its curvature')
    call tap%ok(maxval(cut%points%outline) == size(cut%is_closed), 'outlines are counted from 1')
    again = asked
    again%rule = cut_rule%number
    again%number = 5
    call cut_asked(deck, again, cut, error)
    call tap%ok(size(cut%points) >= 5 .and. size(cut%points) < 50, 'fewer points where asked')
    again = asked
    again%point = [0.0_dp, 0.0_dp, 100.0_dp*radius]
    again%normal = [0.0_dp, 0.0_dp, 1.0_dp]
    call cut_asked(deck, again, cut, error)
    call tap%ok(.not. allocated(error) .and. size(cut%points) == 0, &
        'a plane that misses gives no points')

    again = asked
    again%normal = 0.0_dp
    call refused(again, cause%points_coincide, 'no normal')
    again%normal = ieee_value(1.0_dp, ieee_positive_inf)
    call refused(again, cause%usage, 'an infinite normal')
    again = asked
    again%body = 2
    call refused(again, cause%usage, 'a body that is not there')
    again = asked
    again%kind = cut_kind%oblique
    call refused(again, cause%usage, 'an oblique plane, which takes two points')
    again = asked
    again%number = 1000000
    call refused(again, cause%too_many, 'a million points on an arc')
    again%rule = cut_rule%length
    call refused(again, cause%usage, 'lengths of zero')
    again%step = 1.0e-9_dp
    call refused(again, cause%too_many, 'tiny lengths')
    again%rule = 1
    call refused(again, cause%usage, 'steps, which take decimals')

    call load('inlet')
    do i = 1, size(deck%cuts)
        call cut_listed(deck, i, cut, error)
        call tap%ok(.not. allocated(error) .and. size(cut%points) > 0 .and. &
            cut%name == deck%cuts(i)%name, 'a cut of the deck has its name: '//cut%name)
    end do
    call cut_listed(deck, size(deck%cuts) + 1, cut, error)
    call tap%ok(allocated(error), 'there is no cut after the last')
    call cut_listed(deck, 0, cut, error)
    call tap%ok(allocated(error), 'and none before the first')
    call find_body(deck, 1, error)
    call tap%ok(.not. allocated(error) .or. size(deck%bodies(1)%sections) == 0, &
        'a body with sections is found')
    call tap%finish()

contains

    !> Loads a deck of cards/.
    subroutine load(name)
        character(*), intent(in) :: name !! of the deck, without its ending
        type(source_type) :: source
        call source%from_text(text_file('cards/'//name//'.crd'))
        call read_deck(source, deck, error)
    end subroutine load

    !> Checks that a cut is refused.
    subroutine refused(wanted, why, name)
        type(asked_type), intent(in) :: wanted  !! what is asked
        integer, intent(in) :: why              !! one of `cause%...`
        character(*), intent(in) :: name        !! what is wrong with it
        call cut_asked(deck, wanted, cut, error)
        call tap%ok(allocated(error), 'refused: '//name)
        if (.not. allocated(error)) return
        call tap%ok(error%cause == why, 'for its cause: '//error%message)
    end subroutine refused

end program test_cut
