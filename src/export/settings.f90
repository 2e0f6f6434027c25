!> What the command line asks of an export; every length is in the unit of the file.
module export_settings
    use base_kinds, only: dp
    implicit none (type, external)
    private

    public :: settings_type

    !> The choices. Each writer looks at its own.
    type :: settings_type
        real(dp) :: tolerance = 0.0_dp          !! how far anything may be from the exact shape
        real(dp) :: angle = 10.0_dp             !! mesh: largest turn between triangles, degrees
        logical :: is_binary = .false.          !! STL: binary
        logical :: is_open = .false.            !! STEP, STL, OBJ: no caps, not a solid
        logical :: has_splines = .false.        !! DXF: R2000 with splines
        logical :: is_in_space = .false.        !! DXF: where the body has it, not in its plane
        logical :: has_arcs = .false.           !! DXF, NC: circular arcs for all cuts
        logical :: has_conics = .false.         !! IGES: 104 and 124 where a curve is a conic
        logical :: is_half = .false.            !! patterns: the half, with its centre line
        logical :: is_each = .false.            !! patterns: a sheet for each cut
        character(:), allocatable :: paper      !! of patterns: a4, letter, a3, tabloid, roll;
                                                !! empty: the sheet is as large as the pattern
        real(dp) :: roll_width = 0.0_dp         !! of a roll
        real(dp) :: overlap = 0.0_dp            !! of tiles
        real(dp) :: bevel_step = 0.0_dp         !! patterns: how far bevel marks are apart
        real(dp) :: feed = 0.0_dp               !! NC: a minute
        real(dp) :: depth = 0.0_dp              !! NC: Z of the cut, below zero
        real(dp) :: safe = 0.0_dp               !! NC: Z above everything
    end type settings_type

end module export_settings
