!> A drawing of a body: lines by style, and words, in the units of the deck. A writer of any format
!> draws it; how a style looks is the writer's matter.
!>
!> Words have a size on paper, not in deck units. `dot` says how many deck units a dot of 1/96 inch
!> is, so that whoever places words knows what room they take.
module export_body_drawing
    use base_kinds, only: dp
    use base_text, only: characters, compact
    implicit none (type, external)
    private

    public :: drawing_type, layer_type, stroke_type, words_type, word_side, mark_of, size_of

    !> A line as points close together.
    type :: stroke_type
        real(dp), allocatable :: at(:, :) !! 2 or 3 coordinates by rows, points by columns
    end type stroke_type

    !> Lines of one style. In three dimensions the lines of a layer are the rows of a grid.
    type :: layer_type
        character(12) :: style = ''         !! `section`, `buttock` and the like
        integer :: patch = 0                !! tells layers of the same style apart
        integer :: count = 0                !! how many lines
        type(stroke_type), allocatable :: stroke(:) !! the lines, `stroke(1:count)`
    end type layer_type

    !> Where words stand at their place.
    type, public :: word_side_list
        integer :: left = -1    !! they end there
        integer :: middle = 0   !! it is their middle
        integer :: right = 1    !! they begin there
    end type word_side_list
    type(word_side_list), parameter :: word_side = word_side_list()

    !> Words on the drawing.
    type :: words_type
        character(:), allocatable :: text   !! any bytes
        real(dp) :: at(2) = 0.0_dp          !! their place, at half their height
        integer :: side = 0                 !! one of `word_side%...`
        integer :: size = 0                 !! 0: as small as can be read; 1: plain; 2: a title
    end type words_type

    !> A drawing.
    type :: drawing_type
        character(:), allocatable :: name       !! name of its files, without ending
        character(:), allocatable :: script     !! shared script that draws it, without `.gp`
        character(:), allocatable :: heading    !! what it is of, any bytes
        character(:), allocatable :: view       !! what it shows of that, any bytes
        character(:), allocatable :: note       !! a line more below the view, or nothing
        character(:), allocatable :: x_axis     !! name and unit of the axis to the right
        character(:), allocatable :: y_axis     !! name and unit of the axis upwards
        real(dp) :: low(2) = 0.0_dp             !! left and lower edge
        real(dp) :: high(2) = 1.0_dp            !! right and upper edge
        real(dp) :: dot(2) = 1.0_dp             !! deck units a dot to the right and upwards
        integer :: layers = 0                   !! number of layers
        type(layer_type), allocatable :: layer(:) !! the layers, `layer(1:layers)`
        integer :: count = 0                    !! number of words
        type(words_type), allocatable :: words(:) !! the words, `words(1:count)`
    contains
        procedure :: draw
        procedure :: write_words
        procedure :: write_where_free
        procedure :: is_free
    end type drawing_type

    !> Dots that a character takes across, and a line upwards, by size.
    real(dp), parameter :: width(0:2) = [5.8_dp, 7.0_dp, 9.5_dp]
    real(dp), parameter :: height(0:2) = [12.0_dp, 15.0_dp, 20.0_dp]
    !> Dots between words side by side.
    real(dp), parameter :: gap = 4.0_dp

