// Outlines of the letters, from DejaVu Sans (Bitstream Vera licence: free to embed), curves
// flattened to 0.3 of 64 units per em. Contours are separated by spaces; each point is two
// characters: x + 4 and y + 18, each above '#'.
#pragma once

#include <array>

namespace vasorod {

struct Glyph {
  char32_t character;
  int advance;  ///< in 1/64 em
  const char* contours;
};

// clang-format off
inline constexpr std::array glyphs{
    Glyph{0x0021, 26, "1=7=7515 1d7d7O6D1D1O"},  // !
    Glyph{0x0022, 29, "2d2R-R-d >d>R9R9d"},  // "
    Glyph{0x0023, 54, "HQ?Q<GEG Cc@VIVLcQcNVXVXQMQJGTGTBIBF5A5DB;B85356B,B,G7G:Q/Q/V;V>c"},  // #
    Glyph{0x0024, 41, "=,9,9536,8,=3:999H4I/K-O,S-W0[4]9^9f=f=^B^H\\HWBY=Z=MCKGIJEJAJ<G9C6=5 9M9Z6Y4X3V2S3Q4O6N =G=:@:C<D>E@DCCE@F"},  // $
    Glyph{0x0025, 61, "VJSIQGPDPAP=Q:S9V8X9Z:[=[A[DZGXI VMZM]J`F`A`<]8Z5V4Q5N8K<KAKFNJQM 5a3`1^0[/X0T1Q3P5O8P:Q;T;X;[:^8` QeWe9444 5e:d=a?]@X?S=O:L5K1L-O+S+X+]-a1d"},  // %
    Glyph{0x0026, 50, "7N4L2I1F1D2@4<8:=9B:G= ;RKANGONUNTJSFQBN>W5O5K:G7D5@4<4753608-<,?+C,G-K0N3R1U0Y1^4a8d=eBdGbG]B_>`;_8^7\\6Y7V9T"},  // &
    Glyph{0x0027, 18, "2d2R-R-d"},  // '
    Glyph{0x0028, 25, ";f7^5W3P3I3B5;74;-6-24/;-B-I-P/W2^6f"},  // (
    Glyph{0x0029, 25, ",f1f5^8W:P:I:B8;541-,-042;4B4I4P2W0^"},  // )
    Glyph{0x002a, 32, "E\\:VEPCM9S9G5G5S+M)P4V)\\+_5Y5e9e9YC_"},  // *
    Glyph{0x002b, 54, "D]DLVLVFDFD5?5?F.F.L?L?]"},  // +
    Glyph{0x002c, 20, "/=5=580.,./8"},  // ,
    Glyph{0x002d, 23, "*I;I;D*D"},  // -
    Glyph{0x002e, 20, ".=4=45.5"},  // .
    Glyph{0x002f, 22, "7d=d,/'/"},  // /
    Glyph{0x0030, 41, ";_8_6]4[3W2R2L2F3B4>6;8:;9>:A;C>DBEFELERDWC[A]>_ ;e@dDbG^JZKTKLKEJ?G:D7@5;47537/:-?,E+L,T-Z/^3b7d"},  // 0
    Glyph{0x0031, 41, "/:9:9^.\\.a9d?d?:J:J5/5"},  // 1
    Glyph{0x0032, 41, "3:I:I5,5,:0?5D9H<K=L@PBRBTCWBZ@]=_9_3^,[,a3d9e@dEaG^I[IWHRFODLCKBI?F<C8?"},  // 2
    Glyph{0x0033, 41, "ANEMHJJGKCJ>H;F8B6>58425,6,=2:89=:A<D?DCDFAI>K9K4K4Q:Q>QARCUCXC[A]>_9_4_-]-c4d:e@dEaH]IXIUGREP"},  // 3
    Glyph{0x0034, 41, "?^/E?E >dEdEELEL@E@E5?5?@*@*F"},  // 4
    Glyph{0x0035, 41, ".dGdG^4^4S6T9T>SBRFPHLJIJDJ?H;E8B6=58425,6,<2:89=:A<C@DDCHAL=N8O3N.L"},  // 5
    Glyph{0x0036, 41, "<O8N5L4H3D4?5<8:<9@:C<E?EDEHCL@N IcI]D_?_;_8]6[4X2S2N4Q6R9S=TASERHPJLKILDK?J<G8D6A5<475370:-?,E+L,S.Y1^5b9d?eDd"},  // 6
    Glyph{0x0037, 41, ",dJdJa9535C^,^"},  // 7
    Glyph{0x0038, 41, ";K7K4I2F2B2>4;7:;9?:B<D>EBDFBI?K 5N1O/R-U,X-]0a5d;eBdFaI]JXJUHREOBNFLIJKFKBK>J:G8D6@4;47436/8-:,>+B,F.J1L 3X3U5R8Q;P?QBRCUDXC[B]?_;_8_5]3["},  // 8
    Glyph{0x0039, 41, ".6.<3:89;:?;A>CADEEJCH@F=E:E6E2G/I-L+P+U,Y-]/`2c6d;e@dDbG^IZKTKLKEI@F;B7=58435 ;J>JAMCPDUCYA]>_;_7_4]2Y1U2P4M7J"},  // 9
    Glyph{0x003a, 22, "/=5=55/5 /V5V5N/N"},  // :
    Glyph{0x003b, 22, "/V5V5N/N /=5=580.,./8"},  // ;
    Glyph{0x003c, 54, "VU6IV>V8.F.LVZ"},  // <
    Glyph{0x003d, 54, ".RVRVM.M .EVEV@.@"},  // =
    Glyph{0x003e, 54, ".U.ZVLVF.8.>NI"},  // >
    Glyph{0x003f, 34, "3=:=:535 9B3B3F4I4L6N8P;S=V>Y>\\<^:_7_1^,[,a2d8e=dAaD^EYCUBS?P=M;K:J9H9E"},  // ?
    Glyph{0x0040, 64, "?F?BA?D=G<K=M?OBOFOJMMJOGODOAM?J P<N:L9I8F8A9=<;@:F;K=PASFTITLSNQPOPSTST<X>[@]D^I]PZUVYR[M]H^A]:Z6V2Q0L0F0A1=4975:2>0C/G.K/O0S1W4Y0U-Q+L*G*B*=,8.3206-;,@+F,L-Q0V3Z8]=`BbHbNaT_Y\\^X`TaQbMcJbD`@^=Z:U8P8"},  // @
    Glyph{0x0041, 44, "=]4FEF 9d@dR5L5GA2A.5'5"},  // A
    Glyph{0x0042, 44, "4K4:>:B;E<G?HCGGEIBK>K 4^4P=PAQDRFTFWF[D]A^=^ -d=dDcIaK]LXLTJQHOENIMLJNFNBN>L;J8G7C5>5-5"},  // B
    Glyph{0x0043, 45, "P`PYM\\I^F_B_=_9]5Z3W2R1L2G3B5>9;=:B9F:I;M=P?P9I5A4;5571;-?+E+L+S-Y1^5b;dAeEdIcMb"},  // C
    Glyph{0x0044, 49, "4^4:;:A;F<I?LBMGNLMRLWIZF]A^;^ -d:dBcIaN^RZTTULTER?N;I8B6:5-5"},  // D
    Glyph{0x0045, 40, "-dKdK^4^4QJQJK4K4:K:K5-5"},  // E
    Glyph{0x0046, 37, "-dHdH^4^4QFQFK4K45-5"},  // F
    Glyph{0x0047, 50, "M<MHCHCMSMS9O7K5G4B4;5571:-?+E+L+S-Y1^5b;dBeFdKcObR`RYO\\K^G_B_=_9]6[3W2R1L2G3B6>9;=:B9H:"},  // G
    Glyph{0x0048, 48, "-d4d4QKQKdQdQ5K5KK4K45-5"},  // H
    Glyph{0x0049, 19, "-d4d45-5"},  // I
    Glyph{0x004a, 19, "-d4d48332/0,.**)&($($-&-).,0-3-8"},  // J
    Glyph{0x004b, 42, "-d4d4PIdQd9NR5J54K45-5"},  // K
    Glyph{0x004c, 36, "-d4d4:J:J5-5"},  // L
    Glyph{0x004d, 55, "-d7dCDOdXdX5R5R^F>?>3^35-5"},  // M
    Glyph{0x004e, 48, "-d6dJ=JdQdQ5H53\\35-5"},  // N
    Glyph{0x004f, 50, "@_<_8]5Z3V2R1L2G3B5>8;<:@9D:H;K>MBOGOLORMVKZH]D_ @eFdLbP^SYUSVLUES@P;L7F5@4:5570;-@+E+L+S-Y0^5b:d"},  // O
    Glyph{0x0050, 39, "4^4M<M?NBODREVDYB\\?^<^ -d<d@cDbG`J]KZKVKQJNGKDI@H<H4H45-5"},  // P
    Glyph{0x0051, 50, "@_<_8]5Z3V2R1L2G3B5>8;<:@9D:H;K>MBOGOLORMVKZH]D_ I6Q-J-C4A4@4:5570;-@+E+L+S-Y0^5b:d@eFdLbP^SYUSVLUES>O9"},  // Q
    Glyph{0x0052, 44, "CKEJGHIEKBR5K5EACE@G>H:I4I45-5-d<d@cDbG`J^KZKVKRIOGL 4^4N<N@NBPDSEVDZB\\@^<^"},  // R
    Glyph{0x0053, 41, "IbI\\B_<_8_4]2[2X2U3S6R:P>PDNIKKGLBL>J:H8D6@4:435+7+>3::9?:C;E>EAEDCGAH<J9J3L.O,R+W,[-^0a3c7d<eBd"},  // S
    Glyph{0x0054, 39, "'dNdN^>^>5757^'^"},  // T
    Glyph{0x0055, 47, "-d3d3G3C4?6=9:>9D:G=I?JCJGJdPdPGPAN<L9H6D5>4955619/<-A-G"},  // U
    Glyph{0x0056, 44, "95'd.d=<LdRd@5"},  // V
    Glyph{0x0057, 63, ")d/d9<CdJdT<^dddX5Q5G]=555"},  // W
    Glyph{0x0058, 44, "+d2d=RIdPdAMQ5J5=I05)5:N"},  // X
    Glyph{0x0059, 39, "'d.d;PGdNd>K>5757K"},  // Y
    Glyph{0x005a, 44, "+dOdO_2:P:P5*5*:G^+^"},  // Z
    Glyph{0x005b, 25, "-f:f:a2a21:1:---"},  // [
    Glyph{0x005c, 22, ",d=/7/'d"},  // backslash
    Glyph{0x005d, 25, ":f:----1515a-a-f"},  // ]
    Glyph{0x005e, 54, "EdVRPRB_4R.R?d"},  // ^
    Glyph{0x005f, 32, "H*H&&&&*"},  // _
    Glyph{0x0060, 32, "2h;]7],h"},  // `
    Glyph{0x0061, 39, "=G7F3E1C1@1=3;5989<:@<B@CECG HIH5C5C:@8>6:47425.7,;+?+C-F/H2J6K;KCKCLBO@R=S9T3S-Q-V4X9Y>XBWEUGRHN"},  // a
    Glyph{0x0062, 41, "FFFLDP@S<T8S5P3L3F3A5=8:<9@:D=FA 3S5U7W:X>YBXEWHTJPLLLFLAJ=H9E6B5>4:476583:35-5-f3f"},  // b
    Glyph{0x0063, 35, "FWFQAS<T7S4P1L1F1A4=7:<9A:F<F6A5<47536/9-=+A+F+L-P/T3W7X<YAX"},  // c
    Glyph{0x0064, 41, "DSDfJfJ5D5D:B8?6<4945516/9,=+A+F+L,P/T1W5X9Y<X?WBU 0F1A3=6::9>:A=CADFCLAP>S:T6S3P1L"},  // d
    Glyph{0x0065, 39, "KHKE1E2@4<8:=9C:J<J7C5=47536/9-=+A+F+K-P/T3W7X<Y@XDWGTIQKM EJENCQ@S<T7S4Q2N1J"},  // e
    Glyph{0x0066, 23, "?f?a9a7a5`4^4[4X=X=T4T45.5.T(T(X.X.Z/_1c4e9f"},  // f
    Glyph{0x0067, 41, "DGCLAQ>S:T6S3Q1L0G1A3=6;::>;A=CA J9I4H/F,C*?(:(4(/*//4-9,>-A/C3D8D;B8?7<5955617.:,>+B+G+L,P.T1W5X9Y<X?WBUDSDXJX"},  // g
    Glyph{0x0068, 41, "JJJ5D5DJDNBQ@S=T8S5Q3M3I35-5-f3f3S5U7W:X>YCXGUIQ"},  // h
    Glyph{0x0069, 18, "-X3X35-5 -f3f3^-^"},  // i
    Glyph{0x006a, 18, "-X3X342/0+-(((&(&-'-*-,.-0-4 -f3f3^-^"},  // j
    Glyph{0x006b, 37, "-f3f3IDXKX9HL5D53F35-5"},  // k
    Glyph{0x006c, 18, "-f3f35-5"},  // l
    Glyph{0x006d, 62, "HQKUMWQXUYYX]U_P`J`5Z5ZJZNXQVSSTOSLQJMIII5C5CJCNBQ?S<T8S5Q3M3I35-5-X3X3S5U7W:X>YAXDWGU"},  // m
    Glyph{0x006e, 41, "JJJ5D5DJDNBQ@S=T8S5Q3M3I35-5-X3X3S5U7W:X>YCXGUIQ"},  // n
    Glyph{0x006f, 39, ";T6S3P1L1F1A3=6:;9?:B=DAEFDLBP?S ;Y?XCWFTIPJLKFJAI=F9C6?5;46526/9,=+A+F+L,P/T2W6X"},  // o
    Glyph{0x0070, 41, "3:3(-(-X3X3S5U7W:X>YBXEWHTJPLLLFLAJ=H9E6B5>4:47658 FFFLDP@S<T8S5P3L3F3A5=8:<9@:D=FA"},  // p
    Glyph{0x0071, 41, "0F1A3=6::9>:A=CADFCLAP>S:T6S3P1L D:B8?6<4945516/9,=+A+F+L,P/T1W5X9Y<X?WBUDSDXJXJ(D("},  // q
    Glyph{0x0072, 26, "AS?S=T8S5Q3M3G35-5-X3X3S5U7W;X>Y@YAY"},  // r
    Glyph{0x0073, 33, "CWCR>S9T5T2S1Q0O1M2L4K8I:I?GCEEBE?D:A7=57415*6*<1:79:9=:?<?>?@>B;C7D5E0F-H+K+O,S.V2X8Y>X"},  // s
    Glyph{0x0074, 25, "3b3X?X?T3T3A3=4;6:9:?:?5955526/7.;-A-T)T)X-X-b"},  // t
    Glyph{0x0075, 41, ",C,X2X2C3?4<7::9>:A<C@DDDXJXJ5D5D:B8?6<4943508-<"},  // u
    Glyph{0x0076, 38, ")X/X:;EXKX>565"},  // v
    Glyph{0x0077, 52, "*X/X7=>XEXL=SXYXO5I5AR:535"},  // w
    Glyph{0x0078, 38, "JX=GK5D5:C05)56G*X1X:LCX"},  // x
    Glyph{0x0079, 38, "<29-7*4(1(,(,-/-2-3.506376)X/X:=EXKX"},  // y
    Glyph{0x007a, 34, "+XFXFS0:F:F5*5*:?S+S"},  // z
    Glyph{0x007b, 41, "H/H+F+A+>,;-:/92969>8B7D5E1F/F/J1J5K7L8O9S9Z9^:a;c>eAeFfHfHaFaBa@`?^?Z?R>N=K;I8H;G=E>B?>?6?3@0B/F/"},  // {
    Glyph{0x007c, 22, "4f4&/&/f"},  // |
    Glyph{0x007d, 41, "//1/5/7083868>9B:E<G?H<I:K9N8R8Z8^7`5a1a/a/f1f6e9e;c=a>^>Z>S>O@LBKFJHJHFFFBE@D>B>>>6>2=/;-9,6+1+/+"},  // }
    Glyph{0x007e, 54, "VOVISGPEJDFEBFAFAG<H9I6H4G1F.D.I1K4M:N=MBLCKGJKJPKSL"},  // ~
    Glyph{0x2212, 54, ".LVLVF.F"},  // −
    Glyph{0x00b7, 20, ".O4O4G.G"},  // ·
    Glyph{0x00b2, 26, "/M=M=J*J*M-P2T5X7[8]7^6`4a2a.a*_*c/d2e7d:b<`<]<[:X7T2P"},  // ²
    Glyph{0x00b0, 32, "7`5`3_1]1[1X3V5U7U9U;V=X=[=];_9` 7e;d>b@^A[@W>T;Q7Q3Q0S.W-[.^0b3d"},  // °
    Glyph{0x2264, 54, "VU8LVDV>.I.OVZ .:V:V5.5"},  // ≤
    Glyph{0x2265, 54, ".U.ZVOVI.>.DLL V:V5.5.:"},  // ≥
};
// clang-format on

}  // namespace vasorod
