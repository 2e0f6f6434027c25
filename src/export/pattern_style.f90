!> How the things of a pattern look: lines and their weights, dashes and colours, and the layer that
!> each belongs to, so that a cutter can leave out what is not to be cut.
module export_pattern_style
    use base_kinds, only: dp
    implicit none (type, external)
    private

    public :: look_type, look_of, layer_of

    !> What is drawn.
    type, public :: style_list
        integer :: outline = 1      !! outside of skin
        integer :: inside = 2       !! inside of skin
        integer :: centre = 3       !! BL 0
        integer :: fold = 4         !! BL 0 of a half
        integer :: line = 5         !! other water, butt and station lines
        integer :: line_words = 6   !! their names
        integer :: bevel = 7        !! bevel marks
        integer :: bevel_words = 8  !! their degrees
        integer :: words = 9        !! names and notes of a part
        integer :: bar = 10         !! check bars
        integer :: sheet_words = 11 !! words of the sheet
        integer :: cut = 12         !! where a tile is cut
        integer :: cross = 13       !! crosses and match marks
        integer :: map = 14         !! page map: tiles
        integer :: map_this = 15    !! page map: this tile
        integer :: map_none = 16    !! page map: tiles left out
        integer :: map_part = 17    !! page map: the parts
        integer :: like_outline = 18 !! a line shown beside words: not to be cut
        integer :: like_inside = 19 !! another
    end type style_list

    !> The styles by name.
    type(style_list), parameter, public :: style = style_list()

    !> The layers: of each part, but for the last, which is the sheet's.
    character(*), parameter, public :: layers(6) = [character(9) :: 'outline', 'inside', 'lines', &
        'bevels', 'words', 'sheet']

    !> A look.
    type :: look_type
        integer :: layer = 6                    !! place in `layers`
        logical :: is_filled = .false.          !! an area, not a line; words are
        real(dp) :: width = 0.0_dp              !! of a line, in
        real(dp) :: dash(6) = 0.0_dp            !! on, off, on ... in; 0: the pattern ends
        real(dp) :: colour(3) = 0.0_dp          !! red, green, blue: 0 to 1
    end type look_type

    !> Line weights: thick, medium, thin, in (.35, .18, .13 mm, ISO 128-20).
    real(dp), parameter :: thick = 0.35_dp/25.4_dp, medium = 0.18_dp/25.4_dp, &
        thin = 0.13_dp/25.4_dp
    real(dp), parameter :: dashed(6) = [0.12_dp, 0.06_dp, 0.0_dp, 0.0_dp, 0.0_dp, 0.0_dp], &
        dash_dot(6) = [0.5_dp, 0.06_dp, 0.06_dp, 0.06_dp, 0.0_dp, 0.0_dp], &
        dash_dots(6) = [0.5_dp, 0.06_dp, 0.06_dp, 0.06_dp, 0.06_dp, 0.06_dp], &
        short(6) = [0.05_dp, 0.05_dp, 0.0_dp, 0.0_dp, 0.0_dp, 0.0_dp], unbroken(6) = 0.0_dp
    real(dp), parameter :: black(3) = 0.0_dp, blue(3) = [0.1_dp, 0.3_dp, 0.6_dp], &
        red(3) = [0.7_dp, 0.1_dp, 0.1_dp], grey(3) = 0.45_dp, pale(3) = 0.8_dp

contains

    !> The look of a style.
    pure type(look_type) function look_of(kind) result(look)
        integer, intent(in) :: kind !! one of `style%...`

        select case (kind)
        case (style%outline)
            look = look_type(1, .false., thick, unbroken, black)
        case (style%inside)
            look = look_type(2, .false., medium, dashed, black)
        case (style%centre)
            look = look_type(3, .false., medium, dash_dot, black)
        case (style%fold)
            look = look_type(3, .false., medium, dash_dots, black)
        case (style%line)
            look = look_type(3, .false., thin, unbroken, blue)
        case (style%line_words)
            look = look_type(3, .true., 0.0_dp, unbroken, blue)
        case (style%bevel)
            look = look_type(4, .false., thin, unbroken, red)
        case (style%bevel_words)
            look = look_type(4, .true., 0.0_dp, unbroken, red)
        case (style%words)
            look = look_type(5, .true., 0.0_dp, unbroken, black)
        case (style%like_outline)
            look = look_type(5, .false., thick, unbroken, black)
        case (style%like_inside)
            look = look_type(5, .false., medium, dashed, black)
        case default
            look = sheet_look(kind)
        end select
    end function look_of

    !> The look of what belongs to the sheet.
    pure type(look_type) function sheet_look(kind) result(look)
        integer, intent(in) :: kind !! one of `style%...`

        select case (kind)
        case (style%sheet_words)
            look = look_type(6, .true., 0.0_dp, unbroken, black)
        case (style%cut)
            look = look_type(6, .false., thin, short, grey)
        case (style%map)
            look = look_type(6, .false., thin, unbroken, grey)
        case (style%map_this)
            look = look_type(6, .true., 0.0_dp, unbroken, grey)
        case (style%map_none)
            look = look_type(6, .false., thin, unbroken, pale)
        case (style%map_part)
            look = look_type(6, .false., thin, unbroken, black)
        case default
            look = look_type(6, .false., medium, unbroken, black)
        end select
    end function sheet_look

    !> The layer of a style: a place in `layers`.
    pure integer function layer_of(kind) result(layer)
        integer, intent(in) :: kind !! one of `style%...`
        type(look_type) :: look
        look = look_of(kind)
        layer = look%layer
    end function layer_of

end module export_pattern_style