contains

    !> Draws a line. It goes to the layer of its style and patch. Without points it is none.
    pure subroutine draw(drawing, style, at, patch)
        class(drawing_type), intent(inout) :: drawing !! the drawing
        character(*), intent(in) :: style             !! of the line
        real(dp), intent(in) :: at(:, :)              !! its points by columns
        integer, intent(in), optional :: patch        !! 0 where absent
        type(stroke_type), allocatable :: grown(:)
        integer :: i

        if (size(at, 2) == 0) return
        call find_layer(drawing, style, patch, i)
        associate (layer => drawing%layer(i))
            if (layer%count == size(layer%stroke)) then
                allocate (grown(2*layer%count))
                grown(:layer%count) = layer%stroke
                call move_alloc(grown, layer%stroke)
            end if
            layer%count = layer%count + 1
            layer%stroke(layer%count)%at = at
        end associate
    end subroutine draw

    !> The layer of a style and patch; a new one where there is none.
    pure subroutine find_layer(drawing, style, patch, found)
        class(drawing_type), intent(inout) :: drawing !! the drawing
        character(*), intent(in) :: style             !! of its lines
        integer, intent(in), optional :: patch        !! 0 where absent
        integer, intent(out) :: found                 !! its number
        type(layer_type), allocatable :: grown(:)
        integer :: wanted

        wanted = 0
        if (present(patch)) wanted = patch
        if (.not. allocated(drawing%layer)) allocate (drawing%layer(8))
        do found = 1, drawing%layers
            if (drawing%layer(found)%style == style .and. &
                drawing%layer(found)%patch == wanted) return
        end do
        if (drawing%layers == size(drawing%layer)) then
            allocate (grown(2*drawing%layers))
            grown(:drawing%layers) = drawing%layer
            call move_alloc(grown, drawing%layer)
        end if
        drawing%layers = found
        drawing%layer(found)%style = style
        drawing%layer(found)%patch = wanted
        allocate (drawing%layer(found)%stroke(8))
    end subroutine find_layer

    !> Puts words on the drawing, whatever else is there.
    pure subroutine write_words(drawing, text, at, side, size_of_words)
        class(drawing_type), intent(inout) :: drawing !! the drawing
        character(*), intent(in) :: text              !! any bytes
        real(dp), intent(in) :: at(2)                 !! their place
        integer, intent(in) :: side                   !! one of `word_side%...`
        integer, intent(in) :: size_of_words          !! 0 to 2
        type(words_type), allocatable :: grown(:)

        if (.not. allocated(drawing%words)) allocate (drawing%words(32))
        if (drawing%count == size(drawing%words)) then
            allocate (grown(2*drawing%count))
            grown(:drawing%count) = drawing%words
            call move_alloc(grown, drawing%words)
        end if
        drawing%count = drawing%count + 1
        drawing%words(drawing%count) = words_type(text, at, side, size_of_words)
    end subroutine write_words

    !> Puts small words at the first of some places where they hide no others; nowhere where all
    !> are taken.
    pure subroutine write_where_free(drawing, text, places, side)
        class(drawing_type), intent(inout) :: drawing !! the drawing
        character(*), intent(in) :: text              !! any bytes
        real(dp), intent(in) :: places(:, :)          !! the places by columns, best first
        integer, intent(in) :: side                   !! one of `word_side%...`
        integer :: i

        do i = 1, size(places, 2)
            if (.not. drawing%is_free(words_type(text, places(:, i), side, 0))) cycle
            call drawing%write_words(text, places(:, i), side, 0)
            return
        end do
    end subroutine write_where_free

    !> True where words would hide no others.
    pure logical function is_free(drawing, words)
        class(drawing_type), intent(in) :: drawing !! the drawing
        type(words_type), intent(in) :: words      !! not on it yet
        integer :: i

        is_free = .true.
        do i = 1, drawing%count
            is_free = is_free .and. any(abs(centre_of(words, drawing%dot) &
                - centre_of(drawing%words(i), drawing%dot)) > &
                0.5_dp*(size_of(words) + size_of(drawing%words(i)))*drawing%dot)
        end do
    end function is_free

    !> The middle of words, deck units.
    pure function centre_of(words, dot) result(centre)
        type(words_type), intent(in) :: words !! the words
        real(dp), intent(in) :: dot(2)        !! deck units a dot
        real(dp) :: centre(2), room(2)
        room = size_of(words)
        centre = words%at
        centre(1) = centre(1) + 0.5_dp*real(words%side, dp)*room(1)*dot(1)
    end function centre_of

    !> The room that words take to the right and upwards, dots.
    pure function size_of(words) result(room)
        type(words_type), intent(in) :: words !! the words
        real(dp) :: room(2)
        room = [real(characters(words%text), dp)*width(words%size) + gap, height(words%size)]
    end function size_of

    !> A number as it stands on a drawing: no point without decimals behind it.
    pure function mark_of(value) result(text)
        real(dp), intent(in) :: value !! a finite number
        character(:), allocatable :: text
        text = compact(value)
        if (text(len(text):) == '.') text = text(:len(text) - 1)
    end function mark_of

end module export_body_drawing
