!> Powers of ten in 126 bits, for turning binary into decimal figures by one product.
!>
!>     10**k = (high*2**63 + low + r)*2**binary,    0 <= r < 3,    2**62 <= high, low < 2**63
!>
!> From 10**0 to 10**54 they are exact. Every sixteenth power is in a table, cut to 126 bits; the
!> others are that times a whole power of ten below 10**16, cut again.
!>
!> Source: R. Giulietti, "The Schubfach way to render doubles", 2021, section 9.8 (logarithms in
!> whole numbers); the figures of the table were worked with whole numbers of any length.
module base_power
    use base_kinds, only: i128, i64
    implicit none (type, external)
    private

    public :: power_type, power_of_ten, decade_of_binary, product_with

    !> A power of ten; see above.
    type :: power_type
        integer(i64) :: high = 0 !! upper 63 bits
        integer(i64) :: low = 0  !! lower 63 bits
        integer :: binary = 0    !! power of two behind them
    end type power_type

    !> A power is short of the true one by less than this, in units of its last bit.
    integer, parameter, public :: shortfall = 3
    !> Bits of a half of a power.
    integer, parameter, public :: half_bits = 63
    !> Distance of the powers in the table.
    integer, parameter :: stride = 16

    !> Powers below 10**16.
    integer(i64), parameter :: small(0:stride - 1) = &
        10_i64**int([0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15], i64)
    !> Upper halves of 10**(16 j).
    integer(i64), parameter :: highs(-20:21) = [ &
        9115387125737528424_i64, 5060056332682765458_i64, 5617791046444737211_i64, &
        6237000967295999411_i64, 6924462078501391516_i64, 7687697232696013035_i64, &
        8535058474086213470_i64, 4737909217226284592_i64, 5260135901548373507_i64, &
        5839923990556409879_i64, 6483618076376551497_i64, 7198262071269114212_i64, &
        7991676288808940112_i64, 8872543021186607550_i64, 4925250774549309901_i64, &
        5468126811957529810_i64, 6070840288205403346_i64, 6739986666787659948_i64, &
        7482888383134222941_i64, 8307674973655724205_i64, 4611686018427387904_i64, &
        5120000000000000000_i64, 5684341886080801486_i64, 6310887241768094443_i64, &
        7006492321624085354_i64, 7778769097326427133_i64, 8636168555094444625_i64, &
        4794036587204811087_i64, 5322449800010188399_i64, 5909106315382870899_i64, &
        6560425886295985109_i64, 7283535870312701897_i64, 8086349223904389813_i64, &
        8977651093538418850_i64, 4983597475548783767_i64, 5532904662818065330_i64, &
        6142758149716504390_i64, 6819831532519087681_i64, 7571533991467358150_i64, &
        8406091369059074558_i64, 4666318092516094394_i64, 5180653786536309363_i64]
    !> Lower halves of 10**(16 j).
    integer(i64), parameter :: lows(-20:21) = [ &
        2470272937959442605_i64, 7492916806379061957_i64, 6032811387162639116_i64, &
        3930675837543742387_i64, 9125493878965589186_i64, 4523745595132871321_i64, &
        7583551416783411466_i64, 1194002452706084763_i64, 2222739346921486195_i64, &
        7938553132791110303_i64, 6231654060133073877_i64, 4582739501051995120_i64, &
        3107251736068716279_i64, 6003727033359828405_i64, 4933397350530608389_i64, &
        8589316563156989190_i64, 5749098043168053385_i64, 6149718093871667028_i64, &
        1871111759924843196_i64, 5984069606361426540_i64, 0_i64, &
        0_i64, 8937393460516749312_i64, 2710089775864365056_i64, &
        5706019893239531902_i64, 8578474484080507457_i64, 3563466967739958279_i64, &
        70003547160262508_i64, 8186361988875305037_i64, 6324610901913141865_i64, &
        1575949922397804546_i64, 6872180620830963519_i64, 2409136169475294469_i64, &
        7628014293257544352_i64, 6966887050417449627_i64, 7724407183888759754_i64, &
        8606066656235469485_i64, 1354283389261828998_i64, 2080887032334240836_i64, &
        5904691951894693914_i64, 8766332956520552848_i64, 598578264763148780_i64]

contains

    !> A power of ten.
    elemental type(power_type) function power_of_ten(k) result(power)
        integer, intent(in) :: k !! -320 to 351
        integer(i128) :: upper, lower, factor
        integer :: row, shift
        integer(i64), parameter :: mask = huge(1_i64)

        row = shifta(k, 4)
        factor = int(small(k - stride*row), i128)
        lower = int(lows(row), i128)*factor
        upper = int(highs(row), i128)*factor + shiftr(lower, half_bits)
        power%binary = binary_of_decade(k) - 2*half_bits + 1
        shift = binary_of_decade(k) - binary_of_decade(stride*row)
        power%high = int(shiftr(upper, shift), i64)
        lower = iand(lower, int(mask, i128))
        upper = iand(upper, shiftl(1_i128, shift) - 1_i128)
        power%low = int(shiftr(shiftl(upper, half_bits) + lower, shift), i64)
    end function power_of_ten

    !> `whole*power/2**63`, cut to a whole number: short of the true product by less than
    !> 1 + 3*whole/2**63.
    elemental integer(i128) function product_with(power, whole) result(product)
        type(power_type), intent(in) :: power !! a power of ten
        integer(i64), intent(in) :: whole     !! below 2**62, not negative
        product = int(power%high, i128)*int(whole, i128) + &
            shiftr(int(power%low, i128)*int(whole, i128), half_bits)
    end function product_with

    !> The greatest e with 2**e <= 10**k.
    elemental integer function binary_of_decade(k) result(e)
        integer, intent(in) :: k !! -1233 to 1233
        e = shifta(k*1741647, 19)
    end function binary_of_decade

    !> The greatest k with 10**k <= 2**e, or with 10**k <= 3/4*2**e.
    elemental integer function decade_of_binary(e, three_quarters) result(k)
        integer, intent(in) :: e                !! -1500 to 1500
        logical, intent(in) :: three_quarters   !! the second is asked for
        k = shifta(e*1262611 - merge(524031, 0, three_quarters), 22)
    end function decade_of_binary

end module base_power
