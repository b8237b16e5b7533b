" SPDX-FileCopyrightText: 2026 The Betwixt authors
" SPDX-License-Identifier: Apache-2.0
" Written by betwixt help --print vim: the words are those of its rows.
if exists('b:current_syntax')
  finish
endif
syn case match
syn iskeyword @,48-57,_,-

syn match betwixtNumber '[-+]\=\%(\d\+\.\=\d*\|\.\d\+\)\%([eE][-+]\=\d\+\)\=\%(deg\|rad\|turn\|mm\|cm\|m\)\=\>'
syn match betwixtTime '\<[-+]\=\%(\d\+\.\=\d*\|\.\d\+\)\%(ms\|f\|s\|t\)\>'
syn match betwixtTime '\<\d\+:[0-9:.]\+'
syn keyword betwixtColor lightgoldenrodyellow mediumspringgreen mediumaquamarine mediumslateblue mediumturquoise mediumvioletred blanchedalmond cornflowerblue darkolivegreen lightslategray lightslategrey lightsteelblue mediumseagreen darkgoldenrod darkslateblue darkslategray darkslategrey darkturquoise lavenderblush lightseagreen palegoldenrod paleturquoise palevioletred rebeccapurple antiquewhite darkseagreen lemonchiffon lightskyblue mediumorchid mediumpurple midnightblue darkmagenta deepskyblue floralwhite forestgreen greenyellow lightsalmon lightyellow navajowhite saddlebrown springgreen yellowgreen aquamarine blueviolet chartreuse darkorange darkorchid darksalmon darkviolet dodgerblue ghostwhite lightcoral lightgreen mediumblue papayawhip powderblue sandybrown whitesmoke aliceblue burlywood cadetblue chocolate darkgreen darkkhaki firebrick gainsboro goldenrod indianred lawngreen lightblue lightcyan lightgray lightgrey lightpink limegreen mintcream mistyrose olivedrab orangered palegreen peachpuff rosybrown royalblue slateblue slategray slategrey steelblue turquoise cornsilk darkblue darkcyan darkgray darkgrey deeppink honeydew lavender moccasin seagreen seashell crimson darkred dimgray dimgrey fuchsia hotpink magenta oldlace skyblue thistle bisque indigo maroon orange orchid purple salmon sienna silver tomato violet yellow azure beige black brown coral green ivory khaki linen olive wheat white aqua blue cyan gold gray grey lime navy peru pink plum snow teal red tan
syn match betwixtColor '#\%(\x\{6}\|\x\{3}\)\>'
syn match betwixtOption '\<\%(keep-world\|velocity\|next-to\|release\|tangent\|through\|before\|after\|shift\|times\|until\|from\|into\|keep\|like\|cut\|by\|in\|on\|to\)\>'
syn match betwixtTwerper '\<\%(elastic-in-out\|bounce-in-out\|cubic-in-out\|quart-in-out\|quint-in-out\|back-in-out\|circ-in-out\|ease-in-out\|elastic-out\|expo-in-out\|quad-in-out\|sine-in-out\|bounce-out\|elastic-in\|bounce-in\|cubic-out\|quart-out\|quint-out\|back-out\|circ-out\|cubic-in\|ease-out\|expo-out\|quad-out\|quart-in\|quint-in\|sine-out\|back-in\|bspline\|circ-in\|ease-in\|expo-in\|hermite\|quad-in\|sine-in\|bezier\|fcurve\|linear\|smooth\|match\|slerp\|squad\|steps\|auto\|ease\|hold\|quantise\|smooth\|spring\|wobble\|delay\|limit\|noise\|steps\)\>'
syn match betwixtFunction '\.\zs\%(attach-position\|velocity-space\|environments\|stroke-round\|stroke-width\|transparency\|look-offset\|reach-chain\|reach-share\|attachment\|bounciness\|reach-pole\|collision\|direction\|intensity\|obstacles\|shininess\|transform\|fade-out\|geometry\|language\|loudness\|material\|position\|readings\|rotation\|touching\|density\|display\|fade-in\|in-view\|look-at\|numbers\|shutter\|texture\|upwards\|x-scale\|x-title\|y-scale\|y-title\|closed\|corner\|digits\|extent\|f-stop\|height\|joints\|layout\|length\|module\|motion\|onsets\|placed\|points\|radius\|shadow\|shines\|smooth\|sorted\|stroke\|weight\|within\|align\|apart\|color\|count\|depth\|drawn\|drive\|every\|focus\|front\|holes\|inner\|lines\|nodes\|panel\|parts\|pivot\|point\|range\|reach\|right\|scale\|sides\|slant\|teeth\|touch\|typed\|until\|value\|width\|world\|bare\|base\|cell\|dash\|dots\|file\|fill\|flow\|font\|from\|gain\|grid\|hole\|last\|lens\|mode\|part\|roll\|room\|size\|step\|text\|trim\|tube\|fov\|gap\|tex\|at\|by\|of\|on\|to\|up\|r\|x\|y\|z\)\>'
syn match betwixtFunction '\<\%(attach-position\|velocity-space\|environments\|stroke-round\|stroke-width\|transparency\|look-offset\|reach-chain\|reach-share\|attachment\|bounciness\|reach-pole\|collision\|direction\|intensity\|obstacles\|shininess\|transform\|fade-out\|geometry\|language\|loudness\|material\|position\|readings\|rotation\|touching\|density\|display\|fade-in\|in-view\|look-at\|numbers\|shutter\|texture\|upwards\|x-scale\|x-title\|y-scale\|y-title\|closed\|corner\|digits\|extent\|f-stop\|height\|joints\|layout\|length\|module\|motion\|onsets\|placed\|points\|radius\|shadow\|shines\|smooth\|sorted\|stroke\|weight\|within\|align\|apart\|color\|count\|depth\|drawn\|drive\|every\|focus\|front\|holes\|inner\|lines\|nodes\|panel\|parts\|pivot\|point\|range\|reach\|right\|scale\|sides\|slant\|teeth\|touch\|typed\|until\|value\|width\|world\|bare\|base\|cell\|dash\|dots\|file\|fill\|flow\|font\|from\|gain\|grid\|hole\|last\|lens\|mode\|part\|roll\|room\|size\|step\|text\|trim\|tube\|fov\|gap\|tex\|at\|by\|of\|on\|to\|up\|r\|x\|y\|z\)\ze[.a-z]*='
syn match betwixtOption '\<\%(ease\|tangent\|handle\)-\%(in\|out\)\ze='
syn match betwixtKind '\%(^\%(create\)\s\+\S\+\s\+\)\@<=\%(vector-field\|environment\|number-line\|streamlines\|line-chart\|plane-grid\|polar-axes\|rectangle\|cylinder\|polyline\|columns\|diagram\|polygon\|regular\|riemann\|scatter\|surface\|tangent\|camera\|circle\|matrix\|points\|sphere\|arrow\|brace\|curve\|group\|layer\|light\|plane\|scene\|sound\|table\|torus\|trace\|area\|axes\|bars\|code\|cone\|disc\|gear\|line\|mesh\|plot\|ring\|star\|text\|arc\|bar\|box\|dot\|pie\)\>'
syn match betwixtVerb '^\s\+\zs\%(orthographic\|perspective\|multiply\|polygon\|replace\|texture\|vector\|begin\|color\|point\|call\|font\|push\|text\|view\|end\|pop\|tag\)\>'
syn match betwixtVerb '^\%(circle-around\|pixel-filter\|background\|cross-out\|dimension\|highlight\|procedure\|rearrange\|spotlight\|subframes\|translate\|underline\|exposure\|fade-out\|ambient\|animate\|arrange\|callout\|connect\|contact\|fade-in\|reverse\|samples\|stagger\|stretch\|twerper\|attach\|cancel\|couple\|create\|define\|delete\|detach\|extend\|filter\|ground\|policy\|record\|remove\|rename\|revert\|rotate\|shrink\|spread\|unlink\|alias\|angle\|clear\|erase\|frame\|label\|layer\|letgo\|morph\|notes\|place\|range\|reach\|scale\|split\|start\|theme\|ticks\|write\|bake\|copy\|data\|dial\|draw\|edit\|fall\|fill\|film\|flip\|grow\|halt\|hang\|hide\|kill\|look\|make\|move\|note\|rate\|show\|size\|wipe\|fog\|let\|set\|sky\|use\|at\|on\)\>'
syn match betwixtVerb '\%(^\%(at\|on\)\s\+\S\+\s\+\)\@<=\%(circle-around\|pixel-filter\|background\|cross-out\|dimension\|highlight\|procedure\|rearrange\|spotlight\|subframes\|translate\|underline\|exposure\|fade-out\|ambient\|animate\|arrange\|callout\|connect\|contact\|fade-in\|reverse\|samples\|stagger\|stretch\|twerper\|attach\|cancel\|couple\|create\|define\|delete\|detach\|extend\|filter\|ground\|policy\|record\|remove\|rename\|revert\|rotate\|shrink\|spread\|unlink\|alias\|angle\|clear\|erase\|frame\|label\|layer\|letgo\|morph\|notes\|place\|range\|reach\|scale\|split\|start\|theme\|ticks\|write\|bake\|copy\|data\|dial\|draw\|edit\|fall\|fill\|film\|flip\|grow\|halt\|hang\|hide\|kill\|look\|make\|move\|note\|rate\|show\|size\|wipe\|fog\|let\|set\|sky\|use\|at\|on\)\>'
syn match betwixtComment '\%(^\|[ \t(),=]\)\@1<=#\%(\s.*\)\=$'
syn region betwixtText start='"' skip='\\.' end='"' oneline
syn region betwixtText start='"""' end='"""'

hi def link betwixtComment Comment
hi def link betwixtText String
hi def link betwixtVerb Statement
hi def link betwixtKind Type
hi def link betwixtFunction Identifier
hi def link betwixtTwerper Special
hi def link betwixtOption PreProc
hi def link betwixtColor Constant
hi def link betwixtNumber Number
hi def link betwixtTime Float

let b:current_syntax = 'betwixt'
