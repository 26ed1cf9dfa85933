/* quintrig studio; sources sha256 3e49d0b1d94bbd6f137278a8ade6d2949abbf4ed92322defd022129faa42b713; the licences of the packages in it follow */
/*! smol-toml 1.9.1 (BSD-3-Clause)

Copyright (c) Squirrel Chat et al., All rights reserved.

Redistribution and use in source and binary forms, with or without
modification, are permitted provided that the following conditions are met:

1. Redistributions of source code must retain the above copyright notice, this
   list of conditions and the following disclaimer.
2. Redistributions in binary form must reproduce the above copyright notice,
   this list of conditions and the following disclaimer in the
   documentation and/or other materials provided with the distribution.
3. Neither the name of the copyright holder nor the names of its contributors
   may be used to endorse or promote products derived from this software without
   specific prior written permission.

THIS SOFTWARE IS PROVIDED BY THE COPYRIGHT HOLDERS AND CONTRIBUTORS "AS IS" AND
ANY EXPRESS OR IMPLIED WARRANTIES, INCLUDING, BUT NOT LIMITED TO, THE IMPLIED
WARRANTIES OF MERCHANTABILITY AND FITNESS FOR A PARTICULAR PURPOSE ARE
DISCLAIMED. IN NO EVENT SHALL THE COPYRIGHT HOLDER OR CONTRIBUTORS BE LIABLE
FOR ANY DIRECT, INDIRECT, INCIDENTAL, SPECIAL, EXEMPLARY, OR CONSEQUENTIAL
DAMAGES (INCLUDING, BUT NOT LIMITED TO, PROCUREMENT OF SUBSTITUTE GOODS OR
SERVICES; LOSS OF USE, DATA, OR PROFITS; OR BUSINESS INTERRUPTION) HOWEVER
CAUSED AND ON ANY THEORY OF LIABILITY, WHETHER IN CONTRACT, STRICT LIABILITY,
OR TORT (INCLUDING NEGLIGENCE OR OTHERWISE) ARISING IN ANY WAY OUT OF THE USE
OF THIS SOFTWARE, EVEN IF ADVISED OF THE POSSIBILITY OF SUCH DAMAGE.
*/
/*! three 0.187.0 (MIT)

The MIT License

Copyright © 2010-2026 three.js authors

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in
all copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN
THE SOFTWARE.
*/
var Ue={version:"0.1.0",schema:1,units:["um","mm","cm","m","km","in","ft"],shapeRange:[-4,1],shapeSets:{"4":[[1,1,1,1],[1,1,-3,-3],[1,-3,1,-3],[1,0,-2,-3]],"2":[[1,1],[0,-4],[-2,0],[-2,-4]]},quantities:[{key:"point",symbol:"S(u, v)",latex:"\\mathbf{S}(u,v)",name:"point",meaning:"position",source:"thesis eq. 3.1",power:1,parity:"even",colour:"vector",partner:"",components:3,classes:[]},{key:"normal",symbol:"n",latex:"\\mathbf{n}",name:"unit normal",meaning:"S_u × S_v, normalised",source:"do Carmo 1976, §2.5-3.3",power:0,parity:"odd",colour:"vector",partner:"",components:3,classes:[]},{key:"E",symbol:"E",latex:"E",name:"first form E",meaning:"S_u · S_u",source:"do Carmo 1976, §2.5-3.3",power:2,parity:"even",colour:"sequential",partner:"",components:1,classes:[]},{key:"F",symbol:"F",latex:"F",name:"first form F",meaning:"S_u · S_v",source:"do Carmo 1976, §2.5-3.3",power:2,parity:"even",colour:"diverging",partner:"",components:1,classes:[]},{key:"G",symbol:"G",latex:"G",name:"first form G",meaning:"S_v · S_v",source:"do Carmo 1976, §2.5-3.3",power:2,parity:"even",colour:"sequential",partner:"",components:1,classes:[]},{key:"L",symbol:"L",latex:"L",name:"second form L",meaning:"S_uu · n",source:"do Carmo 1976, §2.5-3.3",power:1,parity:"odd",colour:"diverging",partner:"",components:1,classes:[]},{key:"M",symbol:"M",latex:"M",name:"second form M",meaning:"S_uv · n",source:"do Carmo 1976, §2.5-3.3",power:1,parity:"odd",colour:"diverging",partner:"",components:1,classes:[]},{key:"N",symbol:"N",latex:"N",name:"second form N",meaning:"S_vv · n",source:"do Carmo 1976, §2.5-3.3",power:1,parity:"odd",colour:"diverging",partner:"",components:1,classes:[]},{key:"gaussian",symbol:"K",latex:"K",name:"Gaussian curvature",meaning:"dome or bowl (+), developable (0), saddle (-)",source:"do Carmo 1976, §2.5-3.3",power:-2,parity:"even",colour:"diverging",partner:"",components:1,classes:[]},{key:"mean",symbol:"H",latex:"H",name:"mean curvature",meaning:"bends towards the normal (+) or away from it (-)",source:"do Carmo 1976, §2.5-3.3",power:-1,parity:"odd",colour:"diverging",partner:"",components:1,classes:[]},{key:"k1",symbol:"κ1",latex:"\\kappa_1",name:"larger principal curvature",meaning:"the most that the surface bends towards the normal: H + R, R = (κ1 - κ2)/2",source:"do Carmo 1976, §2.5-3.3",power:-1,parity:"swap",colour:"diverging",partner:"k2",components:1,classes:[]},{key:"k2",symbol:"κ2",latex:"\\kappa_2",name:"smaller principal curvature",meaning:"the least that it bends towards the normal, or the most away from it: H - R, R = (κ1 - κ2)/2",source:"do Carmo 1976, §2.5-3.3",power:-1,parity:"swap",colour:"diverging",partner:"k1",components:1,classes:[]},{key:"direction1",symbol:"d1",latex:"\\mathbf{d}_1",name:"direction of κ1",meaning:"unit tangent, NaN at umbilics",source:"do Carmo 1976, §2.5-3.3",power:0,parity:"swap",colour:"vector",partner:"direction2",components:3,classes:[]},{key:"direction2",symbol:"d2",latex:"\\mathbf{d}_2",name:"direction of κ2",meaning:"unit tangent, NaN at umbilics",source:"do Carmo 1976, §2.5-3.3",power:0,parity:"swap",colour:"vector",partner:"direction1",components:3,classes:[]},{key:"shape_index",symbol:"S",latex:"S",name:"shape index",meaning:"cup -1, rut -1/2, saddle 0, ridge +1/2, cap +1 (n towards the viewer)",source:"Koenderink and van Doorn 1992",power:0,parity:"odd",colour:"diverging",partner:"",components:1,classes:[]},{key:"curvedness",symbol:"C",latex:"C",name:"curvedness",meaning:"how strongly it bends, whatever the shape",source:"Koenderink and van Doorn 1992",power:-1,parity:"even",colour:"sequential",partner:"",components:1,classes:[]},{key:"beta0",symbol:"β0",latex:"\\beta_0",name:"squared slope",meaning:"square of the slope, in the metric of the horizontal plane (the definition for a height field)",source:"Fujita and Ohsaki 2009; Iri et al. 2001",power:0,parity:"even",colour:"sequential",partner:"",components:1,classes:[]},{key:"beta1",symbol:"β1",latex:"\\beta_1",name:"Laplacian of the height",meaning:"bowl-like (+) or roof-like (-), in the metric of the horizontal plane (the definition for a height field)",source:"Fujita and Ohsaki 2009; Iri et al. 2001",power:-1,parity:"even",colour:"diverging",partner:"",components:1,classes:[]},{key:"beta2",symbol:"β2",latex:"\\beta_2",name:"Hessian determinant",meaning:"dome or bowl (+), developable (0), saddle (-), in the metric of the horizontal plane (the definition for a height field)",source:"Fujita and Ohsaki 2009; Iri et al. 2001",power:-2,parity:"even",colour:"diverging",partner:"",components:1,classes:[]},{key:"gamma1",symbol:"γ1",latex:"\\gamma_1",name:"bending along steepest descent",meaning:"slope eases (+) or steepens (-) downhill; weighted by slope², in the metric of the horizontal plane (the definition for a height field)",source:"Fujita and Ohsaki 2009; Iri et al. 2001",power:-1,parity:"even",colour:"diverging",partner:"",components:1,classes:[]},{key:"gamma2",symbol:"γ2",latex:"\\gamma_2",name:"twist of steepest descent",meaning:"0 on crest and trough lines; weighted by slope², in the metric of the horizontal plane (the definition for a height field)",source:"Fujita and Ohsaki 2009; Iri et al. 2001",power:-1,parity:"even",colour:"diverging",partner:"",components:1,classes:[]},{key:"gamma3",symbol:"γ3",latex:"\\gamma_3",name:"bending along the contour",meaning:"hollow (+) or spur (-): rises or falls to both sides along the contour; weighted by slope², in the metric of the horizontal plane (the definition for a height field)",source:"Fujita and Ohsaki 2009; Iri et al. 2001",power:-1,parity:"even",colour:"diverging",partner:"",components:1,classes:[]},{key:"beta0_surface",symbol:"β0ˢ",latex:"\\beta_0^{S}",name:"squared slope",meaning:"square of the slope, in the metric of the surface",source:"Fujita and Ohsaki 2009; Iri et al. 2001",power:0,parity:"even",colour:"sequential",partner:"",components:1,classes:[]},{key:"beta1_surface",symbol:"β1ˢ",latex:"\\beta_1^{S}",name:"Laplacian of the height",meaning:"bowl-like (+) or roof-like (-), in the metric of the surface",source:"Fujita and Ohsaki 2009; Iri et al. 2001",power:-1,parity:"even",colour:"diverging",partner:"",components:1,classes:[]},{key:"beta2_surface",symbol:"β2ˢ",latex:"\\beta_2^{S}",name:"Hessian determinant",meaning:"dome or bowl (+), developable (0), saddle (-), in the metric of the surface",source:"Fujita and Ohsaki 2009; Iri et al. 2001",power:-2,parity:"even",colour:"diverging",partner:"",components:1,classes:[]},{key:"gamma1_surface",symbol:"γ1ˢ",latex:"\\gamma_1^{S}",name:"bending along steepest descent",meaning:"slope eases (+) or steepens (-) downhill; weighted by slope², in the metric of the surface",source:"Fujita and Ohsaki 2009; Iri et al. 2001",power:-1,parity:"even",colour:"diverging",partner:"",components:1,classes:[]},{key:"gamma2_surface",symbol:"γ2ˢ",latex:"\\gamma_2^{S}",name:"twist of steepest descent",meaning:"0 on crest and trough lines; weighted by slope², in the metric of the surface",source:"Fujita and Ohsaki 2009; Iri et al. 2001",power:-1,parity:"even",colour:"diverging",partner:"",components:1,classes:[]},{key:"gamma3_surface",symbol:"γ3ˢ",latex:"\\gamma_3^{S}",name:"bending along the contour",meaning:"hollow (+) or spur (-): rises or falls to both sides along the contour; weighted by slope², in the metric of the surface",source:"Fujita and Ohsaki 2009; Iri et al. 2001",power:-1,parity:"even",colour:"diverging",partner:"",components:1,classes:[]},{key:"point_type",symbol:"point type",latex:"\\mathrm{type}",name:"point type",meaning:"signs of κ1 and κ2",source:"thesis table 3.1",power:0,parity:"even",colour:"classes",partner:"",components:1,classes:["undefined","elliptic","hyperbolic","parabolic","planar","umbilic"]},{key:"hk_type",symbol:"HK type",latex:"HK",name:"HK type",meaning:"signs of K and H, n towards the viewer",source:"Besl and Jain 1986; thesis table 3.2",power:0,parity:"mirror",colour:"classes",partner:"",components:1,classes:["undefined","peak","ridge","saddle ridge","impossible","flat","minimal","pit","valley","saddle valley"]},{key:"shape_class",symbol:"shape class",latex:"S\\,\\mathrm{class}",name:"shape class",meaning:"nine ranges of the shape index",source:"Koenderink and van Doorn 1992; thesis table 3.3",power:0,parity:"mirror",colour:"classes",partner:"",components:1,classes:["undefined","spherical cup","trough","rut","saddle rut","saddle","saddle ridge","ridge","dome","spherical cap","planar"]},{key:"invariant_type",symbol:"invariant type",latex:"\\beta\\,\\mathrm{type}",name:"invariant type",meaning:"signs of β1 and β2, seen from above",source:"Fujita and Ohsaki 2009; thesis table 3.4",power:0,parity:"even",colour:"classes",partner:"",components:1,classes:["undefined","dome","roof","saddle roof","impossible","level or tilted plane","balanced saddle","bowl","trough","saddle trough"]}],limits:{relative:1e-6,flat:1e-6,noise:1e-12,sameColour:1e-9,rounding:14210854715202004e-30,singular:9094947017729282e-28,stepsForSize:17,farOff:1e6,samePoint:7105427357601002e-30,vertical:1e-9,largest:1e50,largestPolygon:64},shapeBreaks:[.125,.375,.625,.875],families:["trigonometric","bernstein","bspline","circular","hyperbolic","powers","joined","formulas","chebyshev"],library:[{name:"trigonometric",title:"Quintic trigonometric Bézier",counts:"6 control points",sizes:[6],usual:6,formulas:{"6":{functions:["a^4*(1-alpha+alpha*a)","s*a^3*(4+alpha-alpha*s)","a^2*b*(8*s+3*c+9)","b^2*a*(8*c+3*s+9)","c*b^3*(4+zeta-zeta*c)","b^4*(1-zeta+zeta*b)"],parameters:[["alpha",-4,1,0,!1,!1],["zeta",-4,1,0,!1,!1]]}}},{name:"quadratic",title:"Quadratic trigonometric Bézier",counts:"3 control points",sizes:[3],usual:3,formulas:{"3":{functions:["a*(1-alpha+alpha*a)","2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b","b*(1-zeta+zeta*b)"],parameters:[["alpha",-1,1,0,!1,!1],["zeta",-1,1,0,!1,!1]]}}},{name:"cubic",title:"Cubic trigonometric Bézier",counts:"4 control points",sizes:[4],usual:4,formulas:{"4":{functions:["a^2*(1-alpha+alpha*a)","s*a*(2+alpha-alpha*s)","c*b*(2+zeta-zeta*c)","b^2*(1-zeta+zeta*b)"],parameters:[["alpha",-2,1,0,!1,!1],["zeta",-2,1,0,!1,!1]]}}},{name:"quartic",title:"Quartic trigonometric Bézier",counts:"5 control points",sizes:[5],usual:5,formulas:{"5":{functions:["a^3*(1-alpha+alpha*a)","s*a^2*(3+alpha-alpha*s)","2*a*b*(2+s+c)","c*b^2*(3+zeta-zeta*c)","b^3*(1-zeta+zeta*b)"],parameters:[["alpha",-3,1,0,!1,!1],["zeta",-3,1,0,!1,!1]]}}},{name:"quintic",title:"Quintic trigonometric Bézier",counts:"6 control points",sizes:[6],usual:6,formulas:{"6":{functions:["a^4*(1-alpha+alpha*a)","s*a^3*(4+alpha-alpha*s)","a^2*b*(8*s+3*c+9)","b^2*a*(8*c+3*s+9)","c*b^3*(4+zeta-zeta*c)","b^4*(1-zeta+zeta*b)"],parameters:[["alpha",-4,1,0,!1,!1],["zeta",-4,1,0,!1,!1]]}}},{name:"generalised_trigonometric",title:"Generalised trigonometric Bézier",counts:"3 or more control points",sizes:[3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24,25,26,27,28,29,30,31,32,33,34,35,36,37,38,39,40,41,42,43,44,45,46,47,48,49,50,51,52,53,54,55,56,57,58,59,60,61,62,63,64],usual:6,formulas:{"3":{functions:["1*1*1*(a*(1-alpha+alpha*a))","1*1*1*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)","1*1*1*(b*(1-zeta+zeta*b))"],parameters:[["alpha",-1,1,0,!1,!1],["zeta",-1,1,0,!1,!1]]},"4":{functions:["1*r*1*(a*(1-alpha+alpha*a))","1*1*t*(a*(1-alpha+alpha*a))+1*r*1*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)","1*1*t*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1*r*1*(b*(1-zeta+zeta*b))","1*1*t*(b*(1-zeta+zeta*b))"],parameters:[["alpha",-1,1,0,!1,!1],["zeta",-1,1,0,!1,!1]]},"5":{functions:["1*r^2*1*(a*(1-alpha+alpha*a))","2*r*t*(a*(1-alpha+alpha*a))+1*r^2*1*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)","1*1*t^2*(a*(1-alpha+alpha*a))+2*r*t*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1*r^2*1*(b*(1-zeta+zeta*b))","1*1*t^2*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+2*r*t*(b*(1-zeta+zeta*b))","1*1*t^2*(b*(1-zeta+zeta*b))"],parameters:[["alpha",-1,1,0,!1,!1],["zeta",-1,1,0,!1,!1]]},"6":{functions:["1*r^3*1*(a*(1-alpha+alpha*a))","3*r^2*t*(a*(1-alpha+alpha*a))+1*r^3*1*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)","3*r*t^2*(a*(1-alpha+alpha*a))+3*r^2*t*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1*r^3*1*(b*(1-zeta+zeta*b))","1*1*t^3*(a*(1-alpha+alpha*a))+3*r*t^2*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+3*r^2*t*(b*(1-zeta+zeta*b))","1*1*t^3*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+3*r*t^2*(b*(1-zeta+zeta*b))","1*1*t^3*(b*(1-zeta+zeta*b))"],parameters:[["alpha",-1,1,0,!1,!1],["zeta",-1,1,0,!1,!1]]},"7":{functions:["1*r^4*1*(a*(1-alpha+alpha*a))","4*r^3*t*(a*(1-alpha+alpha*a))+1*r^4*1*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)","6*r^2*t^2*(a*(1-alpha+alpha*a))+4*r^3*t*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1*r^4*1*(b*(1-zeta+zeta*b))","4*r*t^3*(a*(1-alpha+alpha*a))+6*r^2*t^2*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+4*r^3*t*(b*(1-zeta+zeta*b))","1*1*t^4*(a*(1-alpha+alpha*a))+4*r*t^3*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+6*r^2*t^2*(b*(1-zeta+zeta*b))","1*1*t^4*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+4*r*t^3*(b*(1-zeta+zeta*b))","1*1*t^4*(b*(1-zeta+zeta*b))"],parameters:[["alpha",-1,1,0,!1,!1],["zeta",-1,1,0,!1,!1]]},"8":{functions:["1*r^5*1*(a*(1-alpha+alpha*a))","5*r^4*t*(a*(1-alpha+alpha*a))+1*r^5*1*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)","10*r^3*t^2*(a*(1-alpha+alpha*a))+5*r^4*t*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1*r^5*1*(b*(1-zeta+zeta*b))","10*r^2*t^3*(a*(1-alpha+alpha*a))+10*r^3*t^2*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+5*r^4*t*(b*(1-zeta+zeta*b))","5*r*t^4*(a*(1-alpha+alpha*a))+10*r^2*t^3*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+10*r^3*t^2*(b*(1-zeta+zeta*b))","1*1*t^5*(a*(1-alpha+alpha*a))+5*r*t^4*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+10*r^2*t^3*(b*(1-zeta+zeta*b))","1*1*t^5*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+5*r*t^4*(b*(1-zeta+zeta*b))","1*1*t^5*(b*(1-zeta+zeta*b))"],parameters:[["alpha",-1,1,0,!1,!1],["zeta",-1,1,0,!1,!1]]},"9":{functions:["1*r^6*1*(a*(1-alpha+alpha*a))","6*r^5*t*(a*(1-alpha+alpha*a))+1*r^6*1*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)","15*r^4*t^2*(a*(1-alpha+alpha*a))+6*r^5*t*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1*r^6*1*(b*(1-zeta+zeta*b))","20*r^3*t^3*(a*(1-alpha+alpha*a))+15*r^4*t^2*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+6*r^5*t*(b*(1-zeta+zeta*b))","15*r^2*t^4*(a*(1-alpha+alpha*a))+20*r^3*t^3*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+15*r^4*t^2*(b*(1-zeta+zeta*b))","6*r*t^5*(a*(1-alpha+alpha*a))+15*r^2*t^4*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+20*r^3*t^3*(b*(1-zeta+zeta*b))","1*1*t^6*(a*(1-alpha+alpha*a))+6*r*t^5*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+15*r^2*t^4*(b*(1-zeta+zeta*b))","1*1*t^6*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+6*r*t^5*(b*(1-zeta+zeta*b))","1*1*t^6*(b*(1-zeta+zeta*b))"],parameters:[["alpha",-1,1,0,!1,!1],["zeta",-1,1,0,!1,!1]]},"10":{functions:["1*r^7*1*(a*(1-alpha+alpha*a))","7*r^6*t*(a*(1-alpha+alpha*a))+1*r^7*1*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)","21*r^5*t^2*(a*(1-alpha+alpha*a))+7*r^6*t*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1*r^7*1*(b*(1-zeta+zeta*b))","35*r^4*t^3*(a*(1-alpha+alpha*a))+21*r^5*t^2*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+7*r^6*t*(b*(1-zeta+zeta*b))","35*r^3*t^4*(a*(1-alpha+alpha*a))+35*r^4*t^3*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+21*r^5*t^2*(b*(1-zeta+zeta*b))","21*r^2*t^5*(a*(1-alpha+alpha*a))+35*r^3*t^4*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+35*r^4*t^3*(b*(1-zeta+zeta*b))","7*r*t^6*(a*(1-alpha+alpha*a))+21*r^2*t^5*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+35*r^3*t^4*(b*(1-zeta+zeta*b))","1*1*t^7*(a*(1-alpha+alpha*a))+7*r*t^6*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+21*r^2*t^5*(b*(1-zeta+zeta*b))","1*1*t^7*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+7*r*t^6*(b*(1-zeta+zeta*b))","1*1*t^7*(b*(1-zeta+zeta*b))"],parameters:[["alpha",-1,1,0,!1,!1],["zeta",-1,1,0,!1,!1]]},"11":{functions:["1*r^8*1*(a*(1-alpha+alpha*a))","8*r^7*t*(a*(1-alpha+alpha*a))+1*r^8*1*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)","28*r^6*t^2*(a*(1-alpha+alpha*a))+8*r^7*t*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1*r^8*1*(b*(1-zeta+zeta*b))","56*r^5*t^3*(a*(1-alpha+alpha*a))+28*r^6*t^2*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+8*r^7*t*(b*(1-zeta+zeta*b))","70*r^4*t^4*(a*(1-alpha+alpha*a))+56*r^5*t^3*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+28*r^6*t^2*(b*(1-zeta+zeta*b))","56*r^3*t^5*(a*(1-alpha+alpha*a))+70*r^4*t^4*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+56*r^5*t^3*(b*(1-zeta+zeta*b))","28*r^2*t^6*(a*(1-alpha+alpha*a))+56*r^3*t^5*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+70*r^4*t^4*(b*(1-zeta+zeta*b))","8*r*t^7*(a*(1-alpha+alpha*a))+28*r^2*t^6*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+56*r^3*t^5*(b*(1-zeta+zeta*b))","1*1*t^8*(a*(1-alpha+alpha*a))+8*r*t^7*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+28*r^2*t^6*(b*(1-zeta+zeta*b))","1*1*t^8*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+8*r*t^7*(b*(1-zeta+zeta*b))","1*1*t^8*(b*(1-zeta+zeta*b))"],parameters:[["alpha",-1,1,0,!1,!1],["zeta",-1,1,0,!1,!1]]},"12":{functions:["1*r^9*1*(a*(1-alpha+alpha*a))","9*r^8*t*(a*(1-alpha+alpha*a))+1*r^9*1*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)","36*r^7*t^2*(a*(1-alpha+alpha*a))+9*r^8*t*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1*r^9*1*(b*(1-zeta+zeta*b))","84*r^6*t^3*(a*(1-alpha+alpha*a))+36*r^7*t^2*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+9*r^8*t*(b*(1-zeta+zeta*b))","126*r^5*t^4*(a*(1-alpha+alpha*a))+84*r^6*t^3*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+36*r^7*t^2*(b*(1-zeta+zeta*b))","126*r^4*t^5*(a*(1-alpha+alpha*a))+126*r^5*t^4*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+84*r^6*t^3*(b*(1-zeta+zeta*b))","84*r^3*t^6*(a*(1-alpha+alpha*a))+126*r^4*t^5*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+126*r^5*t^4*(b*(1-zeta+zeta*b))","36*r^2*t^7*(a*(1-alpha+alpha*a))+84*r^3*t^6*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+126*r^4*t^5*(b*(1-zeta+zeta*b))","9*r*t^8*(a*(1-alpha+alpha*a))+36*r^2*t^7*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+84*r^3*t^6*(b*(1-zeta+zeta*b))","1*1*t^9*(a*(1-alpha+alpha*a))+9*r*t^8*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+36*r^2*t^7*(b*(1-zeta+zeta*b))","1*1*t^9*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+9*r*t^8*(b*(1-zeta+zeta*b))","1*1*t^9*(b*(1-zeta+zeta*b))"],parameters:[["alpha",-1,1,0,!1,!1],["zeta",-1,1,0,!1,!1]]},"13":{functions:["1*r^10*1*(a*(1-alpha+alpha*a))","10*r^9*t*(a*(1-alpha+alpha*a))+1*r^10*1*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)","45*r^8*t^2*(a*(1-alpha+alpha*a))+10*r^9*t*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1*r^10*1*(b*(1-zeta+zeta*b))","120*r^7*t^3*(a*(1-alpha+alpha*a))+45*r^8*t^2*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+10*r^9*t*(b*(1-zeta+zeta*b))","210*r^6*t^4*(a*(1-alpha+alpha*a))+120*r^7*t^3*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+45*r^8*t^2*(b*(1-zeta+zeta*b))","252*r^5*t^5*(a*(1-alpha+alpha*a))+210*r^6*t^4*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+120*r^7*t^3*(b*(1-zeta+zeta*b))","210*r^4*t^6*(a*(1-alpha+alpha*a))+252*r^5*t^5*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+210*r^6*t^4*(b*(1-zeta+zeta*b))","120*r^3*t^7*(a*(1-alpha+alpha*a))+210*r^4*t^6*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+252*r^5*t^5*(b*(1-zeta+zeta*b))","45*r^2*t^8*(a*(1-alpha+alpha*a))+120*r^3*t^7*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+210*r^4*t^6*(b*(1-zeta+zeta*b))","10*r*t^9*(a*(1-alpha+alpha*a))+45*r^2*t^8*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+120*r^3*t^7*(b*(1-zeta+zeta*b))","1*1*t^10*(a*(1-alpha+alpha*a))+10*r*t^9*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+45*r^2*t^8*(b*(1-zeta+zeta*b))","1*1*t^10*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+10*r*t^9*(b*(1-zeta+zeta*b))","1*1*t^10*(b*(1-zeta+zeta*b))"],parameters:[["alpha",-1,1,0,!1,!1],["zeta",-1,1,0,!1,!1]]},"14":{functions:["1*r^11*1*(a*(1-alpha+alpha*a))","11*r^10*t*(a*(1-alpha+alpha*a))+1*r^11*1*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)","55*r^9*t^2*(a*(1-alpha+alpha*a))+11*r^10*t*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1*r^11*1*(b*(1-zeta+zeta*b))","165*r^8*t^3*(a*(1-alpha+alpha*a))+55*r^9*t^2*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+11*r^10*t*(b*(1-zeta+zeta*b))","330*r^7*t^4*(a*(1-alpha+alpha*a))+165*r^8*t^3*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+55*r^9*t^2*(b*(1-zeta+zeta*b))","462*r^6*t^5*(a*(1-alpha+alpha*a))+330*r^7*t^4*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+165*r^8*t^3*(b*(1-zeta+zeta*b))","462*r^5*t^6*(a*(1-alpha+alpha*a))+462*r^6*t^5*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+330*r^7*t^4*(b*(1-zeta+zeta*b))","330*r^4*t^7*(a*(1-alpha+alpha*a))+462*r^5*t^6*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+462*r^6*t^5*(b*(1-zeta+zeta*b))","165*r^3*t^8*(a*(1-alpha+alpha*a))+330*r^4*t^7*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+462*r^5*t^6*(b*(1-zeta+zeta*b))","55*r^2*t^9*(a*(1-alpha+alpha*a))+165*r^3*t^8*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+330*r^4*t^7*(b*(1-zeta+zeta*b))","11*r*t^10*(a*(1-alpha+alpha*a))+55*r^2*t^9*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+165*r^3*t^8*(b*(1-zeta+zeta*b))","1*1*t^11*(a*(1-alpha+alpha*a))+11*r*t^10*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+55*r^2*t^9*(b*(1-zeta+zeta*b))","1*1*t^11*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+11*r*t^10*(b*(1-zeta+zeta*b))","1*1*t^11*(b*(1-zeta+zeta*b))"],parameters:[["alpha",-1,1,0,!1,!1],["zeta",-1,1,0,!1,!1]]},"15":{functions:["1*r^12*1*(a*(1-alpha+alpha*a))","12*r^11*t*(a*(1-alpha+alpha*a))+1*r^12*1*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)","66*r^10*t^2*(a*(1-alpha+alpha*a))+12*r^11*t*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1*r^12*1*(b*(1-zeta+zeta*b))","220*r^9*t^3*(a*(1-alpha+alpha*a))+66*r^10*t^2*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+12*r^11*t*(b*(1-zeta+zeta*b))","495*r^8*t^4*(a*(1-alpha+alpha*a))+220*r^9*t^3*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+66*r^10*t^2*(b*(1-zeta+zeta*b))","792*r^7*t^5*(a*(1-alpha+alpha*a))+495*r^8*t^4*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+220*r^9*t^3*(b*(1-zeta+zeta*b))","924*r^6*t^6*(a*(1-alpha+alpha*a))+792*r^7*t^5*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+495*r^8*t^4*(b*(1-zeta+zeta*b))","792*r^5*t^7*(a*(1-alpha+alpha*a))+924*r^6*t^6*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+792*r^7*t^5*(b*(1-zeta+zeta*b))","495*r^4*t^8*(a*(1-alpha+alpha*a))+792*r^5*t^7*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+924*r^6*t^6*(b*(1-zeta+zeta*b))","220*r^3*t^9*(a*(1-alpha+alpha*a))+495*r^4*t^8*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+792*r^5*t^7*(b*(1-zeta+zeta*b))","66*r^2*t^10*(a*(1-alpha+alpha*a))+220*r^3*t^9*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+495*r^4*t^8*(b*(1-zeta+zeta*b))","12*r*t^11*(a*(1-alpha+alpha*a))+66*r^2*t^10*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+220*r^3*t^9*(b*(1-zeta+zeta*b))","1*1*t^12*(a*(1-alpha+alpha*a))+12*r*t^11*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+66*r^2*t^10*(b*(1-zeta+zeta*b))","1*1*t^12*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+12*r*t^11*(b*(1-zeta+zeta*b))","1*1*t^12*(b*(1-zeta+zeta*b))"],parameters:[["alpha",-1,1,0,!1,!1],["zeta",-1,1,0,!1,!1]]},"16":{functions:["1*r^13*1*(a*(1-alpha+alpha*a))","13*r^12*t*(a*(1-alpha+alpha*a))+1*r^13*1*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)","78*r^11*t^2*(a*(1-alpha+alpha*a))+13*r^12*t*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1*r^13*1*(b*(1-zeta+zeta*b))","286*r^10*t^3*(a*(1-alpha+alpha*a))+78*r^11*t^2*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+13*r^12*t*(b*(1-zeta+zeta*b))","715*r^9*t^4*(a*(1-alpha+alpha*a))+286*r^10*t^3*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+78*r^11*t^2*(b*(1-zeta+zeta*b))","1287*r^8*t^5*(a*(1-alpha+alpha*a))+715*r^9*t^4*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+286*r^10*t^3*(b*(1-zeta+zeta*b))","1716*r^7*t^6*(a*(1-alpha+alpha*a))+1287*r^8*t^5*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+715*r^9*t^4*(b*(1-zeta+zeta*b))","1716*r^6*t^7*(a*(1-alpha+alpha*a))+1716*r^7*t^6*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1287*r^8*t^5*(b*(1-zeta+zeta*b))","1287*r^5*t^8*(a*(1-alpha+alpha*a))+1716*r^6*t^7*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1716*r^7*t^6*(b*(1-zeta+zeta*b))","715*r^4*t^9*(a*(1-alpha+alpha*a))+1287*r^5*t^8*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1716*r^6*t^7*(b*(1-zeta+zeta*b))","286*r^3*t^10*(a*(1-alpha+alpha*a))+715*r^4*t^9*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1287*r^5*t^8*(b*(1-zeta+zeta*b))","78*r^2*t^11*(a*(1-alpha+alpha*a))+286*r^3*t^10*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+715*r^4*t^9*(b*(1-zeta+zeta*b))","13*r*t^12*(a*(1-alpha+alpha*a))+78*r^2*t^11*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+286*r^3*t^10*(b*(1-zeta+zeta*b))","1*1*t^13*(a*(1-alpha+alpha*a))+13*r*t^12*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+78*r^2*t^11*(b*(1-zeta+zeta*b))","1*1*t^13*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+13*r*t^12*(b*(1-zeta+zeta*b))","1*1*t^13*(b*(1-zeta+zeta*b))"],parameters:[["alpha",-1,1,0,!1,!1],["zeta",-1,1,0,!1,!1]]}}},{name:"generalised_trigonometric_squares",title:"Generalised trigonometric Bézier, with cos² and sin² for 1 - t and t",counts:"3 to 34 control points",sizes:[3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24,25,26,27,28,29,30,31,32,33,34],usual:6,formulas:{"3":{functions:["1*1*1*(a*(1-alpha+alpha*a))","1*1*1*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)","1*1*1*(b*(1-zeta+zeta*b))"],parameters:[["alpha",-1,1,0,!1,!1],["zeta",-1,1,0,!1,!1]]},"4":{functions:["1*c^2*1*(a*(1-alpha+alpha*a))","1*1*s^2*(a*(1-alpha+alpha*a))+1*c^2*1*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)","1*1*s^2*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1*c^2*1*(b*(1-zeta+zeta*b))","1*1*s^2*(b*(1-zeta+zeta*b))"],parameters:[["alpha",-1,1,0,!1,!1],["zeta",-1,1,0,!1,!1]]},"5":{functions:["1*c^4*1*(a*(1-alpha+alpha*a))","2*c^2*s^2*(a*(1-alpha+alpha*a))+1*c^4*1*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)","1*1*s^4*(a*(1-alpha+alpha*a))+2*c^2*s^2*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1*c^4*1*(b*(1-zeta+zeta*b))","1*1*s^4*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+2*c^2*s^2*(b*(1-zeta+zeta*b))","1*1*s^4*(b*(1-zeta+zeta*b))"],parameters:[["alpha",-1,1,0,!1,!1],["zeta",-1,1,0,!1,!1]]},"6":{functions:["1*c^6*1*(a*(1-alpha+alpha*a))","3*c^4*s^2*(a*(1-alpha+alpha*a))+1*c^6*1*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)","3*c^2*s^4*(a*(1-alpha+alpha*a))+3*c^4*s^2*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1*c^6*1*(b*(1-zeta+zeta*b))","1*1*s^6*(a*(1-alpha+alpha*a))+3*c^2*s^4*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+3*c^4*s^2*(b*(1-zeta+zeta*b))","1*1*s^6*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+3*c^2*s^4*(b*(1-zeta+zeta*b))","1*1*s^6*(b*(1-zeta+zeta*b))"],parameters:[["alpha",-1,1,0,!1,!1],["zeta",-1,1,0,!1,!1]]},"7":{functions:["1*c^8*1*(a*(1-alpha+alpha*a))","4*c^6*s^2*(a*(1-alpha+alpha*a))+1*c^8*1*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)","6*c^4*s^4*(a*(1-alpha+alpha*a))+4*c^6*s^2*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1*c^8*1*(b*(1-zeta+zeta*b))","4*c^2*s^6*(a*(1-alpha+alpha*a))+6*c^4*s^4*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+4*c^6*s^2*(b*(1-zeta+zeta*b))","1*1*s^8*(a*(1-alpha+alpha*a))+4*c^2*s^6*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+6*c^4*s^4*(b*(1-zeta+zeta*b))","1*1*s^8*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+4*c^2*s^6*(b*(1-zeta+zeta*b))","1*1*s^8*(b*(1-zeta+zeta*b))"],parameters:[["alpha",-1,1,0,!1,!1],["zeta",-1,1,0,!1,!1]]},"8":{functions:["1*c^10*1*(a*(1-alpha+alpha*a))","5*c^8*s^2*(a*(1-alpha+alpha*a))+1*c^10*1*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)","10*c^6*s^4*(a*(1-alpha+alpha*a))+5*c^8*s^2*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1*c^10*1*(b*(1-zeta+zeta*b))","10*c^4*s^6*(a*(1-alpha+alpha*a))+10*c^6*s^4*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+5*c^8*s^2*(b*(1-zeta+zeta*b))","5*c^2*s^8*(a*(1-alpha+alpha*a))+10*c^4*s^6*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+10*c^6*s^4*(b*(1-zeta+zeta*b))","1*1*s^10*(a*(1-alpha+alpha*a))+5*c^2*s^8*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+10*c^4*s^6*(b*(1-zeta+zeta*b))","1*1*s^10*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+5*c^2*s^8*(b*(1-zeta+zeta*b))","1*1*s^10*(b*(1-zeta+zeta*b))"],parameters:[["alpha",-1,1,0,!1,!1],["zeta",-1,1,0,!1,!1]]},"9":{functions:["1*c^12*1*(a*(1-alpha+alpha*a))","6*c^10*s^2*(a*(1-alpha+alpha*a))+1*c^12*1*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)","15*c^8*s^4*(a*(1-alpha+alpha*a))+6*c^10*s^2*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1*c^12*1*(b*(1-zeta+zeta*b))","20*c^6*s^6*(a*(1-alpha+alpha*a))+15*c^8*s^4*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+6*c^10*s^2*(b*(1-zeta+zeta*b))","15*c^4*s^8*(a*(1-alpha+alpha*a))+20*c^6*s^6*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+15*c^8*s^4*(b*(1-zeta+zeta*b))","6*c^2*s^10*(a*(1-alpha+alpha*a))+15*c^4*s^8*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+20*c^6*s^6*(b*(1-zeta+zeta*b))","1*1*s^12*(a*(1-alpha+alpha*a))+6*c^2*s^10*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+15*c^4*s^8*(b*(1-zeta+zeta*b))","1*1*s^12*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+6*c^2*s^10*(b*(1-zeta+zeta*b))","1*1*s^12*(b*(1-zeta+zeta*b))"],parameters:[["alpha",-1,1,0,!1,!1],["zeta",-1,1,0,!1,!1]]},"10":{functions:["1*c^14*1*(a*(1-alpha+alpha*a))","7*c^12*s^2*(a*(1-alpha+alpha*a))+1*c^14*1*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)","21*c^10*s^4*(a*(1-alpha+alpha*a))+7*c^12*s^2*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1*c^14*1*(b*(1-zeta+zeta*b))","35*c^8*s^6*(a*(1-alpha+alpha*a))+21*c^10*s^4*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+7*c^12*s^2*(b*(1-zeta+zeta*b))","35*c^6*s^8*(a*(1-alpha+alpha*a))+35*c^8*s^6*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+21*c^10*s^4*(b*(1-zeta+zeta*b))","21*c^4*s^10*(a*(1-alpha+alpha*a))+35*c^6*s^8*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+35*c^8*s^6*(b*(1-zeta+zeta*b))","7*c^2*s^12*(a*(1-alpha+alpha*a))+21*c^4*s^10*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+35*c^6*s^8*(b*(1-zeta+zeta*b))","1*1*s^14*(a*(1-alpha+alpha*a))+7*c^2*s^12*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+21*c^4*s^10*(b*(1-zeta+zeta*b))","1*1*s^14*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+7*c^2*s^12*(b*(1-zeta+zeta*b))","1*1*s^14*(b*(1-zeta+zeta*b))"],parameters:[["alpha",-1,1,0,!1,!1],["zeta",-1,1,0,!1,!1]]},"11":{functions:["1*c^16*1*(a*(1-alpha+alpha*a))","8*c^14*s^2*(a*(1-alpha+alpha*a))+1*c^16*1*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)","28*c^12*s^4*(a*(1-alpha+alpha*a))+8*c^14*s^2*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1*c^16*1*(b*(1-zeta+zeta*b))","56*c^10*s^6*(a*(1-alpha+alpha*a))+28*c^12*s^4*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+8*c^14*s^2*(b*(1-zeta+zeta*b))","70*c^8*s^8*(a*(1-alpha+alpha*a))+56*c^10*s^6*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+28*c^12*s^4*(b*(1-zeta+zeta*b))","56*c^6*s^10*(a*(1-alpha+alpha*a))+70*c^8*s^8*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+56*c^10*s^6*(b*(1-zeta+zeta*b))","28*c^4*s^12*(a*(1-alpha+alpha*a))+56*c^6*s^10*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+70*c^8*s^8*(b*(1-zeta+zeta*b))","8*c^2*s^14*(a*(1-alpha+alpha*a))+28*c^4*s^12*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+56*c^6*s^10*(b*(1-zeta+zeta*b))","1*1*s^16*(a*(1-alpha+alpha*a))+8*c^2*s^14*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+28*c^4*s^12*(b*(1-zeta+zeta*b))","1*1*s^16*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+8*c^2*s^14*(b*(1-zeta+zeta*b))","1*1*s^16*(b*(1-zeta+zeta*b))"],parameters:[["alpha",-1,1,0,!1,!1],["zeta",-1,1,0,!1,!1]]},"12":{functions:["1*c^18*1*(a*(1-alpha+alpha*a))","9*c^16*s^2*(a*(1-alpha+alpha*a))+1*c^18*1*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)","36*c^14*s^4*(a*(1-alpha+alpha*a))+9*c^16*s^2*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1*c^18*1*(b*(1-zeta+zeta*b))","84*c^12*s^6*(a*(1-alpha+alpha*a))+36*c^14*s^4*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+9*c^16*s^2*(b*(1-zeta+zeta*b))","126*c^10*s^8*(a*(1-alpha+alpha*a))+84*c^12*s^6*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+36*c^14*s^4*(b*(1-zeta+zeta*b))","126*c^8*s^10*(a*(1-alpha+alpha*a))+126*c^10*s^8*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+84*c^12*s^6*(b*(1-zeta+zeta*b))","84*c^6*s^12*(a*(1-alpha+alpha*a))+126*c^8*s^10*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+126*c^10*s^8*(b*(1-zeta+zeta*b))","36*c^4*s^14*(a*(1-alpha+alpha*a))+84*c^6*s^12*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+126*c^8*s^10*(b*(1-zeta+zeta*b))","9*c^2*s^16*(a*(1-alpha+alpha*a))+36*c^4*s^14*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+84*c^6*s^12*(b*(1-zeta+zeta*b))","1*1*s^18*(a*(1-alpha+alpha*a))+9*c^2*s^16*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+36*c^4*s^14*(b*(1-zeta+zeta*b))","1*1*s^18*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+9*c^2*s^16*(b*(1-zeta+zeta*b))","1*1*s^18*(b*(1-zeta+zeta*b))"],parameters:[["alpha",-1,1,0,!1,!1],["zeta",-1,1,0,!1,!1]]},"13":{functions:["1*c^20*1*(a*(1-alpha+alpha*a))","10*c^18*s^2*(a*(1-alpha+alpha*a))+1*c^20*1*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)","45*c^16*s^4*(a*(1-alpha+alpha*a))+10*c^18*s^2*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1*c^20*1*(b*(1-zeta+zeta*b))","120*c^14*s^6*(a*(1-alpha+alpha*a))+45*c^16*s^4*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+10*c^18*s^2*(b*(1-zeta+zeta*b))","210*c^12*s^8*(a*(1-alpha+alpha*a))+120*c^14*s^6*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+45*c^16*s^4*(b*(1-zeta+zeta*b))","252*c^10*s^10*(a*(1-alpha+alpha*a))+210*c^12*s^8*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+120*c^14*s^6*(b*(1-zeta+zeta*b))","210*c^8*s^12*(a*(1-alpha+alpha*a))+252*c^10*s^10*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+210*c^12*s^8*(b*(1-zeta+zeta*b))","120*c^6*s^14*(a*(1-alpha+alpha*a))+210*c^8*s^12*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+252*c^10*s^10*(b*(1-zeta+zeta*b))","45*c^4*s^16*(a*(1-alpha+alpha*a))+120*c^6*s^14*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+210*c^8*s^12*(b*(1-zeta+zeta*b))","10*c^2*s^18*(a*(1-alpha+alpha*a))+45*c^4*s^16*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+120*c^6*s^14*(b*(1-zeta+zeta*b))","1*1*s^20*(a*(1-alpha+alpha*a))+10*c^2*s^18*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+45*c^4*s^16*(b*(1-zeta+zeta*b))","1*1*s^20*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+10*c^2*s^18*(b*(1-zeta+zeta*b))","1*1*s^20*(b*(1-zeta+zeta*b))"],parameters:[["alpha",-1,1,0,!1,!1],["zeta",-1,1,0,!1,!1]]},"14":{functions:["1*c^22*1*(a*(1-alpha+alpha*a))","11*c^20*s^2*(a*(1-alpha+alpha*a))+1*c^22*1*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)","55*c^18*s^4*(a*(1-alpha+alpha*a))+11*c^20*s^2*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1*c^22*1*(b*(1-zeta+zeta*b))","165*c^16*s^6*(a*(1-alpha+alpha*a))+55*c^18*s^4*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+11*c^20*s^2*(b*(1-zeta+zeta*b))","330*c^14*s^8*(a*(1-alpha+alpha*a))+165*c^16*s^6*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+55*c^18*s^4*(b*(1-zeta+zeta*b))","462*c^12*s^10*(a*(1-alpha+alpha*a))+330*c^14*s^8*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+165*c^16*s^6*(b*(1-zeta+zeta*b))","462*c^10*s^12*(a*(1-alpha+alpha*a))+462*c^12*s^10*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+330*c^14*s^8*(b*(1-zeta+zeta*b))","330*c^8*s^14*(a*(1-alpha+alpha*a))+462*c^10*s^12*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+462*c^12*s^10*(b*(1-zeta+zeta*b))","165*c^6*s^16*(a*(1-alpha+alpha*a))+330*c^8*s^14*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+462*c^10*s^12*(b*(1-zeta+zeta*b))","55*c^4*s^18*(a*(1-alpha+alpha*a))+165*c^6*s^16*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+330*c^8*s^14*(b*(1-zeta+zeta*b))","11*c^2*s^20*(a*(1-alpha+alpha*a))+55*c^4*s^18*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+165*c^6*s^16*(b*(1-zeta+zeta*b))","1*1*s^22*(a*(1-alpha+alpha*a))+11*c^2*s^20*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+55*c^4*s^18*(b*(1-zeta+zeta*b))","1*1*s^22*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+11*c^2*s^20*(b*(1-zeta+zeta*b))","1*1*s^22*(b*(1-zeta+zeta*b))"],parameters:[["alpha",-1,1,0,!1,!1],["zeta",-1,1,0,!1,!1]]},"15":{functions:["1*c^24*1*(a*(1-alpha+alpha*a))","12*c^22*s^2*(a*(1-alpha+alpha*a))+1*c^24*1*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)","66*c^20*s^4*(a*(1-alpha+alpha*a))+12*c^22*s^2*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1*c^24*1*(b*(1-zeta+zeta*b))","220*c^18*s^6*(a*(1-alpha+alpha*a))+66*c^20*s^4*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+12*c^22*s^2*(b*(1-zeta+zeta*b))","495*c^16*s^8*(a*(1-alpha+alpha*a))+220*c^18*s^6*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+66*c^20*s^4*(b*(1-zeta+zeta*b))","792*c^14*s^10*(a*(1-alpha+alpha*a))+495*c^16*s^8*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+220*c^18*s^6*(b*(1-zeta+zeta*b))","924*c^12*s^12*(a*(1-alpha+alpha*a))+792*c^14*s^10*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+495*c^16*s^8*(b*(1-zeta+zeta*b))","792*c^10*s^14*(a*(1-alpha+alpha*a))+924*c^12*s^12*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+792*c^14*s^10*(b*(1-zeta+zeta*b))","495*c^8*s^16*(a*(1-alpha+alpha*a))+792*c^10*s^14*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+924*c^12*s^12*(b*(1-zeta+zeta*b))","220*c^6*s^18*(a*(1-alpha+alpha*a))+495*c^8*s^16*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+792*c^10*s^14*(b*(1-zeta+zeta*b))","66*c^4*s^20*(a*(1-alpha+alpha*a))+220*c^6*s^18*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+495*c^8*s^16*(b*(1-zeta+zeta*b))","12*c^2*s^22*(a*(1-alpha+alpha*a))+66*c^4*s^20*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+220*c^6*s^18*(b*(1-zeta+zeta*b))","1*1*s^24*(a*(1-alpha+alpha*a))+12*c^2*s^22*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+66*c^4*s^20*(b*(1-zeta+zeta*b))","1*1*s^24*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+12*c^2*s^22*(b*(1-zeta+zeta*b))","1*1*s^24*(b*(1-zeta+zeta*b))"],parameters:[["alpha",-1,1,0,!1,!1],["zeta",-1,1,0,!1,!1]]},"16":{functions:["1*c^26*1*(a*(1-alpha+alpha*a))","13*c^24*s^2*(a*(1-alpha+alpha*a))+1*c^26*1*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)","78*c^22*s^4*(a*(1-alpha+alpha*a))+13*c^24*s^2*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1*c^26*1*(b*(1-zeta+zeta*b))","286*c^20*s^6*(a*(1-alpha+alpha*a))+78*c^22*s^4*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+13*c^24*s^2*(b*(1-zeta+zeta*b))","715*c^18*s^8*(a*(1-alpha+alpha*a))+286*c^20*s^6*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+78*c^22*s^4*(b*(1-zeta+zeta*b))","1287*c^16*s^10*(a*(1-alpha+alpha*a))+715*c^18*s^8*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+286*c^20*s^6*(b*(1-zeta+zeta*b))","1716*c^14*s^12*(a*(1-alpha+alpha*a))+1287*c^16*s^10*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+715*c^18*s^8*(b*(1-zeta+zeta*b))","1716*c^12*s^14*(a*(1-alpha+alpha*a))+1716*c^14*s^12*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1287*c^16*s^10*(b*(1-zeta+zeta*b))","1287*c^10*s^16*(a*(1-alpha+alpha*a))+1716*c^12*s^14*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1716*c^14*s^12*(b*(1-zeta+zeta*b))","715*c^8*s^18*(a*(1-alpha+alpha*a))+1287*c^10*s^16*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1716*c^12*s^14*(b*(1-zeta+zeta*b))","286*c^6*s^20*(a*(1-alpha+alpha*a))+715*c^8*s^18*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1287*c^10*s^16*(b*(1-zeta+zeta*b))","78*c^4*s^22*(a*(1-alpha+alpha*a))+286*c^6*s^20*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+715*c^8*s^18*(b*(1-zeta+zeta*b))","13*c^2*s^24*(a*(1-alpha+alpha*a))+78*c^4*s^22*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+286*c^6*s^20*(b*(1-zeta+zeta*b))","1*1*s^26*(a*(1-alpha+alpha*a))+13*c^2*s^24*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+78*c^4*s^22*(b*(1-zeta+zeta*b))","1*1*s^26*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+13*c^2*s^24*(b*(1-zeta+zeta*b))","1*1*s^26*(b*(1-zeta+zeta*b))"],parameters:[["alpha",-1,1,0,!1,!1],["zeta",-1,1,0,!1,!1]]}}},{name:"sg_bezier",title:"Shape-adjustable generalised Bézier",counts:"3 to 7 control points",sizes:[3,4,5,6,7],usual:4,formulas:{"3":{functions:["r^2*(r+(1-lam1)*t)","t*r*((2+lam1)*r+(2+lam2)*t)","t^2*(t+(1-lam2)*r)"],parameters:[["lam1",-2,1,0,!1,!1],["lam2",-2,1,0,!1,!1]]},"4":{functions:["r^3*(r+(1-lam1)*t)","t*r^2*((3+lam1)*r+(3-lam2)*t)","t^2*r*((3+lam2)*r+(3+lam3)*t)","t^3*(t+(1-lam3)*r)"],parameters:[["lam1",-3,1,0,!1,!1],["lam2",-3,3,0,!1,!1],["lam3",-3,1,0,!1,!1]]},"5":{functions:["r^4*(r+(1-lam1)*t)","t*r^3*((4+lam1)*r+(4-lam2)*t)","t^2*r^2*((6+lam2)*r+(6+lam3)*t)","t^3*r*((4-lam3)*r+(4+lam4)*t)","t^4*(t+(1-lam4)*r)"],parameters:[["lam1",-4,1,0,!1,!1],["lam2",-6,4,0,!1,!1],["lam3",-6,4,0,!1,!1],["lam4",-4,1,0,!1,!1]]},"6":{functions:["r^5*(r+(1-lam1)*t)","t*r^4*((5+lam1)*r+(5-lam2)*t)","t^2*r^3*((10+lam2)*r+(10-lam3)*t)","t^3*r^2*((10+lam3)*r+(10+lam4)*t)","t^4*r*((5-lam4)*r+(5+lam5)*t)","t^5*(t+(1-lam5)*r)"],parameters:[["lam1",-5,1,0,!1,!1],["lam2",-10,5,0,!1,!1],["lam3",-10,10,0,!1,!1],["lam4",-10,5,0,!1,!1],["lam5",-5,1,0,!1,!1]]},"7":{functions:["r^6*(r+(1-lam1)*t)","t*r^5*((6+lam1)*r+(6-lam2)*t)","t^2*r^4*((15+lam2)*r+(15-lam3)*t)","t^3*r^3*((20+lam3)*r+(20+lam4)*t)","t^4*r^2*((15-lam4)*r+(15+lam5)*t)","t^5*r*((6-lam5)*r+(6+lam6)*t)","t^6*(t+(1-lam6)*r)"],parameters:[["lam1",-6,1,0,!1,!1],["lam2",-15,6,0,!1,!1],["lam3",-20,15,0,!1,!1],["lam4",-20,15,0,!1,!1],["lam5",-15,6,0,!1,!1],["lam6",-6,1,0,!1,!1]]}}},{name:"lambda_bezier",title:"λ-Bézier",counts:"3 or more control points",sizes:[3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24,25,26,27,28,29,30,31,32,33,34,35,36,37,38,39,40,41,42,43,44,45,46,47,48,49,50,51,52,53,54,55,56,57,58,59,60,61,62,63,64],usual:4,formulas:{"3":{functions:["r^2*(r+(1-lam)*t)","t*r*((2+(1/1)*lam)*r+(2-(-1/1)*lam)*t)","t^2*(t+(1-lam)*r)"],parameters:[["lam",-1,1,0,!1,!1]]},"4":{functions:["r^3*(r+(1-lam)*t)","t*r^2*((3+(1/1)*lam)*r+(3-(0/1)*lam)*t)","t^2*r*((3+(0/1)*lam)*r+(3-(-1/1)*lam)*t)","t^3*(t+(1-lam)*r)"],parameters:[["lam",-1,1,0,!1,!1]]},"5":{functions:["r^4*(r+(1-lam)*t)","t*r^3*((4+(1/1)*lam)*r+(4-(2/3)*lam)*t)","t^2*r^2*((6+(2/3)*lam)*r+(6-(-2/3)*lam)*t)","t^3*r*((4+(-2/3)*lam)*r+(4-(-1/1)*lam)*t)","t^4*(t+(1-lam)*r)"],parameters:[["lam",-1,1,0,!1,!1]]},"6":{functions:["r^5*(r+(1-lam)*t)","t*r^4*((5+(1/1)*lam)*r+(5-(5/4)*lam)*t)","t^2*r^3*((10+(5/4)*lam)*r+(10-(0/1)*lam)*t)","t^3*r^2*((10+(0/1)*lam)*r+(10-(-5/4)*lam)*t)","t^4*r*((5+(-5/4)*lam)*r+(5-(-1/1)*lam)*t)","t^5*(t+(1-lam)*r)"],parameters:[["lam",-1,1,0,!1,!1]]},"7":{functions:["r^6*(r+(1-lam)*t)","t*r^5*((6+(1/1)*lam)*r+(6-(9/5)*lam)*t)","t^2*r^4*((15+(9/5)*lam)*r+(15-(1/1)*lam)*t)","t^3*r^3*((20+(1/1)*lam)*r+(20-(-1/1)*lam)*t)","t^4*r^2*((15+(-1/1)*lam)*r+(15-(-9/5)*lam)*t)","t^5*r*((6+(-9/5)*lam)*r+(6-(-1/1)*lam)*t)","t^6*(t+(1-lam)*r)"],parameters:[["lam",-1,1,0,!1,!1]]},"8":{functions:["r^7*(r+(1-lam)*t)","t*r^6*((7+(1/1)*lam)*r+(7-(7/3)*lam)*t)","t^2*r^5*((21+(7/3)*lam)*r+(21-(7/3)*lam)*t)","t^3*r^4*((35+(7/3)*lam)*r+(35-(0/1)*lam)*t)","t^4*r^3*((35+(0/1)*lam)*r+(35-(-7/3)*lam)*t)","t^5*r^2*((21+(-7/3)*lam)*r+(21-(-7/3)*lam)*t)","t^6*r*((7+(-7/3)*lam)*r+(7-(-1/1)*lam)*t)","t^7*(t+(1-lam)*r)"],parameters:[["lam",-1,1,0,!1,!1]]},"9":{functions:["r^8*(r+(1-lam)*t)","t*r^7*((8+(1/1)*lam)*r+(8-(20/7)*lam)*t)","t^2*r^6*((28+(20/7)*lam)*r+(28-(4/1)*lam)*t)","t^3*r^5*((56+(4/1)*lam)*r+(56-(2/1)*lam)*t)","t^4*r^4*((70+(2/1)*lam)*r+(70-(-2/1)*lam)*t)","t^5*r^3*((56+(-2/1)*lam)*r+(56-(-4/1)*lam)*t)","t^6*r^2*((28+(-4/1)*lam)*r+(28-(-20/7)*lam)*t)","t^7*r*((8+(-20/7)*lam)*r+(8-(-1/1)*lam)*t)","t^8*(t+(1-lam)*r)"],parameters:[["lam",-1,1,0,!1,!1]]},"10":{functions:["r^9*(r+(1-lam)*t)","t*r^8*((9+(1/1)*lam)*r+(9-(27/8)*lam)*t)","t^2*r^7*((36+(27/8)*lam)*r+(36-(6/1)*lam)*t)","t^3*r^6*((84+(6/1)*lam)*r+(84-(21/4)*lam)*t)","t^4*r^5*((126+(21/4)*lam)*r+(126-(0/1)*lam)*t)","t^5*r^4*((126+(0/1)*lam)*r+(126-(-21/4)*lam)*t)","t^6*r^3*((84+(-21/4)*lam)*r+(84-(-6/1)*lam)*t)","t^7*r^2*((36+(-6/1)*lam)*r+(36-(-27/8)*lam)*t)","t^8*r*((9+(-27/8)*lam)*r+(9-(-1/1)*lam)*t)","t^9*(t+(1-lam)*r)"],parameters:[["lam",-1,1,0,!1,!1]]},"11":{functions:["r^10*(r+(1-lam)*t)","t*r^9*((10+(1/1)*lam)*r+(10-(35/9)*lam)*t)","t^2*r^8*((45+(35/9)*lam)*r+(45-(25/3)*lam)*t)","t^3*r^7*((120+(25/3)*lam)*r+(120-(10/1)*lam)*t)","t^4*r^6*((210+(10/1)*lam)*r+(210-(14/3)*lam)*t)","t^5*r^5*((252+(14/3)*lam)*r+(252-(-14/3)*lam)*t)","t^6*r^4*((210+(-14/3)*lam)*r+(210-(-10/1)*lam)*t)","t^7*r^3*((120+(-10/1)*lam)*r+(120-(-25/3)*lam)*t)","t^8*r^2*((45+(-25/3)*lam)*r+(45-(-35/9)*lam)*t)","t^9*r*((10+(-35/9)*lam)*r+(10-(-1/1)*lam)*t)","t^10*(t+(1-lam)*r)"],parameters:[["lam",-1,1,0,!1,!1]]},"12":{functions:["r^11*(r+(1-lam)*t)","t*r^10*((11+(1/1)*lam)*r+(11-(22/5)*lam)*t)","t^2*r^9*((55+(22/5)*lam)*r+(55-(11/1)*lam)*t)","t^3*r^8*((165+(11/1)*lam)*r+(165-(33/2)*lam)*t)","t^4*r^7*((330+(33/2)*lam)*r+(330-(66/5)*lam)*t)","t^5*r^6*((462+(66/5)*lam)*r+(462-(0/1)*lam)*t)","t^6*r^5*((462+(0/1)*lam)*r+(462-(-66/5)*lam)*t)","t^7*r^4*((330+(-66/5)*lam)*r+(330-(-33/2)*lam)*t)","t^8*r^3*((165+(-33/2)*lam)*r+(165-(-11/1)*lam)*t)","t^9*r^2*((55+(-11/1)*lam)*r+(55-(-22/5)*lam)*t)","t^10*r*((11+(-22/5)*lam)*r+(11-(-1/1)*lam)*t)","t^11*(t+(1-lam)*r)"],parameters:[["lam",-1,1,0,!1,!1]]},"13":{functions:["r^12*(r+(1-lam)*t)","t*r^11*((12+(1/1)*lam)*r+(12-(54/11)*lam)*t)","t^2*r^10*((66+(54/11)*lam)*r+(66-(14/1)*lam)*t)","t^3*r^9*((220+(14/1)*lam)*r+(220-(25/1)*lam)*t)","t^4*r^8*((495+(25/1)*lam)*r+(495-(27/1)*lam)*t)","t^5*r^7*((792+(27/1)*lam)*r+(792-(12/1)*lam)*t)","t^6*r^6*((924+(12/1)*lam)*r+(924-(-12/1)*lam)*t)","t^7*r^5*((792+(-12/1)*lam)*r+(792-(-27/1)*lam)*t)","t^8*r^4*((495+(-27/1)*lam)*r+(495-(-25/1)*lam)*t)","t^9*r^3*((220+(-25/1)*lam)*r+(220-(-14/1)*lam)*t)","t^10*r^2*((66+(-14/1)*lam)*r+(66-(-54/11)*lam)*t)","t^11*r*((12+(-54/11)*lam)*r+(12-(-1/1)*lam)*t)","t^12*(t+(1-lam)*r)"],parameters:[["lam",-1,1,0,!1,!1]]},"14":{functions:["r^13*(r+(1-lam)*t)","t*r^12*((13+(1/1)*lam)*r+(13-(65/12)*lam)*t)","t^2*r^11*((78+(65/12)*lam)*r+(78-(52/3)*lam)*t)","t^3*r^10*((286+(52/3)*lam)*r+(286-(143/4)*lam)*t)","t^4*r^9*((715+(143/4)*lam)*r+(715-(143/3)*lam)*t)","t^5*r^8*((1287+(143/3)*lam)*r+(1287-(143/4)*lam)*t)","t^6*r^7*((1716+(143/4)*lam)*r+(1716-(0/1)*lam)*t)","t^7*r^6*((1716+(0/1)*lam)*r+(1716-(-143/4)*lam)*t)","t^8*r^5*((1287+(-143/4)*lam)*r+(1287-(-143/3)*lam)*t)","t^9*r^4*((715+(-143/3)*lam)*r+(715-(-143/4)*lam)*t)","t^10*r^3*((286+(-143/4)*lam)*r+(286-(-52/3)*lam)*t)","t^11*r^2*((78+(-52/3)*lam)*r+(78-(-65/12)*lam)*t)","t^12*r*((13+(-65/12)*lam)*r+(13-(-1/1)*lam)*t)","t^13*(t+(1-lam)*r)"],parameters:[["lam",-1,1,0,!1,!1]]},"15":{functions:["r^14*(r+(1-lam)*t)","t*r^13*((14+(1/1)*lam)*r+(14-(77/13)*lam)*t)","t^2*r^12*((91+(77/13)*lam)*r+(91-(21/1)*lam)*t)","t^3*r^11*((364+(21/1)*lam)*r+(364-(49/1)*lam)*t)","t^4*r^10*((1001+(49/1)*lam)*r+(1001-(77/1)*lam)*t)","t^5*r^9*((2002+(77/1)*lam)*r+(2002-(77/1)*lam)*t)","t^6*r^8*((3003+(77/1)*lam)*r+(3003-(33/1)*lam)*t)","t^7*r^7*((3432+(33/1)*lam)*r+(3432-(-33/1)*lam)*t)","t^8*r^6*((3003+(-33/1)*lam)*r+(3003-(-77/1)*lam)*t)","t^9*r^5*((2002+(-77/1)*lam)*r+(2002-(-77/1)*lam)*t)","t^10*r^4*((1001+(-77/1)*lam)*r+(1001-(-49/1)*lam)*t)","t^11*r^3*((364+(-49/1)*lam)*r+(364-(-21/1)*lam)*t)","t^12*r^2*((91+(-21/1)*lam)*r+(91-(-77/13)*lam)*t)","t^13*r*((14+(-77/13)*lam)*r+(14-(-1/1)*lam)*t)","t^14*(t+(1-lam)*r)"],parameters:[["lam",-1,1,0,!1,!1]]},"16":{functions:["r^15*(r+(1-lam)*t)","t*r^14*((15+(1/1)*lam)*r+(15-(45/7)*lam)*t)","t^2*r^13*((105+(45/7)*lam)*r+(105-(25/1)*lam)*t)","t^3*r^12*((455+(25/1)*lam)*r+(455-(65/1)*lam)*t)","t^4*r^11*((1365+(65/1)*lam)*r+(1365-(117/1)*lam)*t)","t^5*r^10*((3003+(117/1)*lam)*r+(3003-(143/1)*lam)*t)","t^6*r^9*((5005+(143/1)*lam)*r+(5005-(715/7)*lam)*t)","t^7*r^8*((6435+(715/7)*lam)*r+(6435-(0/1)*lam)*t)","t^8*r^7*((6435+(0/1)*lam)*r+(6435-(-715/7)*lam)*t)","t^9*r^6*((5005+(-715/7)*lam)*r+(5005-(-143/1)*lam)*t)","t^10*r^5*((3003+(-143/1)*lam)*r+(3003-(-117/1)*lam)*t)","t^11*r^4*((1365+(-117/1)*lam)*r+(1365-(-65/1)*lam)*t)","t^12*r^3*((455+(-65/1)*lam)*r+(455-(-25/1)*lam)*t)","t^13*r^2*((105+(-25/1)*lam)*r+(105-(-45/7)*lam)*t)","t^14*r*((15+(-45/7)*lam)*r+(15-(-1/1)*lam)*t)","t^15*(t+(1-lam)*r)"],parameters:[["lam",-1,1,0,!1,!1]]}}},{name:"alpha_bernstein",title:"α-Bernstein",counts:"3 or more control points",sizes:[3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24,25,26,27,28,29,30,31,32,33,34,35,36,37,38,39,40,41,42,43,44,45,46,47,48,49,50,51,52,53,54,55,56,57,58,59,60,61,62,63,64],usual:4,formulas:{"3":{functions:["alpha*1*1*r^2+(1-alpha)*1*1*r","alpha*2*t*r","alpha*1*t^2*1+(1-alpha)*1*t*1"],parameters:[["alpha",0,1,1,!1,!1]]},"4":{functions:["alpha*1*1*r^3+(1-alpha)*1*1*r^2","alpha*3*t*r^2+(1-alpha)*1*t*r","alpha*3*t^2*r+(1-alpha)*1*t*r","alpha*1*t^3*1+(1-alpha)*1*t^2*1"],parameters:[["alpha",0,1,1,!1,!1]]},"5":{functions:["alpha*1*1*r^4+(1-alpha)*1*1*r^3","alpha*4*t*r^3+(1-alpha)*2*t*r^2","alpha*6*t^2*r^2+(1-alpha)*1*t^2*r+(1-alpha)*1*t*r^2","alpha*4*t^3*r+(1-alpha)*2*t^2*r","alpha*1*t^4*1+(1-alpha)*1*t^3*1"],parameters:[["alpha",0,1,1,!1,!1]]},"6":{functions:["alpha*1*1*r^5+(1-alpha)*1*1*r^4","alpha*5*t*r^4+(1-alpha)*3*t*r^3","alpha*10*t^2*r^3+(1-alpha)*3*t^2*r^2+(1-alpha)*1*t*r^3","alpha*10*t^3*r^2+(1-alpha)*1*t^3*r+(1-alpha)*3*t^2*r^2","alpha*5*t^4*r+(1-alpha)*3*t^3*r","alpha*1*t^5*1+(1-alpha)*1*t^4*1"],parameters:[["alpha",0,1,1,!1,!1]]},"7":{functions:["alpha*1*1*r^6+(1-alpha)*1*1*r^5","alpha*6*t*r^5+(1-alpha)*4*t*r^4","alpha*15*t^2*r^4+(1-alpha)*6*t^2*r^3+(1-alpha)*1*t*r^4","alpha*20*t^3*r^3+(1-alpha)*4*t^3*r^2+(1-alpha)*4*t^2*r^3","alpha*15*t^4*r^2+(1-alpha)*1*t^4*r+(1-alpha)*6*t^3*r^2","alpha*6*t^5*r+(1-alpha)*4*t^4*r","alpha*1*t^6*1+(1-alpha)*1*t^5*1"],parameters:[["alpha",0,1,1,!1,!1]]},"8":{functions:["alpha*1*1*r^7+(1-alpha)*1*1*r^6","alpha*7*t*r^6+(1-alpha)*5*t*r^5","alpha*21*t^2*r^5+(1-alpha)*10*t^2*r^4+(1-alpha)*1*t*r^5","alpha*35*t^3*r^4+(1-alpha)*10*t^3*r^3+(1-alpha)*5*t^2*r^4","alpha*35*t^4*r^3+(1-alpha)*5*t^4*r^2+(1-alpha)*10*t^3*r^3","alpha*21*t^5*r^2+(1-alpha)*1*t^5*r+(1-alpha)*10*t^4*r^2","alpha*7*t^6*r+(1-alpha)*5*t^5*r","alpha*1*t^7*1+(1-alpha)*1*t^6*1"],parameters:[["alpha",0,1,1,!1,!1]]},"9":{functions:["alpha*1*1*r^8+(1-alpha)*1*1*r^7","alpha*8*t*r^7+(1-alpha)*6*t*r^6","alpha*28*t^2*r^6+(1-alpha)*15*t^2*r^5+(1-alpha)*1*t*r^6","alpha*56*t^3*r^5+(1-alpha)*20*t^3*r^4+(1-alpha)*6*t^2*r^5","alpha*70*t^4*r^4+(1-alpha)*15*t^4*r^3+(1-alpha)*15*t^3*r^4","alpha*56*t^5*r^3+(1-alpha)*6*t^5*r^2+(1-alpha)*20*t^4*r^3","alpha*28*t^6*r^2+(1-alpha)*1*t^6*r+(1-alpha)*15*t^5*r^2","alpha*8*t^7*r+(1-alpha)*6*t^6*r","alpha*1*t^8*1+(1-alpha)*1*t^7*1"],parameters:[["alpha",0,1,1,!1,!1]]},"10":{functions:["alpha*1*1*r^9+(1-alpha)*1*1*r^8","alpha*9*t*r^8+(1-alpha)*7*t*r^7","alpha*36*t^2*r^7+(1-alpha)*21*t^2*r^6+(1-alpha)*1*t*r^7","alpha*84*t^3*r^6+(1-alpha)*35*t^3*r^5+(1-alpha)*7*t^2*r^6","alpha*126*t^4*r^5+(1-alpha)*35*t^4*r^4+(1-alpha)*21*t^3*r^5","alpha*126*t^5*r^4+(1-alpha)*21*t^5*r^3+(1-alpha)*35*t^4*r^4","alpha*84*t^6*r^3+(1-alpha)*7*t^6*r^2+(1-alpha)*35*t^5*r^3","alpha*36*t^7*r^2+(1-alpha)*1*t^7*r+(1-alpha)*21*t^6*r^2","alpha*9*t^8*r+(1-alpha)*7*t^7*r","alpha*1*t^9*1+(1-alpha)*1*t^8*1"],parameters:[["alpha",0,1,1,!1,!1]]},"11":{functions:["alpha*1*1*r^10+(1-alpha)*1*1*r^9","alpha*10*t*r^9+(1-alpha)*8*t*r^8","alpha*45*t^2*r^8+(1-alpha)*28*t^2*r^7+(1-alpha)*1*t*r^8","alpha*120*t^3*r^7+(1-alpha)*56*t^3*r^6+(1-alpha)*8*t^2*r^7","alpha*210*t^4*r^6+(1-alpha)*70*t^4*r^5+(1-alpha)*28*t^3*r^6","alpha*252*t^5*r^5+(1-alpha)*56*t^5*r^4+(1-alpha)*56*t^4*r^5","alpha*210*t^6*r^4+(1-alpha)*28*t^6*r^3+(1-alpha)*70*t^5*r^4","alpha*120*t^7*r^3+(1-alpha)*8*t^7*r^2+(1-alpha)*56*t^6*r^3","alpha*45*t^8*r^2+(1-alpha)*1*t^8*r+(1-alpha)*28*t^7*r^2","alpha*10*t^9*r+(1-alpha)*8*t^8*r","alpha*1*t^10*1+(1-alpha)*1*t^9*1"],parameters:[["alpha",0,1,1,!1,!1]]},"12":{functions:["alpha*1*1*r^11+(1-alpha)*1*1*r^10","alpha*11*t*r^10+(1-alpha)*9*t*r^9","alpha*55*t^2*r^9+(1-alpha)*36*t^2*r^8+(1-alpha)*1*t*r^9","alpha*165*t^3*r^8+(1-alpha)*84*t^3*r^7+(1-alpha)*9*t^2*r^8","alpha*330*t^4*r^7+(1-alpha)*126*t^4*r^6+(1-alpha)*36*t^3*r^7","alpha*462*t^5*r^6+(1-alpha)*126*t^5*r^5+(1-alpha)*84*t^4*r^6","alpha*462*t^6*r^5+(1-alpha)*84*t^6*r^4+(1-alpha)*126*t^5*r^5","alpha*330*t^7*r^4+(1-alpha)*36*t^7*r^3+(1-alpha)*126*t^6*r^4","alpha*165*t^8*r^3+(1-alpha)*9*t^8*r^2+(1-alpha)*84*t^7*r^3","alpha*55*t^9*r^2+(1-alpha)*1*t^9*r+(1-alpha)*36*t^8*r^2","alpha*11*t^10*r+(1-alpha)*9*t^9*r","alpha*1*t^11*1+(1-alpha)*1*t^10*1"],parameters:[["alpha",0,1,1,!1,!1]]},"13":{functions:["alpha*1*1*r^12+(1-alpha)*1*1*r^11","alpha*12*t*r^11+(1-alpha)*10*t*r^10","alpha*66*t^2*r^10+(1-alpha)*45*t^2*r^9+(1-alpha)*1*t*r^10","alpha*220*t^3*r^9+(1-alpha)*120*t^3*r^8+(1-alpha)*10*t^2*r^9","alpha*495*t^4*r^8+(1-alpha)*210*t^4*r^7+(1-alpha)*45*t^3*r^8","alpha*792*t^5*r^7+(1-alpha)*252*t^5*r^6+(1-alpha)*120*t^4*r^7","alpha*924*t^6*r^6+(1-alpha)*210*t^6*r^5+(1-alpha)*210*t^5*r^6","alpha*792*t^7*r^5+(1-alpha)*120*t^7*r^4+(1-alpha)*252*t^6*r^5","alpha*495*t^8*r^4+(1-alpha)*45*t^8*r^3+(1-alpha)*210*t^7*r^4","alpha*220*t^9*r^3+(1-alpha)*10*t^9*r^2+(1-alpha)*120*t^8*r^3","alpha*66*t^10*r^2+(1-alpha)*1*t^10*r+(1-alpha)*45*t^9*r^2","alpha*12*t^11*r+(1-alpha)*10*t^10*r","alpha*1*t^12*1+(1-alpha)*1*t^11*1"],parameters:[["alpha",0,1,1,!1,!1]]},"14":{functions:["alpha*1*1*r^13+(1-alpha)*1*1*r^12","alpha*13*t*r^12+(1-alpha)*11*t*r^11","alpha*78*t^2*r^11+(1-alpha)*55*t^2*r^10+(1-alpha)*1*t*r^11","alpha*286*t^3*r^10+(1-alpha)*165*t^3*r^9+(1-alpha)*11*t^2*r^10","alpha*715*t^4*r^9+(1-alpha)*330*t^4*r^8+(1-alpha)*55*t^3*r^9","alpha*1287*t^5*r^8+(1-alpha)*462*t^5*r^7+(1-alpha)*165*t^4*r^8","alpha*1716*t^6*r^7+(1-alpha)*462*t^6*r^6+(1-alpha)*330*t^5*r^7","alpha*1716*t^7*r^6+(1-alpha)*330*t^7*r^5+(1-alpha)*462*t^6*r^6","alpha*1287*t^8*r^5+(1-alpha)*165*t^8*r^4+(1-alpha)*462*t^7*r^5","alpha*715*t^9*r^4+(1-alpha)*55*t^9*r^3+(1-alpha)*330*t^8*r^4","alpha*286*t^10*r^3+(1-alpha)*11*t^10*r^2+(1-alpha)*165*t^9*r^3","alpha*78*t^11*r^2+(1-alpha)*1*t^11*r+(1-alpha)*55*t^10*r^2","alpha*13*t^12*r+(1-alpha)*11*t^11*r","alpha*1*t^13*1+(1-alpha)*1*t^12*1"],parameters:[["alpha",0,1,1,!1,!1]]},"15":{functions:["alpha*1*1*r^14+(1-alpha)*1*1*r^13","alpha*14*t*r^13+(1-alpha)*12*t*r^12","alpha*91*t^2*r^12+(1-alpha)*66*t^2*r^11+(1-alpha)*1*t*r^12","alpha*364*t^3*r^11+(1-alpha)*220*t^3*r^10+(1-alpha)*12*t^2*r^11","alpha*1001*t^4*r^10+(1-alpha)*495*t^4*r^9+(1-alpha)*66*t^3*r^10","alpha*2002*t^5*r^9+(1-alpha)*792*t^5*r^8+(1-alpha)*220*t^4*r^9","alpha*3003*t^6*r^8+(1-alpha)*924*t^6*r^7+(1-alpha)*495*t^5*r^8","alpha*3432*t^7*r^7+(1-alpha)*792*t^7*r^6+(1-alpha)*792*t^6*r^7","alpha*3003*t^8*r^6+(1-alpha)*495*t^8*r^5+(1-alpha)*924*t^7*r^6","alpha*2002*t^9*r^5+(1-alpha)*220*t^9*r^4+(1-alpha)*792*t^8*r^5","alpha*1001*t^10*r^4+(1-alpha)*66*t^10*r^3+(1-alpha)*495*t^9*r^4","alpha*364*t^11*r^3+(1-alpha)*12*t^11*r^2+(1-alpha)*220*t^10*r^3","alpha*91*t^12*r^2+(1-alpha)*1*t^12*r+(1-alpha)*66*t^11*r^2","alpha*14*t^13*r+(1-alpha)*12*t^12*r","alpha*1*t^14*1+(1-alpha)*1*t^13*1"],parameters:[["alpha",0,1,1,!1,!1]]},"16":{functions:["alpha*1*1*r^15+(1-alpha)*1*1*r^14","alpha*15*t*r^14+(1-alpha)*13*t*r^13","alpha*105*t^2*r^13+(1-alpha)*78*t^2*r^12+(1-alpha)*1*t*r^13","alpha*455*t^3*r^12+(1-alpha)*286*t^3*r^11+(1-alpha)*13*t^2*r^12","alpha*1365*t^4*r^11+(1-alpha)*715*t^4*r^10+(1-alpha)*78*t^3*r^11","alpha*3003*t^5*r^10+(1-alpha)*1287*t^5*r^9+(1-alpha)*286*t^4*r^10","alpha*5005*t^6*r^9+(1-alpha)*1716*t^6*r^8+(1-alpha)*715*t^5*r^9","alpha*6435*t^7*r^8+(1-alpha)*1716*t^7*r^7+(1-alpha)*1287*t^6*r^8","alpha*6435*t^8*r^7+(1-alpha)*1287*t^8*r^6+(1-alpha)*1716*t^7*r^7","alpha*5005*t^9*r^6+(1-alpha)*715*t^9*r^5+(1-alpha)*1716*t^8*r^6","alpha*3003*t^10*r^5+(1-alpha)*286*t^10*r^4+(1-alpha)*1287*t^9*r^5","alpha*1365*t^11*r^4+(1-alpha)*78*t^11*r^3+(1-alpha)*715*t^10*r^4","alpha*455*t^12*r^3+(1-alpha)*13*t^12*r^2+(1-alpha)*286*t^11*r^3","alpha*105*t^13*r^2+(1-alpha)*1*t^13*r+(1-alpha)*78*t^12*r^2","alpha*15*t^14*r+(1-alpha)*13*t^13*r","alpha*1*t^15*1+(1-alpha)*1*t^14*1"],parameters:[["alpha",0,1,1,!1,!1]]}}},{name:"ali_cubic",title:"Ali's cubic",counts:"4 control points",sizes:[4],usual:4,formulas:{"4":{functions:["r^2*(1+(2-p)*t)","p*t*r^2","q*t^2*r","t^2*(1+(2-q)*r)"],parameters:[["p",0,3,3,!1,!1],["q",0,3,3,!1,!1]]}}},{name:"q_bernstein",title:"q-Bernstein",counts:"2 to 11 control points",sizes:[2,3,4,5,6,7,8,9,10,11],usual:4,formulas:{"2":{functions:["(1*1)*1*(r+(1-q^0)*t)","(1*1)*t"],parameters:[["q",0,1,1,!0,!1]]},"3":{functions:["(1*1)*1*(r+(1-q^0)*t)*(r+(1-q^1)*t)","(1*1+1*q)*t*(r+(1-q^0)*t)","(1*1)*t^2"],parameters:[["q",0,1,1,!0,!1]]},"4":{functions:["(1*1)*1*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)","(1*1+1*q+1*q^2)*t*(r+(1-q^0)*t)*(r+(1-q^1)*t)","(1*1+1*q+1*q^2)*t^2*(r+(1-q^0)*t)","(1*1)*t^3"],parameters:[["q",0,1,1,!0,!1]]},"5":{functions:["(1*1)*1*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)*(r+(1-q^3)*t)","(1*1+1*q+1*q^2+1*q^3)*t*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)","(1*1+1*q+2*q^2+1*q^3+1*q^4)*t^2*(r+(1-q^0)*t)*(r+(1-q^1)*t)","(1*1+1*q+1*q^2+1*q^3)*t^3*(r+(1-q^0)*t)","(1*1)*t^4"],parameters:[["q",0,1,1,!0,!1]]},"6":{functions:["(1*1)*1*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)*(r+(1-q^3)*t)*(r+(1-q^4)*t)","(1*1+1*q+1*q^2+1*q^3+1*q^4)*t*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)*(r+(1-q^3)*t)","(1*1+1*q+2*q^2+2*q^3+2*q^4+1*q^5+1*q^6)*t^2*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)","(1*1+1*q+2*q^2+2*q^3+2*q^4+1*q^5+1*q^6)*t^3*(r+(1-q^0)*t)*(r+(1-q^1)*t)","(1*1+1*q+1*q^2+1*q^3+1*q^4)*t^4*(r+(1-q^0)*t)","(1*1)*t^5"],parameters:[["q",0,1,1,!0,!1]]},"7":{functions:["(1*1)*1*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)*(r+(1-q^3)*t)*(r+(1-q^4)*t)*(r+(1-q^5)*t)","(1*1+1*q+1*q^2+1*q^3+1*q^4+1*q^5)*t*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)*(r+(1-q^3)*t)*(r+(1-q^4)*t)","(1*1+1*q+2*q^2+2*q^3+3*q^4+2*q^5+2*q^6+1*q^7+1*q^8)*t^2*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)*(r+(1-q^3)*t)","(1*1+1*q+2*q^2+3*q^3+3*q^4+3*q^5+3*q^6+2*q^7+1*q^8+1*q^9)*t^3*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)","(1*1+1*q+2*q^2+2*q^3+3*q^4+2*q^5+2*q^6+1*q^7+1*q^8)*t^4*(r+(1-q^0)*t)*(r+(1-q^1)*t)","(1*1+1*q+1*q^2+1*q^3+1*q^4+1*q^5)*t^5*(r+(1-q^0)*t)","(1*1)*t^6"],parameters:[["q",0,1,1,!0,!1]]},"8":{functions:["(1*1)*1*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)*(r+(1-q^3)*t)*(r+(1-q^4)*t)*(r+(1-q^5)*t)*(r+(1-q^6)*t)","(1*1+1*q+1*q^2+1*q^3+1*q^4+1*q^5+1*q^6)*t*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)*(r+(1-q^3)*t)*(r+(1-q^4)*t)*(r+(1-q^5)*t)","(1*1+1*q+2*q^2+2*q^3+3*q^4+3*q^5+3*q^6+2*q^7+2*q^8+1*q^9+1*q^10)*t^2*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)*(r+(1-q^3)*t)*(r+(1-q^4)*t)","(1*1+1*q+2*q^2+3*q^3+4*q^4+4*q^5+5*q^6+4*q^7+4*q^8+3*q^9+2*q^10+1*q^11+1*q^12)*t^3*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)*(r+(1-q^3)*t)","(1*1+1*q+2*q^2+3*q^3+4*q^4+4*q^5+5*q^6+4*q^7+4*q^8+3*q^9+2*q^10+1*q^11+1*q^12)*t^4*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)","(1*1+1*q+2*q^2+2*q^3+3*q^4+3*q^5+3*q^6+2*q^7+2*q^8+1*q^9+1*q^10)*t^5*(r+(1-q^0)*t)*(r+(1-q^1)*t)","(1*1+1*q+1*q^2+1*q^3+1*q^4+1*q^5+1*q^6)*t^6*(r+(1-q^0)*t)","(1*1)*t^7"],parameters:[["q",0,1,1,!0,!1]]},"9":{functions:["(1*1)*1*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)*(r+(1-q^3)*t)*(r+(1-q^4)*t)*(r+(1-q^5)*t)*(r+(1-q^6)*t)*(r+(1-q^7)*t)","(1*1+1*q+1*q^2+1*q^3+1*q^4+1*q^5+1*q^6+1*q^7)*t*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)*(r+(1-q^3)*t)*(r+(1-q^4)*t)*(r+(1-q^5)*t)*(r+(1-q^6)*t)","(1*1+1*q+2*q^2+2*q^3+3*q^4+3*q^5+4*q^6+3*q^7+3*q^8+2*q^9+2*q^10+1*q^11+1*q^12)*t^2*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)*(r+(1-q^3)*t)*(r+(1-q^4)*t)*(r+(1-q^5)*t)","(1*1+1*q+2*q^2+3*q^3+4*q^4+5*q^5+6*q^6+6*q^7+6*q^8+6*q^9+5*q^10+4*q^11+3*q^12+2*q^13+1*q^14+1*q^15)*t^3*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)*(r+(1-q^3)*t)*(r+(1-q^4)*t)","(1*1+1*q+2*q^2+3*q^3+5*q^4+5*q^5+7*q^6+7*q^7+8*q^8+7*q^9+7*q^10+5*q^11+5*q^12+3*q^13+2*q^14+1*q^15+1*q^16)*t^4*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)*(r+(1-q^3)*t)","(1*1+1*q+2*q^2+3*q^3+4*q^4+5*q^5+6*q^6+6*q^7+6*q^8+6*q^9+5*q^10+4*q^11+3*q^12+2*q^13+1*q^14+1*q^15)*t^5*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)","(1*1+1*q+2*q^2+2*q^3+3*q^4+3*q^5+4*q^6+3*q^7+3*q^8+2*q^9+2*q^10+1*q^11+1*q^12)*t^6*(r+(1-q^0)*t)*(r+(1-q^1)*t)","(1*1+1*q+1*q^2+1*q^3+1*q^4+1*q^5+1*q^6+1*q^7)*t^7*(r+(1-q^0)*t)","(1*1)*t^8"],parameters:[["q",0,1,1,!0,!1]]},"10":{functions:["(1*1)*1*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)*(r+(1-q^3)*t)*(r+(1-q^4)*t)*(r+(1-q^5)*t)*(r+(1-q^6)*t)*(r+(1-q^7)*t)*(r+(1-q^8)*t)","(1*1+1*q+1*q^2+1*q^3+1*q^4+1*q^5+1*q^6+1*q^7+1*q^8)*t*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)*(r+(1-q^3)*t)*(r+(1-q^4)*t)*(r+(1-q^5)*t)*(r+(1-q^6)*t)*(r+(1-q^7)*t)","(1*1+1*q+2*q^2+2*q^3+3*q^4+3*q^5+4*q^6+4*q^7+4*q^8+3*q^9+3*q^10+2*q^11+2*q^12+1*q^13+1*q^14)*t^2*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)*(r+(1-q^3)*t)*(r+(1-q^4)*t)*(r+(1-q^5)*t)*(r+(1-q^6)*t)","(1*1+1*q+2*q^2+3*q^3+4*q^4+5*q^5+7*q^6+7*q^7+8*q^8+8*q^9+8*q^10+7*q^11+7*q^12+5*q^13+4*q^14+3*q^15+2*q^16+1*q^17+1*q^18)*t^3*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)*(r+(1-q^3)*t)*(r+(1-q^4)*t)*(r+(1-q^5)*t)","(1*1+1*q+2*q^2+3*q^3+5*q^4+6*q^5+8*q^6+9*q^7+11*q^8+11*q^9+12*q^10+11*q^11+11*q^12+9*q^13+8*q^14+6*q^15+5*q^16+3*q^17+2*q^18+1*q^19+1*q^20)*t^4*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)*(r+(1-q^3)*t)*(r+(1-q^4)*t)","(1*1+1*q+2*q^2+3*q^3+5*q^4+6*q^5+8*q^6+9*q^7+11*q^8+11*q^9+12*q^10+11*q^11+11*q^12+9*q^13+8*q^14+6*q^15+5*q^16+3*q^17+2*q^18+1*q^19+1*q^20)*t^5*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)*(r+(1-q^3)*t)","(1*1+1*q+2*q^2+3*q^3+4*q^4+5*q^5+7*q^6+7*q^7+8*q^8+8*q^9+8*q^10+7*q^11+7*q^12+5*q^13+4*q^14+3*q^15+2*q^16+1*q^17+1*q^18)*t^6*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)","(1*1+1*q+2*q^2+2*q^3+3*q^4+3*q^5+4*q^6+4*q^7+4*q^8+3*q^9+3*q^10+2*q^11+2*q^12+1*q^13+1*q^14)*t^7*(r+(1-q^0)*t)*(r+(1-q^1)*t)","(1*1+1*q+1*q^2+1*q^3+1*q^4+1*q^5+1*q^6+1*q^7+1*q^8)*t^8*(r+(1-q^0)*t)","(1*1)*t^9"],parameters:[["q",0,1,1,!0,!1]]},"11":{functions:["(1*1)*1*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)*(r+(1-q^3)*t)*(r+(1-q^4)*t)*(r+(1-q^5)*t)*(r+(1-q^6)*t)*(r+(1-q^7)*t)*(r+(1-q^8)*t)*(r+(1-q^9)*t)","(1*1+1*q+1*q^2+1*q^3+1*q^4+1*q^5+1*q^6+1*q^7+1*q^8+1*q^9)*t*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)*(r+(1-q^3)*t)*(r+(1-q^4)*t)*(r+(1-q^5)*t)*(r+(1-q^6)*t)*(r+(1-q^7)*t)*(r+(1-q^8)*t)","(1*1+1*q+2*q^2+2*q^3+3*q^4+3*q^5+4*q^6+4*q^7+5*q^8+4*q^9+4*q^10+3*q^11+3*q^12+2*q^13+2*q^14+1*q^15+1*q^16)*t^2*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)*(r+(1-q^3)*t)*(r+(1-q^4)*t)*(r+(1-q^5)*t)*(r+(1-q^6)*t)*(r+(1-q^7)*t)","(1*1+1*q+2*q^2+3*q^3+4*q^4+5*q^5+7*q^6+8*q^7+9*q^8+10*q^9+10*q^10+10*q^11+10*q^12+9*q^13+8*q^14+7*q^15+5*q^16+4*q^17+3*q^18+2*q^19+1*q^20+1*q^21)*t^3*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)*(r+(1-q^3)*t)*(r+(1-q^4)*t)*(r+(1-q^5)*t)*(r+(1-q^6)*t)","(1*1+1*q+2*q^2+3*q^3+5*q^4+6*q^5+9*q^6+10*q^7+13*q^8+14*q^9+16*q^10+16*q^11+18*q^12+16*q^13+16*q^14+14*q^15+13*q^16+10*q^17+9*q^18+6*q^19+5*q^20+3*q^21+2*q^22+1*q^23+1*q^24)*t^4*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)*(r+(1-q^3)*t)*(r+(1-q^4)*t)*(r+(1-q^5)*t)","(1*1+1*q+2*q^2+3*q^3+5*q^4+7*q^5+9*q^6+11*q^7+14*q^8+16*q^9+18*q^10+19*q^11+20*q^12+20*q^13+19*q^14+18*q^15+16*q^16+14*q^17+11*q^18+9*q^19+7*q^20+5*q^21+3*q^22+2*q^23+1*q^24+1*q^25)*t^5*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)*(r+(1-q^3)*t)*(r+(1-q^4)*t)","(1*1+1*q+2*q^2+3*q^3+5*q^4+6*q^5+9*q^6+10*q^7+13*q^8+14*q^9+16*q^10+16*q^11+18*q^12+16*q^13+16*q^14+14*q^15+13*q^16+10*q^17+9*q^18+6*q^19+5*q^20+3*q^21+2*q^22+1*q^23+1*q^24)*t^6*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)*(r+(1-q^3)*t)","(1*1+1*q+2*q^2+3*q^3+4*q^4+5*q^5+7*q^6+8*q^7+9*q^8+10*q^9+10*q^10+10*q^11+10*q^12+9*q^13+8*q^14+7*q^15+5*q^16+4*q^17+3*q^18+2*q^19+1*q^20+1*q^21)*t^7*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)","(1*1+1*q+2*q^2+2*q^3+3*q^4+3*q^5+4*q^6+4*q^7+5*q^8+4*q^9+4*q^10+3*q^11+3*q^12+2*q^13+2*q^14+1*q^15+1*q^16)*t^8*(r+(1-q^0)*t)*(r+(1-q^1)*t)","(1*1+1*q+1*q^2+1*q^3+1*q^4+1*q^5+1*q^6+1*q^7+1*q^8+1*q^9)*t^9*(r+(1-q^0)*t)","(1*1)*t^10"],parameters:[["q",0,1,1,!0,!1]]}}},{name:"normalised_trigonometric",title:"Normalised trigonometric B-basis",counts:"3, 5, 7, 9 or 11 control points",sizes:[3,5,7,9,11],usual:5,formulas:{"3":{functions:["(1*1)*sin(beta*r/2)^2*1/sin(beta/2)^2","(1*(2*cos(beta/2)))*sin(beta*r/2)*sin(beta*t/2)/sin(beta/2)^2","(1*1)*1*sin(beta*t/2)^2/sin(beta/2)^2"],parameters:[["beta",0,3.141592653589793,1.5707963267948966,!0,!0]]},"5":{functions:["(1*1)*sin(beta*r/2)^4*1/sin(beta/2)^4","(2*(2*cos(beta/2)))*sin(beta*r/2)^3*sin(beta*t/2)/sin(beta/2)^4","(1*(2*cos(beta/2))^2+2*1)*sin(beta*r/2)^2*sin(beta*t/2)^2/sin(beta/2)^4","(2*(2*cos(beta/2)))*sin(beta*r/2)*sin(beta*t/2)^3/sin(beta/2)^4","(1*1)*1*sin(beta*t/2)^4/sin(beta/2)^4"],parameters:[["beta",0,3.141592653589793,1.5707963267948966,!0,!0]]},"7":{functions:["(1*1)*sin(beta*r/2)^6*1/sin(beta/2)^6","(3*(2*cos(beta/2)))*sin(beta*r/2)^5*sin(beta*t/2)/sin(beta/2)^6","(3*(2*cos(beta/2))^2+3*1)*sin(beta*r/2)^4*sin(beta*t/2)^2/sin(beta/2)^6","(1*(2*cos(beta/2))^3+6*(2*cos(beta/2)))*sin(beta*r/2)^3*sin(beta*t/2)^3/sin(beta/2)^6","(3*(2*cos(beta/2))^2+3*1)*sin(beta*r/2)^2*sin(beta*t/2)^4/sin(beta/2)^6","(3*(2*cos(beta/2)))*sin(beta*r/2)*sin(beta*t/2)^5/sin(beta/2)^6","(1*1)*1*sin(beta*t/2)^6/sin(beta/2)^6"],parameters:[["beta",0,3.141592653589793,1.5707963267948966,!0,!0]]},"9":{functions:["(1*1)*sin(beta*r/2)^8*1/sin(beta/2)^8","(4*(2*cos(beta/2)))*sin(beta*r/2)^7*sin(beta*t/2)/sin(beta/2)^8","(6*(2*cos(beta/2))^2+4*1)*sin(beta*r/2)^6*sin(beta*t/2)^2/sin(beta/2)^8","(4*(2*cos(beta/2))^3+12*(2*cos(beta/2)))*sin(beta*r/2)^5*sin(beta*t/2)^3/sin(beta/2)^8","(1*(2*cos(beta/2))^4+12*(2*cos(beta/2))^2+6*1)*sin(beta*r/2)^4*sin(beta*t/2)^4/sin(beta/2)^8","(4*(2*cos(beta/2))^3+12*(2*cos(beta/2)))*sin(beta*r/2)^3*sin(beta*t/2)^5/sin(beta/2)^8","(6*(2*cos(beta/2))^2+4*1)*sin(beta*r/2)^2*sin(beta*t/2)^6/sin(beta/2)^8","(4*(2*cos(beta/2)))*sin(beta*r/2)*sin(beta*t/2)^7/sin(beta/2)^8","(1*1)*1*sin(beta*t/2)^8/sin(beta/2)^8"],parameters:[["beta",0,3.141592653589793,1.5707963267948966,!0,!0]]},"11":{functions:["(1*1)*sin(beta*r/2)^10*1/sin(beta/2)^10","(5*(2*cos(beta/2)))*sin(beta*r/2)^9*sin(beta*t/2)/sin(beta/2)^10","(10*(2*cos(beta/2))^2+5*1)*sin(beta*r/2)^8*sin(beta*t/2)^2/sin(beta/2)^10","(10*(2*cos(beta/2))^3+20*(2*cos(beta/2)))*sin(beta*r/2)^7*sin(beta*t/2)^3/sin(beta/2)^10","(5*(2*cos(beta/2))^4+30*(2*cos(beta/2))^2+10*1)*sin(beta*r/2)^6*sin(beta*t/2)^4/sin(beta/2)^10","(1*(2*cos(beta/2))^5+20*(2*cos(beta/2))^3+30*(2*cos(beta/2)))*sin(beta*r/2)^5*sin(beta*t/2)^5/sin(beta/2)^10","(5*(2*cos(beta/2))^4+30*(2*cos(beta/2))^2+10*1)*sin(beta*r/2)^4*sin(beta*t/2)^6/sin(beta/2)^10","(10*(2*cos(beta/2))^3+20*(2*cos(beta/2)))*sin(beta*r/2)^3*sin(beta*t/2)^7/sin(beta/2)^10","(10*(2*cos(beta/2))^2+5*1)*sin(beta*r/2)^2*sin(beta*t/2)^8/sin(beta/2)^10","(5*(2*cos(beta/2)))*sin(beta*r/2)*sin(beta*t/2)^9/sin(beta/2)^10","(1*1)*1*sin(beta*t/2)^10/sin(beta/2)^10"],parameters:[["beta",0,3.141592653589793,1.5707963267948966,!0,!0]]}}},{name:"c_bezier",title:"C-Bézier",counts:"4 control points",sizes:[4],usual:4,formulas:{"4":{functions:["(phi*r-sin(phi*r))/(phi-sin(phi))","sin(phi/2)^3/(phi/2*(1-cos(phi/2))-(phi/2-sin(phi/2)))*((1-cos(phi*r))/(1-cos(phi))-(phi*r-sin(phi*r))/(phi-sin(phi)))","sin(phi/2)^3/(phi/2*(1-cos(phi/2))-(phi/2-sin(phi/2)))*((1-cos(phi*t))/(1-cos(phi))-(phi*t-sin(phi*t))/(phi-sin(phi)))","(phi*t-sin(phi*t))/(phi-sin(phi))"],parameters:[["phi",0,3.141592653589793,1.5707963267948966,!0,!1]]}}},{name:"h_bezier",title:"H-Bézier",counts:"4 control points",sizes:[4],usual:4,formulas:{"4":{functions:["(sinh(phi*r)-phi*r)/(sinh(phi)-phi)","sinh(phi/2)^3/(phi/2*(cosh(phi/2)-1)-(sinh(phi/2)-phi/2))*((cosh(phi*r)-1)/(cosh(phi)-1)-(sinh(phi*r)-phi*r)/(sinh(phi)-phi))","sinh(phi/2)^3/(phi/2*(cosh(phi/2)-1)-(sinh(phi/2)-phi/2))*((cosh(phi*t)-1)/(cosh(phi)-1)-(sinh(phi*t)-phi*t)/(sinh(phi)-phi))","(sinh(phi*t)-phi*t)/(sinh(phi)-phi)"],parameters:[["phi",0,8,1,!0,!1]]}}},{name:"bernstein",title:"Bernstein polynomials, classical Bézier",counts:"2 or more control points",sizes:[2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24,25,26,27,28,29,30,31,32,33,34,35,36,37,38,39,40,41,42,43,44,45,46,47,48,49,50,51,52,53,54,55,56,57,58,59,60,61,62,63,64],usual:4,formulas:{}}],basisKeys:["functions","parameters","source","claims"],words:{point_type:["","lies on one side of the tangent plane, like an egg","crosses the tangent plane, like a saddle","bends in one direction only, like a cylinder","is flat to second order, like a plane","bends alike in all directions, like a sphere"],hk_type:["","bulges towards the normal in all directions","bulges towards the normal in one direction, straight in the other","saddle that mostly bulges towards the normal","cannot occur, since H² >= K","plane","saddle, equally bent both ways","hollow in all directions","hollow in one direction, straight in the other","saddle that is mostly hollow"],shape_class:["","hollow of a sphere, S = -1","hollow, more bent one way","gutter, S = -1/2","gutter with a sagging axis","symmetric saddle, S = 0","crest with a sagging axis","crest, S = +1/2","bulge, more bent one way","bulge of a sphere, S = +1","plane, κ1 = κ2 = 0"]},kinds:{tensor:{title:"Tensor-product surface",construction:!0,surface:!0,shapeNames:["alpha1","zeta1","alpha2","zeta2"],fields:{flip:{description:"Turn the normal to the other side",required:!1,default:!1,type:"boolean"},shape:{description:"Shape parameters of the basis, those in u, then those in v; for the quintic basis (α1, ζ1, α2, ζ2), or (α, ζ) for a developable, each in [-4, 1]",required:!1,default:[0,0,0,0],type:"shape"},basis:{description:"Basis, by name, or two for u and v, such as ['cubic', 'quintic']; 'bernstein' gives the classical surface on the same points",required:!1,default:"trigonometric",type:"basis"},bases:{description:"Bases of your own by name: [bases.NAME] with functions = [...] and parameters = { NAME = [low, high] }, or the name of a file of [basis.NAME] tables beside the model",required:!1,default:{},type:"raw"},unchecked_shape:{description:"Allow shape parameters outside their range, [-4, 1] for the quintic basis; the convex-hull property is then lost",required:!1,default:!1,type:"boolean"},unchecked_basis:{description:"Allow a basis whose functions do not sum to 1; the surface moves with the origin",required:!1,default:!1,type:"boolean"},points:{description:"6 x 6 control points [x, y, z]; points[i][j] with i along u, j along v",required:!0,type:"points",counts:[6,6],dimension:3}}},symmetric:{title:"Tensor-product surface that is its own mirror image",construction:!0,surface:!0,shapeNames:["alpha1","zeta1","alpha2","zeta2"],fields:{flip:{description:"Turn the normal to the other side",required:!1,default:!1,type:"boolean"},shape:{description:"Shape parameters of the basis, those in u, then those in v; for the quintic basis (α1, ζ1, α2, ζ2), or (α, ζ) for a developable, each in [-4, 1]",required:!1,default:[0,0,0,0],type:"shape"},basis:{description:"Basis, by name, or two for u and v, such as ['cubic', 'quintic']; 'bernstein' gives the classical surface on the same points",required:!1,default:"trigonometric",type:"basis"},bases:{description:"Bases of your own by name: [bases.NAME] with functions = [...] and parameters = { NAME = [low, high] }, or the name of a file of [basis.NAME] tables beside the model",required:!1,default:{},type:"raw"},unchecked_shape:{description:"Allow shape parameters outside their range, [-4, 1] for the quintic basis; the convex-hull property is then lost",required:!1,default:!1,type:"boolean"},unchecked_basis:{description:"Allow a basis whose functions do not sum to 1; the surface moves with the origin",required:!1,default:!1,type:"boolean"},points:{description:"3 x 6 control points, half of the net; the other three rows are mirrored",required:!0,type:"points",counts:[3,6],dimension:3},mirror:{description:"Mirror plane [a, b, c, d]: a x + b y + c z + d = 0",required:!0,type:"plane"}}},swept:{title:"Translational sweep of a section along a trajectory",construction:!0,surface:!0,shapeNames:["alpha1","zeta1","alpha2","zeta2"],fields:{flip:{description:"Turn the normal to the other side",required:!1,default:!1,type:"boolean"},shape:{description:"Shape parameters of the basis, those in u, then those in v; for the quintic basis (α1, ζ1, α2, ζ2), or (α, ζ) for a developable, each in [-4, 1]",required:!1,default:[0,0,0,0],type:"shape"},basis:{description:"Basis, by name, or two for u and v, such as ['cubic', 'quintic']; 'bernstein' gives the classical surface on the same points",required:!1,default:"trigonometric",type:"basis"},bases:{description:"Bases of your own by name: [bases.NAME] with functions = [...] and parameters = { NAME = [low, high] }, or the name of a file of [basis.NAME] tables beside the model",required:!1,default:{},type:"raw"},unchecked_shape:{description:"Allow shape parameters outside their range, [-4, 1] for the quintic basis; the convex-hull property is then lost",required:!1,default:!1,type:"boolean"},unchecked_basis:{description:"Allow a basis whose functions do not sum to 1; the surface moves with the origin",required:!1,default:!1,type:"boolean"},section:{description:"6 points [x, y, z] of the section curve, along u",required:!0,type:"points",counts:[6],dimension:3},trajectory:{description:"6 points [x, y, z] of the trajectory curve, along v",required:!0,type:"points",counts:[6],dimension:3}}},swung:{title:"Profile swung along a plane trajectory",construction:!0,surface:!0,shapeNames:["alpha1","zeta1","alpha2","zeta2"],fields:{flip:{description:"Turn the normal to the other side",required:!1,default:!1,type:"boolean"},shape:{description:"Shape parameters of the basis, those in u, then those in v; for the quintic basis (α1, ζ1, α2, ζ2), or (α, ζ) for a developable, each in [-4, 1]",required:!1,default:[0,0,0,0],type:"shape"},basis:{description:"Basis, by name, or two for u and v, such as ['cubic', 'quintic']; 'bernstein' gives the classical surface on the same points",required:!1,default:"trigonometric",type:"basis"},bases:{description:"Bases of your own by name: [bases.NAME] with functions = [...] and parameters = { NAME = [low, high] }, or the name of a file of [basis.NAME] tables beside the model",required:!1,default:{},type:"raw"},unchecked_shape:{description:"Allow shape parameters outside their range, [-4, 1] for the quintic basis; the convex-hull property is then lost",required:!1,default:!1,type:"boolean"},unchecked_basis:{description:"Allow a basis whose functions do not sum to 1; the surface moves with the origin",required:!1,default:!1,type:"boolean"},profile:{description:"6 pairs [r, z] of the profile curve, along u",required:!0,type:"points",counts:[6],dimension:2},trajectory:{description:"6 pairs [x, y] of the trajectory curve, along v",required:!0,type:"points",counts:[6],dimension:2},scale:{description:"Scale factor λ of the trajectory",required:!1,default:1,type:"number"}}},ruled:{title:"Straight lines between two curves",construction:!0,surface:!0,shapeNames:["alpha1","zeta1","alpha2","zeta2"],fields:{flip:{description:"Turn the normal to the other side",required:!1,default:!1,type:"boolean"},shape:{description:"Shape parameters of the basis, those in u, then those in v; for the quintic basis (α1, ζ1, α2, ζ2), or (α, ζ) for a developable, each in [-4, 1]",required:!1,default:[0,0,0,0],type:"shape"},basis:{description:"Basis, by name, or two for u and v, such as ['cubic', 'quintic']; 'bernstein' gives the classical surface on the same points",required:!1,default:"trigonometric",type:"basis"},bases:{description:"Bases of your own by name: [bases.NAME] with functions = [...] and parameters = { NAME = [low, high] }, or the name of a file of [basis.NAME] tables beside the model",required:!1,default:{},type:"raw"},unchecked_shape:{description:"Allow shape parameters outside their range, [-4, 1] for the quintic basis; the convex-hull property is then lost",required:!1,default:!1,type:"boolean"},unchecked_basis:{description:"Allow a basis whose functions do not sum to 1; the surface moves with the origin",required:!1,default:!1,type:"boolean"},first:{description:"6 points [x, y, z] of the curve at v = 0, with (α1, ζ1)",required:!0,type:"points",counts:[6],dimension:3},second:{description:"6 points [x, y, z] of the curve at v = 1, with (α2, ζ2)",required:!0,type:"points",counts:[6],dimension:3}}},developable:{title:"Strip enveloped by a family of planes",construction:!0,surface:!0,shapeNames:["alpha","zeta"],fields:{flip:{description:"Turn the normal to the other side",required:!1,default:!1,type:"boolean"},shape:{description:"Shape parameters of the basis, those in u, then those in v; for the quintic basis (α1, ζ1, α2, ζ2), or (α, ζ) for a developable, each in [-4, 1]",required:!1,default:[0,0],type:"shape"},basis:{description:"Basis, by name, or two for u and v, such as ['cubic', 'quintic']; 'bernstein' gives the classical surface on the same points",required:!1,default:"trigonometric",type:"basis"},bases:{description:"Bases of your own by name: [bases.NAME] with functions = [...] and parameters = { NAME = [low, high] }, or the name of a file of [basis.NAME] tables beside the model",required:!1,default:{},type:"raw"},unchecked_shape:{description:"Allow shape parameters outside their range, [-4, 1] for the quintic basis; the convex-hull property is then lost",required:!1,default:!1,type:"boolean"},unchecked_basis:{description:"Allow a basis whose functions do not sum to 1; the surface moves with the origin",required:!1,default:!1,type:"boolean"},planes:{description:"6 control planes [a, b, c, d]: a x + b y + c z + d = 0",required:!0,type:"points",counts:[6],dimension:4},bounds:{description:"2 planes [a, b, c, d] that cut the rulings at v = 0 and v = 1",required:!0,type:"points",counts:[2],dimension:4}}},nurbs:{title:"Rational B-spline surface (NURBS), such as a face read from a CAD file",construction:!1,surface:!0,shapeNames:[],fields:{flip:{description:"Turn the normal to the other side",required:!1,default:!1,type:"boolean"},degrees:{description:"Degrees (p, q) in u and v",required:!0,type:"raw"},knots:{description:"Full knot vectors in u and v: control points + degree + 1 numbers each; u, v in [0, 1] span them",required:!0,type:"raw"},points:{description:"Control points [x, y, z]; points[i][j] with i along u, j along v",required:!0,type:"raw"},weights:{description:"Weights of the control points, all 1 when left out",required:!1,default:null,type:"raw"},trim:{description:"Closed loops of [u, v] that bound the face on its surface",required:!1,default:[],type:"raw"}}},sphere:{title:"Sphere",construction:!1,surface:!0,shapeNames:[],fields:{flip:{description:"Turn the normal to the other side",required:!1,default:!1,type:"boolean"},radius:{description:"Radius",required:!1,default:1,type:"positive"}}},ellipsoid:{title:"Ellipsoid x²/a² + y²/b² + z²/c² = 1",construction:!1,surface:!0,shapeNames:[],fields:{flip:{description:"Turn the normal to the other side",required:!1,default:!1,type:"boolean"},a:{description:"Half axis along x",required:!1,default:3,type:"positive"},b:{description:"Half axis along y",required:!1,default:2,type:"positive"},c:{description:"Half axis along z",required:!1,default:1,type:"positive"}}},cylinder:{title:"Circular cylinder",construction:!1,surface:!0,shapeNames:[],fields:{flip:{description:"Turn the normal to the other side",required:!1,default:!1,type:"boolean"},radius:{description:"Radius",required:!1,default:1,type:"positive"},height:{description:"Height along z",required:!1,default:2,type:"positive"}}},cone:{title:"Cone with its apex up",construction:!1,surface:!0,shapeNames:[],fields:{flip:{description:"Turn the normal to the other side",required:!1,default:!1,type:"boolean"},radius:{description:"Radius of the base",required:!1,default:1,type:"positive"},height:{description:"Height along z",required:!1,default:2,type:"positive"}}},torus:{title:"Torus",construction:!1,surface:!0,shapeNames:[],fields:{flip:{description:"Turn the normal to the other side",required:!1,default:!1,type:"boolean"},major:{description:"Radius of the circle of centres",required:!1,default:3,type:"positive"},minor:{description:"Radius of the tube",required:!1,default:1,type:"positive"}}},catenoid:{title:"Catenoid, a minimal surface",construction:!1,surface:!0,shapeNames:[],fields:{flip:{description:"Turn the normal to the other side",required:!1,default:!1,type:"boolean"},waist:{description:"Radius of the waist",required:!1,default:1,type:"positive"},height:{description:"Height along z",required:!1,default:2,type:"positive"}}},helicoid:{title:"One turn of a helicoid, a minimal surface",construction:!1,surface:!0,shapeNames:[],fields:{flip:{description:"Turn the normal to the other side",required:!1,default:!1,type:"boolean"},radius:{description:"Half length of the rulings",required:!1,default:1,type:"positive"},pitch:{description:"Rise in one turn",required:!1,default:2,type:"number"}}},hyperbolic_paraboloid:{title:"z = x y",construction:!1,surface:!0,shapeNames:[],fields:{flip:{description:"Turn the normal to the other side",required:!1,default:!1,type:"boolean"},size:{description:"Half side of the square of parameters",required:!1,default:1,type:"positive"}}},monkey_saddle:{title:"z = x³ - 3 x y²",construction:!1,surface:!0,shapeNames:[],fields:{flip:{description:"Turn the normal to the other side",required:!1,default:!1,type:"boolean"},size:{description:"Half side of the square of parameters",required:!1,default:1,type:"positive"}}},enneper:{title:"Enneper's minimal surface",construction:!1,surface:!0,shapeNames:[],fields:{flip:{description:"Turn the normal to the other side",required:!1,default:!1,type:"boolean"},size:{description:"Half side of the square of parameters",required:!1,default:1,type:"positive"}}},curve:{title:"Curve",construction:!0,surface:!1,shapeNames:["alpha","zeta"],fields:{flip:{description:"Run from the other end",required:!1,default:!1,type:"boolean"},shape:{description:"Shape parameters of the basis, those in u, then those in v; for the quintic basis (α1, ζ1, α2, ζ2), or (α, ζ) for a developable, each in [-4, 1]",required:!1,default:[0,0],type:"shape"},basis:{description:"Basis, by name, or two for u and v, such as ['cubic', 'quintic']; 'bernstein' gives the classical surface on the same points",required:!1,default:"trigonometric",type:"basis"},bases:{description:"Bases of your own by name: [bases.NAME] with functions = [...] and parameters = { NAME = [low, high] }, or the name of a file of [basis.NAME] tables beside the model",required:!1,default:{},type:"raw"},unchecked_shape:{description:"Allow shape parameters outside their range, [-4, 1] for the quintic basis; the convex-hull property is then lost",required:!1,default:!1,type:"boolean"},unchecked_basis:{description:"Allow a basis whose functions do not sum to 1; the surface moves with the origin",required:!1,default:!1,type:"boolean"},points:{description:"6 control points, all [x, y] or all [x, y, z]",required:!0,type:"points",counts:[0],dimension:0},close:{description:"End in the first control point, which is then not given again as the last",required:!1,default:!1,type:"boolean"}}}},palette:{undefined:"#7d7d7d",front:"#9dc3e0",back:"#e8c793",series:["#0072b2","#d55e00","#009e73","#cc79a7","#e69f00","#56b4e9","#000000","#a6761d"],classes:{point_type:["#7d7d7d","#d9541e","#5fd99a","#f5a623","#f2f0ea","#7f1d0f"],hk_type:["#7d7d7d","#d9541e","#f5a623","#fbe26a","#000000","#f2f0ea","#5fd99a","#2166ac","#56a0d3","#a6d8f0"],shape_class:["#7d7d7d","#08306b","#2166ac","#56a0d3","#a6d8f0","#5fd99a","#fbe26a","#f5a623","#d9541e","#7f1d0f","#f2f0ea"],invariant_type:["#7d7d7d","#d9541e","#f5a623","#fbe26a","#000000","#f2f0ea","#5fd99a","#2166ac","#56a0d3","#a6d8f0"]},diverging:["#12406f","#194e80","#215c91","#286aa2","#2f78b3","#4387bc","#5796c5","#6ca5cd","#80b4d6","#92bfdc","#a5cae1","#b7d5e7","#cadfec","#d5e5ed","#e0eaee","#ebefee","#f6f3ee","#f7ebe2","#f7e3d6","#f8dbca","#f8d2be","#f4c4ac","#f1b59a","#eda789","#e99878","#e18369","#d96f5b","#d05a4c","#c7473e","#b53938","#a32b32","#921e2b","#821226"],sequential:["#f3f1d8","#ebeed0","#e3eac8","#dbe7c0","#d3e3b8","#cbe0b0","#c0dcac","#b4d6a9","#a7d1a5","#9acca2","#8ec79f","#82c29d","#76bb9c","#6bb59c","#60ae9b","#55a89b","#4aa29a","#459b98","#409497","#3a8d95","#358694","#307f92","#2f7890","#2e708d","#2d698b","#2d6288","#2c5b85","#2c5481","#2d4c7b","#2d4575","#2d3d6f","#2e3668","#2e2f63"]},presets:[{schema:1,name:"Car boot lid",unit:"mm",kind:"swept",shape:[1,1,0,0],section:[[0,0,30],[240,0,-14],[590,0,36],[606,0,-2],[505,0,-190],[560,0,-390]],trajectory:[[-150,-700,-90],[-55,-610,-24],[0,-260,0],[0,260,0],[-55,610,-24],[-150,700,-90]]},{schema:1,name:"Classical quintic swung vase",unit:"cm",kind:"swung",flip:!0,basis:"bernstein",profile:[[1,0],[3,1],[4,3],[3,5],[2,7],[2,8]],trajectory:[[1,0],[1,.6],[.7,1],[0,1.2],[-.6,1.1],[-1,.9]],scale:1.5},{schema:1,name:"Cylinder",unit:"mm",kind:"cylinder",radius:10,height:40},{schema:1,name:"Developable vault",unit:"m",kind:"developable",shape:[1,1],planes:[[-1,.22,1,-11],[-.8,.1,1,-9],[-.35,-.04,1,-6],[.35,-.1,1,-6],[.8,-.04,1,-9],[1,.04,1,-11]],bounds:[[0,1,0,0],[0,1,0,-10]]},{schema:1,name:"Saddle roof from a CSV net",unit:"m",kind:"tensor",shape:[0,0,0,0],points:[[[0,0,3],[0,2,4.92],[0,4,5.88],[0,6,5.88],[0,8,4.92],[0,10,3]],[[2,0,1.08],[2,2,3],[2,4,3.96],[2,6,3.96],[2,8,3],[2,10,1.08]],[[4,0,.12],[4,2,2.04],[4,4,3],[4,6,3],[4,8,2.04],[4,10,.12]],[[6,0,.12],[6,2,2.04],[6,4,3],[6,6,3],[6,8,2.04],[6,10,.12]],[[8,0,1.08],[8,2,3],[8,4,3.96],[8,6,3.96],[8,8,3],[8,10,1.08]],[[10,0,3],[10,2,4.92],[10,4,5.88],[10,6,5.88],[10,8,4.92],[10,10,3]]]},{schema:1,name:"Rear of a car",unit:"mm",patch:[{name:"rear window",kind:"swept",shape:[1,1,0,0],section:[[-720,0,470],[-600,0,452],[-430,0,390],[-300,0,290],[-150,0,160],[0,0,30]],trajectory:[[-150,-700,-90],[-55,-610,-24],[0,-260,0],[0,260,0],[-55,610,-24],[-150,700,-90]]},{name:"boot lid",kind:"swept",shape:[1,1,0,0],section:[[0,0,30],[240,0,-14],[590,0,36],[606,0,-2],[505,0,-190],[560,0,-390]],trajectory:[[-150,-700,-90],[-55,-610,-24],[0,-260,0],[0,260,0],[-55,610,-24],[-150,700,-90]]}]},{schema:1,name:"Ruled roof",unit:"m",kind:"ruled",shape:[1,1,1,1],first:[[0,0,0],[1,2,4],[3,3,5],[5,3,5],[7,2,4],[8,0,0]],second:[[0,10,2],[1,9,0],[3,8,-2],[5,8,3],[7,9,5],[8,10,1]]},{schema:1,name:"Sphere",unit:"mm",kind:"sphere",radius:20},{schema:1,name:"Swept canopy",unit:"m",kind:"swept",shape:[1,1,1,1],section:[[0,0,0],[2,0,1],[4,0,3],[6,0,3],[8,0,1],[10,0,0]],trajectory:[[0,0,0],[0,1,3],[0,3,5],[0,5,5],[0,7,3],[0,8,0]]},{schema:1,name:"Swung vase",unit:"cm",kind:"swung",flip:!0,shape:[1,1,1,1],profile:[[1,0],[3,1],[4,3],[3,5],[2,7],[2,8]],trajectory:[[1,0],[1,.6],[.7,1],[0,1.2],[-.6,1.1],[-1,.9]],scale:1.5},{schema:1,name:"Symmetric shell",unit:"m",kind:"symmetric",shape:[1,1,1,1],points:[[[0,0,0],[0,2,2],[0,4,3],[0,6,3],[0,8,2],[0,10,0]],[[2,0,1.5],[2,2,3],[2,4,4.5],[2,6,4.5],[2,8,3],[2,10,1.5]],[[4,0,3],[4,2,3.5],[4,4,5],[4,6,5],[4,8,3.5],[4,10,3]]],mirror:[1,0,0,-5]},{schema:1,name:"Thesis net of section 2.5.2",kind:"tensor",flip:!0,shape:[1,1,1,1],points:[[[0,0,0],[0,0,10],[4,0,10],[6,0,10],[10,0,10],[10,0,0]],[[0,2,0],[0,2,10],[4,2,10],[6,2,10],[10,2,10],[10,2,0]],[[0,4,0],[0,4,10],[4,4,10],[6,4,10],[10,4,10],[10,4,0]],[[0,6,0],[0,6,10],[4,6,10],[6,6,10],[10,6,10],[10,6,0]],[[0,8,0],[0,8,10],[4,8,10],[6,8,10],[10,8,10],[10,8,0]],[[0,10,0],[0,10,10],[4,10,10],[6,10,10],[10,10,10],[10,10,0]]]},{schema:1,name:"Wavy surface",unit:"cm",kind:"tensor",shape:[1,1,1,1],points:[[[0,0,0],[0,2,1],[0,4,2],[0,6,2],[0,8,1],[0,10,0]],[[2,0,1],[2,2,3],[2,4,5],[2,6,4],[2,8,2],[2,10,1]],[[4,0,2],[4,2,5],[4,4,8],[4,6,7],[4,8,4],[4,10,2]],[[6,0,2],[6,2,4],[6,4,7],[6,6,6],[6,8,3],[6,10,1]],[[8,0,1],[8,2,2],[8,4,4],[8,6,3],[8,8,1],[8,10,-1]],[[10,0,0],[10,2,1],[10,4,2],[10,6,1],[10,8,-1],[10,10,-3]]]}],starters:{tensor:{schema:1,name:"My tensor surface",unit:"mm",kind:"tensor",points:[[[0,0,0],[0,20,0],[0,40,0],[0,60,0],[0,80,0],[0,100,0]],[[20,0,0],[20,20,5],[20,40,15],[20,60,16],[20,80,7],[20,100,2]],[[40,0,0],[40,20,15],[40,40,40],[40,60,44],[40,80,19],[40,100,4]],[[60,0,0],[60,20,16],[60,40,44],[60,60,49],[60,80,21],[60,100,5]],[[80,0,0],[80,20,7],[80,40,19],[80,60,21],[80,80,9],[80,100,2]],[[100,0,0],[100,20,2],[100,40,4],[100,60,5],[100,80,2],[100,100,0]]],shape:[0,0,0,0]},symmetric:{schema:1,name:"My symmetric surface",unit:"mm",kind:"symmetric",points:[[[0,0,0],[0,20,8],[0,40,23],[0,60,25],[0,80,11],[0,100,2]],[[20,0,10],[20,20,18],[20,40,33],[20,60,35],[20,80,21],[20,100,12]],[[40,0,30],[40,20,38],[40,40,53],[40,60,55],[40,80,41],[40,100,32]]],mirror:[1,0,0,-50],shape:[0,0,0,0]},swept:{schema:1,name:"My swept surface",unit:"mm",kind:"swept",section:[[0,0,0],[20,0,10],[40,0,30],[60,0,30],[80,0,10],[100,0,0]],trajectory:[[0,0,0],[0,20,11],[0,40,30],[0,60,34],[0,80,14],[0,100,3]],shape:[0,0,0,0]},swung:{schema:1,name:"My swung surface",unit:"mm",kind:"swung",profile:[[20,0],[60,10],[80,40],[50,70],[30,100],[40,120]],trajectory:[[1,0],[1,.6],[.7,1],[-.7,1],[-1,.6],[-1,0]],shape:[0,0,0,0],flip:!0,scale:1},ruled:{schema:1,name:"My ruled surface",unit:"mm",kind:"ruled",first:[[0,0,0],[20,0,10],[40,0,30],[60,0,30],[80,0,10],[100,0,0]],second:[[0,100,0],[20,100,5],[40,100,13],[60,100,14],[80,100,6],[100,100,1]],shape:[0,0,0,0]},developable:{schema:1,name:"My developable surface",unit:"mm",kind:"developable",planes:[[-1,.2,1,-110],[-.8,.1,1,-90],[-.35,-.05,1,-60],[.35,-.05,1,-60],[.8,.1,1,-90],[1,.2,1,-110]],bounds:[[0,1,0,0],[0,1,0,-100]],shape:[0,0]},nurbs:{schema:1,name:"My nurbs",unit:"mm",kind:"nurbs",degrees:[2,2],knots:[[0,0,0,1,1,1],[0,0,0,1,1,1]],points:[[[0,0,0],[0,50,50],[0,100,0]],[[50,0,30],[50,50,80],[50,100,30]],[[100,0,0],[100,50,50],[100,100,0]]],weights:[[1,.7,1],[1,.7,1],[1,.7,1]]},sphere:{schema:1,name:"My sphere",unit:"mm",kind:"sphere",radius:20},ellipsoid:{schema:1,name:"My ellipsoid",unit:"mm",kind:"ellipsoid",a:30,b:20,c:10},cylinder:{schema:1,name:"My cylinder",unit:"mm",kind:"cylinder",radius:10,height:40},cone:{schema:1,name:"My cone",unit:"mm",kind:"cone",radius:10,height:20},torus:{schema:1,name:"My torus",unit:"mm",kind:"torus",major:30,minor:10},catenoid:{schema:1,name:"My catenoid",unit:"mm",kind:"catenoid",waist:10,height:20},helicoid:{schema:1,name:"My helicoid",unit:"mm",kind:"helicoid",radius:10,pitch:20},hyperbolic_paraboloid:{schema:1,name:"My hyperbolic paraboloid",unit:"mm",kind:"hyperbolic_paraboloid"},monkey_saddle:{schema:1,name:"My monkey saddle",unit:"mm",kind:"monkey_saddle"},enneper:{schema:1,name:"My enneper",unit:"mm",kind:"enneper"},curve:{schema:1,name:"My curve",unit:"mm",kind:"curve",points:[[0,0],[10,40],[40,50],[60,-10],[90,0],[100,30]],shape:[0,0]}}};var kt=()=>new Float64Array(3);function Bt(i,e,t){let n=i[0],r=i[1],s=i[2],a=e[0],o=e[1],l=e[2];return t[0]=n*a,t[1]=n*o+r*a,t[2]=n*l+r*o+s*a,t}function kn(i,e,t,n,r,s){return s[0]=i*e[0]+t*n[0]+r,s[1]=i*e[1]+t*n[1],s[2]=i*e[2]+t*n[2],s}function Sp(i,e,t){let n=e[0],r=e[1],s=e[2],a=i[0]/n,o=(i[1]-a*r)/n,l=(i[2]-(a*s+o*r))/n;return t[0]=a,t[1]=o,t[2]=l,t}function ea(i,e,t){t[0].fill(0),t[0][0]=1;for(let n=1;n<=e;n++)Bt(t[n-1],i,t[n])}var _i=i=>Array.from({length:i},kt);var Mp=.5*Math.PI,Si=class{constructor(e,t){this.start=e;this.end=t}start;end;size=2;derivatives(e,t,n){let r=this.end-this.start,s=Mp*r;for(let a=0;a<t;a++){ta(this.start+r*e[a]);let o=xr,l=_r;n[2*a]=l,n[2*a+1]=o,n[2*(t+a)]=s*-o,n[2*(t+a)+1]=s*l,n[2*(2*t+a)]=s*s*-l,n[2*(2*t+a)+1]=s*s*-o}}},ns=class{constructor(e,t){this.start=e;this.end=t}start;end;size=2;derivatives(e,t,n){let r=this.end-this.start;for(let s=0;s<t;s++){let a=this.start+r*e[s],o=Math.cosh(a),l=Math.sinh(a);for(let c=0,h=1;c<3;c++,h*=r)n[2*(c*t+s)]=h*(c===1?l:o),n[2*(c*t+s)+1]=h*(c===1?o:l)}}},hn=class{constructor(e,t,n){this.start=e;this.end=t;this.degree=n;this.size=n+1}start;end;degree;size;derivatives(e,t,n){let r=kt(),s=_i(this.size),a=this.size;r[1]=this.end-this.start;for(let o=0;o<t;o++){r[0]=this.start+(this.end-this.start)*e[o],ea(r,this.degree,s);for(let l=0;l<a;l++)Lh(s[l],n,t,o,a,l)}}},Bn=class{constructor(e){this.parts=e;this.size=e.reduce((t,n)=>t+n.size,0)}parts;size;scratch=new Float64Array(0);derivatives(e,t,n){let r=0;for(let s of this.parts){let a=s.size;this.scratch.length<3*t*a&&(this.scratch=new Float64Array(3*t*a)),s.derivatives(e,t,this.scratch);for(let o=0;o<3*t;o++)for(let l=0;l<a;l++)n[o*this.size+r+l]=this.scratch[o*a+l];r+=a}}};function Lh(i,e,t,n,r,s){e[n*r+s]=i[0],e[(t+n)*r+s]=i[1],e[(2*t+n)*r+s]=2*i[2]}var xr=0,_r=1;function ta(i){let e=T1(i),t=Mp*(i-e),n=Math.sin(t),r=Math.cos(t),s=(e%4+4)%4;xr=(s===0?n:s===1?r:s===2?-n:-r)+0,_r=(s===0?r:s===1?-n:s===2?-r:n)+0}function T1(i){let e=Math.floor(i);return i-e!==.5?Math.round(i):e%2===0?e:e+1}var qi=kt(),Vi=kt(),Hi=kt(),Gi=kt(),Mi=kt(),Dh=kt(),zh=kt(),bo=kt(),na=kt(),ri=kt(),is=_i(5),wp=_i(5);Mi[0]=1;var ai=[!1,!1],un=class{constructor(e,t,n=ai){this.alpha=e;this.zeta=t;this.still=n}alpha;zeta;still;size=6;derivatives(e,t,n){let{alpha:r,zeta:s}=this;for(let a=0;a<t;a++){let[o,l]=this.still;if(this.slopes(e[a],!1,!1,is),o||l){this.slopes(e[a],o,l,wp);let b=(o?qi[0]:1)*(l?Vi[0]:1);for(let m=0;m<5;m++)is[m][1]=b*wp[m][1]}let c=qi[0],h=Vi[0],d=Hi[0],u=Gi[0],p=e[a]<.5,f=6*a;n[f]=d**4*(p?1-r*c:1-r+r*d),n[f+1]=c*d**3*(p?4+r-r*c:4+r*d),n[f+2]=d**2*u*(8*c+3*h+9),n[f+3]=u**2*d*(8*h+3*c+9),n[f+4]=h*u**3*(p?4+s*u:4+s-s*h),n[f+5]=u**4*(p?1-s+s*u:1-s*h);for(let b=0;b<2;b++){let m=6*((b+1)*t+a);n[m]=-is[0][b];for(let g=1;g<5;g++)n[m+g]=is[g-1][b]-is[g][b];n[m+5]=is[4][b]}}}slopes(e,t,n,r){ta(e),Ep(xr,_r,qi),Ep(_r,-xr,Vi),kn(-1,qi,0,qi,0,Hi),kn(-1,Vi,0,Vi,0,Gi),Hi[0]=2*Math.sin(.25*Math.PI*(1-e))**2,Gi[0]=2*Math.sin(.25*Math.PI*e)**2;let s=e<.5,a=t?Mi:qi,o=n?Mi:Vi;Bt(a,o,bo),Bt(Hi,Hi,Dh),Bt(Gi,Gi,zh),Ap(this.alpha,qi,Hi,s,t,na),Bt(o,Bt(Bt(Dh,Hi,ri),na,ri),r[0]),Bt(Dh,bo,r[1]),kn(12,r[1],0,Mi,0,r[1]),Sp(Mi,kn(1,qi,1,Vi,1,ri),ri),kn(4,ri,32,Mi,0,ri),Bt(Bt(Hi,Gi,na),Bt(bo,ri,ri),r[2]),Bt(zh,bo,r[3]),kn(12,r[3],0,Mi,0,r[3]),Ap(this.zeta,Vi,Gi,!s,n,na),Bt(a,Bt(Bt(zh,Gi,ri),na,ri),r[4]);for(let l=0;l<5;l++)kn(.5*Math.PI,r[l],0,Mi,0,r[l])}},si=class{constructor(e){this.degree=e;this.size=e+1}degree;size;derivatives(e,t,n){let r=kt(),s=kt(),a=C1(this.degree);r[1]=1,s[1]=-1;for(let o=0;o<t;o++)r[0]=e[o],s[0]=1-e[o],a(r,s,n,t,o)}};function Tp(i,e,t){let n=(r,s)=>t[r].every((a,o)=>a.every((l,c)=>l===t[s][o][c]));return[i===-4||n(0,1),e===-4||n(t.length-1,t.length-2)]}function Fh(i,e){let t=1;for(let n=1;n<=e;n++)t=t*(i-e+n)/n;return t}function Ap(i,e,t,n,r,s){if(r)return void kn(-5*i,Mi,0,e,0,s);kn(-5*i,e,0,e,0,s),s[0]=n?4+i-5*i*e[0]:4-4*i+5*i*t[0]}function Ep(i,e,t){let n=.5*Math.PI;t[0]=i,t[1]=n*e,t[2]=n*n*-i/2}function C1(i){let e=_i(i+1),t=_i(i+1),n=kt(),r=e.map((s,a)=>Fh(i,a));return(s,a,o,l,c)=>{ea(s,i,e),ea(a,i,t);for(let h=0;h<=i;h++)Bt(e[h],t[i-h],n),kn(r[h],n,0,n,0,n),Lh(n,o,l,c,i+1,h)}}var vo=["t","r","s","c","a","b"],Uh=["sin","cos","sinh","cosh","sqrt","exp"],Np=[...vo,"pi",...Uh],Cp=4e3,Rp=40,Oh=64,Pp=200,yo=/\s*(?:(?<number>(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?)|(?<name>[\p{L}_][\p{L}\p{N}_]*)|(?<sign>\*\*|.))/suy,Ip={s:"a",c:"b",t:"r",a:"s",b:"c",r:"t"};function qh(i,e=[]){if(typeof i!="string")throw new Error(`expected a formula in quotation marks, found ${JSON.stringify(i)}`.slice(0,200));if(i.length>Cp)throw new Error(`expected at most ${Cp} characters, found ${i.length}; shorten the formula`);return new kh(i,e).whole()}function Lp(i){return i.is==="binary"?[i.left,i.right]:i.is==="power"?[i.base]:i.is==="call"?[i.argument]:[]}var kh=class{constructor(e,t){this.text=e;this.parameters=t;this.advance()}text;parameters;place=0;depth=0;kind="";token="";start=0;whole(){let[e]=this.sum();return this.kind&&this.fail("expected an operator + - * / ^ or the end",this.kind==="sign"?this.remedy():"write 2*t for a product"),e}advance(){yo.lastIndex=this.place;let e=yo.exec(this.text)?.groups,t=Object.entries(e??{}).find(([,n])=>n!==void 0&&n.trim()!=="");[this.kind,this.token]=t??["",""],this.start=t?yo.lastIndex-this.token.length:this.text.trimEnd().length,t&&(this.place=yo.lastIndex)}fail(e,t=""){let n=this.kind?rn(this.token.slice(0,40)):"the end of the formula";throw new Error(`character ${this.start+1}: ${e}, found ${n}${t?`; ${t}`:""}`)}sign(e){return this.kind==="sign"&&this.token.length===1&&e.includes(this.token)}sum(){return this.chain("+-",()=>this.product())}product(){return this.chain("*/",()=>this.factor())}chain(e,t){let[n,r]=t();for(;this.sign(e);){let s=this.token;this.advance();let[a,o]=t();[n,r]=[R1(s,n,a),this.higher(r,o)]}return[n,r]}factor(){if(this.sign("-")){this.deeper(),this.advance();let[n,r]=this.factor();this.depth--;let s={is:"number",value:n.is==="number"?-n.value:-1};return[n.is==="number"?s:{is:"binary",sign:"*",left:s,right:n},this.higher(r)]}let[e,t]=this.atom();return this.token==="**"&&this.fail("expected an operator + - * / ^","write ^ for a power"),this.sign("^")&&(this.advance(),[e,t]=[{is:"power",base:e,exponent:this.exponent()},this.higher(t)],(this.sign("^")||this.token==="**")&&this.fail("expected one power only","set parentheses: (x^2)^3")),[e,t]}exponent(){(this.kind!=="number"||!/^\d+$/.test(this.token))&&this.fail(`expected a whole power from 0 to ${Oh}`,"write products, quotients or sqrt for others");let e=Number(this.token);return(this.token.length>4||e>Oh)&&this.fail(`expected a power of at most ${Oh}`,"lower it"),this.advance(),e}atom(){if(this.kind==="number"){let e=Number(this.token);return e>1e100&&this.fail("expected a number of at most 1e100"),this.advance(),[{is:"number",value:e},1]}return this.kind==="name"?this.named():this.sign("(")?this.bracket():this.fail("expected a number, a name or '('",this.remedy())}named(){let e=this.token;if(Uh.includes(e)){this.advance(),this.token!=="("&&this.fail(`expected '(' after ${e}`,`write ${e}(...)`);let[n,r]=this.bracket();return[{is:"call",name:e,argument:n},this.higher(r)]}let t=[...vo,"pi",...this.parameters];if(!t.includes(e)){let n=/^\s*\(/.test(this.text.slice(this.place)),r=n?Uh:t,s=xo(e,r),a=s?`did you mean ${rn(s)}?`:n?"":"list it under parameters";this.fail(`expected ${n?"a function":"a name"}, one of ${r.join(", ")}`,a)}return this.advance(),this.sign("(")&&this.fail("expected an operator + - * / ^","write t*(...) for a product"),[{is:"name",name:e},1]}bracket(){this.deeper(),this.advance();let e=this.sum();return this.token!==")"&&this.fail("expected ')'",this.remedy()),this.advance(),this.depth--,e}deeper(){++this.depth>Rp&&this.fail(`expected at most ${Rp} levels of nesting`,"simplify the formula")}higher(...e){let t=Math.max(...e)+1;return t>Pp&&this.fail(`expected at most ${Pp} terms or factors in a row`,"simplify the formula"),t}remedy(){return[".","[","{","_","'",'"',";",":","@","=","!","`"].includes(this.token)?"a formula holds numbers, names, + - * / ^ and parentheses only":this.token===","?"write one argument only":""}};function R1(i,e,t){let n=(a,o)=>JSON.stringify(a)===JSON.stringify(o),r=a=>a.is==="number"&&a.value===1,s=(a,o)=>({is:"call",name:a,argument:o});if(i==="-"&&r(e)){if(t.is==="name"&&Ip[t.name])return{is:"name",name:Ip[t.name]};if(t.is==="call"&&t.name==="cos")return s("versin",t.argument)}if(i==="-"&&t.is==="call"&&t.name==="sin"&&n(t.argument,e))return s("sinrest",e);if(i==="-"&&e.is==="call"){if(e.name==="cosh"&&r(t))return s("coshless",e.argument);if(e.name==="sinh"&&n(e.argument,t))return s("sinhrest",t)}return{is:"binary",sign:i,left:e,right:t}}function rn(i){let e=i.includes("'")&&!i.includes('"')?'"':"'";return e+i.replaceAll("\\","\\\\").replaceAll(`
`,"\\n").replaceAll(e,`\\${e}`)+e}function xo(i,e){return e.map(n=>[2*Bh(n,i)/(n.length+i.length),n]).filter(([n])=>n>=.6).sort(([n,r],[s,a])=>s-n||(r<a?1:-1))[0]?.[1]??""}function Bh(i,e){for(let t=Math.min(i.length,e.length);t>0;t--)for(let n=0;n+t<=i.length;n++){let r=e.indexOf(i.slice(n,n+t));if(r>=0)return t+Bh(i.slice(0,n),e.slice(0,r))+Bh(i.slice(n+t),e.slice(r+t))}return 0}function Dp(i,e,t){for(let n=0;n<t.length;n++){let r=0;for(let s=0;s<=n;s++)r+=i[s]*e[n-s];t[n]=r}}function zp(i,e,t){for(let n=0;n<t.length;n++){let r=i[n];for(let s=0;s<n;s++)r-=t[s]*e[n-s];t[n]=r/e[0]}}function Fp(i,e){e[0]=Math.sqrt(i[0]);for(let t=1;t<e.length;t++){let n=i[t];for(let r=1;r<t;r++)n-=e[r]*e[t-r];e[t]=n/(2*e[0])}}function _o(i,e,t,n,r){let s=0;for(let a=1;a<=r;a++)s+=a*i[a]*e[r-a];n[r]=t*s/r}function Op(i,e){e[0]=Math.exp(i[0]);for(let t=1;t<e.length;t++)_o(i,e,1,e,t)}var rs=new Float64Array(0),ia=new Float64Array(0),ra=new Float64Array(0);function Wi(i,e){rs.length!==i.length&&([rs,ia,ra]=[i.slice(),i.slice(),i.slice()]);let t=i[0],n=e?1:-1;rs[0]=e?Math.sinh(t):Math.sin(t),ia[0]=e?Math.cosh(t):Math.cos(t),ra[0]=2*(e?Math.sinh(.5*t):Math.sin(.5*t))**2;for(let r=1;r<i.length;r++)_o(i,ia,1,rs,r),_o(i,rs,1,ra,r),ia[r]=n*ra[r];return{sine:rs,cosine:ia,versine:ra}}function Vh(i,e,t){let n=i[0],r=e?n*n:-n*n,s=0;for(let l=10;l>1;l--)s=(1+s)*r/(2*l*(2*l+1));let a=e?Math.sinh(n)-n:n-Math.sin(n),{versine:o}=Wi(i,e);t[0]=Math.abs(n)<1.5?n**3*(1+s)/6:a;for(let l=1;l<t.length;l++)_o(i,o,1,t,l)}var Up={sin:(i,e)=>e.set(Wi(i,!1).sine),cos:(i,e)=>e.set(Wi(i,!1).cosine),versin:(i,e)=>e.set(Wi(i,!1).versine),sinrest:(i,e)=>Vh(i,!1,e),sinh:(i,e)=>e.set(Wi(i,!0).sine),cosh:(i,e)=>e.set(Wi(i,!0).cosine),coshless:(i,e)=>e.set(Wi(i,!0).versine),sinhrest:(i,e)=>Vh(i,!0,e),sqrt:Fp,exp:Op};function P1(i,e){let t=new Float64Array(1);return Up[i](Float64Array.of(e),t),t[0]}var Sr=class{constructor(e,t){this.values=t;this.roots=e.map(n=>this.placed(this.node(n)))}values;operations=[];places=new Map;found=new Map;roots;registers=[];at(e,t){this.registers[0]?.length!==t+1&&(this.registers=this.operations.map(()=>new Float64Array(t+1)));let{registers:n}=this;ta(e);let r=xr,s=_r;return this.operations.forEach(({name:a,x:o,y:l,value:c},h)=>{let d=n[h],u=n[o],p=n[l];switch(a){case"t":case"r":d.fill(0),d[0]=a==="t"?e:1-e,t&&(d[1]=a==="t"?1:-1);break;case"s":return So(r,s,d);case"c":return So(s,-r,d);case"a":return So(-r,-s,d,2*Math.sin(.25*Math.PI*(1-e))**2);case"b":return So(-s,r,d,2*Math.sin(.25*Math.PI*e)**2);case"number":d.fill(0),d[0]=c;break;case"add":for(let f=0;f<=t;f++)d[f]=u[f]+p[f];break;case"subtract":for(let f=0;f<=t;f++)d[f]=u[f]-p[f];break;case"multiply":return Dp(u,p,d);case"divide":return zp(u,p,d);case"scale":for(let f=0;f<=t;f++)d[f]=c*u[f];break;case"shift":d.set(u),d[0]+=c;break;default:return Up[a](u,d)}}),this.roots.map(a=>n[a])}put(e,t=0,n=0,r=0){let s=`${e} ${t} ${n} ${Object.is(r,-0)?"-0":r}`,a=this.places.get(s);return a!==void 0?{at:a}:(this.places.set(s,this.operations.length),{at:this.operations.push({name:e,x:t,y:n,value:r})-1})}placed(e){return("at"in e?e:this.put("number",0,0,e.number)).at}node(e){let t=this.found.get(e);if(t)return t;let n=this.made(e);return this.found.set(e,n),n}made(e){switch(e.is){case"number":return{number:e.value};case"name":return vo.includes(e.name)?this.put(e.name):{number:e.name==="pi"?Math.PI:this.values[e.name]};case"power":return this.power(this.node(e.base),e.exponent);case"binary":return this.binary(e.sign,this.node(e.left),this.node(e.right));case"call":{let t=this.node(e.argument);return"number"in t?{number:P1(e.name,t.number)}:this.put(e.name,t.at)}}}binary(e,t,n){if("number"in t&&"number"in n){let[r,s]=[t.number,n.number];return{number:e==="+"?r+s:e==="-"?r-s:e==="*"?r*s:r/s}}if("number"in n){let r=n.number,s=this.placed(t);return e==="*"||e==="/"?this.put("scale",s,0,e==="*"?r:1/r):this.put("shift",s,0,e==="+"?r:-r)}return e==="/"?this.put("divide",this.placed(t),n.at):"number"in t?e==="*"?this.put("scale",n.at,0,t.number):this.put("shift",e==="-"?this.placed(this.put("scale",n.at,0,-1)):n.at,0,t.number):this.put(e==="+"?"add":e==="-"?"subtract":"multiply",t.at,n.at)}power(e,t){if("number"in e)return{number:e.number**t};let n=null,r=e;for(let s=t;s;s>>=1)s&1&&(n=n?this.binary("*",n,r):r),s>1&&(r=this.binary("*",r,r));return n??{number:1}}};function So(i,e,t,n=i){let r=.5*Math.PI;for(let s=0,a=1;s<t.length;s++)t[s]=a*(s%4===0?i:s%4===1?e:s%4===2?-i:-e),a*=r/(s+1);t[0]=n}var kp=64,I1=7,Bp=.001,qp=1e-9,Vp=1e12,sa=64,oi=Array.from({length:sa+1},(i,e)=>.5-.5*Math.cos(Math.PI*e/sa));function Gp(i,e){let t=$p(e);i.forEach((r,s)=>{for(let[a,o,l]of Yp(r)){let c=N1(a,o,t,e);if(c)throw new Error(`functions[${s}]: ${l} ${c}; rewrite it, or narrow the range of the parameters`)}});let n=t.map(r=>Hh(i,e,r));i.forEach((r,s)=>n.forEach((a,o)=>a.forEach((l,c)=>{if(Math.abs(l[s])<=Vp)return;let h=ss(e,t[o],oi[c]);throw new Error(`functions[${s}]: expected values of size at most ${Vp.toExponential()}, found none such ${h}; rewrite it, or narrow the range`)})))}function Wp(i,e){let t=-1,n="";for(let r of $p(e))Hh(i,e,r).forEach((s,a)=>{let o=Math.abs(s.reduce((l,c)=>l+c,0)-1)/Math.max(1,...s.map(Math.abs));o>t&&([t,n]=[o,ss(e,r,oi[a])])});return{by:t,where:n}}function $p(i){let e=i.length,t=Array.from({length:e},(s,a)=>a),n=2**e<=kp?Array.from({length:2**e},(s,a)=>t.map(o=>a>>e-1-o&1)):Array.from({length:kp},(s,a)=>t.map(o=>a<2?a:Hp(a,o)<.5?0:1)),r=e?Array.from({length:I1},(s,a)=>t.map(o=>Hp(a+1,o))):[];return[...n,t.map(()=>.5),...r].map(s=>i.map(({low:a,high:o,open:l},c)=>{let h=a+Bp*(o-a)*Number(l[0]),d=o-Bp*(o-a)*Number(l[1]);return h+(d-h)*s[c]}))}var Hp=(i,e)=>((i+1)*.754877666+(e+1)*(i+3)*.569840291)%1,Xp=(i,e)=>Object.fromEntries(i.map(({name:t},n)=>[t,e[n]]));function Hh(i,e,t){let n=new Sr(i,Xp(e,t));return oi.map(r=>n.at(r,0).map(s=>s[0]))}function*Yp(i){for(let e of Lp(i))yield*Yp(e);i.is==="binary"&&i.sign==="/"&&(yield[i.right,!1,"divides by zero"]),i.is==="call"&&i.name==="sqrt"&&(yield[i.argument,!0,"takes the root of a number that is not positive"])}function N1(i,e,t,n){let r=t.map(u=>Hh([i],n,u).map(p=>p[0]));if(!r.every(u=>u.every(Number.isFinite)))return"";for(let[u,p]of r.entries()){let f=Math.max(...p.map(Math.abs)),b=p.findIndex(m=>Math.abs(m)<=qp*f||e&&m<0);if(b>=0)return ss(n,t[u],oi[b])}let s=r.map(u=>u.map(Math.sign)),a=[-1,1].every(u=>s.some(p=>p.includes(u)));for(let[u,p]of a?s.entries():[]){let f=p.findIndex((b,m)=>m+1<p.length&&p[m+1]!==b);if(f>=0)return ss(n,t[u],.5*(oi[f]+oi[f+1]),"near")}let o=u=>Math.min(...e?u:u.map(Math.abs)),l=r.map(o),c=l.indexOf(Math.min(...l)),h=r[c],d=h.findIndex(u=>(e?u:Math.abs(u))===l[c]);return a?ss(n,t[c],oi[d],"near"):L1(i,t[c],d,qp*Math.max(...h.map(Math.abs)),n)}function L1(i,e,t,n,r){let s=oi[Math.max(t-1,0)],a=oi[Math.min(t+1,sa)],o=new Sr([i],Xp(r,e));for(let l=0;l<4;l++){let c=oi.map((u,p)=>s+(a-s)*p/sa),h=c.map(u=>Math.abs(o.at(u,0)[0][0])),d=h.indexOf(Math.min(...h));if(h[d]<=n)return ss(r,e,c[d],"near");[s,a]=[c[Math.max(d-1,0)],c[Math.min(d+1,sa)]]}return""}function ss(i,e,t,n="at"){let r=s=>String(Number(s.toPrecision(4)));return[`${n} t = ${r(t)}`,...i.map(({name:s},a)=>`${s} = ${r(e[a])}`)].join(", ")}var Jp=64,Zp=24;function wo(i,e,t,n){if(!/^[A-Za-z_]\w*$/.test(i))throw new Error(`parameters: expected a name of letters, digits and _, found ${rn(i.slice(0,60))}`);if(i.length>30||Np.includes(i))throw new Error(`parameters: ${rn(i.slice(0,40))} is ${i.length>30?"longer than 30 letters":"taken by the grammar"}; choose another name`);if(!(e<t))throw new Error(`parameters.${i}: expected a range [low, high] with low < high, found [${Mo(e)}, ${Mo(t)}]`);return{name:i,low:e,high:t,start:n??(e<=0&&t>=0?0:.5*(e+t)),open:[!1,!1]}}var as=({low:i,high:e,open:t},n)=>(t[0]?n>i:n>=i)&&(t[1]?n<e:n<=e),os=({low:i,high:e,open:t})=>`${t[0]?"(":"["}${Mo(i)}, ${Mo(e)}${t[1]?")":"]"}`,Mo=i=>String(Number(i.toPrecision(6))),Mr=class{constructor(e,t,n,r=!1){this.name=e;this.functions=t;this.parameters=n;let s=n.map(o=>o.name),a=t.length;if(a<2||a>Jp)throw new Error(`functions: expected 2 to ${Jp} formulas, found ${a}`);if(s.length>Zp)throw new Error(`parameters: expected at most ${Zp}, found ${s.length}`);this.trees=t.map((o,l)=>{try{return qh(o,s)}catch(c){throw new Error(`functions[${l}]: ${c.message}`)}}),r||Gp(this.trees,n)}name;functions;parameters;trees;off=null;get size(){return this.functions.length}get offSum(){return this.off??=Wp(this.trees,this.parameters)}get partition(){return this.offSum.by<=1e-12}},dn=class{constructor(e,t){this.basis=e;this.size=e.size,this.tape=new Sr(e.trees,Object.fromEntries(e.parameters.map(({name:n},r)=>[n,t[r]])))}basis;size;tape;get partition(){return this.basis.partition}series(e,t){return this.tape.at(e,t)}derivatives(e,t,n){let r=this.size;for(let s=0;s<t;s++)this.series(e[s],2).forEach((a,o)=>{n[s*r+o]=a[0],n[(t+s)*r+o]=a[1],n[(2*t+s)*r+o]=2*a[2]})}slopes(e,t,n,r){let s=this.series(e,3),a=s.length-1,o=this.basis.partition;for(let l=0;l<3;l++)if(o)if(e<.5)for(let c=a-1,h=0;c>=0;c--)r[c][l]=h+=(l+1)*s[c+1][l+1];else for(let c=0,h=0;c<a;c++)r[c][l]=h-=(l+1)*s[c][l+1];else for(let c=0;c<=a;c++)r[c][l]=(l+1)*s[c][l+1]}};var Kp=64,Qp={},Ao={},qn=Qp;function D1(i){let e=new Map,{name:t,title:n,counts:r,sizes:s,formulas:a}=i,o=l=>s.includes(l)&&(l in a||t==="bernstein");return{name:t,title:n,counts:r,sizes:s,has:o,basis(l){let c=e.get(l);if(c)return c;if(!o(l))throw new Error(`points: a page from disk holds no formulas of the ${t} basis for ${l} points; open the model with: quintrig view MODEL`);let{functions:h,parameters:d}=a[l]??z1(l),u=new Mr(t,h,d.map(([p,f,b,m,g,v])=>({name:p,low:f,high:b,start:m,open:[g,v]})),!0);return e.set(l,u),u}}}var z1=i=>({functions:Array.from({length:i},(e,t)=>`${Fh(i-1,t)}*t^${t}*r^${i-1-t}`),parameters:[]});function Ar(i){for(let e of i){let t=Ao[e.name],n=t?{...t,formulas:{...t.formulas,...e.formulas}}:e;Ao[e.name]=n,Qp[e.name]=D1(n)}}Ar(Ue.library);var F1={...Ao},ef=()=>Object.values(Ao).filter(i=>i!==F1[i.name]),jp=new WeakMap;function Er(i){if(i===void 0)return{};if(typeof i=="string")throw new Error(`bases: a page from disk reads no file ${rn(i)}; put its tables into the model as [bases.NAME], or use: quintrig view MODEL`);if(!Wh(i))throw new Error(`bases: expected [bases.NAME] tables, found ${wr(i)}`);let e=jp.get(i);if(e)return e;let t=Object.keys(i).length;if(t>Kp)throw new Error(`bases: expected at most ${Kp} bases, found ${t}`);let n=Object.fromEntries(Object.entries(i).map(([r,s])=>{try{return[r,O1(k1(r,s))]}catch(a){throw new Error(`bases.${r.slice(0,60)}: ${a.message}`)}}));return jp.set(i,n),n}var O1=i=>{let{name:e,size:t}=i;return{name:e,title:e,counts:`${t} control points`,sizes:[t],has:n=>n===t,basis:()=>i}},Gh=Ue.basisKeys,U1=Ue.library.map(({name:i})=>i);function k1(i,e){if(U1.includes(i))throw new Error(`${rn(i)} is the name of a basis that quintrig brings; choose another name`);if(!/^[A-Za-z_]\w{0,59}$/.test(i))throw new Error(`expected a name of letters, digits and _, found ${rn(i.slice(0,60))}`);if(!Wh(e))throw new Error(`expected a table with functions = [...] and parameters = {...}, found ${wr(e)}`);let t=Object.keys(e).find(o=>!Gh.includes(o));if(t!==void 0){let o=xo(t,Gh);throw new Error(`unknown key ${rn(t)}${o?`; did you mean ${rn(o)}?`:""}; the keys are ${Gh.join(", ")}`)}let{functions:n,parameters:r={},source:s=""}=e;if(!Array.isArray(n))throw new Error(`functions: expected a list of formulas, such as ["1-t", "t"], found ${wr(n)}`);if(!Wh(r))throw new Error(`parameters: expected a table such as { lam = [-1, 1] }, found ${wr(r)}`);if(typeof s!="string"||s.length>400)throw new Error(`source: expected a text of at most 400 letters, found ${wr(s)}`);let a=Object.entries(r).map(([o,l])=>{let c=`parameters.${o.slice(0,40)}`;if(!Array.isArray(l)||l.length<2||l.length>3)throw new Error(`${c}: expected its range [low, high], such as [-1, 1], found ${wr(l)}`);let h=l.find(d=>typeof d!="number"||!Number.isFinite(d));if(h!==void 0)throw new Error(`parameters.${o}: expected a finite number, found ${wr(h)}`);return wo(o,...l)});return new Mr(i,n,a)}function Eo(i,e={}){let t={...qn,...e};if(Object.hasOwn(t,i))return t[i];let n=xo(i,Object.keys(t));throw new Error(`basis: expected one of ${Object.keys(t).join(", ")}, found ${rn(i)}${n?`; did you mean ${rn(n)}?`:""}`)}function $h(i,e,t,n=ai){return e===6&&(i===qn.trigonometric||i===qn.quintic)?new un(t[0],t[1],n):i===qn.bernstein?new si(e-1):new dn(i.basis(e),t)}var Wh=i=>typeof i=="object"&&i!==null&&!Array.isArray(i),wr=i=>(i===void 0?"none":typeof i=="string"?rn(i):JSON.stringify(i)??String(i)).slice(0,60);var Ze=class extends Error{},Tr=Ue.shapeRange,tf={...Ue.kinds},nf={...Ue.starters},st=tf,Xh=nf;function Cr(i){Ar(i.library??[]);for(let[e,t]of Object.entries(i.kinds??{}))tf[e]??=t;for(let[e,t]of Object.entries(i.starters??{}))nf[e]??=t}function Pe(i,e){return i[e]??st[i.kind]?.fields[e]?.default}function Vn(i){let e=Pe(i,"basis");if(e===void 0)return[];let t=Er(Pe(i,"bases")),n=l=>Pe(i,l)??[],r=B1(i),s=n(r[0]),a=(s[0]??[]).length,o=i.kind==="symmetric"?[["points",Yh(Eo([e].flat()[0],t),s.length)],["points[0]",a]]:i.kind==="curve"?[["points",s.length+ +(Pe(i,"close")===!0)]]:i.kind==="developable"?[["planes",s.length]]:st[i.kind].fields[r[0]].counts.length===2?[[r[0],s.length],[`${r[0]}[0]`,a]]:[[r[0],s.length],[r.at(-1),n(r.at(-1)).length]];if(Array.isArray(e)&&e.length!==o.length)throw new Error(`basis: expected one basis, or ${o.length}, found ${e.length}`);return o.map(([l,c],h)=>{let d=Eo(Array.isArray(e)?e[h]:e,t);if(!d.sizes.includes(c)){let u=i.kind==="curve"&&Pe(i,"close")===!0?"; close = true adds the first once more, as the last":"";throw new Error(`${l}: expected ${l==="planes"?d.counts.replace("points","planes"):d.counts} for the ${d.name} basis, found ${c}${u}`)}return{entry:d,points:c,place:l}})}var B1=i=>Object.entries(st[i.kind].fields).flatMap(([e,t])=>t.type==="points"?[e]:[]);function Yh(i,e){let t=[2*e,2*e-1].find(r=>i.sizes.includes(r));if(t!==void 0)return t;let n=[...new Set(i.sizes.map(r=>r+1>>1))].sort((r,s)=>r-s);throw new Error(`points: expected ${n.length<4?n.join(" or "):`${n[0]} to ${n.at(-1)}`} rows, half of the net, found ${e}`)}var Rr=i=>sf(i,"trigonometric","quintic"),$i=i=>sf(i,"bernstein");function sf(i,...e){let t=Pe(i,"basis");return t!==void 0&&[t].flat().every(n=>e.includes(n))}var rf=new WeakMap;function wi(i){let e=rf.get(i);if(!e){try{e=Pe(i,"basis")===void 0?q1(i):af(Vn(i))}catch{e=[]}rf.set(i,e)}return e}var q1=i=>(st[i.kind]?.fields.shape?st[i.kind].shapeNames:[]).map(e=>({name:e,label:e,low:Tr[0],high:Tr[1],start:0,open:[!1,!1],of:0}));function af(i){let e=(t,n)=>i.length<2?t:/\d$/.test(t)?`${t}_${n+1}`:`${t}${n+1}`;return i.flatMap(({entry:t,points:n},r)=>t.basis(n).parameters.map(s=>({...s,label:e(s.name,r),of:r})))}function pn(i){if(!st[i.kind]?.fields.shape)return[];let e=i.shape??[];return e.length?e:$i(i)||!st[i.kind].fields.basis?Pe(i,"shape")??[]:wi(i).map(t=>t.start)}function Jh(i,e){let t=af(e),n=i.shape??[];if(n.length===0)return e.map(({entry:r,points:s})=>r.basis(s).parameters.map(a=>a.start));if(e.every(r=>r.entry===qn.bernstein)){if(n.length!==2*e.length)throw new Error(`shape: expected none or ${2*e.length} numbers, which do not act in the bernstein basis, found ${n.length}`);return e.map(()=>[])}if(n.length!==t.length){let r=t.length?` (${t.map(s=>s.label).join(", ")})`:", as the basis has no shape parameters";throw new Error(`shape: expected ${t.length} numbers${r}, found ${n.length}`)}if(i.unchecked_shape!==!0){let r=n.findIndex((s,a)=>!as(t[a],s));if(r>=0)throw new Error(`shape[${r}] (${t[r].label}) = ${n[r]} is outside ${os(t[r])}, the range of this basis; choose a value in the range, or set unchecked_shape = true and lose what the range warrants, such as the convex-hull property`)}return e.map((r,s)=>n.filter((a,o)=>t[o].of===s))}function V1(i,e){if(i.unchecked_basis!==!0)for(let t of e.map(({entry:n,points:r})=>n.basis(r))){if(t.partition)continue;let{by:n,where:r}=t.offSum;throw new Error(`basis: the functions of '${t.name}' do not sum to 1 (off by ${Number(n.toPrecision(3))} ${r}); correct the formulas, or set unchecked_basis = true and have a surface that moves with the origin`)}}var of=i=>i.map(({entry:e,points:t})=>e.basis(t)).filter(e=>!e.partition);function To(i){let e=Vn(i),t=Jh(i,e);return V1(i,e),e.map(({entry:n,points:r},s)=>{let a=t[s],o=n===qn.trigonometric||n===qn.quintic,l=()=>new dn(n.basis(r),a);return{partition:n.basis(r).partition,formulas:l,dual:()=>o?new un(a[0],a[1]):l(),functions:(c=ai)=>$h(n,r,a,c),still:c=>o?Tp(a[0],a[1],c):ai}})}function Rn(i,e=3){let t=new Array(e).fill(1/0),n=new Array(e).fill(-1/0);for(let o of i)if(o.every(Number.isFinite))for(let l=0;l<e;l++)t[l]=Math.min(t[l],o[l]),n[l]=Math.max(n[l],o[l]);let r=Math.max(...t.map((o,l)=>n[l]-o));if(!Number.isFinite(r))return t.map(()=>0);let s=t.map((o,l)=>.5*o+.5*n[l]),a=2**(Math.floor(Math.log2(r))+3);return r>0&&a>0&&Number.isFinite(a)?s.map(o=>Math.round(o/a)*a+0):s}var Hn=(i,e)=>i.map((t,n)=>t-e[n]);function ls(i,e){if(e.every(r=>r===0))return[...i];let t=i[3],n=0;for(let r=0;r<3;r++){let s=i[r]*e[r],[a,o]=lf(i[r]),[l,c]=lf(e[r]),h=o*c-(s-a*l-o*l-a*c),d=t+s,u=d-t;n+=t-(d-u)+(s-u)+h,t=d}return[i[0],i[1],i[2],t+n]}function lf(i){let e=134217729*i,t=e-(e-i);return[t,i-t]}var sn=class{constructor(e,t){this.points=e;this.functions=t;this.size=e.m,this.dimension=e.dimension}points;functions;size;dimension;scratch=new Float64Array(0);derivatives(e,t,n){let r=this.functions.size,s=this.size*this.dimension,a=this.points.values;this.scratch.length<3*t*r&&(this.scratch=new Float64Array(3*t*r));let o=this.scratch;this.functions.derivatives(e,t,o);for(let l=0;l<3*t;l++)for(let c=0;c<s;c++){let h=0;for(let d=0;d<r;d++)h+=o[l*r+d]*a[d*s+c];n[l*s+c]=h}}},cs=i=>i.flip?"against":"along",{stepsForSize:Pn,farOff:H1,samePoint:G1}=Ue.limits,cf=Float64Array.from({length:Pn},(i,e)=>e/(Pn-1)),li=new Float64Array(3*Pn*Pn),aa=new Float64Array(Pn*Pn);function hs(i){let{rows:e,blend:t,origin:n=[0,0,0]}=i,r=e.size,s=e.dimension,a=new Float64Array(3*Pn*r*s),o=new Float64Array(3*Pn*r);e.derivatives(cf,Pn,a),t.derivatives(cf,Pn,o);let l=0,c=[0,0,0,1];for(let v=0;v<Pn;v++)for(let M=0;M<Pn;M++){for(let E=0;E<s;E++){c[E]=0;for(let w=0;w<r;w++)c[E]+=a[(v*r+w)*s+E]*o[M*r+w]}let x=s===4?c[3]:1;for(let E=0;E<3;E++)li[3*l+E]=c[E]/x;Number.isFinite(li[3*l]+li[3*l+1]+li[3*l+2])&&l++}let h=[1/0,1/0,1/0],d=[-1/0,-1/0,-1/0],[u,p,f]=[0,1,2].map(v=>{for(let M=0;M<l;M++)aa[M]=li[3*M+v];return hf(aa.subarray(0,l))});for(let v=0;v<l;v++)aa[v]=Math.max(Math.abs(li[3*v]-u),Math.abs(li[3*v+1]-p),Math.abs(li[3*v+2]-f));let b=H1*hf(aa.slice(0,l))||1/0;for(let v=0;v<l;v++)if(!(aa[v]>b))for(let M=0;M<3;M++)h[M]=Math.min(h[M],li[3*v+M]),d[M]=Math.max(d[M],li[3*v+M]);let m=l?Math.sqrt(h.reduce((v,M,x)=>v+(d[x]-M)**2,0)):0;for(let v=0;v<3;v++)h[v]+=n[v],d[v]+=n[v];let g=Math.max(...h.map(Math.abs),...d.map(Math.abs));return{low:h,high:d,size:m>G1*g?m:0}}function hf(i){i.sort();let e=i.length>>1;return i.length%2?i[e]:.5*(i[e-1]+i[e])}function Gt(i){let e=i.length,t=i[0].length,n=i[0][0].length,r=new Float64Array(e*t*n);return i.forEach((s,a)=>s.forEach((o,l)=>r.set(o,(a*t+l)*n))),{values:r,n:e,m:t,dimension:n}}function Zh(i,e,t){let n=Rn(i.flat());return Kh(i.map(r=>r.map(s=>Hn(s,n))),n,e,t,Gt(i))}function Kh(i,e,t,n,r){let s=()=>i.map(c=>c.map(h=>h.map((d,u)=>d+e[u])));r??=Gt(s()),t.every(c=>c.partition)||([i,e]=[s(),[0,0,0]]);let a=i[0].map((c,h)=>i.map(d=>d[h])),o=t[0].functions(t[0].still(i)),l=t[1].functions(t[1].still(a));return{rows:new sn(Gt(i),o),blend:l,flip:n,net:r,origin:e}}function uf(i,e,t,n,r){let s=Rn(i.flat()),a=ls(e,s),o=i.map(c=>c.map(h=>Hn(h,s))),l=o.map(c=>c.map(h=>us(h,a))).reverse();if(t){let c=Math.max(...l[0].flatMap((h,d)=>h.map((u,p)=>Math.abs(u-o.at(-1)[d][p]))));if(c>1e-9*Math.max(...o.flat(2).map(Math.abs)))throw new Error(`points[${i.length-1}]: expected points on the mirror plane, as this basis has a middle row, found them ${Number((.5*c).toPrecision(3))} away`);l.shift()}return Kh([...o,...l],s,n,r)}function df(i,e,t,n){let[r,s]=[Rn(i),Rn(e)],a=i.map(h=>Hn(h,r)),o=e.map(h=>Hn(h,s)),l=(h,d)=>h.map(u=>d.map(p=>u.map((f,b)=>f+p[b]))),c=r.map((h,d)=>h+s[d]);return Kh(l(a,o),c,t,n,Gt(l(i,e)))}function pf(i,e,t,n,r){return Zh(i.map(([s,a])=>e.map(([o,l])=>[t*s*o,t*s*l,a])),n,r)}function ff(i,e,t,n){let r=[0,0,0],[s,a]=t,o=s.partition&&a.partition?Rn([...i,...e]):r,l=Gt([...i.map(f=>[Hn(f,o),r]),...e.map(f=>[r,Hn(f,o)])]),c=s.still(i.map(f=>[f])),h=a.still(e.map(f=>[f])),d=[c[0]&&h[0],c[1]&&h[1]],u=new Bn([s.functions(d),a.functions(d)]),p=i.length===e.length?Gt(i.map((f,b)=>[f,e[b]])):null;return{rows:new sn(l,u),blend:new si(1),flip:n,net:p,origin:o}}function us(i,e){let[t,n,r,s]=e,a=(i[0]*t+i[1]*n+i[2]*r+s)/(t*t+n*n+r*r);return[i[0]-2*a*t,i[1]-2*a*n,i[2]-2*a*r]}var{noise:mf,rounding:W1}=Ue.limits;function gf(i,e,t,n,r){let s=$1(new ds(i,e,t,n)),a=l=>ls(l,s),o=new ds(i.map(a),e.map(a),t,n);if(!o.meets())throw new Error("planes: the control planes envelop no strip that the bounding planes cut (they are equal, parallel, or all contain one line that a bounding plane contains too); change the planes or the bounds");return{rows:o,blend:new si(1),flip:r,net:null,origin:s}}function $1(i){let t=Float64Array.from({length:17},(l,c)=>c/16),n=new Float64Array(306);i.derivatives(t,17,n);let s=Array.from({length:34},(l,c)=>Array.from(n.subarray(3*c,3*c+3))).filter(l=>l.every(Number.isFinite)),a=[0,1,2].map(l=>s.map(c=>c[l]).sort((c,h)=>c-h)),o=l=>a.map(c=>c[Math.floor(l*(c.length-1))]);return s.length?Rn([o(.25),o(.75)]):[0,0,0]}var ds=class{constructor(e,t,n,r=!0){this.planes=e;this.bounds=t;this.functions=n;this.edges=r?e.slice(1).map((a,o)=>a.map((l,c)=>l-e[o][c])):e.map(a=>[...a]);let s=(a,o)=>n instanceof un&&(n[a]===-4||o.every(l=>l===0));this.start=s("alpha",this.edges[0]),this.end=s("zeta",this.edges.at(-1)),this.hodograph=_i(this.edges.length)}planes;bounds;functions;size=2;dimension=3;edges;start;end;scratch=new Float64Array(0);hodograph;derivatives(e,t,n){let r=3*this.functions.size*t;this.scratch.length<r&&(this.scratch=new Float64Array(r)),this.functions.derivatives(e,t,this.scratch);for(let s=0;s<t;s++){let{plane:a,slope:o}=this.dual(e[s],t,s);this.bounds.forEach((l,c)=>{X1(a,o,l).forEach((h,d)=>{for(let u=0;u<3;u++)n[((d*t+s)*2+c)*3+u]=(d===2?2:1)*h[u]})})}}meets(){let t=Float64Array.from({length:33},(s,a)=>a/32);this.scratch=new Float64Array(3*this.functions.size*33),this.functions.derivatives(t,33,this.scratch);let n=this.bounds.map(()=>0),r=[0,0];for(let s=0;s<33;s++){let{plane:a,slope:o}=this.dual(t[s],33,s),[l,c]=[a[0].slice(0,3),o[0].slice(0,3)];Number.isNaN(c[0])||(r[0]=Math.max(r[0],Math.hypot(...l)),r[1]=Math.max(r[1],Math.hypot(...c)),this.bounds.forEach((h,d)=>n[d]=Math.max(n[d],Math.abs(In(oa(l,c),h)))))}return n.every((s,a)=>s>mf*r[0]*r[1]*Math.hypot(...this.bounds[a].slice(0,3)))}dual(e,t,n){this.functions.slopes(e,this.start,this.end,this.hodograph);let r=[0,1,2],s=[0,1,2,3],{size:a}=this.functions,o=r.map(h=>s.map(d=>{let u=0;for(let p=0;p<a;p++)u+=this.scratch[a*(h*t+n)+p]*this.planes[p][d];return h===2?u/2:u})),l=r.map(h=>s.map(d=>this.hodograph.reduce((u,p,f)=>u+p[h]*this.edges[f][d],0))),c=s.map(h=>this.hodograph.reduce((d,u,p)=>d+Math.abs(u[0]*this.edges[p][h]),0));return s.every(h=>Math.abs(l[0][h])<=W1*c[h])&&l[0].fill(NaN),{plane:o,slope:l}}};function X1(i,e,t){let n=i.map(m=>oa(t,m)),[r,s,a]=e,o=i[0],l=In(r,n[0]),c=In(r,n[1])+In(s,n[0]),h=oa(r,t),d=oa(o,r),u=[0,1,2].map(m=>-(o[3]*h[m]+r[3]*n[0][m]+t[3]*d[m])/l),p=(-s[3]-In(s,u))/l,f=n[0].map(m=>p*m),b=(-2*a[3]-In(s,f)-2*In(a,u)-p*c)/l;return[u,f,n[0].map((m,g)=>.5*(p*n[1][g]+b*m))]}function Co(i,e=257){let t=Float64Array.from({length:e},(h,d)=>d/(e-1)),n=new Float64Array(3*e*6);i.rows.derivatives(t,e,n);let r=Array.from(t,(h,d)=>Y1(n,e,d)),s=r.map(([h,d])=>Math.max(Math.abs(h),Math.abs(d))),a=s.filter(h=>!Number.isNaN(h)).sort((h,d)=>h-d),o=mf*(a[a.length>>1]??0),l=[],c=!1;return r.forEach(([h,d],u)=>{let p=h*d<=0&&s[u]>o;p&&!c&&l.push({u:[],v:[]}),p&&(l.at(-1).u.push(t[u]),l.at(-1).v.push(h/(h-d))),c=p}),l}function Y1(i,e,t){let n=(c,h,d)=>i[((c*e+t)*2+h)*3+d],r=[0,1,2].map(c=>n(0,1,c)-n(0,0,c)),[s,a]=[0,1].map(c=>oa([n(1,c,0),n(1,c,1),n(1,c,2)],r)),o=In(s,s)>In(a,a)?s:a,l=Math.sqrt(In(o,o))||1;return[In(s,o)/l,In(a,o)/l]}var In=(i,e)=>i[0]*e[0]+i[1]*e[1]+i[2]*e[2],oa=(i,e)=>[i[1]*e[2]-i[2]*e[1],i[2]*e[0]-i[0]*e[2],i[0]*e[1]-i[1]*e[0]];var Pr=class{constructor(e,t){this.degree=t;this.size=e.length-t-1;let n=e[t],r=e[this.size];if(!(r>n))throw new Error(`knots: expected them to rise from ${n} over the domain, found them to end at ${r}`);this.knots=e.map(s=>s===r?1:(s-n)/(r-n))}degree;size;knots;derivatives(e,t,n){let{knots:r,degree:s,size:a}=this,o=Array.from({length:s+1},()=>new Float64Array(r.length-1));for(let l=0;l<t;l++){let c=s;for(;c<a-1&&r[c+1]<=e[l];)c++;o[0].fill(0),o[0][c]=1;for(let h=1;h<=s;h++){let d=o[h-1],u=p=>(e[l]-r[p])*bf(r[p+h]-r[p])*d[p];for(let p=0;p<r.length-1-h;p++)o[h][p]=u(p)+d[p+1]-u(p+1)}for(let h=0;h<3;h++){let d=h<=s?o[s-h]:new Float64Array(r.length-1);for(let u=s-h+1;h<=s&&u<=s;u++){let p=d,f=b=>u*bf(r[b+u]-r[b])*p[b];d=Float64Array.from({length:r.length-1-u},(b,m)=>f(m)-f(m+1))}for(let u=0;u<a;u++)n[(h*t+l)*a+u]=d[u]}}}},bf=i=>i>0?1/i:0;function yf(i,e,t,n,r,s=[]){let a=Gt(i),o=new Pr(n[0],t[0]),l=new Pr(n[1],t[1]);if(o.size!==a.n||l.size!==a.m)throw new Error(`knots: expected ${a.n+t[0]+1} and ${a.m+t[1]+1}, found ${n[0].length} and ${n[1].length}`);let c=Rn(i.flat()),h=i.map(p=>p.map(f=>Hn(f,c))),d=e?.[0]?.[0];if(!e||e.every(p=>p.every(f=>f===d)))return{rows:new sn(Gt(h),o),blend:l,flip:r,net:a,origin:c,trim:s};let u=h.map((p,f)=>p.map((b,m)=>[...b.map(g=>g*e[f][m]),e[f][m]]));return{rows:new sn(Gt(u),o),blend:l,flip:r,net:a,origin:c,trim:s}}var vf=new hn(0,1,0),xf=(i,e)=>jh(i,i,i,e);function jh(i,e,t,n){return la(new Si(-1,1),[[i,e,0],[0,0,t]],!n)}function _f(i,e,t){return la(new hn(0,1,1),[[i,i,0],[0,0,e]],!t)}function Sf(i,e,t){return la(new hn(0,1,1),[[i,i,0],[-i,-i,e]],!t)}function Mf(i,e,t){return la(new Bn([new Si(0,4),vf]),[[e,e,0],[0,0,e],[i,i,0]],!t)}function wf(i,e,t){let n=.5*e/i,r=new Bn([new ns(-n,n),new hn(-n,n,1)]);return la(r,[[i,i,0],[0,0,0],[0,0,0],[0,0,i]],!t)}function Af(i,e,t){let n=Gt([[[0,0,0],[0,0,0],[0,0,0],[0,0,e/(2*Math.PI)]],[[1,0,0],[0,1,0],[0,0,0],[0,0,0]]]),r=new Bn([new Si(0,4),new hn(0,2*Math.PI,1)]);return{rows:new sn(n,new hn(-i,i,1)),blend:r,flip:t,net:null}}var Ef=(i,e)=>Qh(i,[[1,0,1,0,0],[0,1,0,1,0],[1,1,0,0,1]],e),Tf=(i,e)=>Qh(i,[[1,0,1,0,0],[0,1,0,1,0],[3,0,0,0,1],[1,2,0,0,-3]],e);function Cf(i,e){let t=.3333333333333333,n=[[1,0,1,0,0],[3,0,-t,0,0],[1,2,1,0,0],[0,1,0,1,0],[0,3,0,-t,0],[2,1,0,1,0],[2,0,0,0,1],[0,2,0,0,-1]];return Qh(i,n,e)}function la(i,e,t){let n=Gt(e.map(([r,s,a])=>[[r,0,0],[0,s,0],[0,0,a]]));return{rows:new sn(n,i),blend:new Bn([new Si(0,4),vf]),flip:t,net:null}}function Qh(i,e,t){let n=Math.max(...e.map(a=>a[0]))+1,r=Math.max(...e.map(a=>a[1]))+1,s={values:new Float64Array(n*r*3),n,m:r,dimension:3};for(let[a,o,...l]of e)s.values.set(l,(a*r+o)*3);return{rows:new sn(s,new hn(-i,i,n-1)),blend:new hn(-i,i,r-1),flip:t,net:null}}var eu=class{constructor(e){this.patch=e;this.flip=this.get("flip")}patch;flip;get bases(){return To(this.patch)}get odd(){return Yh(Vn(this.patch)[0].entry,this.net("points").length)%2===1}get(e){return Pe(this.patch,e)}size(e){return this.get(e)}curve(e){return this.get(e)}net(e){return this.get(e)}strip(){let[e]=this.bases;return gf(this.curve("planes"),this.curve("bounds"),e.dual(),e.partition,this.flip)}},tu={tensor:i=>Zh(i.net("points"),i.bases,i.flip),symmetric:i=>uf(i.net("points"),i.get("mirror"),i.odd,i.bases,i.flip),swept:i=>df(i.curve("section"),i.curve("trajectory"),i.bases,i.flip),swung:i=>pf(i.curve("profile"),i.curve("trajectory"),i.size("scale"),i.bases,i.flip),ruled:i=>ff(i.curve("first"),i.curve("second"),i.bases,i.flip),developable:i=>i.strip(),nurbs:i=>yf(i.net("points"),i.get("weights"),i.get("degrees"),i.curve("knots"),i.flip,i.net("trim")),sphere:i=>xf(i.size("radius"),i.flip),ellipsoid:i=>jh(i.size("a"),i.size("b"),i.size("c"),i.flip),cylinder:i=>_f(i.size("radius"),i.size("height"),i.flip),cone:i=>Sf(i.size("radius"),i.size("height"),i.flip),torus:i=>Mf(i.size("major"),i.size("minor"),i.flip),catenoid:i=>wf(i.size("waist"),i.size("height"),i.flip),helicoid:i=>Af(i.size("radius"),i.size("pitch"),i.flip),hyperbolic_paraboloid:i=>Ef(i.size("size"),i.flip),monkey_saddle:i=>Tf(i.size("size"),i.flip),enneper:i=>Cf(i.size("size"),i.flip)},Ir=i=>i.kind==="curve"||Object.hasOwn(tu,i.kind),Rf=i=>tu[i.kind](new eu(i));var Ro=class{constructor(e,t){this.breaks=e;this.series=t;this.size=t[0][0][0].length}breaks;series;size;derivatives(e,t,n){let{breaks:r,series:s,size:a}=this;for(let o=0;o<t;o++){let l=0;for(;l<s.length-1&&r[l+1]<=e[o];)l++;let c=r[l],h=r[l+1],d=(e[o]-c-(h-e[o]))/(h-c);s[l].forEach((u,p)=>{for(let f=0;f<a;f++){let b=0,m=0;for(let g=u.length-1;g>0;g--)[b,m]=[2*d*b-m+u[g][f],b];n[(p*t+o)*a+f]=d*b-m+u[0][f]}})}}};var Pf={trigonometric:(i,e)=>new un(i("alpha"),i("zeta"),e),bernstein:i=>new si(i("degree")),bspline:i=>new Pr(i("knots"),i("degree")),circular:i=>new Si(i("start"),i("end")),hyperbolic:i=>new ns(i("start"),i("end")),powers:i=>new hn(i("start"),i("end"),i("degree")),joined:i=>new Bn(i("parts").map(ca)),formulas:i=>new dn(new Mr("",i("functions"),i("names").map(e=>wo(e,-1,1)),!0),i("values")),chebyshev:i=>new Ro(i("breaks"),i("series"))};function ca(i){let e=Pf[i.family];if(!e)throw new Error(`functions: the page does not know ${i.family} functions`);return e(t=>i[t],i.still??ai)}var ha=class extends Ze{},Z1=512,K1=8,Xi=new Map,If=new Map,Po=new Map,Yi=[],nu=!1;function Io(i,e){let t={ask:i,arrived:e};return Yi.push(t),()=>{Yi.splice(Yi.indexOf(t),1)}}function ua(i){for(let{keys:e,surface:t,error:n}of i)iu(su(e),t?Q1(t):new Ze(n??"there is no surface"))}function Nf(i){let e=su(i),t=Xi.get(e),n=`${i.kind} ${i.name}`;if(t instanceof Ze)throw t;if(t)return If.set(n,t),t;if(!Yi.length)throw new Ze(`patch "${i.name}": ${Lf(i)}`);Po.set(e,i),j1();let r=If.get(n);if(!r)throw new ha(`patch "${i.name}": is being built by Python`);return r}var ru=i=>Yi.length||Xi.has(su(i))?"":`patch "${i.name}": ${Lf(i)}`,Lf=({kind:i})=>`a ${i} is built by Python, which a page from disk lacks; change it with: quintrig view MODEL`;async function j1(){if(!nu){for(nu=!0,await Promise.resolve();Po.size&&Yi.length;){let i=[...Po].slice(-K1);Po.clear();try{ua(await Yi.at(-1).ask(i.map(([,e])=>e)))}catch(e){for(let[t]of i)iu(t,new Ze(e.message))}for(let[e]of i)Xi.has(e)||iu(e,new Ze("Python did not build this patch"));for(let{arrived:e}of Yi)e()}nu=!1}}function iu(i,e){Xi.delete(i),Xi.set(i,e),Xi.size>Z1&&Xi.delete(Xi.keys().next().value)}function su(i){let e=Object.keys(st[i.kind]?.fields??{}).sort();return JSON.stringify([i.kind,...e.map(t=>Pe(i,t)??null)])}function Q1({origin:i,flip:e,net:t,blend:n,...r}){return{rows:eb(r,i),blend:ca(n),flip:e,net:t&&Gt(t),origin:i}}function eb({points:i,planes:e,bounds:t,functions:n,dimension:r},s){let a=ca(n);if(i)return new sn(Gt(i),a);if(e&&t&&(a instanceof un||a instanceof dn)){let o=c=>ls(c,s),l=a instanceof dn?a:new un(a.alpha,a.zeta,ai);return new ds(e.map(o),t.map(o),l,!(a instanceof dn)||a.partition)}return{size:a.size/r,dimension:r,derivatives:(o,l,c)=>a.derivatives(o,l,c)}}var tb=1e-13,nb=1e-10,No=400,nt=i=>i.kind==="curve",au=class{constructor(e,t,n=!1){this.points=e;this.functions=t;this.backwards=n;this.flat=e[0].length===2;let r=e.map(s=>[s[0],s[1],s[2]??0]);this.origin=t.partition?Rn(r):[0,0,0],this.local=r.map(s=>Hn(s,this.origin)),this.polygon=this.local.slice(1).reduce((s,a,o)=>s+Math.hypot(...a.map((l,c)=>l-this.local[o][c])),0)}points;functions;backwards;flat;polygon;origin;local;derivatives(e){let t=this.functions.series(this.backwards?1-e:e,3),n=this.backwards?-1:1,r=(s,a)=>[0,1,2].map(o=>a*this.local.reduce((l,c,h)=>l+t[h][s]*c[o],0));return[r(0,1).map((s,a)=>s+this.origin[a]),r(1,n),r(2,2),r(3,6*n)]}at(e){let[t,n,r,s]=this.derivatives(e),a=Math.hypot(...n),o=!(a>tb*this.polygon),l=rb(n,r),c=Math.hypot(...l),h=this.flat&&l[2]<0?-1:1,d=1e-13*a*Math.max(Math.hypot(...r),this.polygon),u=zf(n,r)/a**4;return{t:e,point:t,speed:a,curvature:o?NaN:h*c/a**3,torsion:o||c<=d?NaN:zf(l,s)/c**2,bend:r.map((p,f)=>o?NaN:p/a**2-n[f]*u)}}sample(e){return Array.from({length:e},(t,n)=>this.at(n/(e-1)))}get length(){let e=.5/Math.sqrt(3),t=Array.from({length:No},(r,s)=>s),n=r=>Math.hypot(...this.derivatives(r)[1]);return t.reduce((r,s)=>r+n((s+.5-e)/No)+n((s+.5+e)/No),0)/(2*No)}bends=e=>Math.abs(e)*this.polygon>nb},Df=new WeakMap;function St(i){let e=Df.get(i);if(!e){try{e=ib(i)}catch(t){e=new Ze(`patch "${i.name}": ${t.message}`)}Df.set(i,e)}if(e instanceof Ze)throw e;return e}function ib(i){let e=Pe(i,"points");if(e.some(r=>r.length!==e[0].length))throw new Error("points: expected points all [x, y] or all [x, y, z]");let[t]=To(i),n=Pe(i,"flip")===!0;if(n&&!Rr(i)&&!$i(i))throw new Error("flip: expected the quintic or the Bernstein basis, whose ends can be exchanged");return new au(Pe(i,"close")===!0?[...e,e[0]]:e,t.formulas(),n)}var zf=(i,e)=>i[0]*e[0]+i[1]*e[1]+i[2]*e[2],rb=(i,e)=>[i[1]*e[2]-i[2]*e[1],i[2]*e[0]-i[0]*e[2],i[0]*e[1]-i[1]*e[0]];var Lo=Ue.units,{largest:kf,largestPolygon:Ff}=Ue.limits;function vt(i){if(!Uf(i))throw new Ze(`model: expected keys and values, got ${an(i)}`);let{schema:e=Ue.schema,name:t="",unit:n="",patch:r,join:s,built:a,library:o,...l}=i;if(a&&ua(a),o&&Ar(o),e!==Ue.schema)throw new Ze(`schema: expected ${Ue.schema}, got ${an(e)}; this quintrig reads version 1`);if(n!==""&&!Lo.includes(n))throw new Ze(`unit: expected one of ${Lo.join(", ")}, got ${an(n)}; leave it out for plain numbers`);if(typeof t!="string"||t.length>200)throw new Ze(`name: expected a short text, got ${an(t)}`);if(r===void 0){let f=Of({...l,name:t||String(l.kind??"surface")});return{name:t||f.name,unit:n,patches:[f]}}if(!Array.isArray(r)||!r.length)throw new Ze(`patch: expected one or more [[patch]] tables, got ${an(r)}`);let{bases:c,...h}=l,d=Object.keys(h)[0];if(d)throw new Ze(`unknown key '${d}' beside [[patch]] tables; move it into a patch`);c!==void 0&&Bf(()=>Er(c));let u=r.map((f,b)=>{if(!Uf(f))throw new Ze(`patch ${b+1}: expected a table of keys, got ${an(f)}`);let m=c!==void 0&&st[String(f.kind)]?.fields.bases?{bases:c}:{};return Of({...m,...f,name:f.name??`patch ${b+1}`})}),p=u.filter(nt);if(new Set(p.map(f=>St(f).flat)).size>1)throw new Ze("points: expected curves all in the plane or all in space, found both in one model");if(s!==void 0&&!Array.isArray(s))throw new Ze(`join: expected one or more [[join]] tables, got ${an(s)}`);return{name:t||u[0].name,unit:n,patches:u,...s?{join:s}:{}}}function on(i){let e={schema:Ue.schema,name:i.name};if(i.unit&&(e.unit=i.unit),i.patches.length===1){let{name:s,...a}=i.patches[0];return{...e,...a}}let t=[...new Set(i.patches.filter(s=>s.bases).map(s=>JSON.stringify(s.bases)))],n=t.length===1?{bases:JSON.parse(t[0])}:{},r=t.length===1?i.patches.map(({bases:s,...a})=>a):i.patches;return{...e,...n,patch:r,...i.join?{join:i.join}:{}}}function Nn(i){if(!Ir(i))return Nf(i);try{return Rf(i)}catch(e){throw new Ze(`patch "${i.name}": ${e.message}`)}}function Of(i){let e=`patch "${String(i.name)}"`,t=Object.hasOwn(st,String(i.kind)),n=st[String(i.kind)];if(!t||!n)throw new Ze(`${e}: kind: expected one of ${Object.keys(st).join(", ")}, got ${an(i.kind)}`);let r=l=>{throw new Ze(`${e}: ${l}`)};for(let l of Object.keys(i))l!=="kind"&&l!=="name"&&!Object.hasOwn(n.fields,l)&&r(`unknown key '${l}'`);n.fields.bases&&Bf(()=>Er(i.bases),`${e}: `);let s=n.fields.basis!==void 0,a=n.surface&&(!s||["trigonometric","quintic",void 0].includes(i.basis));for(let[l,c]of Object.entries(n.fields)){let h=i[l];if(h===void 0){c.required&&r(`missing key '${l}': expected ${c.description}`);continue}c.type==="number"||c.type==="positive"?Vf(h,l,r,c.type==="positive"):c.type==="boolean"&&typeof h!="boolean"?r(`${l}: expected true or false, got ${an(h)}`):c.type==="choice"&&!c.choices.includes(h)?r(`${l}: expected one of ${c.choices.join(", ")}, got ${an(h)}`):c.type==="plane"?Do(h,l,4,r):c.type==="basis"&&!sb(h)?r(`${l}: expected the name of a basis, or two, got ${an(h)}`):c.type==="shape"&&s?Do(h,l,null,r):c.type==="shape"?ab(h,l,n.shapeNames,i.unchecked_shape===!0,r):c.type==="points"&&qf(h,l,a?c.counts:c.counts.map(()=>0),c.dimension,r)}let o=i;try{nt(o)?St(o):Nn(o)}catch(l){if(!(l instanceof ha))throw l}return o}function Bf(i,e=""){try{i()}catch(t){throw new Ze(`${e}${t.message}`)}}var sb=i=>[i].flat().every(e=>typeof e=="string"&&e!=="");function ab(i,e,t,n,r){Do(i,e,t.length,r).forEach((s,a)=>{!n&&!(s>=Tr[0]&&s<=Tr[1])&&r(`shape[${a}] (${t[a]}) = ${s} is outside [${Tr.join(", ")}], where the basis is non-negative; choose a value in the range, or set unchecked_shape = true and lose the convex-hull property`)})}function qf(i,e,t,n,r){if(!t.length)return void Do(i,e,n,r);if(!Array.isArray(i))return r(`${e}: expected a list, got ${an(i)}`);let s=t[0],a=t.length===2;(s?i.length!==s:i.length<2||i.length>Ff)&&r(`${e}: expected ${s||`2 to ${Ff}`} ${a?"rows":"points"}, got ${i.length}`),i.forEach((o,l)=>qf(o,`${e}[${l}]`,t.slice(1),n,r)),a&&i.some(o=>o.length!==i[0].length)&&r(`${e}: expected rows of equal length`)}function Do(i,e,t,n){return Array.isArray(i)?(t===null||(t===0?i.length===2||i.length===3:i.length===t)||n(`${e}: expected ${t===0?"2 or 3":t} numbers, got ${i.length}`),i.forEach((s,a)=>Vf(s,`${e}[${a}]`,n,!1)),i):n(`${e}: expected a list, got ${an(i)}`)}var ob=kf.toExponential().replace("e+","e");function Vf(i,e,t,n){typeof i!="number"&&t(`${e}: expected a number, got ${an(i)}`),Number.isFinite(i)||t(`${e}: expected a finite number, got ${String(i)}`),Math.abs(i)>kf&&t(`${e}: expected a number of size at most ${ob}, got ${String(i)}`),n&&!(i>0)&&t(`${e}: expected a number greater than 0, got ${String(i)}`)}var Uf=i=>typeof i=="object"&&i!==null&&!Array.isArray(i);function an(i){let e=i===void 0?"nothing":JSON.stringify(i)??String(i);return e.length<=60?e:`${e.slice(0,57)}...`}var ou="quintrig:here:";function Hf(i,e){let t=()=>{let{source:n,saved:r}=e.state;try{sessionStorage.setItem(ou+i.place,JSON.stringify(n?{name:n.name}:{model:on(r)}))}catch{sessionStorage.removeItem(ou+i.place)}};e.subscribe((n,r)=>{(n.opened!==r.opened||n.source!==r.source)&&t()})}async function Gf(i){try{let e=JSON.parse(sessionStorage.getItem(ou+i.place)??"null");return e?e.name?await i.load(e.name):{model:vt(e.model),source:null}:null}catch{return null}}function lb(i,e){let t=i.slice(0,e).split(/\r?\n/);return[t.length,t.pop().length+1]}function cb(i,e,t){let n=i.split(/\r?\n/),r="",s=(Math.log10(e+1)|0)+1;for(let a=e-1;a<=e+1;a++){let o=n[a-1];o&&(r+=a.toString().padEnd(s," "),r+=":  ",r+=o,r+=`
`,a===e&&(r+=" ".repeat(s+t+2),r+=`^
`))}return r}var Ie=class i extends Error{line;column;codeblock;constructor(e,t){let[n,r]=lb(t.toml,t.ptr),s=cb(t.toml,n,r);super(`Invalid TOML document: ${e}

${s}`,t),this.line=n,this.column=r,this.codeblock=s}static x(e,t,n){throw new i(e,{toml:t.s,ptr:n??t.p})}};function zo(i){let e=i.p,t=i.s.charCodeAt(i.p++),n=t,r=t===39,s=t===i.s.charCodeAt(i.p)&&t===i.s.charCodeAt(i.p+1);s&&((t=i.s.charCodeAt(i.p+=2))===10?i.p++:t===13&&i.s.charCodeAt(i.p+1)===10&&(i.p+=2));let a="",o=i.p,l=0;for(;i.p<i.s.length;i.p++)if(t=i.s.charCodeAt(i.p),s&&(t===10||t===13&&i.s.charCodeAt(i.p+1)===10))l=l&&3;else if(t<32&&t!==9||t===127)Ie.x("control characters are not allowed in strings",i);else if((!l||l===3)&&t===n&&(!s||i.s.charCodeAt(i.p+1)===n&&i.s.charCodeAt(i.p+2)===n)){if(s&&(i.s.charCodeAt(i.p+3)===n&&i.p++,i.s.charCodeAt(i.p+3)===n&&i.p++),!l){let c=i.s.slice(o,i.p);a=a?a+c:c}return i.p+=s?3:1,a}else if(!l)!r&&t===92&&(a+=i.s.slice(o,o=i.p),l=1);else if(l===1)if(t===120||t===117||t===85){let c=i.p++-1,h=0,d=t===120?2:t===117?4:8;for(let u=0;u<d;u++,i.p++){let p=i.s.charCodeAt(i.p),f=p>=48&&p<=57?p-48:p>=65&&p<=70?p-65+10:p>=97&&p<=102?p-97+10:-1;f<0&&Ie.x("invalid non-hex character in unicode escape",i),h=h<<4|f}(h<0||h>1114111||h>=55296&&h<=57343)&&Ie.x("invalid unicode escape",i,c),a+=String.fromCodePoint(h),o=i.p--,l=0}else s&&(t===32||t===9)?l=2:(t===98?a+="\b":t===116?a+="	":t===110?a+=`
`:t===102?a+="\f":t===114?a+="\r":t===101?a+="\x1B":t===34?a+='"':t===92?a+="\\":Ie.x("unrecognised escape sequence",i),o=i.p+1,l=0);else t!==32&&t!==9&&(l===2&&Ie.x("invalid escape: only line-ending whitespace may be escaped",i,o),l=!r&&t===92?1:0,o=i.p);Ie.x("unfinished string",i,e)}var hb=/^(\d{4}-\d{2}-\d{2})?[Tt ]?(?:(\d{2}):\d{2}(?::\d{2}(?:\.\d+)?)?)?(Z|z|[-+]\d{2}:\d{2})?$/i,da=class i extends Date{#t=!1;#n=!1;#e=null;constructor(e,t,n){let r=!0,s=!0,a="Z",o;if(typeof e=="string")if(t)e:{if(t<3){if(+e.slice(11,13)>23){e="";break e}t===2?(a=null,e+="Z"):(o=e.charCodeAt(e.length-1))!==90&&o!==122&&(a=e.slice(e.length-6)),n&&(e=e.slice(0,10)+"T"+e.slice(11))}else t===4&&(e=+e.slice(0,2)>23?"":`0000-01-01T${e}Z`);r=t!==4,s=t!==3}else{let l=e.match(hb);l?(l[1]||(r=!1,e=`0000-01-01T${e}`),s=!!l[2],s&&e[10]===" "&&(e=e.replace(" ","T")),l[2]&&+l[2]>23?e="":(a=l[3]||null,!a&&s&&(e+="Z"))):e=""}super(e),isNaN(this.getTime())||(this.#t=r,this.#n=s,this.#e=a)}isDateTime(){return this.#t&&this.#n}isLocal(){return!this.#t||!this.#n||!this.#e}isDate(){return this.#t&&!this.#n}isTime(){return this.#n&&!this.#t}isValid(){return this.#t||this.#n}toISOString(){let e=super.toISOString();if(this.isDate())return e.slice(0,10);if(this.isTime())return e.slice(11,23);if(this.#e===null)return e.slice(0,-1);if(this.#e==="Z"||this.#e==="z")return e;let t=+this.#e.slice(1,3)*60+ +this.#e.slice(4,6);return t=this.#e[0]==="-"?t:-t,new Date(this.getTime()-t*6e4).toISOString().slice(0,-1)+this.#e}static wrapAsOffsetDateTime(e,t="Z"){let n=new i(e);return n.#e=t,n}static wrapAsLocalDateTime(e){let t=new i(e);return t.#e=null,t}static wrapAsLocalDate(e){let t=new i(e);return t.#n=!1,t.#e=null,t}static wrapAsLocalTime(e){let t=new i(e);return t.#t=!1,t.#e=null,t}};function fn(i,e=10){return e===16?i>47&&i<58||i>64&&i<71||i>96&&i<103:i>47&&i<48+e}function cu(i,e){return i===32||i===9||i===10||i===13||e&&(i===e||i===44)||i===35}function fa(i,e){let t=i.p,n=i.s.charCodeAt(i.p);if(n===91||n===123){i.d--||Ie.x("document contains excessively nested structures. aborting.",i);let r=n===91?Xf(i):$f(i);return i.d++,r}return n===34||n===39?zo(i):n===116?((i.s.charCodeAt(++i.p)!==114||i.s.charCodeAt(++i.p)!==117||i.s.charCodeAt(++i.p)!==101)&&Ie.x("invalid value",i,t),i.p++,!0):n===102?((i.s.charCodeAt(++i.p)!==97||i.s.charCodeAt(++i.p)!==108||i.s.charCodeAt(++i.p)!==115||i.s.charCodeAt(++i.p)!==101)&&Ie.x("invalid value",i,t),i.p++,!1):n===43||n===45?Fo(i,i.p,i.s.charCodeAt(++i.p),44-n,e):i.s.charCodeAt(i.p+4)===45&&i.s.charCodeAt(i.p+7)===45?ub(i,n,e):i.s.charCodeAt(i.p+2)===58?db(i,n,e):Fo(i,i.p,n,0,e)}function Fo(i,e,t,n,r){let s=t,a=0,o=!1;if(s===105)return(i.s.charCodeAt(++i.p)!==110||i.s.charCodeAt(++i.p)!==102)&&Ie.x("invalid value",i,e),i.p++,(n||1)/0;if(s===110)return(i.s.charCodeAt(++i.p)!==97||i.s.charCodeAt(++i.p)!==110)&&Ie.x("invalid value",i,e),i.p++,NaN;if(s===48){if(++i.p>=i.s.length||cu(s=i.s.charCodeAt(i.p),r))return i.bi===!0?0n:0;if(!n){if(s===120)return lu(i,e,16,r);if(s===98)return lu(i,e,2,r);if(s===111)return lu(i,e,8,r)}s===46?a=2:s===101||s===69?a=4:Ie.x("illegal leading zero",i,e)}else fn(s)||Ie.x("invalid value",i,e);for(;++i.p<i.s.length&&(s=i.s.charCodeAt(i.p),!cu(s,r));)a||(a=1),s===95?(a&1||Ie.x("illegal underscore",i),a+=11,o=!0):a===1&&s===46?a=2:(a===1||a===3)&&(s===101||s===69)?a=4:a===4&&(s===43||s===45)?a=6:fn(s)?a>9?a-=11:a&1||a++:Ie.x("illegal character in numeric literal",i);if(!a){let c=(t-48)*(n||1);return i.bi===!0?BigInt(c):c}a&1||Ie.x("unfinished numeric value",i,e);let l=i.s.slice(e,i.p);return o&&(l=l.replaceAll("_","")),a>1?parseFloat(l):Wf(i,l,10,e)}function lu(i,e,t,n){let r,s=1;for(;++i.p<i.s.length&&(r=i.s.charCodeAt(i.p),!cu(r,n));)r===95?(s&1&&Ie.x("illegal underscore",i),s=3):fn(r,t)?s&1&&s--:Ie.x("illegal character in numeric literal",i);s&1&&Ie.x("unfinished numeric value",i);let a=i.s.slice(e+2,i.p);return s&&(a=a.replaceAll("_","")),Wf(i,a,t,e)}function Wf(i,e,t,n){if(i.bi!==!0)e:{let r=parseInt(e,t);if(!Number.isSafeInteger(r)){if(i.bi)break e;Ie.x("integer value cannot be represented losslessly",i,n)}return r}return BigInt(t===10?e:(t===2?"0b":t===8?"0o":"0x")+e)}function ub(i,e,t){let n=i.p++,r;if(!fn(e)||!fn(i.s.charCodeAt(i.p++))||!fn(i.s.charCodeAt(i.p++))||!fn(i.s.charCodeAt(i.p++)))return Fo(i,i.p=n,e,0,t);if(i.p+=5,fn(i.s.charCodeAt(i.p++))||Ie.x("invalid date-time: date part is malformed",i,n),i.p>=i.s.length||((e=i.s.charCodeAt(i.p))!==32||(r=!0,!fn(i.s.charCodeAt(i.p+1))))&&e!==84&&e!==116){let a=i.s.slice(n,i.p);return pa(i,a,3,!1,n)}if(i.s.charCodeAt(i.p+=3)!==58&&Ie.x("invalid date-time: time part is malformed",i,n),i.s.charCodeAt(i.p+=3)===58&&(i.p+=3),i.s.charCodeAt(i.p)===46)for(;fn(i.s.charCodeAt(++i.p)););if(e=i.s.charCodeAt(i.p)){if(e===90||e===122){let a=i.s.slice(n,++i.p);return pa(i,a,1,r,n,"[+00:00]")}if(e===43||e===45){let a=i.s.slice(n,i.p+=6);return pa(i,a,1,r,n,!i.ld&&"["+i.s.slice(i.p-6,i.p)+"]")}}let s=i.s.slice(n,i.p);return pa(i,s,2,r,n)}function db(i,e,t){let n=i.p;if(!fn(e)||!fn(i.s.charCodeAt(++i.p)))return Fo(i,--i.p,e,0,t);if(i.s.charCodeAt(i.p+=4)===58&&(i.p+=3),i.s.charCodeAt(i.p)===46)for(;fn(i.s.charCodeAt(++i.p)););let r=i.s.slice(n,i.p);return pa(i,r,4,!1,n)}function pa(i,e,t,n,r,s){if(i.ld){let a=new da(e,t,n);return a.isValid()||Ie.x("invalid date",i,r),a}try{switch(s&&(e+=s),t){case 1:return Temporal.ZonedDateTime.from(e);case 2:return Temporal.PlainDateTime.from(e);case 3:return Temporal.PlainDate.from(e);case 4:return Temporal.PlainTime.from(e)}}catch(a){Ie.x(a instanceof Error?a.message:""+a,i,r)}}function pb(i){for(;i.p<i.s.length;i.p++){let e=i.s.charCodeAt(i.p);if(e===10)break;if(e===13&&i.s.charCodeAt(i.p+1)===10){i.p++;break}(e<32&&e!==9||e===127)&&Ie.x("control characters are not allowed in comments",i)}}function Gn(i,e,t){let n;for(;i.p<i.s.length;){for(;i.p<i.s.length&&((n=i.s.charCodeAt(i.p))===32||n===9||!e&&(n===10||n===13&&i.s.charCodeAt(i.p+1)===10));)i.p++;if(t||n!==35)break;pb(i)}}function Oo(i,e=61){let t,n=0,r=[],s,a=i.s.charCodeAt(t=i.p);do{if(a===e)return n||Ie.x("unexpected end of key",i),n===1&&r.push(i.s.slice(s,i.p)),i.p++,r;a===46?(n||Ie.x("illegal empty bare key",i),n===1&&r.push(i.s.slice(s,i.p)),n=0):!n&&(a===34||a===39)?(a===i.s.charCodeAt(i.p+1)&&a===i.s.charCodeAt(i.p+2)&&Ie.x("illegal quoted key: multiline strings are not allowed",i),r.push(zo(i)),n=2,i.p--):a===32||a===9?n===1&&(r.push(i.s.slice(s,i.p)),n=2):n===2||a<48&&a!==45||a>57&&a<65||a>90&&a<97&&a!==95||a>122?Ie.x("illegal character in key",i):n||(n=1,s=i.p)}while(a=i.s.charCodeAt(++i.p));Ie.x("incomplete key-value: cannot find end of key",i,t)}function $f(i){let e=i.p++,t=Object.create(null),n=new Set,r;for(;i.p<i.s.length;){if(Gn(i),(r=i.s.charCodeAt(i.p))===125)return i.p++,t;let s,a=t,o=!1,l=i.p,c=Oo(i);for(let d=0;d<c.length;d++){d&&(a=o?a[s]:a[s]=Object.create(null)),s=c[d],(o=Object.hasOwn(a,s))&&(typeof a[s]!="object"||n.has(a[s]))&&Ie.x("trying to redefine an already defined value",i,l);let u=s==="__proto__";if(i.uk&&(u||s==="constructor")){a=i.uk!==1&&Ie.x("document contains an unsafe property",i,l);break}!o&&u&&Object.defineProperty(a,s,{enumerable:!0,configurable:!0,writable:!0})}o&&Ie.x("trying to redefine an already defined value",i,l),Gn(i,!0,!0);let h=fa(i,125);if(a&&typeof(a[s]=h)=="object"&&n.add(h),Gn(i),(r=i.s.charCodeAt(i.p++))===125)return t;r!==44&&Ie.x("expected comma or end of structure",i,i.p-1)}Ie.x("unfinished table",i,e)}function Xf(i){let e=i.p++,t=[],n;for(;i.p<i.s.length;){if(Gn(i),(n=i.s.charCodeAt(i.p))===93)return i.p++,t;if(t.push(fa(i,93)),Gn(i),(n=i.s.charCodeAt(i.p++))===93)return t;n!==44&&Ie.x("expected comma or end of structure",i,i.p-1)}Ie.x("unfinished array",i,e)}function Yf(i,e,t,n,r){let s=t,a=n,o,l=!1,c;for(let h=0;h<e.length;h++){if(h){if(s=l?s[o]:s[o]=Object.create(null),a=(c=a[o]).c,r===0&&(c.t===1||c.t===2))return null;if(c.t===2){let d=s.length-1;s=s[d],a=a[d].c}}if(o=e[h],(l=Object.hasOwn(s,o))&&a[o]?.t===0&&a[o]?.d)return null;if(!l){let d=o==="__proto__";if(i.uk&&(d||o==="constructor"))return!1;d&&(Object.defineProperty(s,o,{enumerable:!0,configurable:!0,writable:!0}),Object.defineProperty(a,o,{enumerable:!0,configurable:!0,writable:!0})),a[o]={t:h<e.length-1&&r===2?3:r,d:!1,i:0,c:Object.create(null)}}}if(c=a[o],c.t!==r&&!(r===1&&c.t===3)||(r===2&&(c.d||(c.d=!0,s[o]=[]),s[o].push(s=Object.create(null)),c.c[c.i++]=c={t:1,d:!1,i:0,c:Object.create(null)}),c.d))return null;if(c.d=!0,r===1)s=l?s[o]:s[o]=Object.create(null);else if(r===0&&l)return null;return[o,s,c.c]}function Jf(i,e,t){(e===null||i.uk===2)&&Ie.x(e===null?"trying to redefine an already defined table or value":"document contains an unsafe property",i,t)}function hu(i,e={}){let t={s:i,p:0,d:e.maxDepth??1e3,bi:e.integersAsBigInt??!1,ld:e.useLegacyDate??!0,uk:e.unsafeKeyBehaviour==="throw"?2:e.unsafeKeyBehaviour==="drop"?1:0},n=Object.create(null),r=Object.create(null),s,a=!1,o=n,l=r;for(i.charCodeAt(0)===65279&&t.p++,Gn(t);t.p<i.length;){if(i.charCodeAt(t.p)===91){let c=i.charCodeAt(++t.p)===91;s=t.p+=+c,a=!1;let h=Oo(t,93);c&&(i.charCodeAt(t.p)!==93&&Ie.x("expected end of table array declaration",t),t.p++);let d=Yf(t,h,n,r,c?2:1);d?(l=d[2],o=d[1]):(Jf(t,d,s),a=!0)}else{s=t.p;let c=Oo(t),h=Yf(t,c,o,l,0);!h&&!a&&Jf(t,h,s),Gn(t,!0,!0);let d=fa(t,void 0);h&&!a&&(h[1][h[0]]=d)}Gn(t,!0),t.p<i.length&&(s=i.charCodeAt(t.p))!==10&&(s!==13||i.charCodeAt(t.p+1)!==10)&&Ie.x("each key-value declaration must be followed by an end-of-line",t),Gn(t)}return n}var AA=!!"".isWellFormed;function Kf(i){let e=[],t=!1,n=!1,r=0,s=o=>(o.lastIndex=r,o.exec(i)?.[0]??""),a=(o,l=r)=>{let c=i.slice(0,l).split(`
`);return{what:o,line:c.length,column:c.at(-1).length+1}};for(;r<i.length;){let o=i[r],l=e.at(-1)==="table";if(o==='"'||o==="'"){let c=s(fb),h=o==='"'?/^(?:[^\\]|\\[^ex])*?\\([ex])/.exec(c):null;if(h)return a(`unknown escape sequence \\${h[1]}`,r+h[0].length-2);r+=c.length||1,t=n=!1}else if(o==="#")r+=s(/[^\n]*/y).length;else if(o===`
`){if(l)return a("a line break in an inline table");e.length||(t=!1),r++}else if(o==="["||o==="{")e.push(o==="{"?"table":t?"list":"header"),t=e.at(-1)==="list",n=!1,r++;else if(o==="]"||o==="}"){if(n&&l)return a("a comma at the end of an inline table");e.pop(),t=n=!1,r++}else if(o===","||o==="=")t=o==="="||e.at(-1)==="list",n=o===",",r++;else if(/\s/.test(o))r++;else{let c=t?s(mb):"",h=c||s(/[^\s,=\]}#]+/y);if(c&&!gb(c))return a(`the date or time ${c} does not exist or lacks its seconds`);r+=h.length,t=n=!1}}return null}var fb=/"""(?:[^\\]|\\.)*?"{3,5}|'''.*?'{3,5}|"(?:[^"\\]|\\.)*"|'[^']*'/sy,mb=/\d{4}-\d\d-\d\d(?:[Tt ]\d[\d:.]*(?:[Zz]|[+-]\d\d:\d\d)?)?|\d\d:[\d:.]*/y,Zf=/^([01]\d|2[0-3]):[0-5]\d:[0-5]\d(?:\.\d+)?(?:[Zz]|[+-]([01]\d|2[0-3]):[0-5]\d)?$/;function gb(i){if(i[2]===":")return Zf.test(i);let[e,t,n]=i.slice(0,10).split("-").map(Number),r=new Date(0);return r.setUTCFullYear(e,t-1,n),e>0&&r.getUTCMonth()===t-1&&r.getUTCDate()===n&&(i.length===10||Zf.test(i.slice(11)))}var bb=20,Wn=i=>du(on(i));function du(i){let e=[],t=o=>{for(let[l,c]of Object.entries(o))c!=null&&e.push(`${l} = ${Uo(c)}`)},{patch:n,join:r,...s}=i,a=({bases:o,...l},c="")=>{t(l);for(let[h,d]of Object.entries(o??{}))e.push("",`[${c}bases.${jf(h)}]`),t(d)};a(s);for(let[o,l]of Object.entries({patch:n,join:r}))for(let c of l??[])e.push("",`[[${o}]]`),a(c,`${o}.`);return`${e.join(`
`)}
`}var jf=i=>/^[\w-]+$/.test(i)?i:JSON.stringify(i);function Uo(i,e=""){return typeof i=="object"&&i!==null&&!Array.isArray(i)?`{ ${Object.entries(i).map(([n,r])=>`${jf(n)} = ${Uo(r)}`).join(", ")} }`:Array.isArray(i)?i.every(n=>!Array.isArray(n))&&!i.some(n=>typeof n=="string"&&n.length>12)?`[${i.map(n=>Uo(n)).join(", ")}]`:`[
${i.map(n=>`${e}    ${Uo(n,`${e}    `)},
`).join("")}${e}]`:typeof i=="string"?JSON.stringify(i):String(i)}function ps(i){try{let e=i.replace(/^\uFEFF/,""),{...t}=hu(e,{integersAsBigInt:"asNeeded",maxDepth:bb}),n=Kf(e);if(n)throw new Ze(`not valid TOML: ${n.what} (at line ${n.line}, column ${n.column})`);return uu(t)}catch(e){if(!(e instanceof Ie))throw e;let[t]=e.message.replace(/^Invalid TOML document: /,"").split(`
`);throw new Ze(`not valid TOML: ${t} (at line ${e.line}, column ${e.column})`)}}function uu(i){return typeof i=="bigint"?Number(i):Array.isArray(i)?i.map(uu):typeof i!="object"||i===null||i instanceof Date?i:Object.fromEntries(Object.entries(i).map(([e,t])=>[e,uu(t)]))}function T(i,e={},...t){let n=document.createElement(i);for(let[r,s]of Object.entries(e))if(r==="on")for(let[a,o]of Object.entries(s))n.addEventListener(a,o);else r==="class"?n.className=String(s):r.startsWith("aria-")&&typeof s=="boolean"?n.setAttribute(r,String(s)):s===!0?n.setAttribute(r,""):s!==!1&&s!==null&&s!==void 0&&n.setAttribute(r,String(s));return n.append(...t.filter(r=>r!=null&&r!==!1).map(r=>typeof r=="number"?String(r):r)),n}var Qf="http://www.w3.org/2000/svg";function xt(i){let e=document.createElementNS(Qf,"svg");e.setAttribute("viewBox","0 0 16 16"),e.setAttribute("class","icon"),e.setAttribute("aria-hidden","true");let t=document.createElementNS(Qf,"path");return t.setAttribute("d",i),e.append(t),e}var Mt={undo:"M3 6h7a3.5 3.5 0 0 1 0 7H6M3 6l3-3M3 6l3 3",redo:"M13 6H6a3.5 3.5 0 0 0 0 7h4M13 6l-3-3M13 6l-3 3",open:"M2 4.5h4l1.5 1.5H14v7H2zM2 8h12",save:"M3 3h8l2 2v8H3zM5.5 3v3.5h4V3M5 13V9h6v4",picture:"M2 4h3l1-1.5h4L11 4h3v9H2zM8 6.2a2.4 2.4 0 1 0 0 4.8 2.4 2.4 0 0 0 0-4.8z",export:"M8 10V2.5M5 5l3-3 3 3M3 9v4.5h10V9",sun:"M8 5.2a2.8 2.8 0 1 0 0 5.6 2.8 2.8 0 0 0 0-5.6zM8 1v1.6M8 13.4V15M1 8h1.6M13.4 8H15M3 3l1.2 1.2M11.8 11.8 13 13M13 3l-1.2 1.2M4.2 11.8 3 13",moon:"M13 9.5A5.5 5.5 0 1 1 6.5 3 4.4 4.4 0 0 0 13 9.5z",help:"M8 2a6 6 0 1 0 0 12A6 6 0 0 0 8 2zM6.2 6.2a1.9 1.9 0 1 1 2.6 1.8c-.6.3-.8.6-.8 1.2M8 11.2v.3",down:"M4.5 6.5 8 10l3.5-3.5",fit:"M2.5 6V2.5H6M10 2.5h3.5V6M13.5 10v3.5H10M6 13.5H2.5V10",pin:"M8 14V9.5M5 9.5h6L9.8 7V3.5H11v-1H5v1h1.2V7z",close:"M4 4l8 8M12 4l-8 8",flip:"M8 2v12M5 5 2 8l3 3M11 5l3 3-3 3",wire:"M2 12 6 3l8 2-3 9zM4 7.5l8.6 2M9.5 4 6.5 13",side:"M2.5 3h11v10h-11zM6 3v10"},pu=i=>i.value.trim()===""?NaN:Number(i.value.replace(",","."));function $n(i,e,t="text/plain"){let n=typeof e=="string"?new Blob([e],{type:t}):e,r=T("a",{href:URL.createObjectURL(n),download:i});r.click(),setTimeout(()=>URL.revokeObjectURL(r.href),1e4)}var Xn=i=>i.normalize("NFKD").replace(/[^\w-]+/g,"_").replace(/^_+|_+$/g,"").toLowerCase()||"surface";var ma=class extends Error{},Nr=class extends Error{constructor(t){super(`${t?"The studio's server has stopped: it does not answer.":"The studio's server was started anew, and does not know this tab."} Your work is still here, and unsaved changes are kept in this browser.`);this.stopped=t}stopped},fs=class{constructor(e,t){this.kind=e;this.place=t}kind;place;list(){return Promise.resolve([])}load(e){return Promise.reject(new Ze(`${e}: a page from disk has no folder to open files from`))}read(e,t){return new Promise(n=>n(yb(e,t)))}save(e,t){return $n(`${Xn(e.replace(/\.(toml|json)$/i,""))}.toml`,Wn(t)),Promise.resolve(null)}formats(){return Promise.resolve([])}export(){return Promise.reject(new Error("exports need the live studio: quintrig view MODEL"))}},ko=class{constructor(e){this.place=e}place;kind="live";async list(){return(await this.ask("GET","api/files")).files}async load(e){return fu(await this.ask("GET",`api/files/${encodeURIComponent(e)}`))}async read(e,t){let n=await this.ask("POST","api/check",JSON.stringify({name:e,text:t}));return vt(n.model)}async save(e,t,n){let r=JSON.stringify({text:Wn(t),tag:n});return await this.ask("PUT",`api/files/${encodeURIComponent(e)}`,r)}async formats(e,t){return(await this.ask("POST","api/formats",JSON.stringify({text:Wn(e),patch:t}))).formats}async export({model:e,...t},{suffix:n}){let r=JSON.stringify({text:Wn(e),suffix:n,...t}),{name:s,notes:a,content:o}=await this.ask("POST","api/export",r);return $n(s,new Blob([Uint8Array.from(atob(o),l=>l.charCodeAt(0))])),{name:s,notes:a}}async build(e){return(await this.ask("POST","api/build",JSON.stringify({patches:JSON.stringify(e)}))).built}async ask(e,t,n){return(await this.send(e,t,n)).json()}async send(e,t,n){let r;try{r=await fetch(t,{method:e,body:n??null,...n?{headers:{"Content-Type":"application/json"}}:{}})}catch{throw new Nr(!0)}if(r.ok)return r;let s=await r.json().catch(()=>null);if(r.status===403&&!s)throw new Nr(!1);let a=s?.error??`the server answered ${r.status}`;throw r.status===409?new ma(a):r.status===422?new Ze(a):new Error(a)}};function fu(i){let{model:e,name:t,tag:n}=i;return{model:vt(e),source:t?{name:t,tag:n}:null}}function yb(i,e){try{if(/\.toml$/i.test(i))return vt(ps(e));if(!/\.json$/i.test(i))throw new Ze("expected a file ending in .toml or .json");let t;try{t=JSON.parse(e)}catch(n){throw new Ze(`not valid JSON: ${n.message}`)}return vt(t)}catch(t){throw new Ze(`${i}: ${t.message}`)}}var ms=Ue.limits;function Bo(i,e,t,n,r){if(!(Math.abs(t)<1e300))return 0;if(t<=r)return 5;let s=Math.abs(i)<=n*t*t?0:i>0?1:-1;return 1+3*(1+(Math.abs(e)<=n*t?0:e>0?1:-1))+(1-s)}function mu(i,e,t,n){if(i===0)return 0;if(i===5)return 4;let r=(i-1)%3;return r===0?e<=n*t?5:1:r===1?3:2}function gu(i,e){if(e===0)return 0;if(e===5)return 10;let t=1;for(let n of Ue.shapeBreaks)i>=-n&&t++,i>n&&t++;return t}function em(i,e,t){let n=.5*(i-t);return Math.sqrt(n*n+e*e)}function tm(i,e,t,n){return t>n?-2/Math.PI*Math.atan2(i,e):NaN}var Lr=1,Dr=0;function qo(i,e,t,n){let r=.5*(i-t),s=r>=0?n+r:e,a=r>=0?e:n-r,o=Math.sqrt(s*s+a*a);Lr=s/o,Dr=a/o}var vb=Ue.limits.vertical;function nm(i,e,t,n,r,s,a){a[0]=i*n*n+2*e*n*r+t*r*r,a[1]=s*((t-i)*n*r+e*(n*n-r*r)),a[2]=i*r*r-2*e*n*r+t*n*n}function im(i,e,t,n,r,s){let a=1/(Math.abs(r)>vb?r:0),o=a*a,l=o*a;s[0]=e*o,s[1]=(i[0]+2*t*r*r)*l,s[2]=n*o*o,s[3]=i[0]*l*o,s[4]=i[1]*o*o,s[5]=i[2]*l}function rm(i,e,t,n,r,s){s[0]=e,s[1]=2*r*t,s[2]=r*r*n,s[3]=r*i[0],s[4]=Math.abs(r)*i[1],s[5]=r*i[2]}var ci=Ue.quantities,lt=Object.fromEntries(ci.map(i=>[i.key,i])),Vo=(i,e)=>Ue.words[i]?.[e]??"";function Ho(i,e){if(!e||i.power===0)return"";let t=e+["","","²","³"][Math.abs(i.power)];return i.power>0?t:`1/${t}`}function gs({trim:i=[]},e,t){return!i.length||sm(i,e).filter(n=>n>t).length%2===1||_b(i,e,t)}function Go({trim:i=[]},e,t){let n=t.length,r=new Uint8Array(e.length*n).fill(i.length?0:1);if(!i.length)return r;for(let s=0;s<e.length;s++){let a=sm(i,e[s]).sort((o,l)=>o-l);for(let o=0,l=0;o<n;o++){for(;l<a.length&&a[l]<=t[o];)l++;r[s*n+o]=l%2}}return r}function Ji({trim:i=[]}){if(!i.length)return[0,0,1,1];let e=[1,1],t=[0,0];for(let n of i.flat())for(let r of[0,1])e[r]=Math.min(e[r],n[r]),t[r]=Math.max(t[r],n[r]);return[e[0],e[1],t[0],t[1]]}function sm(i,e){let t=[];for(let n of i){let[r,s]=n.at(-1);for(let a of n){let[o,l]=a;r>e!=o>e&&t.push(s+(e-r)/(o-r)*(l-s)),[r,s]=[o,l]}}return t}var xb=1e-9;function _b(i,e,t){return i.some(n=>n.some(([r,s],a)=>{let[o,l]=n.at(a-1),c=r-o,h=s-l,d=Math.hypot(c,h),u=(e-o)*c+(t-l)*h,p=(e-o)*h-(t-l)*c;return d>0&&Math.abs(p)<=xb*d&&u>=0&&u<=d*d}))}var Sb=Ue.limits.singular,bu=Ue.limits.noise,ze={a:0,b:1,c:2,normal:3,e1:6,e2:9,point:12,forms:15,mean:21,halfDifference:22,gaussian:23,curvedness:24},Mb=25,ys=class{nu=0;nv=0;count=0;size=0;sign=1;stride=0;planes=new Float64Array(0);low=[0,0,0];high=[0,0,0];u=new Float64Array(0);v=new Float64Array(0);rows=new Float64Array(0);blend=new Float64Array(0);origin=[0,0,0];partials=new Float64Array(18);evaluate(e,t,n){let[r,s,a,o]=Ji(e);this.u=lm(t,r,a),this.v=lm(n,s,o),this.evaluateAt(e,this.u,this.v,!0)}evaluateAt(e,t,n,r){let s=hs(e);this.low=s.low,this.high=s.high,this.size=s.size,this.sign=e.flip?-1:1,this.nu=r?t.length:1,this.nv=n.length,this.count=this.nu*this.nv,this.origin=e.origin??[0,0,0];let a=e.rows.size,o=e.rows.dimension;this.rows.length<3*t.length*a*o&&(this.rows=new Float64Array(3*t.length*a*o)),this.blend.length<3*n.length*a&&(this.blend=new Float64Array(3*n.length*a)),this.stride<this.count&&(this.stride=this.count,this.planes=new Float64Array(Mb*this.stride)),e.rows.derivatives(t,t.length,this.rows),e.blend.derivatives(n,n.length,this.blend);let l=this.size>0?Sb*this.size*this.size:1/0;o===4?this.driveRational(a,t.length,n.length,r,l):this.drive(a,t.length,n.length,r,l)}quantity(e,t,n){Eb(this,e,t,n)}drive(e,t,n,r,s){let{rows:a,blend:o,partials:l}=this,c=3*e*t,h=e*n;for(let d=0;d<this.count;d++){let u=r?d/n|0:d,p=r?d-u*n:d,f=0,b=0,m=0,g=0,v=0,M=0,x=0,E=0,w=0,y=0,A=0,D=0,R=0,N=0,F=0,V=0,P=0,G=0;for(let W=0,O=3*e*u,Q=e*p;W<e;W++,O+=3,Q++){let H=o[Q],J=o[Q+h],te=o[Q+2*h],ve=a[O],Ee=a[O+1],X=a[O+2],re=a[O+c],me=a[O+c+1],Me=a[O+c+2];f+=ve*H,b+=Ee*H,m+=X*H,g+=re*H,v+=me*H,M+=Me*H,x+=ve*J,E+=Ee*J,w+=X*J,y+=a[O+2*c]*H,A+=a[O+2*c+1]*H,D+=a[O+2*c+2]*H,R+=re*J,N+=me*J,F+=Me*J,V+=ve*te,P+=Ee*te,G+=X*te}l[0]=f,l[1]=b,l[2]=m,l[3]=g,l[4]=v,l[5]=M,l[6]=x,l[7]=E,l[8]=w,l[9]=y,l[10]=A,l[11]=D,l[12]=R,l[13]=N,l[14]=F,l[15]=V,l[16]=P,l[17]=G,this.reduce(d,s)}}driveRational(e,t,n,r,s){let{rows:a,blend:o,partials:l}=this,c=4*e*t,h=e*n,d=new Float64Array(24);for(let u=0;u<this.count;u++){let p=r?u/n|0:u,f=r?u-p*n:u;d.fill(0);for(let E=0,w=4*e*p,y=e*f;E<e;E++,w+=4,y++){let A=o[y],D=o[y+h],R=o[y+2*h];for(let N=0;N<4;N++){let F=a[w+N],V=a[w+c+N];d[N]+=F*A,d[4+N]+=V*A,d[8+N]+=F*D,d[12+N]+=a[w+2*c+N]*A,d[16+N]+=V*D,d[20+N]+=F*R}}let b=d[3],m=d[7],g=d[11],v=d[15],M=d[19],x=d[23];for(let E=0;E<3;E++){let w=d[E]/b,y=(d[4+E]-m*w)/b,A=(d[8+E]-g*w)/b;l[E]=w,l[3+E]=y,l[6+E]=A,l[9+E]=(d[12+E]-2*m*y-v*w)/b,l[12+E]=(d[16+E]-m*A-g*y-M*w)/b,l[15+E]=(d[20+E]-2*g*A-x*w)/b}this.reduce(u,s)}}reduce(e,t){let n=this.partials,r=n[0],s=n[1],a=n[2],o=n[3],l=n[4],c=n[5],h=n[6],d=n[7],u=n[8],p=n[9],f=n[10],b=n[11],m=n[12],g=n[13],v=n[14],M=n[15],x=n[16],E=n[17],w=this.planes,y=this.stride,A=this.sign,D=o*o+l*l+c*c,R=o*h+l*d+c*u,N=h*h+d*d+u*u,F=l*u-c*d,V=c*h-o*u,P=o*d-l*h,G=Math.sqrt(F*F+V*V+P*P),W=G>t?1/G:NaN,O=A*W,Q=F*O,H=V*O,J=P*O,te=p*Q+f*H+b*J,ve=m*Q+g*H+v*J,Ee=M*Q+x*H+E*J,X=R/D,re=te/D,me=(ve-X*te)*W,Me=(Ee-2*X*ve+X*X*te)*(D*W)*W,pe=.5*(re+Me),Le=em(re,me,Me),ft=1/Math.sqrt(D),Ce=o*ft,et=l*ft,it=c*ft;w[e]=re,w[y+e]=me,w[2*y+e]=Me,w[3*y+e]=Q,w[4*y+e]=H,w[5*y+e]=J,w[6*y+e]=Ce,w[7*y+e]=et,w[8*y+e]=it,w[9*y+e]=A*(H*it-J*et),w[10*y+e]=A*(J*Ce-Q*it),w[11*y+e]=A*(Q*et-H*Ce),w[12*y+e]=r+this.origin[0],w[13*y+e]=s+this.origin[1],w[14*y+e]=a+this.origin[2],w[15*y+e]=D,w[16*y+e]=R,w[17*y+e]=N,w[18*y+e]=te,w[19*y+e]=ve,w[20*y+e]=Ee,w[21*y+e]=pe,w[22*y+e]=Le,w[23*y+e]=re*Me-me*me,w[24*y+e]=Math.sqrt(pe*pe+Le*Le)}},wb=["E","F","G","L","M","N"],Ab=["beta0","beta1","beta2","gamma1","gamma2","gamma3"],yu=new Float64Array(3),bs=new Float64Array(6);function Eb(i,e,t,n){let{planes:r,stride:s,count:a}=i,o=(f,b=1)=>{for(let m=0;m<b;m++)for(let g=0,v=(f+m)*s;g<a;g++,v++)t[b*g+m]=r[v]},l=i.size>0?1/i.size:1/0,c=n.flat*l,h=n.relative;switch(e){case"point":return o(ze.point,3);case"normal":return o(ze.normal,3);case"gaussian":return o(ze.gaussian);case"mean":return o(ze.mean);case"curvedness":return o(ze.curvedness);case"k1":case"k2":{let f=e==="k1"?1:-1;for(let b=0;b<a;b++)t[b]=r[ze.mean*s+b]+f*r[ze.halfDifference*s+b];return}case"direction1":case"direction2":return Tb(i,e==="direction2",h,bu*l,t);case"shape_index":for(let f=0;f<a;f++)t[f]=am(r,s,f,bu*l);return;case"hk_type":for(let f=0;f<a;f++)t[f]=vu(r,s,f,h,c);return;case"point_type":for(let f=0;f<a;f++){let b=vu(r,s,f,h,c);t[f]=mu(b,r[ze.halfDifference*s+f],r[ze.curvedness*s+f],h)}return;case"shape_class":for(let f=0;f<a;f++)t[f]=gu(am(r,s,f,bu*l),vu(r,s,f,h,c));return;case"invariant_type":for(let f=0;f<a;f++){om(i,f,!0);let b=.5*bs[1],m=2*b*b-bs[2];t[f]=Bo(bs[2],b,Math.sqrt(Math.max(m,0)),h,c)}return}let d=wb.indexOf(e);if(d>=0)return o(ze.forms+d);let u=e.endsWith("_surface"),p=Ab.indexOf(u?e.slice(0,-8):e);if(p<0)throw new Error(`unknown quantity '${e}'; known are ${Object.keys(lt).join(", ")}`);for(let f=0;f<a;f++)om(i,f,!u),t[f]=bs[p]}function vu(i,e,t,n,r){return Bo(i[ze.gaussian*e+t],i[ze.mean*e+t],i[ze.curvedness*e+t],n,r)}function am(i,e,t,n){return tm(i[ze.mean*e+t],i[ze.halfDifference*e+t],i[ze.curvedness*e+t],n)}function om(i,e,t){let{planes:n,stride:r}=i,s=n[(ze.e1+2)*r+e],a=n[(ze.e2+2)*r+e],o=n[(ze.normal+2)*r+e];nm(n[e],n[r+e],n[2*r+e],s,a,i.sign,yu);let l=s*s+a*a,c=n[ze.mean*r+e],h=n[ze.gaussian*r+e];t?im(yu,l,c,h,o,bs):rm(yu,l,c,h,o,bs)}function Tb(i,e,t,n,r){let{planes:s,stride:a,count:o}=i;for(let l=0;l<o;l++){let c=s[ze.halfDifference*a+l],h=s[ze.curvedness*a+l],d=c>t*h&&h>n;qo(s[l],s[a+l],s[2*a+l],c);for(let u=0;u<3;u++){let p=s[(ze.e1+u)*a+l],f=s[(ze.e2+u)*a+l],b=e?Lr*f-Dr*p:Lr*p+Dr*f;r[3*l+u]=d?b:NaN}}}var lm=(i,e,t)=>Float64Array.from({length:i},(n,r)=>r===i-1?t:e+(t-e)*(r/(i-1)));function Yn(i,e,t,n=!1,r=ci.map(a=>a.key),s=ms){for(let o of[...Array.from(e),...Array.from(t)])if(!(o>=0&&o<=1))throw new Error(`parameter ${o} is outside the domain [0, 1]`);let a=new ys;return a.evaluateAt(i,Float64Array.from(e),Float64Array.from(t),!n),Object.fromEntries(r.map(o=>{let l=new Float64Array(a.count*(lt[o]?.components??1));return a.quantity(o,l,s),[o,l]}))}function hm(i,e,t,n){let r=cm(i,e,t),s=cm(i,e,n);return i.map((a,o)=>a+s[o]-r[o])}function Wo(i,e,t,n){let r=Math.hypot(...e),s=e.map(l=>l/r),a=l=>{let c=i.map((u,p)=>u-l.origin[p]),h=Zi(s,l.direction),d=1-h*h;return d>1e-4?(h*Zi(c,l.direction)-Zi(c,s))/d:0},o=a(n)-a(t);return i.map((l,c)=>l+o*s[c])}function um(i,{origin:e,direction:t},n){let r=Zi(e,t),s=r*r-Zi(e,e)+i*i,a=h=>e.map((d,u)=>d+h*t[u]);if(s<=0){let h=a(-r),d=Math.hypot(...h)||1;return h.map(u=>i*u/d)}let[o,l]=[a(-r-Math.sqrt(s)),a(-r+Math.sqrt(s))],c=h=>Math.hypot(...h.map((d,u)=>d-n[u]));return c(o)<=c(l)?o:l}function cm(i,e,t){let n=Zi(e,i)-Zi(e,t.origin),r=Zi(e,t.direction),s=Math.abs(r)>1e-9?n/r:0;return t.origin.map((a,o)=>a+s*t.direction[o])}var Zi=(i,e)=>i[0]*e[0]+i[1]*e[1]+i[2]*e[2];var Cb=.1,xu=[[1,0,0],[0,1,0],[0,0,1]];function dm(i,e,t){let n=[0,1,2].filter(c=>i[c]);if(n.length===0)return null;if(n.length===1)return{line:xu[n[0]]};let r=t.map(Math.abs),s=r.indexOf(Math.max(...r)),a=n.length===2?xu[i.indexOf(!1)]:e??xu[s];if(Math.abs(gm(a,t))>Cb)return{normal:a};let o=bm(a,t),l=Math.hypot(...o);return{line:o.map(c=>Math.abs(c)<1e-9*l?0:c/l)}}function pm(i,e,t,n){return i===null?e:"line"in i?Wo(e,i.line,t,n):hm(e,i.normal,t,n)}function fm(i,e,t,n,r=!1){let s=u=>Math.round(u/n)*n;if(i===null)return[...e];if("line"in i){let u=i.line.map(Math.abs),p=u.indexOf(Math.max(...u)),f=i.line,b=(s(t[p])-e[p])/f[p];return e.map((m,g)=>g===p?s(t[g]):f[g]?m+b*f[g]:m)}let a=i.normal,o=a.map(Math.abs),l=o.indexOf(Math.max(...o)),c=[0,1,2].filter(u=>u!==l),h=[...e];for(let u of c)h[u]=s(t[u]);let d=c.reduce((u,p)=>u+a[p]*(h[p]-e[p]),0);return d!==0&&(h[l]=r?s(e[l]-d/a[l]):e[l]-d/a[l]),h}function mm(i){let[e,...t]=i,n=t.map(c=>c.map((h,d)=>h-e[d])),r=Math.max(0,...n.map(c=>Math.hypot(...c))),s=n.find(c=>Math.hypot(...c)===r);if(!s||!(r>0))return;let a=n.map(c=>bm(s,c)),o=Math.max(...a.map(c=>Math.hypot(...c))),l=a.find(c=>Math.hypot(...c)===o).map(c=>c/o);if(!(!(o>1e-9*r*r)||n.some(c=>Math.abs(gm(c,l))>1e-9*r)))return l.map(c=>Math.abs(c)<1e-12?0:c)}var gm=(i,e)=>i[0]*e[0]+i[1]*e[1]+i[2]*e[2],bm=(i,e)=>[i[1]*e[2]-i[2]*e[1],i[2]*e[0]-i[0]*e[2],i[0]*e[1]-i[1]*e[0]];var zr=[.11,.36,.66],ga=[0,.47,.42],ji=[!0,!0,!0],_m=400,ym=new WeakMap;function mn(i){let e=ym.get(i);if(!e){try{e=nt(i)?Rb(i):Su(i,Nn(i))}catch{e=[]}ym.set(i,e)}return e}function Rb(i){let e=Pe(i,"points"),t=e[0].length===2;return Ki("points",e.map(n=>[n[0],n[1],n[2]??0]),t?[!0,!0,!1]:ji,zr).map((n,r)=>({...n,label:`point ${r}`}))}function Su(i,e){let t=n=>Pe(i,n)??[];switch(i.kind){case"tensor":case"nurbs":return $o(t("points"));case"symmetric":{let n=t("points"),r=Pe(i,"mirror"),s=$o(n).map(a=>({...a,id:`${a.id}′`,label:`${a.label}′`,position:us(a.position,r),mirrored:!0}));return[...$o(n),...s]}case"swept":return[...Ki("section",t("section"),ji,zr),...Ki("trajectory",t("trajectory"),ji,ga)];case"ruled":return[...Ki("first",t("first"),ji,zr),...Ki("second",t("second"),ji,ga)];case"swung":return[...Ki("profile",t("profile").map(([n,r])=>[n,0,r]),[!0,!1,!0],zr),...Ki("trajectory",t("trajectory").map(([n,r])=>[n,r,0]),[!0,!0,!1],ga)];case"developable":return[...xm("planes",t("planes"),e,n=>[n/5,.5],zr),...xm("bounds",t("bounds"),e,n=>[.5,n],ga)];default:return Pb(i).flatMap(([n,r],s)=>r===2?$o(t(n),n):Ki(n,t(n),ji,s?ga:zr))}}var Pb=i=>Object.entries(st[i.kind]?.fields??{}).flatMap(([e,t])=>t.type==="points"&&t.dimension===3?[[e,t.counts.length]]:[]);function Xo(i,e,t){if(e.along){let s=Pe(i,e.key)[e.index[0]],a=-(s[0]*t[0]+s[1]*t[1]+s[2]*t[2]);return ba(i,e.key,e.index,[s[0],s[1],s[2],_u(a)])}let n=e.position.map((s,a)=>e.free[a]?t[a]:s);if(e.mirrored&&(n=us(n,Pe(i,"mirror"))),nt(i))return ba(i,e.key,e.index,n.slice(0,e.free[2]?3:2).map(_u));let r=i.kind!=="swung"?n:e.key==="profile"?[n[0],n[2]]:[n[0],n[1]];return ba(i,e.key,e.index,r.map(_u))}function ba(i,e,t,n){let r=(s,a)=>a.length?s.map((o,l)=>l===a[0]?r(o,a.slice(1)):o):n;return{...i,[e]:r(Pe(i,e),t)}}function Sm(i){let e=Pe(i,"points").map(t=>[t[0],t[1],t[2]??0]);return[Pe(i,"close")===!0?[...e,e[0]]:e]}function Mm(i,e){let t=a=>Pe(i,a);switch(i.kind){case"swept":return[t("section").slice(),t("trajectory").slice()];case"swung":return[t("profile").map(([a,o])=>[a,0,o]),t("trajectory").map(([a,o])=>[a,o,0])];case"ruled":return[t("first").slice(),t("second").slice()]}let n=e.net;if(!n||n.n*n.m>_m)return[];let r=(a,o)=>Array.from(n.values.subarray(3*(a*n.m+o),3*(a*n.m+o)+3)),s=a=>Array.from({length:a},(o,l)=>l);return[...s(n.n).map(a=>s(n.m).map(o=>r(a,o))),...s(n.m).map(a=>s(n.n).map(o=>r(o,a)))]}var _u=i=>Number(i.toPrecision(12))+0,vm=i=>String(i).replace(/\d/g,e=>"₀₁₂₃₄₅₆₇₈₉"[Number(e)]);function $o(i,e="points"){return i.length*(i[0]?.length??0)>_m?[]:i.flatMap((t,n)=>t.map((r,s)=>({id:`${e}[${n}][${s}]`,key:e,index:[n,s],label:`P${vm(n)}${n>9||s>9?",":""}${vm(s)}`,position:r,free:ji,tint:zr})))}function Ki(i,e,t,n){let r=mm(e);return e.map((s,a)=>({id:`${i}[${a}]`,key:i,index:[a],label:`${i} ${a}`,position:s,free:t,tint:n,...r&&{plane:r}}))}function xm(i,e,t,n,r){return e.map((s,a)=>{let[o,l]=n(a),c=Array.from(Yn(t,[o],[l],!0,["point"]).point),[h,d,u,p]=s,f=(c[0]*h+c[1]*d+c[2]*u+p)/(h*h+d*d+u*u),b=[c[0]-f*h,c[1]-f*d,c[2]-f*u];return{id:`${i}[${a}]`,key:i,index:[a],label:`${i==="planes"?"plane":"bound"} ${a}`,position:b,free:ji,along:[h,d,u],tint:r}})}var Mu={quantity:"gaussian",range:"robust",percentile:2,low:-1,high:1,contours:!1,net:!0,curves:!0,directions:!1,normals:!1,combs:"off",combScale:1,comb:!0,zeroK:!1,zeroH:!1,minRadius:!1,stripes:"none",density:24,lightAzimuth:30,lightElevation:60,section:!1,sectionAzimuth:0,sectionTilt:0,sectionAt:0,clip:!1,wireframe:!1,projection:"perspective",theme:"auto",snap:!1,snapStep:1,locks:[!1,!1,!1],resolution:150},wm=["theme","projection","curves","net","resolution"],Am="quintrig:settings";function Em(){try{let i=JSON.parse(localStorage.getItem(Am)??"{}"),e=wm.filter(t=>typeof i[t]==typeof Mu[t]);return{...Mu,...Object.fromEntries(e.map(t=>[t,i[t]]))}}catch{return Mu}}function Tm(i){try{localStorage.setItem(Am,JSON.stringify(Object.fromEntries(wm.map(e=>[e,i[e]]))))}catch{}}var Jo=class{constructor(e){this.state=e}state;past=[];future=[];openings=1;gesture=null;listeners=[];subscribe(e){this.listeners.push(e)}set(e){let t=this.state;this.state={...t,...e},this.state.settings!==t.settings&&Tm(this.state.settings);for(let n of this.listeners)n(this.state,t)}setting(e){this.set({settings:{...this.state.settings,...e}})}edit(e,t=null){if(e===this.state.model)return;let n=e.patches.find(r=>!Ir(r)&&ru(r));if(n)return this.set({message:{kind:"error",text:ru(n)}});(t===null||t!==this.gesture)&&this.remember(),this.gesture=t,this.future=[],this.replace({...Yo(this.state),model:e},t!==null)}resume(e){this.remember(),this.gesture=null,this.future=[],this.replace({...e,opened:++this.openings},!1)}written(e,t,n){let r=s=>s.opened===e?{...s,saved:t,source:n??s.source}:s;this.past=this.past.map(r),this.future=this.future.map(r),this.set(r(this.state))}editPatch(e,t=null){let{model:n,patch:r}=this.state;this.edit({...n,patches:n.patches.map((s,a)=>a===r?e:s)},t)}settle(){this.gesture=null,this.state.moving&&this.set({moving:!1})}undo(){let e=this.past.pop();e&&(this.future.push(Yo(this.state)),this.gesture=null,this.replace(e,!1))}redo(){let e=this.future.pop();e&&(this.past.push(Yo(this.state)),this.gesture=null,this.replace(e,!1))}open(e,t,n=e){this.past=[],this.future=[],this.gesture=null,this.set({model:e,saved:n,source:t,patch:0,selected:null,pins:[],hover:null,kept:[],compare:"off",canUndo:!1,canRedo:!1,moving:!1,message:null,opened:++this.openings})}remember(){this.past.push(Yo(this.state)),this.past.length>500&&this.past.shift()}replace(e,t){let n=Math.min(this.state.patch,e.model.patches.length-1);this.set({...e,patch:n,moving:t,canUndo:this.past.length>0,canRedo:this.future.length>0})}},Yo=({model:i,saved:e,source:t,opened:n})=>({model:i,saved:e,source:t,opened:n}),Zo=Ue.presets.map(vt),vs=i=>(Rr(i)?Ue.shapeSets[String(pn(i).length)]:void 0)??[],Ko=i=>vt(Xh[i]),Ve=i=>i.model.patches[i.patch];var Cm=new WeakMap;function jo(i){let{model:e,saved:t,compare:n,kept:r,patch:s}=i,a={label:"",model:e,editable:!0};if(n==="before")return[{label:"before",model:t,editable:!1},{...a,label:"now"}];if(n==="kept"&&r.length)return[{...a,label:"now"},...r.map(l=>({...l,editable:!1}))];let o=vs(e.patches[s]);return n==="sets"&&o.length?o.map(l=>({label:`(${l.join(", ").replaceAll("-","−")})`,model:Ib(e,l),editable:!0})):[a]}var Qo=({compare:i},e)=>i==="before"?Math.min(1,e-1):0;function Ib(i,e){let t=n=>{if(vs(n)[0]?.length!==e.length||String(pn(n))===String(e))return n;let r=Cm.get(n)??new Map;Cm.set(n,r);let s=r.get(String(e))??{...n,shape:e};return r.set(String(e),s),s};return{...i,patches:i.patches.map(t)}}var wu=41,Rm=Array.from({length:wu},(i,e)=>e/(wu-1));function Nb(i){let e=hs(i),t=[0,1,2];if(!(e.size>0))return{low:e.low,high:e.low};let[n,r,s,a]=Ji(i),o=Rm.map(x=>n+x*(s-n)),l=Rm.map(x=>r+x*(a-r)),{point:c}=Yn(i,o,l,!1,["point"]),h=Go(i,o,l),d=!h.includes(1),u=t.map(x=>c.filter((E,w)=>w%3===x&&Number.isFinite(E)&&(d||h[(w-x)/3])).sort()),p=(x,E)=>u[x][Math.round(E*(u[x].length-1))],f=t.map(x=>p(x,0)),b=t.map(x=>p(x,1)),m=t.map(x=>p(x,.1)),g=t.map(x=>p(x,.9)),v=(x,E)=>Math.hypot(...t.map(w=>E[w]-x[w]));if(v(f,b)<=8*v(m,g))return{low:f,high:b};let M=t.map(x=>.5*(g[x]-m[x]));return{low:t.map(x=>Math.max(f[x],m[x]-M[x])),high:t.map(x=>Math.min(b[x],g[x]+M[x]))}}function Lb(i){let e=i.sample(wu).map(({point:n})=>n),t=[0,1,2];return{low:t.map(n=>Math.min(...e.map(r=>r[n]))),high:t.map(n=>Math.max(...e.map(r=>r[n])))}}function Pm(i){let e=[1/0,1/0,1/0],t=[-1/0,-1/0,-1/0];for(let n of i.flatMap(({model:r})=>r.patches))try{let r=nt(n)?Lb(St(n)):Nb(Nn(n));for(let s=0;s<3;s++)e[s]=Math.min(e[s],r.low[s]),t[s]=Math.max(t[s],r.high[s])}catch{}return e[0]<=t[0]?{low:e,high:t}:null}var Im={centre:[0,0,0],scale:1,half:[1,1,1]};function Nm(i,e){let t=.5*Math.hypot(e[0]-i[0],e[1]-i[1],e[2]-i[2]),n=t>0&&Number.isFinite(t)?1/t:1,r=a=>.5*(i[a]+e[a]),s=a=>.5*n*(e[a]-i[a]);return{centre:[r(0),r(1),r(2)],scale:n,half:[s(0),s(1),s(2)]}}var qt=(i,e)=>[(e[0]-i.centre[0])*i.scale,(e[1]-i.centre[1])*i.scale,(e[2]-i.centre[2])*i.scale],Lm=(i,e)=>[e[0]/i.scale+i.centre[0],e[1]/i.scale+i.centre[1],e[2]/i.scale+i.centre[2]];var Dm=[.38,.62],Db=2,zb=16,Fb=50;function Au(i,e,t){let{x:n,y:r}=i.project(e,t),s=i.ray(e,n,r),a=i.ray(e,n+1,r),o=Math.hypot(...t.map((l,c)=>l-s.origin[c]));return Math.hypot(...t.map((l,c)=>s.origin[c]+o*s.direction[c]-a.origin[c]-o*a.direction[c]))}function el(i,e,t,n){let r=58*Au(i,e,t),s=h=>{let{x:d,y:u}=i.project(e,t.map((p,f)=>p+r*h[f]));return[d,u]},a=(h,d)=>[0,1,2].map(u=>u===h?d:0),l=[0,1,2].filter(h=>n[h]).map(h=>({axes:[h],outline:[s(a(h,18/58)),s(a(h,1))]}));return[...[[1,2],[2,0],[0,1]].filter(h=>h.every(d=>n[d])).map(([h,d])=>({axes:[h,d],outline:[[0,0],[1,0],[1,1],[0,1]].map(([u,p])=>s([0,1,2].map(f=>f===h?Dm[u]:f===d?Dm[p]:0)))})).filter(({outline:h})=>Math.abs(Ob(h))>Fb),...l.filter(({outline:[h,d]})=>Math.hypot(d[0]-h[0],d[1]-h[1])>zb)]}function zm(i,e,t,n){let r=s=>i.findLast(({outline:[a,o,...l]})=>!l.length&&Ub(a,o,e,t)<s);return r(Db)??i.findLast(({outline:s})=>s.length>2&&kb(s,e,t))??r(n)??null}var Ob=i=>.5*i.reduce((e,[t,n],r)=>e+t*i[(r+1)%i.length][1]-n*i[(r+1)%i.length][0],0);function Ub([i,e],[t,n],r,s){let a=t-i,o=n-e,l=Math.min(1,Math.max(0,((r-i)*a+(s-e)*o)/(a*a+o*o)));return Math.hypot(r-i-l*a,s-e-l*o)}function kb(i,e,t){let n=i.map(([r,s],a)=>{let[o,l]=i[(a+1)%i.length];return Math.sign((o-r)*(t-s)-(l-s)*(e-r))});return n.every(r=>r>=0)||n.every(r=>r<=0)}var Bb=0,qb=i=>`${i}-${++Bb}`,tl=new WeakSet,Fr=i=>tl.has(i);function nl(i,e){i.addEventListener("input",()=>tl.add(i)),i.addEventListener("change",()=>tl.delete(i));let t=()=>{tl.delete(i),e()};i.addEventListener("blur",t),i.addEventListener("keydown",n=>{n.key!=="Escape"||!Fr(i)||(n.stopPropagation(),t())})}function Fm(i,e,t){i.classList.toggle("wrong",!e),i.title=e?"":`${i.value||"That"} was not taken: expected ${t}`}function Jn(i){let{min:e,max:t}=i,{step:n}=i,r=qb("slider"),s=f=>`${100*(Math.min(t,Math.max(e,f))-e)/(t-e)}%`,a=T("input",{type:"range",id:r,min:e,max:t,step:n,"aria-label":i.name}),o=T("input",{type:"number",class:"number",step:n,"aria-label":`${i.name}, number`,...i.hard&&!i.allowed?{min:e,max:t}:{}}),l=T("div",{class:"track"}),c=NaN,h=()=>{o.value=Number.isNaN(c)?"":String(Number(c.toPrecision(8)))};nl(o,h),a.addEventListener("input",()=>{u(Number(a.value)),i.onInput(Number(a.value))}),a.addEventListener("change",()=>i.onSettle?.()),o.addEventListener("change",()=>{let f=pu(o),b=i.allowed?.holds(f)??(f>=e&&f<=t),m=Number.isFinite(f)&&(!i.hard||b);if(Fm(o,m,i.hard?i.allowed?.words??`a number from ${e} to ${t}`:"a number"),!m||f===c)return h();c=f,h(),i.onInput(f),i.onSettle?.()});let d=(i.marks??[]).map(f=>{let b=T("span",{class:"mark"},String(f).replace("-","−"));return b.style.left=s(f),b}),u=f=>{l.style.setProperty("--share",s(f)),l.style.setProperty("--zero",s(0))};return{element:T("div",{class:"slider"},T("label",{for:r,class:"symbol"},i.label),T("div",{class:"range"},l,a,T("div",{class:"marks","aria-hidden":"true"},...d)),o),update(f){a.value=String(f),c=f,u(f),!Fr(o)&&(h(),o.classList.remove("wrong"))},bounds(f,b,m){e=f,t=b,Object.assign(a,{min:String(f),max:String(b),step:String(m)}),o.step=String(m)}}}function hi(i){let e=T("input",{type:"number",class:"number",step:i.step??"any","aria-label":i.name}),t=NaN,n=()=>{e.value=Number.isNaN(t)?"":String(Number(t.toPrecision(10)))};return nl(e,n),e.addEventListener("change",()=>{let s=pu(e),a=Number.isFinite(s)&&Math.abs(s)<=1e50&&(!i.positive||s>0);if(Fm(e,a,i.positive?"a number greater than 0":"a number"),!a||s===t)return n();t=s,n(),i.onChange(s)}),{element:T("label",{class:"field"},T("span",{},i.label),e),update(s){t=s,!Fr(e)&&(e.disabled=Number.isNaN(s),n(),e.classList.remove("wrong"))}}}function ln(i,e,t,n=""){let r=T("input",{type:"checkbox",class:"switch"});return r.addEventListener("change",()=>e(r.checked)),{element:T("label",{class:"toggle",title:n||!1},r,T("span",{},i),t),update:a=>{r.checked=a}}}function gn(i,e,t){let n=e.map(s=>{let a=T("button",{type:"button",role:"radio",class:"segment",title:s.title??!1,"data-value":s.value},s.label);return a.addEventListener("click",()=>t(s.value)),a}),r=T("div",{class:"segmented",role:"radiogroup","aria-label":i},...n);return r.addEventListener("keydown",s=>{let a={ArrowRight:1,ArrowDown:1,ArrowLeft:-1,ArrowUp:-1}[s.key],o=n.indexOf(s.target);if(!a||o<0)return;s.preventDefault(),s.stopPropagation();let l=(o+a+n.length)%n.length;n[l].focus(),t(e[l].value)}),{element:r,update(s){n.forEach((a,o)=>{let l=e[o].value===s;a.setAttribute("aria-checked",String(l)),a.tabIndex=l||o===0&&!e.some(c=>c.value===s)?0:-1})}}}function Or(i,e,t){let n=s=>s.options.map(a=>T("option",{value:a.value},a.label)),r=T("select",{"aria-label":i},...e.flatMap(s=>s.label?[T("optgroup",{label:s.label},...n(s))]:n(s)));return r.addEventListener("change",()=>t(r.value)),{element:r,update:s=>{r.value=s}}}function Qe(i,e,t,n="button"){return T("button",{type:"button",class:n,title:e,"aria-label":e,on:{click:t}},i)}function ya(i,e,t,n="button",r){let s=T("div",{class:"menu",role:"menu","aria-label":e,hidden:!0}),a=T("button",{type:"button",class:n,title:e,"aria-label":e,"aria-haspopup":"menu","aria-expanded":"false"},i),o=T("div",{class:"menu-box"},a,s),l=d=>{s.hidden=!0,a.setAttribute("aria-expanded","false"),d&&a.focus()},c=()=>{s.replaceChildren(...t().map(d=>{if(typeof d=="string")return T("div",{class:"menu-title",role:"presentation"},d);let u=d.reason?T("small",{class:"reason"},d.reason.split(/[:;]\s/)[0]):d.hint?T("small",{},d.hint):null,p=T("button",{type:"button",role:"menuitem",class:"menu-item",title:d.reason??"",disabled:d.disabled??!1},T("span",{},d.label),u);return p.addEventListener("click",()=>{l(!0),d.act()}),p}))},h=()=>{s.hidden=!1,a.setAttribute("aria-expanded","true"),c(),r?.().then(p=>{if(!p||s.hidden)return;let f=[...s.children].indexOf(s.querySelector(":focus"));a.focus(),c(),s.children[f]?.focus()});let d=s.getBoundingClientRect().right,u=o.closest(".studio").getBoundingClientRect().right;s.classList.toggle("to-left",d>u-8),s.querySelector("[role=menuitem]:not([disabled])")?.focus()};return a.addEventListener("click",()=>s.hidden?h():l(!1)),o.addEventListener("focusout",d=>{o.contains(d.relatedTarget)||l(!1)}),o.addEventListener("keydown",d=>{if(s.hidden)return;let u=[...s.querySelectorAll("[role=menuitem]:not([disabled])")],p=u.indexOf(d.target);d.stopPropagation(),d.key==="Escape"?l(!0):(d.key==="ArrowDown"||d.key==="ArrowUp")&&(d.preventDefault(),u[(p+(d.key==="ArrowDown"?1:-1)+u.length)%u.length]?.focus())}),o}function ui(i,e,...t){return T("details",{class:"section",open:e},T("summary",{},i),T("div",{class:"section-body"},...t))}function He(i,e=4){if(Number.isNaN(i))return"undefined";if(!Number.isFinite(i))return i>0?"∞":"−∞";if(i===0)return"0";let t=Math.abs(i);return(t>=1e5||t<.001?Vb(i,e):String(Number(i.toPrecision(e)))).replace("-","−")}function Vb(i,e){let[t,n]=i.toExponential(e-1).split("e");return`${Number(t)}·10${Eu(Number(n))}`}var Om=i=>!(i>0)||!Number.isFinite(i)||i>=.01&&i<1e4?0:3*Math.floor(Math.log10(i)/3),Eu=i=>String(i).replace(/[-\d]/g,e=>e==="-"?"⁻":"⁰¹²³⁴⁵⁶⁷⁸⁹"[Number(e)]),Tu=i=>i>0&&i<.001?"<0.1 %":`${He(100*i,i<.1?2:3)} %`,Rt=i=>i.charAt(0).toUpperCase()+i.slice(1),Um={alpha:"α",beta:"β",gamma:"γ",delta:"δ",zeta:"ζ",theta:"θ",kappa:"κ",lam:"λ",lambda:"λ",mu:"μ",nu:"ν",rho:"ρ",sigma:"σ",tau:"τ",phi:"φ",omega:"ω"};function Cu(i){let e=i.replace(/[\d_]+$/,"");return[e,i.slice(e.length).replaceAll("_",",")]}function km(i){let[e,t]=Cu(i),n=Qi("span","","math");return n.append(Qi("i",Um[e]??e),...t?[Qi("sub",t)]:[]),n}function Ai(i){let e=document.createElement("span");e.className="math";let t=i.replace(/\\mathrm\{([^}]*)\}/g,"«$1»").replace(/\\mathbf\{([^}]*)\}/g,"‹$1›").replace(/\\,/g," "),n=/«([^»]*)»|‹([^›]*)›|\\([a-z]+)|([_^])(?:\{([^}]*)\}|(.))|([^\\_^])/g;for(let[,r,s,a,o,l,c,h]of t.matchAll(n))r!==void 0?e.append(Qi("span",r,"roman")):s!==void 0?e.append(Qi("b",s)):a!==void 0?e.append(Qi("i",Um[a]??a)):o?e.append(Qi(o==="_"?"sub":"sup",l??c??"")):h&&e.append(/[A-Za-z]/.test(h)?Qi("i",h):h);return e}function Qi(i,e,t=""){let n=document.createElement(i);return n.textContent=e,t&&(n.className=t),n}function il(i,e,t=5){return i.colour==="classes"?i.classes[e]??"undefined":He(e,t)}var di=(i,e)=>Ho(i,e);var Hb={4:["α1","ζ1","α2","ζ2"],2:["α","ζ"]},Gb=new Set(["name","kind","shape"]);function Pu(i,e){let t=e.patches.length>1,n=[];return i.unit!==e.unit&&n.push(`unit ${i.unit||"none"} → ${e.unit||"none"}`),i.patches.length!==e.patches.length&&n.push(`${i.patches.length} → ${e.patches.length} patches`),e.patches.forEach((r,s)=>{let a=i.patches[s];!a||a===r||n.push(...Wb(a,r,e.unit).map(o=>t?`${r.name}: ${o}`:o))}),n}function Wb(i,e,t){if(i.kind!==e.kind)return[`${i.kind} → ${e.kind}`.replaceAll("_"," ")];let n=pn(i),r=pn(e).flatMap((s,a)=>s===n[a]?[]:[`${Hb[n.length]?.[a]??`shape ${a}`} ${He(n[a]??NaN)} → ${He(s)}`]);for(let s of new Set([...Object.keys(i),...Object.keys(e)])){let a=Pe(i,s),o=Pe(e,s);Gb.has(s)||JSON.stringify(a)===JSON.stringify(o)||(typeof a=="number"&&typeof o=="number"?r.push(`${s} ${He(a)} → ${He(o)}`):Array.isArray(a)&&Array.isArray(o)?r.push($b(s,Ru(a),Ru(o),t)):r.push(`${s} ${String(a)} → ${String(o)}`))}return r}function $b(i,e,t,n){if(e.length!==t.length)return`${i}: ${e.length} → ${t.length} points`;let r=t.map((l,c)=>Math.hypot(...l.map((h,d)=>h-(e[c][d]??0)))),s=r.filter(l=>l>0).length,a=He(Math.max(...r)),o=i==="planes"||i==="bounds"?"":n&&` ${n}`;return`${i}: ${s} of ${t.length} moved, by ${s>1?"up to ":""}${a}${o}`}var Ru=i=>i.every(e=>typeof e=="number")?[i]:i.flatMap(e=>Array.isArray(e)?Ru(e):[]);function Zn(i,e,t,n){return new Promise(r=>{let s=T("dialog",{"aria-label":e}),a=l=>{s.close(),s.remove(),r(l)},o=T("form",{method:"dialog"},T("h2",{},e),T("div",{class:"dialog-body"},...t),T("div",{class:"dialog-buttons"},...n.map(([l,c],h)=>Qe(c,c,()=>a(l),h===0?"button primary":"button"))));o.addEventListener("submit",l=>{l.preventDefault(),a(n[0]?.[0]??null)}),s.addEventListener("cancel",l=>{l.preventDefault(),a(null)}),s.addEventListener("keydown",l=>l.stopPropagation()),s.append(o),i.append(s),s.showModal(),(o.querySelector("input")??o.querySelector(".primary"))?.focus()})}async function Bm(i,e,t){let n=T("input",{type:"text",value:t,"aria-label":"File name",spellcheck:"false"});return await Zn(i,e,[T("label",{class:"field wide"},T("span",{},"File name"),n),T("p",{class:"hint"},"Ends in .toml or .json; saved in the folder that the studio was opened on.")],[["save","Save"],["cancel","Cancel"]])==="save"?n.value.trim():null}async function qm(i,e,t,n){let r=T("input",{type:"number",class:"number",min:0,step:"any",placeholder:"usual","aria-label":`Tolerance${t?` in ${t}`:""}`}),s=[T("label",{class:"field wide"},T("span",{},`Tolerance${t?` (${t})`:""}`),r),T("p",{class:"hint"},"How far the file may be from the surface. Left empty: a mesh keeps to a thousandth of its size, a flat pattern to what a cutter can do."),...n?[T("p",{class:"hint"},`Colours as shown: ${n}, where the format has colours.`)]:[]];for(;;){if(await Zn(i,`Export ${e}`,s,[["export","Export"],["cancel","Cancel"]])!=="export")return null;if(!r.value&&r.validity.valid)return{tolerance:null};let o=Number(r.value);if(r.validity.valid&&o>0&&o<1/0)return{tolerance:o};s.some(l=>l.classList.contains("error"))||s.push(T("p",{class:"hint error",role:"alert"},"Expected a length greater than 0, or nothing."))}}async function Vm(i,e,t){let n=(p,f)=>T("input",{type:"number",class:"number",min:64,max:8192,step:1,value:f,"aria-label":p}),r=n("Width in pixels",Math.round(e)),s=n("Height in pixels",Math.round(t)),a=(p,f)=>{r.value=String(p),s.value=String(f)},o=T("div",{class:"chips"},Qe("1920 × 1080","1920 × 1080",()=>a(1920,1080),"chip"),Qe("3840 × 2160","3840 × 2160",()=>a(3840,2160),"chip"),Qe("2000 × 2000","2000 × 2000",()=>a(2e3,2e3),"chip")),l=T("select",{"aria-label":"Background"},T("option",{value:"theme"},"As shown"),T("option",{value:"white"},"White"),T("option",{value:"none"},"Transparent")),c=!0,h=ln("With legend",p=>c=p);if(h.update(!0),await Zn(i,"Save a picture",[T("div",{class:"pair"},T("label",{class:"field"},T("span",{},"Width"),r),T("label",{class:"field"},T("span",{},"Height"),s)),o,T("label",{class:"row"},T("span",{class:"caption"},"Background"),l),h.element],[["save","Save PNG"],["cancel","Cancel"]])!=="save")return null;let u=(p,f)=>Math.min(8192,Math.max(64,Math.round(Number(p.value))||f));return{width:u(r,e),height:u(s,t),background:l.value,legend:c}}var Xb=[["Ctrl Z, Ctrl Shift Z","undo, redo"],["Ctrl S, Ctrl O","save, open"],["1 to 6","views: oblique, top, side, back, front, bottom"],["P","perspective or parallel"],["F","fit"],["N","control net"],["I","iso-curves"],["W","wireframe"],["Z","zebra"],["C","compare: next arrangement"],["arrows","turn the view, or move the chosen point by the snap step"],["Shift arrows","pan, or move by ten steps"],["+ −","zoom"],["[ ]","choose the control point before or after"],["Esc","let go of the point"],["Enter","pin the point in the middle of the picture"]],Iu=i=>Zn(i,"Keys and pointer",[T("p",{},"Drag to turn, with Shift or the right button to pan, wheel to zoom; on a screen to touch, two fingers pan and zoom. Drag a control point to move it. Click the surface to pin a point."),T("dl",{class:"keys-list"},...Xb.flatMap(([e,t])=>[T("dt",{},e),T("dd",{},t)])),T("p",{class:"hint"},"Grey is where a quantity has no value. The signs of H, κ1, κ2 and S follow the normal; the bar at the bottom says which way it points.")],[["close","Close"]]);var Nu=5,Lu=2;function Du(i){let{model:e,kept:t}=i.state;if(t.length>=Nu)return i.set({compare:"kept",message:{kind:"note",text:`${Nu} are kept already: delete one first`}});let n=new Set(t.map(s=>s.label)),r=Array.from({length:Nu+1},(s,a)=>a+1).find(s=>!n.has(`kept ${s}`));i.set({kept:[...t,{label:`kept ${r}`,model:e}],compare:"kept"})}function zu(i,e){let t=Pu(i.kept[e].model,i.model);return t.length?`now: ${t.slice(0,Lu).join("; ")}${t.length>Lu?`; ${t.length-Lu} more`:""}`:"same as now"}function Hm(i,e){let{label:t,model:n}=i.state.kept[e],r=Pu(n,i.state.model).join(`
`),s=()=>i.state.kept.findIndex(l=>l.model===n&&l.label===t),a=l=>i.set({kept:i.state.kept.flatMap((c,h)=>h===s()?l(c):[c])}),o=T("div",{class:"kept"},T("div",{class:"kept-tools"},Qe("Restore",`Restore ${t}`,()=>i.edit(n),"button"),Qe("Rename",`Rename ${t}`,()=>{Yb(o.closest(".studio"),t).then(l=>l&&a(c=>[{...c,label:l}]))},"button"),Qe("Delete",`Delete ${t}`,()=>{a(()=>[]),i.state.kept.length||i.set({compare:"off"})},"button")),T("div",{class:"differs",title:r||!1},zu(i.state,e)));return o}async function Yb(i,e){let t=T("input",{type:"text",value:e,maxlength:60,"aria-label":"Name of the variant"});return await Zn(i,"Rename",[T("label",{class:"field wide"},T("span",{},"Name"),t)],[["rename","Rename"],["cancel","Cancel"]])==="rename"?t.value.trim():""}var Jb=["gaussian","mean","k1","k2","shape_index","curvedness","hk_type","shape_class","point_type"];function va(i,e){return Yn(Nn(i.patches[e.patch]),[e.u],[e.v],!0)}var Gm=(i,{patch:e,u:t,v:n})=>gs(Nn(i.patches[e]),t,n);function Fu(i,e,t=0){let n=i[e.key][t];return e.colour==="classes"||e.power>=0?n:Math.abs(n)<=Ue.limits.noise*i.curvedness[0]**-e.power?0:n}var Zb=(i,e)=>`normal ${cs(Nn(i))} S_u x S_v${e?` on ${i.name.replaceAll(`
`," ")}`:""}`,rl=i=>i.pins.filter(({patch:e})=>e<i.model.patches.length&&nt(i.model.patches[e])===nt(Ve(i))),sl=class{constructor(e,t){this.store=e;this.unfolded=t;let n=hi({label:this.first,name:"u to pin",step:.05,onChange:o=>this.u=Math.min(1,Math.max(0,o))}),r=hi({label:T("i",{class:"math"},"v"),name:"v to pin",step:.05,onChange:o=>this.v=Math.min(1,Math.max(0,o))});n.update(this.u),r.update(this.v);let s=ln("All quantities",o=>{this.all=o,this.refresh(e.state)});this.surfaces=[r.element,s.element];let a=T("div",{class:"probe-tools"},n.element,r.element,Qe("Pin","Pin the point at these parameters",()=>this.add()),s.element,T("span",{class:"spacer"}),Qe("CSV","Save the table as CSV",()=>this.save()),Qe("Clear","Clear: remove all pins",()=>e.set({pins:[]})));this.element=T("details",{class:"probe"},T("summary",{},xt(Mt.pin),"Probe",this.count,this.hint),a,this.body),this.element.addEventListener("toggle",()=>this.unfolded()),this.suit(e.state),e.subscribe((o,l)=>{(o.model!==l.model||o.patch!==l.patch)&&this.suit(o),o.pins.length>l.pins.length&&(this.element.open=!0),(o.pins!==l.pins||(o.model!==l.model||o.patch!==l.patch)&&o.pins.length)&&this.refresh(o)})}store;unfolded;element;body=T("div",{class:"probe-body"});count=T("span",{class:"badge"});surfaces;hint=T("span",{class:"hint"});first=T("span",{},T("i",{class:"math"},"u"));all=!1;u=.5;v=.5;suit(e){let t=nt(Ve(e));for(let n of this.surfaces)n.hidden=t;this.hint.textContent=`click the ${t?"curve":"surface"} to pin a point`,this.first.replaceChildren(T("i",{class:"math"},t?"t":"u"))}add(){let{pins:e,patch:t}=this.store.state;this.store.set({pins:[...e,{patch:t,u:this.u,v:this.v}]})}curves({model:e},t){let n=t.every(l=>St(e.patches[l.patch]).flat),r=e.unit?`1/${e.unit}`:"",s=["x","y",...n?[]:["z"]].map(l=>[l,e.unit]),a=[["t",""],...s,["κ",r],["1/κ",e.unit],...n?[]:[["τ",r]]],o=t.map(l=>{let{t:c,point:h,curvature:d,torsion:u}=St(e.patches[l.patch]).at(l.u);return[c,...h.slice(0,n?2:3),d,1/d,...n?[]:[u]]});return{heads:a,rows:o}}showCurves(e){let t=rl(e),{heads:n,rows:r}=this.curves(e,t),s=e.model.patches.length>1,a=T("tr",{},T("th",{},"#"),s?T("th",{},"curve"):null,...n.map(([l,c])=>T("th",{},T("i",{class:"math"},l),c?T("span",{class:"unit"},c):null)),T("th",{})),o=r.map((l,c)=>T("tr",{},T("td",{},T("span",{class:"pin-number"},c+1)),s?T("td",{},e.model.patches[t[c].patch].name):null,...l.map(h=>T("td",{},He(h))),T("td",{},this.remover(t[c],c))));this.body.replaceChildren(T("table",{},T("thead",{},a),T("tbody",{},...o)))}remover(e,t){return Qe(xt(Mt.close),`Remove pin ${t+1}`,()=>this.store.set({pins:this.store.state.pins.filter(n=>n!==e)}),"tiny")}columns(){return(this.all?ci.map(t=>t.key):["point",...Jb]).flatMap(t=>{let n=lt[t];return n.components===1?[{q:n,part:0,head:n.symbol}]:["x","y","z"].map((r,s)=>({q:n,part:s,head:t==="point"?r:`${n.symbol} ${r}`}))})}refresh(e){if(this.count.textContent=e.pins.length?String(e.pins.length):"",!e.pins.length){this.body.replaceChildren();return}if(nt(Ve(e)))return this.showCurves(e);let t=e.model.patches.length>1,n=this.columns(),r=T("tr",{},T("th",{},"#"),t?T("th",{},"patch"):null,T("th",{},T("i",{class:"math"},"u")),T("th",{},T("i",{class:"math"},"v")),...n.map(({q:a,head:o})=>T("th",{title:Rt(a.name)},a.components===1?a.colour==="classes"?Rt(a.name):Ai(a.latex):T("i",{class:"math"},o),di(a,e.model.unit)?T("span",{class:"unit"},di(a,e.model.unit)):null)),T("th",{})),s=rl(e).map((a,o)=>{let l=va(e.model,a);return T("tr",{},T("td",{},T("span",{class:"pin-number"},o+1)),t?T("td",{},e.model.patches[a.patch].name):null,T("td",{},He(a.u)),T("td",{},He(a.v)),...Gm(e.model,a)?n.map(({q:c,part:h})=>T("td",{class:c.colour==="classes"?"word":""},il(c,Fu(l,c,h)))):[T("td",{class:"word",colspan:n.length},"outside the trimmed face")],T("td",{},this.remover(a,o)))});this.body.replaceChildren(T("table",{},T("thead",{},r),T("tbody",{},...s)))}save(){let{model:e}=this.store.state,t=rl(this.store.state);if(nt(Ve(this.store.state)))return this.saveCurves();let n=ci.flatMap(c=>Array.from({length:c.components},(h,d)=>({q:c,part:d}))),r=({q:c,part:h})=>c.components===1?c.key:`${c.key}_${"xyz"[h]}`,s=n.map(({q:c})=>[c.key,di(c,e.unit)]).filter(([,c])=>c),a=c=>c.replaceAll(/(^|[,;])(\s*)(?=[=+\-@])/g,"$1$2'"),o=c=>/[",\n]/.test(c)?`"${c.replaceAll('"','""')}"`:c,l=[`# ${a(e.name.replaceAll(`
`," "))}: ${[...new Set(t.map(c=>c.patch))].map(c=>Zb(e.patches[c],e.patches.length>1)).join(", ")}`,...s.length?[`# Units: ${[...new Map(s)].map(([c,h])=>`${c} in ${h}`).join(", ")}`]:[],["patch","u","v",...n.map(r)].join(","),...t.map(c=>{let h=va(e,c),d=Gm(e,c),u=({q:p,part:f})=>{let b=h[p.key][f];return d?p.colour==="classes"?o(p.classes[b]):Number.isNaN(b)?"":String(b):""};return[o(a(e.patches[c.patch].name)),c.u,c.v,...n.map(u)].join(",")})];$n(`${Xn(e.name)}_probe.csv`,`${l.join(`
`)}
`,"text/csv")}saveCurves(){let{model:e}=this.store.state,t=rl(this.store.state),{heads:n,rows:r}=this.curves(this.store.state,t),s=[["curve",...n.map(([a,o])=>o?`${a} (${o})`:a)].join(","),...r.map((a,o)=>[JSON.stringify(e.patches[t[o].patch].name.replace(/^[=+\-@]/,"'$&")),...a.map(l=>Number.isNaN(l)?"":l)].join(","))];$n(`${Xn(e.name)}_probe.csv`,`${s.join(`
`)}
`,"text/csv")}};var xa="http://www.w3.org/2000/svg",Ou=["x","y","z"];function Kb(i,e,t){let{flat:n}=St(i),r=St(i).at(e),s=t?`1/${t}`:"",a=(o,l,c)=>T("tr",{},T("th",{},T("i",{class:"math"},o)),T("td",{},l,c?T("span",{class:"unit"},c):null));return[T("div",{class:"tip-title"},`t = ${He(e)}`),T("div",{class:"tip-point"},`(${r.point.slice(0,n?2:3).map(o=>He(o)).join(", ")})${t?` ${t}`:""}`),T("table",{},a("κ",He(r.curvature),s),a("1/κ",He(1/r.curvature),t),n?null:a("τ",He(r.torsion),s))]}var al=class{constructor(e,t,n){this.store=e;this.stage=t;let r=(s,a,o)=>Qe(a,o,()=>n.view(s),"button view-button");this.projection=gn("Projection",[{value:"perspective",label:"Perspective"},{value:"orthographic",label:"Parallel",title:"Orthographic: lengths in the plane of the picture are true"}],s=>{this.stage.orbit.straight=!1,e.setting({projection:s})}),this.triad.setAttribute("viewBox","-32 -32 64 64"),this.triad.setAttribute("class","triad"),this.triad.setAttribute("aria-hidden","true"),this.gizmo.setAttribute("class","gizmo"),this.gizmo.setAttribute("aria-hidden","true"),this.element.append(this.cells,this.gizmo,this.marks,this.tip,this.triad,T("div",{class:"view-tools",role:"toolbar","aria-label":"View"},r("iso","Oblique","Oblique view (1)"),r("top","Top","Top view, along −z (2)"),r("side","Side","Side view, along +y (3)"),r("back","Back","Back view, along −x (4)"),r("front","Front","Front view, along +x (5)"),r("bottom","Bottom","Bottom view, along +z (6)"),Qe(xt(Mt.fit),"Fit (F)",n.fit,"button square"),this.projection.element))}store;stage;element=T("div",{class:"hud"});cells=T("div",{class:"cells"});marks=T("div",{class:"marks-layer"});tip=T("div",{class:"tip",hidden:!0,role:"status"});triad=document.createElementNS(xa,"svg");gizmo=document.createElementNS(xa,"svg");projection;named="";labels(e,t){let n=t.compare==="kept"&&e.length>1?1:e.length,{cells:r}=this.stage,s=JSON.stringify(r.map((a,o)=>[e[o],a.x,a.y,a.width,a.height,o>=n&&zu(t,o-n)]));s!==this.named&&(this.named=s,this.cells.replaceChildren(...r.map((a,o)=>{let l=T("div",{class:"cell"},e[o]?T("span",{class:"cell-label"},e[o]):null,o>=n?Hm(this.store,o-n):null);return Object.assign(l.style,{left:`${a.x}px`,top:`${a.y}px`,width:`${a.width}px`,height:`${a.height}px`}),l})))}refresh(e,t,n){this.projection.update(this.stage.orbit.projection),this.drawTriad();let r=[],s=(l,c,h)=>{let d=this.stage.project(l,qt(t,c)),u=this.stage.cells[l];d.x<u.x||d.x>u.x+u.width||d.y<u.y||d.y>u.y+u.height||(r.length<8&&!e.moving&&h.classList.toggle("behind",this.stage.hides(l,qt(t,c),e.settings,t)),h.style.transform=`translate(${d.x.toFixed(1)}px, ${d.y.toFixed(1)}px)`,r.push(h))},a=Qo(e,this.stage.cells.length);this.drawGizmo(e,t,a),e.pins.forEach((l,c)=>{let h=e.model.patches[l.patch];h&&s(a,nt(h)?St(h).at(l.u).point:Array.from(va(e.model,l).point),T("span",{class:"pin"},T("b",{},c+1)))});let o=e.model.unit?` ${e.model.unit}`:"";for(let{cell:l,at:c}of n)s(l,c.point,T("span",{class:"sharpest"},T("b",{},"r",T("sub",{},"min"),` = ${He(c.radius)}${o}`)));this.marks.replaceChildren(...r),this.showTip(e)}drawGizmo(e,t,n){let r=e.settings.net&&mn(Ve(e)).find(a=>a.id===e.selected),s=r&&!r.along?el(this.stage,n,qt(t,r.position),r.free.map((a,o)=>a&&!e.settings.locks[o])):[];this.gizmo.replaceChildren(...s.map(({axes:a,outline:o})=>{let l=document.createElementNS(xa,"polygon");return l.setAttribute("points",o.map(c=>c.map(h=>h.toFixed(1)).join(",")).join(" ")),l.setAttribute("class",a.length===1?`arm axis-${Ou[a[0]]}`:`square axis-${Ou[3-a[0]-a[1]]}`),l}))}showTip(e){let{hover:t}=e;if(!t||t.patch>=e.model.patches.length)return void(this.tip.hidden=!0);let n=this.stage.cells[t.cell]?.pieces[t.patch];if(!n?.patch)return void(this.tip.hidden=!0);if(nt(n.patch))return this.tell(t,Kb(n.patch,t.u,e.model.unit));let r=va({...e.model,patches:[n.patch]},{...t,patch:0}),s=[...new Set([e.settings.quantity==="none"?"gaussian":e.settings.quantity,"gaussian","mean","hk_type","shape_class"])],a=(l,c,h="")=>T("tr",{},T("th",{},l),T("td",{},c,h?T("span",{class:"unit"},h):null)),o=r.point;this.tell(t,[T("div",{class:"tip-title"},`u = ${He(t.u)}, v = ${He(t.v)}`),T("div",{class:"tip-point"},`(${Array.from(o,l=>He(l)).join(", ")})${e.model.unit?` ${e.model.unit}`:""}`),T("table",{},...s.map(l=>{let c=lt[l];return a(c.colour==="classes"?c.name:Ai(c.latex),il(c,Fu(r,c)),di(c,e.model.unit))})),T("div",{class:"tip-words"},Vo("hk_type",r.hk_type[0]))])}tell(e,t){this.tip.replaceChildren(...t),this.tip.hidden=!1;let n=this.element.getBoundingClientRect(),r=this.tip.getBoundingClientRect(),s=e.x+18+r.width>n.width?e.x-18-r.width:e.x+18,a=Math.min(Math.max(6,e.y+14),n.height-r.height-6);this.tip.style.transform=`translate(${Math.round(s)}px, ${Math.round(a)}px)`}drawTriad(){let{right:e,up:t,towards:n}=this.stage.orbit.axes(),r=Ou.map((s,a)=>{let o=l=>[l.x,l.y,l.z][a];return{name:s,x:20*o(e),y:-20*o(t),depth:o(n)}}).sort((s,a)=>s.depth-a.depth);this.triad.replaceChildren(...r.flatMap(({name:s,x:a,y:o})=>{let l=document.createElementNS(xa,"line"),c=document.createElementNS(xa,"text");return l.setAttribute("x2",String(a)),l.setAttribute("y2",String(o)),l.setAttribute("class",`axis-${s}`),c.setAttribute("x",String(a*1.32)),c.setAttribute("y",String(o*1.32)),c.textContent=s,[l,c]}))}};var m0=0,dd=1,g0=2;var Xa=1,b0=2,Gs=3,dr=0,en=1,Fn=2,Wr=0,Ws=1,pd=2,fd=3,md=4,y0=5;var $r=100,v0=101,x0=102,_0=103,S0=104,M0=200,w0=201,A0=202,E0=203,gd=204,bd=205,T0=206,C0=207,R0=208,P0=209,I0=210,N0=211,L0=212,D0=213,z0=214,Il=0,Nl=1,Ll=2,Ds=3,Dl=4,zl=5,zs=6,Fl=7,yd=0,F0=1,O0=2,bi=0,vd=1,xd=2,_d=3,Sd=4,Md=5,wd=6,Ad=7;var Ed=300,Xr=301,$s=302,lc=303,cc=304,Ol=1e3,fi=1001,Ul=1002,Et=1003,U0=1004;var Ya=1005;var Ft=1006,hc=1007;var zi=1008;var tn=1009,Td=1010,Cd=1011,Xs=1012,uc=1013,ti=1014,Mn=1015,ni=1016,dc=1017,pc=1018,Yr=1020,Rd=35902,Pd=35899,Id=1021,Nd=1022,wn=1023,Li=1026,Fi=1027,Ja=1028,fc=1029,pr=1030,mc=1031;var gc=1033,Za=33776,Ka=33777,ja=33778,Qa=33779,bc=35840,yc=35841,vc=35842,xc=35843,_c=36196,Sc=37492,Mc=37496,wc=37488,Ac=37489,eo=37490,Ec=37491,Tc=37808,Cc=37809,Rc=37810,Pc=37811,Ic=37812,Nc=37813,Lc=37814,Dc=37815,zc=37816,Fc=37817,Oc=37818,Uc=37819,kc=37820,Bc=37821,qc=36492,Vc=36494,Hc=36495,Gc=36283,Wc=36284,to=36285,$c=36286;var Ea=2300,kl=2301,Rl=2302,sd=2303,ad=2400,od=2401,ld=2402;var k0=3200;var Ld=0,B0=1,Oi="",vn="srgb",Ta="srgb-linear",Ca="linear",at="srgb";var Pl=7680;var q0=519,V0=512,H0=513,G0=514,Dd=515,W0=516,$0=517,zd=518,Fd=519,Od=35044,Ys=35048;var Ui="300 es",Dn=2e3,Ra=2001;function jb(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function Qb(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function Pa(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function X0(){let i=Pa("canvas");return i.style.display="block",i}var Wm={},Fs=null;function Ia(...i){let e="THREE."+i.shift();Fs?Fs("log",e,...i):console.log(e,...i)}function Y0(i){let e=i[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=i[1];t&&t.isStackTrace?i[0]+=" "+t.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function Ne(...i){i=Y0(i);let e="THREE."+i.shift();if(Fs)Fs("warn",e,...i);else{let t=i[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...i)}}function De(...i){i=Y0(i);let e="THREE."+i.shift();if(Fs)Fs("error",e,...i);else{let t=i[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...i)}}function Aa(...i){let e=i.join(" ");e in Wm||(Wm[e]=!0,Ne(...i))}function J0(i,e,t){return new Promise(function(n,r){function s(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:r();break;case i.TIMEOUT_EXPIRED:setTimeout(s,t);break;default:n()}}setTimeout(s,t)})}var Z0={[Il]:Il,[Ll]:zs,[Dl]:Dl,[Ds]:zl,[Nl]:Nl,[zs]:Ll,[Fl]:Fl,[zl]:Ds},mi=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let r=n[e];if(r!==void 0){let s=r.indexOf(t);s!==-1&&r.splice(s,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let r=n.slice(0);for(let s=0,a=r.length;s<a;s++)r[s].call(this,e);e.target=null}}},Wt=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var Uu=Math.PI/180,Bl=180/Math.PI;function Jr(){let i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(Wt[i&255]+Wt[i>>8&255]+Wt[i>>16&255]+Wt[i>>24&255]+"-"+Wt[e&255]+Wt[e>>8&255]+"-"+Wt[e>>16&15|64]+Wt[e>>24&255]+"-"+Wt[t&63|128]+Wt[t>>8&255]+"-"+Wt[t>>16&255]+Wt[t>>24&255]+Wt[n&255]+Wt[n>>8&255]+Wt[n>>16&255]+Wt[n>>24&255]).toLowerCase()}function je(i,e,t){return Math.max(e,Math.min(t,i))}function ey(i,e){return(i%e+e)%e}function ku(i,e,t){return(1-t)*i+t*e}function K0(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function Xc(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function j0(i,e){if(e.constructor===Float32Array)return i;let t=Xc(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/t,-1)}function Q0(i,e){if(e.constructor===Float32Array)return i;let t=Xc(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*t)}var $e=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6],this.y=r[1]*t+r[4]*n+r[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=je(this.x,e.x,t.x),this.y=je(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=je(this.x,e,t),this.y=je(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(je(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(je(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),r=Math.sin(t),s=this.x-e.x,a=this.y-e.y;return this.x=s*n-a*r+e.x,this.y=s*r+a*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},gi=class{constructor(e=0,t=0,n=0,r=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=r}static slerpFlat(e,t,n,r,s,a,o){let l=n[r+0],c=n[r+1],h=n[r+2],d=n[r+3],u=s[a+0],p=s[a+1],f=s[a+2],b=s[a+3];if(d!==b||l!==u||c!==p||h!==f){let m=l*u+c*p+h*f+d*b;m<0&&(u=-u,p=-p,f=-f,b=-b,m=-m);let g=1-o;if(m<.9995){let v=Math.acos(m),M=Math.sin(v);g=Math.sin(g*v)/M,o=Math.sin(o*v)/M,l=l*g+u*o,c=c*g+p*o,h=h*g+f*o,d=d*g+b*o}else{l=l*g+u*o,c=c*g+p*o,h=h*g+f*o,d=d*g+b*o;let v=1/Math.sqrt(l*l+c*c+h*h+d*d);l*=v,c*=v,h*=v,d*=v}}e[t]=l,e[t+1]=c,e[t+2]=h,e[t+3]=d}static multiplyQuaternionsFlat(e,t,n,r,s,a){let o=n[r],l=n[r+1],c=n[r+2],h=n[r+3],d=s[a],u=s[a+1],p=s[a+2],f=s[a+3];return e[t]=o*f+h*d+l*p-c*u,e[t+1]=l*f+h*u+c*d-o*p,e[t+2]=c*f+h*p+o*u-l*d,e[t+3]=h*f-o*d-l*u-c*p,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,r){return this._x=e,this._y=t,this._z=n,this._w=r,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,r=e._y,s=e._z,a=e._order,o=Math.cos,l=Math.sin,c=o(n/2),h=o(r/2),d=o(s/2),u=l(n/2),p=l(r/2),f=l(s/2);switch(a){case"XYZ":this._x=u*h*d+c*p*f,this._y=c*p*d-u*h*f,this._z=c*h*f+u*p*d,this._w=c*h*d-u*p*f;break;case"YXZ":this._x=u*h*d+c*p*f,this._y=c*p*d-u*h*f,this._z=c*h*f-u*p*d,this._w=c*h*d+u*p*f;break;case"ZXY":this._x=u*h*d-c*p*f,this._y=c*p*d+u*h*f,this._z=c*h*f+u*p*d,this._w=c*h*d-u*p*f;break;case"ZYX":this._x=u*h*d-c*p*f,this._y=c*p*d+u*h*f,this._z=c*h*f-u*p*d,this._w=c*h*d+u*p*f;break;case"YZX":this._x=u*h*d+c*p*f,this._y=c*p*d+u*h*f,this._z=c*h*f-u*p*d,this._w=c*h*d-u*p*f;break;case"XZY":this._x=u*h*d-c*p*f,this._y=c*p*d-u*h*f,this._z=c*h*f+u*p*d,this._w=c*h*d+u*p*f;break;default:Ne("Quaternion: .setFromEuler() encountered an unknown order: "+a)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,r=Math.sin(n);return this._x=e.x*r,this._y=e.y*r,this._z=e.z*r,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],r=t[4],s=t[8],a=t[1],o=t[5],l=t[9],c=t[2],h=t[6],d=t[10],u=n+o+d;if(u>0){let p=.5/Math.sqrt(u+1);this._w=.25/p,this._x=(h-l)*p,this._y=(s-c)*p,this._z=(a-r)*p}else if(n>o&&n>d){let p=2*Math.sqrt(1+n-o-d);this._w=(h-l)/p,this._x=.25*p,this._y=(r+a)/p,this._z=(s+c)/p}else if(o>d){let p=2*Math.sqrt(1+o-n-d);this._w=(s-c)/p,this._x=(r+a)/p,this._y=.25*p,this._z=(l+h)/p}else{let p=2*Math.sqrt(1+d-n-o);this._w=(a-r)/p,this._x=(s+c)/p,this._y=(l+h)/p,this._z=.25*p}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(je(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let r=Math.min(1,t/n);return this.slerp(e,r),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,r=e._y,s=e._z,a=e._w,o=t._x,l=t._y,c=t._z,h=t._w;return this._x=n*h+a*o+r*c-s*l,this._y=r*h+a*l+s*o-n*c,this._z=s*h+a*c+n*l-r*o,this._w=a*h-n*o-r*l-s*c,this._onChangeCallback(),this}slerp(e,t){let n=e._x,r=e._y,s=e._z,a=e._w,o=this.dot(e);o<0&&(n=-n,r=-r,s=-s,a=-a,o=-o);let l=1-t;if(o<.9995){let c=Math.acos(o),h=Math.sin(c);l=Math.sin(l*c)/h,t=Math.sin(t*c)/h,this._x=this._x*l+n*t,this._y=this._y*l+r*t,this._z=this._z*l+s*t,this._w=this._w*l+a*t,this._onChangeCallback()}else this._x=this._x*l+n*t,this._y=this._y*l+r*t,this._z=this._z*l+s*t,this._w=this._w*l+a*t,this.normalize();return this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),r=Math.sqrt(1-n),s=Math.sqrt(n);return this.set(r*Math.sin(e),r*Math.cos(e),s*Math.sin(t),s*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},k=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,n=0){this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion($m.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion($m.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,r=this.z,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6]*r,this.y=s[1]*t+s[4]*n+s[7]*r,this.z=s[2]*t+s[5]*n+s[8]*r,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,r=this.z,s=e.elements,a=1/(s[3]*t+s[7]*n+s[11]*r+s[15]);return this.x=(s[0]*t+s[4]*n+s[8]*r+s[12])*a,this.y=(s[1]*t+s[5]*n+s[9]*r+s[13])*a,this.z=(s[2]*t+s[6]*n+s[10]*r+s[14])*a,this}applyQuaternion(e){let t=this.x,n=this.y,r=this.z,s=e.x,a=e.y,o=e.z,l=e.w,c=2*(a*r-o*n),h=2*(o*t-s*r),d=2*(s*n-a*t);return this.x=t+l*c+a*d-o*h,this.y=n+l*h+o*c-s*d,this.z=r+l*d+s*h-a*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,r=this.z,s=e.elements;return this.x=s[0]*t+s[4]*n+s[8]*r,this.y=s[1]*t+s[5]*n+s[9]*r,this.z=s[2]*t+s[6]*n+s[10]*r,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=je(this.x,e.x,t.x),this.y=je(this.y,e.y,t.y),this.z=je(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=je(this.x,e,t),this.y=je(this.y,e,t),this.z=je(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(je(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,r=e.y,s=e.z,a=t.x,o=t.y,l=t.z;return this.x=r*l-s*o,this.y=s*a-n*l,this.z=n*o-r*a,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return Bu.copy(this).projectOnVector(e),this.sub(Bu)}reflect(e){return this.sub(Bu.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(je(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,r=this.z-e.z;return t*t+n*n+r*r}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let r=Math.sin(t)*e;return this.x=r*Math.sin(n),this.y=Math.cos(t)*e,this.z=r*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),r=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=r,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Bu=new k,$m=new gi,Fe=class{static{this.prototype.isMatrix3=!0}constructor(e,t,n,r,s,a,o,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,r,s,a,o,l,c)}set(e,t,n,r,s,a,o,l,c){let h=this.elements;return h[0]=e,h[1]=r,h[2]=o,h[3]=t,h[4]=s,h[5]=l,h[6]=n,h[7]=a,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,r=t.elements,s=this.elements,a=n[0],o=n[3],l=n[6],c=n[1],h=n[4],d=n[7],u=n[2],p=n[5],f=n[8],b=r[0],m=r[3],g=r[6],v=r[1],M=r[4],x=r[7],E=r[2],w=r[5],y=r[8];return s[0]=a*b+o*v+l*E,s[3]=a*m+o*M+l*w,s[6]=a*g+o*x+l*y,s[1]=c*b+h*v+d*E,s[4]=c*m+h*M+d*w,s[7]=c*g+h*x+d*y,s[2]=u*b+p*v+f*E,s[5]=u*m+p*M+f*w,s[8]=u*g+p*x+f*y,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],r=e[2],s=e[3],a=e[4],o=e[5],l=e[6],c=e[7],h=e[8];return t*a*h-t*o*c-n*s*h+n*o*l+r*s*c-r*a*l}invert(){let e=this.elements,t=e[0],n=e[1],r=e[2],s=e[3],a=e[4],o=e[5],l=e[6],c=e[7],h=e[8],d=h*a-o*c,u=o*l-h*s,p=c*s-a*l,f=t*d+n*u+r*p;if(f===0)return this.set(0,0,0,0,0,0,0,0,0);let b=1/f;return e[0]=d*b,e[1]=(r*c-h*n)*b,e[2]=(o*n-r*a)*b,e[3]=u*b,e[4]=(h*t-r*l)*b,e[5]=(r*s-o*t)*b,e[6]=p*b,e[7]=(n*l-c*t)*b,e[8]=(a*t-n*s)*b,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,r,s,a,o){let l=Math.cos(s),c=Math.sin(s);return this.set(n*l,n*c,-n*(l*a+c*o)+a+e,-r*c,r*l,-r*(-c*a+l*o)+o+t,0,0,1),this}scale(e,t){return Aa("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(qu.makeScale(e,t)),this}rotate(e){return Aa("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(qu.makeRotation(-e)),this}translate(e,t){return Aa("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(qu.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let r=0;r<9;r++)if(t[r]!==n[r])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}},qu=new Fe,Xm=new Fe().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Ym=new Fe().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function ty(){let i={enabled:!0,workingColorSpace:Ta,spaces:{},convert:function(r,s,a){return this.enabled===!1||s===a||!s||!a||(this.spaces[s].transfer===at&&(r.r=Ni(r.r),r.g=Ni(r.g),r.b=Ni(r.b)),this.spaces[s].primaries!==this.spaces[a].primaries&&(r.applyMatrix3(this.spaces[s].toXYZ),r.applyMatrix3(this.spaces[a].fromXYZ)),this.spaces[a].transfer===at&&(r.r=Ls(r.r),r.g=Ls(r.g),r.b=Ls(r.b))),r},workingToColorSpace:function(r,s){return this.convert(r,this.workingColorSpace,s)},colorSpaceToWorking:function(r,s){return this.convert(r,s,this.workingColorSpace)},getPrimaries:function(r){return this.spaces[r].primaries},getTransfer:function(r){return r===Oi?Ca:this.spaces[r].transfer},getToneMappingMode:function(r){return this.spaces[r].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(r,s=this.workingColorSpace){return r.fromArray(this.spaces[s].luminanceCoefficients)},define:function(r){Object.assign(this.spaces,r)},_getMatrix:function(r,s,a){return r.copy(this.spaces[a].fromXYZ).multiply(this.spaces[s].toXYZ)},_getDrawingBufferColorSpace:function(r){return this.spaces[r].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(r=this.workingColorSpace){return this.spaces[r].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[Ta]:{primaries:e,whitePoint:n,transfer:Ca,toXYZ:Xm,fromXYZ:Ym,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:vn},outputColorSpaceConfig:{drawingBufferColorSpace:vn}},[vn]:{primaries:e,whitePoint:n,transfer:at,toXYZ:Xm,fromXYZ:Ym,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:vn}}}),i}var Ke=ty();function Ni(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function Ls(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var xs,ql=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{xs===void 0&&(xs=Pa("canvas")),xs.width=e.width,xs.height=e.height;let r=xs.getContext("2d");e instanceof ImageData?r.putImageData(e,0,0):r.drawImage(e,0,0,e.width,e.height),n=xs}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=Pa("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let r=n.getImageData(0,0,e.width,e.height),s=r.data;for(let a=0;a<s.length;a++)s[a]=Ni(s[a]/255)*255;return n.putImageData(r,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(Ni(t[n]/255)*255):t[n]=Ni(t[n]);return{data:t,width:e.width,height:e.height}}else return Ne("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},ny=0,Os=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:ny++}),this.uuid=Jr(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},r=this.data;if(r!==null){let s;if(Array.isArray(r)){s=[];for(let a=0,o=r.length;a<o;a++)r[a].isDataTexture?s.push(Vu(r[a].image)):s.push(Vu(r[a]))}else s=Vu(r);n.url=s}return t||(e.images[this.uuid]=n),n}};function Vu(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?ql.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(Ne("Texture: Unable to serialize Texture."),{})}var iy=0,Hu=new k,Qt=class i extends mi{constructor(e=i.DEFAULT_IMAGE,t=i.DEFAULT_MAPPING,n=fi,r=fi,s=Ft,a=zi,o=wn,l=tn,c=i.DEFAULT_ANISOTROPY,h=Oi){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:iy++}),this.uuid=Jr(),this.name="",this.source=new Os(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=r,this.magFilter=s,this.minFilter=a,this.anisotropy=c,this.format=o,this.internalFormat=null,this.type=l,this.offset=new $e(0,0),this.repeat=new $e(1,1),this.center=new $e(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new Fe,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Hu).x}get height(){return this.source.getSize(Hu).y}get depth(){return this.source.getSize(Hu).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){Ne(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let r=this[t];if(r===void 0){Ne(`Texture.setValues(): property '${t}' does not exist.`);continue}r&&n&&r.isVector2&&n.isVector2||r&&n&&r.isVector3&&n.isVector3||r&&n&&r.isMatrix3&&n.isMatrix3?r.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Ed)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case Ol:e.x=e.x-Math.floor(e.x);break;case fi:e.x=e.x<0?0:1;break;case Ul:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case Ol:e.y=e.y-Math.floor(e.y);break;case fi:e.y=e.y<0?0:1;break;case Ul:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};Qt.DEFAULT_IMAGE=null;Qt.DEFAULT_MAPPING=Ed;Qt.DEFAULT_ANISOTROPY=1;var ht=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,n=0,r=1){this.x=e,this.y=t,this.z=n,this.w=r}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,r){return this.x=e,this.y=t,this.z=n,this.w=r,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,r=this.z,s=this.w,a=e.elements;return this.x=a[0]*t+a[4]*n+a[8]*r+a[12]*s,this.y=a[1]*t+a[5]*n+a[9]*r+a[13]*s,this.z=a[2]*t+a[6]*n+a[10]*r+a[14]*s,this.w=a[3]*t+a[7]*n+a[11]*r+a[15]*s,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,r,s,l=e.elements,c=l[0],h=l[4],d=l[8],u=l[1],p=l[5],f=l[9],b=l[2],m=l[6],g=l[10];if(Math.abs(h-u)<.01&&Math.abs(d-b)<.01&&Math.abs(f-m)<.01){if(Math.abs(h+u)<.1&&Math.abs(d+b)<.1&&Math.abs(f+m)<.1&&Math.abs(c+p+g-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let M=(c+1)/2,x=(p+1)/2,E=(g+1)/2,w=(h+u)/4,y=(d+b)/4,A=(f+m)/4;return M>x&&M>E?M<.01?(n=0,r=.707106781,s=.707106781):(n=Math.sqrt(M),r=w/n,s=y/n):x>E?x<.01?(n=.707106781,r=0,s=.707106781):(r=Math.sqrt(x),n=w/r,s=A/r):E<.01?(n=.707106781,r=.707106781,s=0):(s=Math.sqrt(E),n=y/s,r=A/s),this.set(n,r,s,t),this}let v=Math.sqrt((m-f)*(m-f)+(d-b)*(d-b)+(u-h)*(u-h));return Math.abs(v)<.001&&(v=1),this.x=(m-f)/v,this.y=(d-b)/v,this.z=(u-h)/v,this.w=Math.acos((c+p+g-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=je(this.x,e.x,t.x),this.y=je(this.y,e.y,t.y),this.z=je(this.z,e.z,t.z),this.w=je(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=je(this.x,e,t),this.y=je(this.y,e,t),this.z=je(this.z,e,t),this.w=je(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(je(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Vl=class extends mi{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Ft,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new ht(0,0,e,t),this.scissorTest=!1,this.viewport=new ht(0,0,e,t),this.textures=[];let r=n.count;for(let s=0;s<r;s++)this.textures[s]=new Qt({width:e,height:t,depth:n.depth}),this.textures[s].isRenderTargetTexture=!0,this.textures[s].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:Ft,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let r=0,s=this.textures.length;r<s;r++)this.textures[r].image.width=e,this.textures[r].image.height=t,this.textures[r].image.depth=n,this.textures[r].isData3DTexture!==!0&&(this.textures[r].isArrayTexture=this.textures[r].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let r=Object.assign({},e.textures[t].image);this.textures[t].source=new Os(r)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},xn=class extends Vl{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}},Na=class extends Qt{constructor(e=null,t=1,n=1,r=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:r},this.magFilter=Et,this.minFilter=Et,this.wrapR=fi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var Hl=class extends Qt{constructor(e=null,t=1,n=1,r=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:r},this.magFilter=Et,this.minFilter=Et,this.wrapR=fi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var pt=class i{static{this.prototype.isMatrix4=!0}constructor(e,t,n,r,s,a,o,l,c,h,d,u,p,f,b,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,r,s,a,o,l,c,h,d,u,p,f,b,m)}set(e,t,n,r,s,a,o,l,c,h,d,u,p,f,b,m){let g=this.elements;return g[0]=e,g[4]=t,g[8]=n,g[12]=r,g[1]=s,g[5]=a,g[9]=o,g[13]=l,g[2]=c,g[6]=h,g[10]=d,g[14]=u,g[3]=p,g[7]=f,g[11]=b,g[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),n.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,n=e.elements,r=1/_s.setFromMatrixColumn(e,0).length(),s=1/_s.setFromMatrixColumn(e,1).length(),a=1/_s.setFromMatrixColumn(e,2).length();return t[0]=n[0]*r,t[1]=n[1]*r,t[2]=n[2]*r,t[3]=0,t[4]=n[4]*s,t[5]=n[5]*s,t[6]=n[6]*s,t[7]=0,t[8]=n[8]*a,t[9]=n[9]*a,t[10]=n[10]*a,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,r=e.y,s=e.z,a=Math.cos(n),o=Math.sin(n),l=Math.cos(r),c=Math.sin(r),h=Math.cos(s),d=Math.sin(s);if(e.order==="XYZ"){let u=a*h,p=a*d,f=o*h,b=o*d;t[0]=l*h,t[4]=-l*d,t[8]=c,t[1]=p+f*c,t[5]=u-b*c,t[9]=-o*l,t[2]=b-u*c,t[6]=f+p*c,t[10]=a*l}else if(e.order==="YXZ"){let u=l*h,p=l*d,f=c*h,b=c*d;t[0]=u+b*o,t[4]=f*o-p,t[8]=a*c,t[1]=a*d,t[5]=a*h,t[9]=-o,t[2]=p*o-f,t[6]=b+u*o,t[10]=a*l}else if(e.order==="ZXY"){let u=l*h,p=l*d,f=c*h,b=c*d;t[0]=u-b*o,t[4]=-a*d,t[8]=f+p*o,t[1]=p+f*o,t[5]=a*h,t[9]=b-u*o,t[2]=-a*c,t[6]=o,t[10]=a*l}else if(e.order==="ZYX"){let u=a*h,p=a*d,f=o*h,b=o*d;t[0]=l*h,t[4]=f*c-p,t[8]=u*c+b,t[1]=l*d,t[5]=b*c+u,t[9]=p*c-f,t[2]=-c,t[6]=o*l,t[10]=a*l}else if(e.order==="YZX"){let u=a*l,p=a*c,f=o*l,b=o*c;t[0]=l*h,t[4]=b-u*d,t[8]=f*d+p,t[1]=d,t[5]=a*h,t[9]=-o*h,t[2]=-c*h,t[6]=p*d+f,t[10]=u-b*d}else if(e.order==="XZY"){let u=a*l,p=a*c,f=o*l,b=o*c;t[0]=l*h,t[4]=-d,t[8]=c*h,t[1]=u*d+b,t[5]=a*h,t[9]=p*d-f,t[2]=f*d-p,t[6]=o*h,t[10]=b*d+u}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(ry,e,sy)}lookAt(e,t,n){let r=this.elements;return bn.subVectors(e,t),bn.lengthSq()===0&&(bn.z=1),bn.normalize(),er.crossVectors(n,bn),er.lengthSq()===0&&(Math.abs(n.z)===1?bn.x+=1e-4:bn.z+=1e-4,bn.normalize(),er.crossVectors(n,bn)),er.normalize(),ol.crossVectors(bn,er),r[0]=er.x,r[4]=ol.x,r[8]=bn.x,r[1]=er.y,r[5]=ol.y,r[9]=bn.y,r[2]=er.z,r[6]=ol.z,r[10]=bn.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,r=t.elements,s=this.elements,a=n[0],o=n[4],l=n[8],c=n[12],h=n[1],d=n[5],u=n[9],p=n[13],f=n[2],b=n[6],m=n[10],g=n[14],v=n[3],M=n[7],x=n[11],E=n[15],w=r[0],y=r[4],A=r[8],D=r[12],R=r[1],N=r[5],F=r[9],V=r[13],P=r[2],G=r[6],W=r[10],O=r[14],Q=r[3],H=r[7],J=r[11],te=r[15];return s[0]=a*w+o*R+l*P+c*Q,s[4]=a*y+o*N+l*G+c*H,s[8]=a*A+o*F+l*W+c*J,s[12]=a*D+o*V+l*O+c*te,s[1]=h*w+d*R+u*P+p*Q,s[5]=h*y+d*N+u*G+p*H,s[9]=h*A+d*F+u*W+p*J,s[13]=h*D+d*V+u*O+p*te,s[2]=f*w+b*R+m*P+g*Q,s[6]=f*y+b*N+m*G+g*H,s[10]=f*A+b*F+m*W+g*J,s[14]=f*D+b*V+m*O+g*te,s[3]=v*w+M*R+x*P+E*Q,s[7]=v*y+M*N+x*G+E*H,s[11]=v*A+M*F+x*W+E*J,s[15]=v*D+M*V+x*O+E*te,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],r=e[8],s=e[12],a=e[1],o=e[5],l=e[9],c=e[13],h=e[2],d=e[6],u=e[10],p=e[14],f=e[3],b=e[7],m=e[11],g=e[15],v=l*p-c*u,M=o*p-c*d,x=o*u-l*d,E=a*p-c*h,w=a*u-l*h,y=a*d-o*h;return t*(b*v-m*M+g*x)-n*(f*v-m*E+g*w)+r*(f*M-b*E+g*y)-s*(f*x-b*w+m*y)}determinantAffine(){let e=this.elements,t=e[0],n=e[4],r=e[8],s=e[1],a=e[5],o=e[9],l=e[2],c=e[6],h=e[10];return t*(a*h-o*c)-n*(s*h-o*l)+r*(s*c-a*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let r=this.elements;return e.isVector3?(r[12]=e.x,r[13]=e.y,r[14]=e.z):(r[12]=e,r[13]=t,r[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],r=e[2],s=e[3],a=e[4],o=e[5],l=e[6],c=e[7],h=e[8],d=e[9],u=e[10],p=e[11],f=e[12],b=e[13],m=e[14],g=e[15],v=t*o-n*a,M=t*l-r*a,x=t*c-s*a,E=n*l-r*o,w=n*c-s*o,y=r*c-s*l,A=h*b-d*f,D=h*m-u*f,R=h*g-p*f,N=d*m-u*b,F=d*g-p*b,V=u*g-p*m,P=v*V-M*F+x*N+E*R-w*D+y*A;if(P===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let G=1/P;return e[0]=(o*V-l*F+c*N)*G,e[1]=(r*F-n*V-s*N)*G,e[2]=(b*y-m*w+g*E)*G,e[3]=(u*w-d*y-p*E)*G,e[4]=(l*R-a*V-c*D)*G,e[5]=(t*V-r*R+s*D)*G,e[6]=(m*x-f*y-g*M)*G,e[7]=(h*y-u*x+p*M)*G,e[8]=(a*F-o*R+c*A)*G,e[9]=(n*R-t*F-s*A)*G,e[10]=(f*w-b*x+g*v)*G,e[11]=(d*x-h*w-p*v)*G,e[12]=(o*D-a*N-l*A)*G,e[13]=(t*N-n*D+r*A)*G,e[14]=(b*M-f*E-m*v)*G,e[15]=(h*E-d*M+u*v)*G,this}scale(e){let t=this.elements,n=e.x,r=e.y,s=e.z;return t[0]*=n,t[4]*=r,t[8]*=s,t[1]*=n,t[5]*=r,t[9]*=s,t[2]*=n,t[6]*=r,t[10]*=s,t[3]*=n,t[7]*=r,t[11]*=s,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],r=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,r))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),r=Math.sin(t),s=1-n,a=e.x,o=e.y,l=e.z,c=s*a,h=s*o;return this.set(c*a+n,c*o-r*l,c*l+r*o,0,c*o+r*l,h*o+n,h*l-r*a,0,c*l-r*o,h*l+r*a,s*l*l+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,r,s,a){return this.set(1,n,s,0,e,1,a,0,t,r,1,0,0,0,0,1),this}compose(e,t,n){let r=this.elements,s=t._x,a=t._y,o=t._z,l=t._w,c=s+s,h=a+a,d=o+o,u=s*c,p=s*h,f=s*d,b=a*h,m=a*d,g=o*d,v=l*c,M=l*h,x=l*d,E=n.x,w=n.y,y=n.z;return r[0]=(1-(b+g))*E,r[1]=(p+x)*E,r[2]=(f-M)*E,r[3]=0,r[4]=(p-x)*w,r[5]=(1-(u+g))*w,r[6]=(m+v)*w,r[7]=0,r[8]=(f+M)*y,r[9]=(m-v)*y,r[10]=(1-(u+b))*y,r[11]=0,r[12]=e.x,r[13]=e.y,r[14]=e.z,r[15]=1,this}decompose(e,t,n){let r=this.elements;e.x=r[12],e.y=r[13],e.z=r[14];let s=this.determinantAffine();if(s===0)return n.set(1,1,1),t.identity(),this;let a=_s.set(r[0],r[1],r[2]).length(),o=_s.set(r[4],r[5],r[6]).length(),l=_s.set(r[8],r[9],r[10]).length();s<0&&(a=-a),Kn.copy(this);let c=1/a,h=1/o,d=1/l;return Kn.elements[0]*=c,Kn.elements[1]*=c,Kn.elements[2]*=c,Kn.elements[4]*=h,Kn.elements[5]*=h,Kn.elements[6]*=h,Kn.elements[8]*=d,Kn.elements[9]*=d,Kn.elements[10]*=d,t.setFromRotationMatrix(Kn),n.x=a,n.y=o,n.z=l,this}makePerspective(e,t,n,r,s,a,o=Dn,l=!1){let c=this.elements,h=2*s/(t-e),d=2*s/(n-r),u=(t+e)/(t-e),p=(n+r)/(n-r),f,b;if(l)f=s/(a-s),b=a*s/(a-s);else if(o===Dn)f=-(a+s)/(a-s),b=-2*a*s/(a-s);else if(o===Ra)f=-a/(a-s),b=-a*s/(a-s);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+o);return c[0]=h,c[4]=0,c[8]=u,c[12]=0,c[1]=0,c[5]=d,c[9]=p,c[13]=0,c[2]=0,c[6]=0,c[10]=f,c[14]=b,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,n,r,s,a,o=Dn,l=!1){let c=this.elements,h=2/(t-e),d=2/(n-r),u=-(t+e)/(t-e),p=-(n+r)/(n-r),f,b;if(l)f=1/(a-s),b=a/(a-s);else if(o===Dn)f=-2/(a-s),b=-(a+s)/(a-s);else if(o===Ra)f=-1/(a-s),b=-s/(a-s);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+o);return c[0]=h,c[4]=0,c[8]=0,c[12]=u,c[1]=0,c[5]=d,c[9]=0,c[13]=p,c[2]=0,c[6]=0,c[10]=f,c[14]=b,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let r=0;r<16;r++)if(t[r]!==n[r])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}},_s=new k,Kn=new pt,ry=new k(0,0,0),sy=new k(1,1,1),er=new k,ol=new k,bn=new k,Jm=new pt,Zm=new gi,ar=class i{constructor(e=0,t=0,n=0,r=i.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=r}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,r=this._order){return this._x=e,this._y=t,this._z=n,this._order=r,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let r=e.elements,s=r[0],a=r[4],o=r[8],l=r[1],c=r[5],h=r[9],d=r[2],u=r[6],p=r[10];switch(t){case"XYZ":this._y=Math.asin(je(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(-h,p),this._z=Math.atan2(-a,s)):(this._x=Math.atan2(u,c),this._z=0);break;case"YXZ":this._x=Math.asin(-je(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(o,p),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-d,s),this._z=0);break;case"ZXY":this._x=Math.asin(je(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(-d,p),this._z=Math.atan2(-a,c)):(this._y=0,this._z=Math.atan2(l,s));break;case"ZYX":this._y=Math.asin(-je(d,-1,1)),Math.abs(d)<.9999999?(this._x=Math.atan2(u,p),this._z=Math.atan2(l,s)):(this._x=0,this._z=Math.atan2(-a,c));break;case"YZX":this._z=Math.asin(je(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-d,s)):(this._x=0,this._y=Math.atan2(o,p));break;case"XZY":this._z=Math.asin(-je(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(u,c),this._y=Math.atan2(o,s)):(this._x=Math.atan2(-h,p),this._y=0);break;default:Ne("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return Jm.makeRotationFromQuaternion(e),this.setFromRotationMatrix(Jm,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return Zm.setFromEuler(this),this.setFromQuaternion(Zm,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};ar.DEFAULT_ORDER="XYZ";var La=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},ay=0,Km=new k,Ss=new gi,Ei=new pt,ll=new k,_a=new k,oy=new k,ly=new gi,jm=new k(1,0,0),Qm=new k(0,1,0),e0=new k(0,0,1),t0={type:"added"},cy={type:"removed"},Ms={type:"childadded",child:null},Gu={type:"childremoved",child:null},_n=class i extends mi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:ay++}),this.uuid=Jr(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let e=new k,t=new ar,n=new gi,r=new k(1,1,1);function s(){n.setFromEuler(t,!1)}function a(){t.setFromQuaternion(n,void 0,!1)}t._onChange(s),n._onChange(a),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:r},modelViewMatrix:{value:new pt},normalMatrix:{value:new Fe}}),this.matrix=new pt,this.matrixWorld=new pt,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new La,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Ss.setFromAxisAngle(e,t),this.quaternion.multiply(Ss),this}rotateOnWorldAxis(e,t){return Ss.setFromAxisAngle(e,t),this.quaternion.premultiply(Ss),this}rotateX(e){return this.rotateOnAxis(jm,e)}rotateY(e){return this.rotateOnAxis(Qm,e)}rotateZ(e){return this.rotateOnAxis(e0,e)}translateOnAxis(e,t){return Km.copy(e).applyQuaternion(this.quaternion),this.position.add(Km.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(jm,e)}translateY(e){return this.translateOnAxis(Qm,e)}translateZ(e){return this.translateOnAxis(e0,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(Ei.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?ll.copy(e):ll.set(e,t,n);let r=this.parent;this.updateWorldMatrix(!0,!1),_a.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Ei.lookAt(_a,ll,this.up):Ei.lookAt(ll,_a,this.up),this.quaternion.setFromRotationMatrix(Ei),r&&(Ei.extractRotation(r.matrixWorld),Ss.setFromRotationMatrix(Ei),this.quaternion.premultiply(Ss.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(De("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(t0),Ms.child=e,this.dispatchEvent(Ms),Ms.child=null):De("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(cy),Gu.child=e,this.dispatchEvent(Gu),Gu.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),Ei.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),Ei.multiply(e.parent.matrixWorld)),e.applyMatrix4(Ei),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(t0),Ms.child=e,this.dispatchEvent(Ms),Ms.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,r=this.children.length;n<r;n++){let a=this.children[n].getObjectByProperty(e,t);if(a!==void 0)return a}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let r=this.children;for(let s=0,a=r.length;s<a;s++)r[s].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(_a,e,oy),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(_a,ly,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let n=0,r=t.length;n<r;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,r=t.length;n<r;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,n=e.y,r=e.z,s=this.matrix.elements;s[12]+=t-s[0]*t-s[4]*n-s[8]*r,s[13]+=n-s[1]*t-s[5]*n-s[9]*r,s[14]+=r-s[2]*t-s[6]*n-s[10]*r}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,r=t.length;n<r;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t,n=!1){let r=this.parent;if(e===!0&&r!==null&&r.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),t===!0){let s=this.children;for(let a=0,o=s.length;a<o;a++)s[a].updateWorldMatrix(!1,!0,n)}}toJSON(e){let t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let r={};r.uuid=this.uuid,r.type=this.type,r.name=this.name,r.castShadow=this.castShadow,r.receiveShadow=this.receiveShadow,r.visible=this.visible,r.frustumCulled=this.frustumCulled,r.renderOrder=this.renderOrder,r.static=this.static,r.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(r.userData=this.userData),r.layers=this.layers.mask,r.matrix=this.matrix.toArray(),r.up=this.up.toArray(),this.pivot!==null&&(r.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(r.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(r.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(r.type="InstancedMesh",r.count=this.count,r.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(r.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(r.type="BatchedMesh",r.perObjectFrustumCulled=this.perObjectFrustumCulled,r.sortObjects=this.sortObjects,r.drawRanges=this._drawRanges,r.reservedRanges=this._reservedRanges,r.geometryInfo=this._geometryInfo.map(o=>({...o,boundingBox:o.boundingBox?o.boundingBox.toJSON():void 0,boundingSphere:o.boundingSphere?o.boundingSphere.toJSON():void 0})),r.instanceInfo=this._instanceInfo.map(o=>({...o})),r.availableInstanceIds=this._availableInstanceIds.slice(),r.availableGeometryIds=this._availableGeometryIds.slice(),r.nextIndexStart=this._nextIndexStart,r.nextVertexStart=this._nextVertexStart,r.geometryCount=this._geometryCount,r.maxInstanceCount=this._maxInstanceCount,r.maxVertexCount=this._maxVertexCount,r.maxIndexCount=this._maxIndexCount,r.geometryInitialized=this._geometryInitialized,r.matricesTexture=this._matricesTexture.toJSON(e),r.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(r.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(r.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(r.boundingBox=this.boundingBox.toJSON()));function s(o,l){return o[l.uuid]===void 0&&(o[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?r.background=this.background.toJSON():this.background.isTexture&&(r.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(r.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){r.geometry=s(e.geometries,this.geometry);let o=this.geometry.parameters;if(o!==void 0&&o.shapes!==void 0){let l=o.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let d=l[c];s(e.shapes,d)}else s(e.shapes,l)}}if(this.isSkinnedMesh&&(r.bindMode=this.bindMode,r.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(s(e.skeletons,this.skeleton),r.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let o=[];for(let l=0,c=this.material.length;l<c;l++)o.push(s(e.materials,this.material[l]));r.material=o}else r.material=s(e.materials,this.material);if(this.children.length>0){r.children=[];for(let o=0;o<this.children.length;o++)r.children.push(this.children[o].toJSON(e).object)}if(this.animations.length>0){r.animations=[];for(let o=0;o<this.animations.length;o++){let l=this.animations[o];r.animations.push(s(e.animations,l))}}if(t){let o=a(e.geometries),l=a(e.materials),c=a(e.textures),h=a(e.images),d=a(e.shapes),u=a(e.skeletons),p=a(e.animations),f=a(e.nodes);o.length>0&&(n.geometries=o),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),d.length>0&&(n.shapes=d),u.length>0&&(n.skeletons=u),p.length>0&&(n.animations=p),f.length>0&&(n.nodes=f)}return n.object=r,n;function a(o){let l=[];for(let c in o){let h=o[c];delete h.metadata,l.push(h)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let r=e.children[n];this.add(r.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};_n.DEFAULT_UP=new k(0,1,0);_n.DEFAULT_MATRIX_AUTO_UPDATE=!0;_n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Ii=class extends _n{constructor(){super(),this.isGroup=!0,this.type="Group"}},hy={type:"move"},Us=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Ii,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Ii,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new k,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new k),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Ii,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new k,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new k,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let r=null,s=null,a=null,o=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){a=!0;for(let b of e.hand.values()){let m=t.getJointPose(b,n),g=this._getHandJoint(c,b);m!==null&&(g.matrix.fromArray(m.transform.matrix),g.matrix.decompose(g.position,g.quaternion,g.scale),g.matrixWorldNeedsUpdate=!0,g.jointRadius=m.radius),g.visible=m!==null}let h=c.joints["index-finger-tip"],d=c.joints["thumb-tip"],u=h.position.distanceTo(d.position),p=.02,f=.005;c.inputState.pinching&&u>p+f?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&u<=p-f&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(s=t.getPose(e.gripSpace,n),s!==null&&(l.matrix.fromArray(s.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,s.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(s.linearVelocity)):l.hasLinearVelocity=!1,s.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(s.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));o!==null&&(r=t.getPose(e.targetRaySpace,n),r===null&&s!==null&&(r=s),r!==null&&(o.matrix.fromArray(r.transform.matrix),o.matrix.decompose(o.position,o.quaternion,o.scale),o.matrixWorldNeedsUpdate=!0,r.linearVelocity?(o.hasLinearVelocity=!0,o.linearVelocity.copy(r.linearVelocity)):o.hasLinearVelocity=!1,r.angularVelocity?(o.hasAngularVelocity=!0,o.angularVelocity.copy(r.angularVelocity)):o.hasAngularVelocity=!1,this.dispatchEvent(hy)))}return o!==null&&(o.visible=r!==null),l!==null&&(l.visible=s!==null),c!==null&&(c.visible=a!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let n=new Ii;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}},eg={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},tr={h:0,s:0,l:0},cl={h:0,s:0,l:0};function Wu(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}var Ge=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let r=e;r&&r.isColor?this.copy(r):typeof r=="number"?this.setHex(r):typeof r=="string"&&this.setStyle(r)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=vn){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,Ke.colorSpaceToWorking(this,t),this}setRGB(e,t,n,r=Ke.workingColorSpace){return this.r=e,this.g=t,this.b=n,Ke.colorSpaceToWorking(this,r),this}setHSL(e,t,n,r=Ke.workingColorSpace){if(e=ey(e,1),t=je(t,0,1),n=je(n,0,1),t===0)this.r=this.g=this.b=n;else{let s=n<=.5?n*(1+t):n+t-n*t,a=2*n-s;this.r=Wu(a,s,e+1/3),this.g=Wu(a,s,e),this.b=Wu(a,s,e-1/3)}return Ke.colorSpaceToWorking(this,r),this}setStyle(e,t=vn){function n(s){s!==void 0&&parseFloat(s)<1&&Ne("Color: Alpha component of "+e+" will be ignored.")}let r;if(r=/^(\w+)\(([^\)]*)\)/.exec(e)){let s,a=r[1],o=r[2];switch(a){case"rgb":case"rgba":if(s=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return n(s[4]),this.setRGB(Math.min(255,parseInt(s[1],10))/255,Math.min(255,parseInt(s[2],10))/255,Math.min(255,parseInt(s[3],10))/255,t);if(s=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return n(s[4]),this.setRGB(Math.min(100,parseFloat(s[1]))/100,Math.min(100,parseFloat(s[2]))/100,Math.min(100,parseFloat(s[3]))/100,t);break;case"hsl":case"hsla":if(s=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return n(s[4]),this.setHSL(parseFloat(s[1])/360,parseFloat(s[2])/100,parseFloat(s[3])/100,t);break;default:Ne("Color: Unknown color model "+e)}}else if(r=/^\#([A-Fa-f\d]+)$/.exec(e)){let s=r[1],a=s.length;if(a===3)return this.setRGB(parseInt(s.charAt(0),16)/15,parseInt(s.charAt(1),16)/15,parseInt(s.charAt(2),16)/15,t);if(a===6)return this.setHex(parseInt(s,16),t);Ne("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=vn){let n=eg[e.toLowerCase()];return n!==void 0?this.setHex(n,t):Ne("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Ni(e.r),this.g=Ni(e.g),this.b=Ni(e.b),this}copyLinearToSRGB(e){return this.r=Ls(e.r),this.g=Ls(e.g),this.b=Ls(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=vn){return Ke.workingToColorSpace($t.copy(this),e),Math.round(je($t.r*255,0,255))*65536+Math.round(je($t.g*255,0,255))*256+Math.round(je($t.b*255,0,255))}getHexString(e=vn){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=Ke.workingColorSpace){Ke.workingToColorSpace($t.copy(this),t);let n=$t.r,r=$t.g,s=$t.b,a=Math.max(n,r,s),o=Math.min(n,r,s),l,c,h=(o+a)/2;if(o===a)l=0,c=0;else{let d=a-o;switch(c=h<=.5?d/(a+o):d/(2-a-o),a){case n:l=(r-s)/d+(r<s?6:0);break;case r:l=(s-n)/d+2;break;case s:l=(n-r)/d+4;break}l/=6}return e.h=l,e.s=c,e.l=h,e}getRGB(e,t=Ke.workingColorSpace){return Ke.workingToColorSpace($t.copy(this),t),e.r=$t.r,e.g=$t.g,e.b=$t.b,e}getStyle(e=vn){Ke.workingToColorSpace($t.copy(this),e);let t=$t.r,n=$t.g,r=$t.b;return e!==vn?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${r.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(r*255)})`}offsetHSL(e,t,n){return this.getHSL(tr),this.setHSL(tr.h+e,tr.s+t,tr.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(tr),e.getHSL(cl);let n=ku(tr.h,cl.h,t),r=ku(tr.s,cl.s,t),s=ku(tr.l,cl.l,t);return this.setHSL(n,r,s),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,r=this.b,s=e.elements;return this.r=s[0]*t+s[3]*n+s[6]*r,this.g=s[1]*t+s[4]*n+s[7]*r,this.b=s[2]*t+s[5]*n+s[8]*r,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},$t=new Ge;Ge.NAMES=eg;var Da=class extends _n{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new ar,this.environmentIntensity=1,this.environmentRotation=new ar,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},jn=new k,Ti=new k,$u=new k,Ci=new k,ws=new k,As=new k,n0=new k,Xu=new k,Yu=new k,Ju=new k,Zu=new ht,Ku=new ht,ju=new ht,sr=class i{constructor(e=new k,t=new k,n=new k){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,r){r.subVectors(n,t),jn.subVectors(e,t),r.cross(jn);let s=r.lengthSq();return s>0?r.multiplyScalar(1/Math.sqrt(s)):r.set(0,0,0)}static getBarycoord(e,t,n,r,s){jn.subVectors(r,t),Ti.subVectors(n,t),$u.subVectors(e,t);let a=jn.dot(jn),o=jn.dot(Ti),l=jn.dot($u),c=Ti.dot(Ti),h=Ti.dot($u),d=a*c-o*o;if(d===0)return s.set(0,0,0),null;let u=1/d,p=(c*l-o*h)*u,f=(a*h-o*l)*u;return s.set(1-p-f,f,p)}static containsPoint(e,t,n,r){return this.getBarycoord(e,t,n,r,Ci)===null?!1:Ci.x>=0&&Ci.y>=0&&Ci.x+Ci.y<=1}static getInterpolation(e,t,n,r,s,a,o,l){return this.getBarycoord(e,t,n,r,Ci)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(s,Ci.x),l.addScaledVector(a,Ci.y),l.addScaledVector(o,Ci.z),l)}static getInterpolatedAttribute(e,t,n,r,s,a){return Zu.setScalar(0),Ku.setScalar(0),ju.setScalar(0),Zu.fromBufferAttribute(e,t),Ku.fromBufferAttribute(e,n),ju.fromBufferAttribute(e,r),a.setScalar(0),a.addScaledVector(Zu,s.x),a.addScaledVector(Ku,s.y),a.addScaledVector(ju,s.z),a}static isFrontFacing(e,t,n,r){return jn.subVectors(n,t),Ti.subVectors(e,t),jn.cross(Ti).dot(r)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,r){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[r]),this}setFromAttributeAndIndices(e,t,n,r){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,r),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return jn.subVectors(this.c,this.b),Ti.subVectors(this.a,this.b),jn.cross(Ti).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return i.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return i.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,r,s){return i.getInterpolation(e,this.a,this.b,this.c,t,n,r,s)}containsPoint(e){return i.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return i.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,r=this.b,s=this.c,a,o;ws.subVectors(r,n),As.subVectors(s,n),Xu.subVectors(e,n);let l=ws.dot(Xu),c=As.dot(Xu);if(l<=0&&c<=0)return t.copy(n);Yu.subVectors(e,r);let h=ws.dot(Yu),d=As.dot(Yu);if(h>=0&&d<=h)return t.copy(r);let u=l*d-h*c;if(u<=0&&l>=0&&h<=0&&l-h>0)return a=l/(l-h),t.copy(n).addScaledVector(ws,a);Ju.subVectors(e,s);let p=ws.dot(Ju),f=As.dot(Ju);if(f>=0&&p<=f)return t.copy(s);let b=p*c-l*f;if(b<=0&&c>=0&&f<=0)return o=c/(c-f),t.copy(n).addScaledVector(As,o);let m=h*f-p*d;if(m<=0&&d-h>=0&&p-f>=0)return n0.subVectors(s,r),o=(d-h)/(d-h+(p-f)),t.copy(r).addScaledVector(n0,o);let g=1/(m+b+u);return a=b*g,o=u*g,t.copy(n).addScaledVector(ws,a).addScaledVector(As,o)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},or=class{constructor(e=new k(1/0,1/0,1/0),t=new k(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(Qn.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(Qn.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=Qn.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let s=n.getAttribute("position");if(t===!0&&s!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let a=0,o=s.count;a<o;a++)e.isMesh===!0?e.getVertexPosition(a,Qn):Qn.fromBufferAttribute(s,a),Qn.applyMatrix4(e.matrixWorld),this.expandByPoint(Qn);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),hl.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),hl.copy(n.boundingBox)),hl.applyMatrix4(e.matrixWorld),this.union(hl)}let r=e.children;for(let s=0,a=r.length;s<a;s++)this.expandByObject(r[s],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Qn),Qn.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Sa),ul.subVectors(this.max,Sa),Es.subVectors(e.a,Sa),Ts.subVectors(e.b,Sa),Cs.subVectors(e.c,Sa),nr.subVectors(Ts,Es),ir.subVectors(Cs,Ts),Ur.subVectors(Es,Cs);let t=[0,-nr.z,nr.y,0,-ir.z,ir.y,0,-Ur.z,Ur.y,nr.z,0,-nr.x,ir.z,0,-ir.x,Ur.z,0,-Ur.x,-nr.y,nr.x,0,-ir.y,ir.x,0,-Ur.y,Ur.x,0];return!Qu(t,Es,Ts,Cs,ul)||(t=[1,0,0,0,1,0,0,0,1],!Qu(t,Es,Ts,Cs,ul))?!1:(dl.crossVectors(nr,ir),t=[dl.x,dl.y,dl.z],Qu(t,Es,Ts,Cs,ul))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Qn).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Qn).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(Ri[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),Ri[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),Ri[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),Ri[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),Ri[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),Ri[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),Ri[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),Ri[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(Ri),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},Ri=[new k,new k,new k,new k,new k,new k,new k,new k],Qn=new k,hl=new or,Es=new k,Ts=new k,Cs=new k,nr=new k,ir=new k,Ur=new k,Sa=new k,ul=new k,dl=new k,kr=new k;function Qu(i,e,t,n,r){for(let s=0,a=i.length-3;s<=a;s+=3){kr.fromArray(i,s);let o=r.x*Math.abs(kr.x)+r.y*Math.abs(kr.y)+r.z*Math.abs(kr.z),l=e.dot(kr),c=t.dot(kr),h=n.dot(kr);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>o)return!1}return!0}var wt=new k,pl=new $e,uy=0,At=class extends mi{constructor(e,t,n=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:uy++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=Od,this.updateRanges=[],this.gpuType=Mn,this.version=0,this._normalizationScale=e!==void 0?Xc(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let r=0,s=this.itemSize;r<s;r++)this.array[e+r]=t.array[n+r];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)pl.fromBufferAttribute(this,t),pl.applyMatrix3(e),this.setXY(t,pl.x,pl.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)wt.fromBufferAttribute(this,t),wt.applyMatrix3(e),this.setXYZ(t,wt.x,wt.y,wt.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)wt.fromBufferAttribute(this,t),wt.applyMatrix4(e),this.setXYZ(t,wt.x,wt.y,wt.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)wt.fromBufferAttribute(this,t),wt.applyNormalMatrix(e),this.setXYZ(t,wt.x,wt.y,wt.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)wt.fromBufferAttribute(this,t),wt.transformDirection(e),this.setXYZ(t,wt.x,wt.y,wt.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=r,this}setXYZW(e,t,n,r,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),r=this._normalize(r),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=r,this.array[e+3]=s,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):j0(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Q0(e,this.array)}};var za=class extends At{constructor(e,t,n){super(new Uint16Array(e),t,n)}};var Fa=class extends At{constructor(e,t,n){super(new Uint32Array(e),t,n)}};var zn=class extends At{constructor(e,t,n){super(new Float32Array(e),t,n)}},dy=new or,Ma=new k,ed=new k,Vr=class{constructor(e=new k,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):dy.setFromPoints(e).getCenter(n);let r=0;for(let s=0,a=e.length;s<a;s++)r=Math.max(r,n.distanceToSquared(e[s]));return this.radius=Math.sqrt(r),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Ma.subVectors(e,this.center);let t=Ma.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),r=(n-this.radius)*.5;this.center.addScaledVector(Ma,r/n),this.radius+=r}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(ed.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Ma.copy(e.center).add(ed)),this.expandByPoint(Ma.copy(e.center).sub(ed))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},py=0,Ln=new pt,td=new _n,Rs=new k,yn=new or,wa=new or,zt=new k,cn=class i extends mi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:py++}),this.uuid=Jr(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(jb(e)?Fa:za)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let s=new Fe().getNormalMatrix(e);n.applyNormalMatrix(s),n.needsUpdate=!0}let r=this.attributes.tangent;return r!==void 0&&(r.transformDirection(e),r.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Ln.makeRotationFromQuaternion(e),this.applyMatrix4(Ln),this}rotateX(e){return Ln.makeRotationX(e),this.applyMatrix4(Ln),this}rotateY(e){return Ln.makeRotationY(e),this.applyMatrix4(Ln),this}rotateZ(e){return Ln.makeRotationZ(e),this.applyMatrix4(Ln),this}translate(e,t,n){return Ln.makeTranslation(e,t,n),this.applyMatrix4(Ln),this}scale(e,t,n){return Ln.makeScale(e,t,n),this.applyMatrix4(Ln),this}lookAt(e){return td.lookAt(e),td.updateMatrix(),this.applyMatrix4(td.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Rs).negate(),this.translate(Rs.x,Rs.y,Rs.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let n=[];for(let r=0,s=e.length;r<s;r++){let a=e[r];n.push(a.x,a.y,a.z||0)}this.setAttribute("position",new zn(n,3))}else{let n=Math.min(e.length,t.count);for(let r=0;r<n;r++){let s=e[r];t.setXYZ(r,s.x,s.y,s.z||0)}e.length>t.count&&Ne("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new or);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){De("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new k(-1/0,-1/0,-1/0),new k(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,r=t.length;n<r;n++){let s=t[n];yn.setFromBufferAttribute(s),this.morphTargetsRelative?(zt.addVectors(this.boundingBox.min,yn.min),this.boundingBox.expandByPoint(zt),zt.addVectors(this.boundingBox.max,yn.max),this.boundingBox.expandByPoint(zt)):(this.boundingBox.expandByPoint(yn.min),this.boundingBox.expandByPoint(yn.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&De('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Vr);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){De("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new k,1/0);return}if(e){let n=this.boundingSphere.center;if(yn.setFromBufferAttribute(e),t)for(let s=0,a=t.length;s<a;s++){let o=t[s];wa.setFromBufferAttribute(o),this.morphTargetsRelative?(zt.addVectors(yn.min,wa.min),yn.expandByPoint(zt),zt.addVectors(yn.max,wa.max),yn.expandByPoint(zt)):(yn.expandByPoint(wa.min),yn.expandByPoint(wa.max))}yn.getCenter(n);let r=0;for(let s=0,a=e.count;s<a;s++)zt.fromBufferAttribute(e,s),r=Math.max(r,n.distanceToSquared(zt));if(t)for(let s=0,a=t.length;s<a;s++){let o=t[s],l=this.morphTargetsRelative;for(let c=0,h=o.count;c<h;c++)zt.fromBufferAttribute(o,c),l&&(Rs.fromBufferAttribute(e,c),zt.add(Rs)),r=Math.max(r,n.distanceToSquared(zt))}this.boundingSphere.radius=Math.sqrt(r),isNaN(this.boundingSphere.radius)&&De('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){De("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=t.position,r=t.normal,s=t.uv,a=this.getAttribute("tangent");(a===void 0||a.count!==n.count)&&(a=new At(new Float32Array(4*n.count),4),this.setAttribute("tangent",a));let o=[],l=[],c=new Uint8Array(n.count);for(let D=0;D<n.count;D++)o[D]=new k,l[D]=new k;let h=new k,d=new k,u=new k,p=new $e,f=new $e,b=new $e,m=new k,g=new k;function v(D,R,N){c[D]=c[R]=c[N]=1,h.fromBufferAttribute(n,D),d.fromBufferAttribute(n,R),u.fromBufferAttribute(n,N),p.fromBufferAttribute(s,D),f.fromBufferAttribute(s,R),b.fromBufferAttribute(s,N),d.sub(h),u.sub(h),f.sub(p),b.sub(p);let F=1/(f.x*b.y-b.x*f.y);isFinite(F)&&(m.copy(d).multiplyScalar(b.y).addScaledVector(u,-f.y).multiplyScalar(F),g.copy(u).multiplyScalar(f.x).addScaledVector(d,-b.x).multiplyScalar(F),o[D].add(m),o[R].add(m),o[N].add(m),l[D].add(g),l[R].add(g),l[N].add(g))}let M=this.groups;M.length===0&&(M=[{start:0,count:e.count}]);for(let D=0,R=M.length;D<R;++D){let N=M[D],F=N.start,V=N.count;for(let P=F,G=F+V;P<G;P+=3)v(e.getX(P+0),e.getX(P+1),e.getX(P+2))}let x=new k,E=new k,w=new k,y=new k;function A(D){w.fromBufferAttribute(r,D),y.copy(w);let R=o[D];x.copy(R),x.sub(w.multiplyScalar(w.dot(R))).normalize(),E.crossVectors(y,R);let F=E.dot(l[D])<0?-1:1;a.setXYZW(D,x.x,x.y,x.z,F)}for(let D=0,R=n.count;D<R;++D)c[D]&&A(D);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==t.count)n=new At(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let u=0,p=n.count;u<p;u++)n.setXYZ(u,0,0,0);let r=new k,s=new k,a=new k,o=new k,l=new k,c=new k,h=new k,d=new k;if(e)for(let u=0,p=e.count;u<p;u+=3){let f=e.getX(u+0),b=e.getX(u+1),m=e.getX(u+2);r.fromBufferAttribute(t,f),s.fromBufferAttribute(t,b),a.fromBufferAttribute(t,m),h.subVectors(a,s),d.subVectors(r,s),h.cross(d),o.fromBufferAttribute(n,f),l.fromBufferAttribute(n,b),c.fromBufferAttribute(n,m),o.add(h),l.add(h),c.add(h),n.setXYZ(f,o.x,o.y,o.z),n.setXYZ(b,l.x,l.y,l.z),n.setXYZ(m,c.x,c.y,c.z)}else for(let u=0,p=t.count;u<p;u+=3)r.fromBufferAttribute(t,u+0),s.fromBufferAttribute(t,u+1),a.fromBufferAttribute(t,u+2),h.subVectors(a,s),d.subVectors(r,s),h.cross(d),n.setXYZ(u+0,h.x,h.y,h.z),n.setXYZ(u+1,h.x,h.y,h.z),n.setXYZ(u+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)zt.fromBufferAttribute(e,t),zt.normalize(),e.setXYZ(t,zt.x,zt.y,zt.z)}toNonIndexed(){function e(o,l){let c=o.array,h=o.itemSize,d=o.normalized,u=new c.constructor(l.length*h),p=0,f=0;for(let b=0,m=l.length;b<m;b++){o.isInterleavedBufferAttribute?p=l[b]*o.data.stride+o.offset:p=l[b]*h;for(let g=0;g<h;g++)u[f++]=c[p++]}return new At(u,h,d)}if(this.index===null)return Ne("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new i,n=this.index.array,r=this.attributes;for(let o in r){let l=r[o],c=e(l,n);t.setAttribute(o,c)}let s=this.morphAttributes;for(let o in s){let l=[],c=s[o];for(let h=0,d=c.length;h<d;h++){let u=c[h],p=e(u,n);l.push(p)}t.morphAttributes[o]=l}t.morphTargetsRelative=this.morphTargetsRelative;let a=this.groups;for(let o=0,l=a.length;o<l;o++){let c=a[o];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let l in n){let c=n[l];e.data.attributes[l]=c.toJSON(e.data)}let r={},s=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let d=0,u=c.length;d<u;d++){let p=c[d];h.push(p.toJSON(e.data))}h.length>0&&(r[l]=h,s=!0)}s&&(e.data.morphAttributes=r,e.data.morphTargetsRelative=this.morphTargetsRelative);let a=this.groups;a.length>0&&(e.data.groups=JSON.parse(JSON.stringify(a)));let o=this.boundingSphere;return o!==null&&(e.data.boundingSphere=o.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let r=e.attributes;for(let c in r){let h=r[c];this.setAttribute(c,h.clone(t))}let s=e.morphAttributes;for(let c in s){let h=[],d=s[c];for(let u=0,p=d.length;u<p;u++)h.push(d[u].clone(t));this.morphAttributes[c]=h}this.morphTargetsRelative=e.morphTargetsRelative;let a=e.groups;for(let c=0,h=a.length;c<h;c++){let d=a[c];this.addGroup(d.start,d.count,d.materialIndex)}let o=e.boundingBox;o!==null&&(this.boundingBox=o.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},Gl=class{constructor(e,t){this.isInterleavedBuffer=!0,this.array=e,this.stride=t,this.count=e!==void 0?e.length/t:0,this.usage=Od,this.updateRanges=[],this.version=0,this.uuid=Jr()}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.array=new e.array.constructor(e.array),this.count=e.count,this.stride=e.stride,this.usage=e.usage,this}copyAt(e,t,n){e*=this.stride,n*=t.stride;for(let r=0,s=this.stride;r<s;r++)this.array[e+r]=t.array[n+r];return this}set(e,t=0){return this.array.set(e,t),this}clone(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=i0(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=this.array.slice(0).buffer);let n=new this.array.constructor(e.arrayBuffers[t]),r=new this.constructor(n,this.stride);return r.setUsage(this.usage),r}onUpload(e){return this.onUploadCallback=e,this}toJSON(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=i0(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let n={uuid:this.uuid,buffer:t,type:this.array.constructor.name,stride:this.stride};return n.usage=this.usage,n}};function i0(i){return i.buffer._uuid===void 0&&(i.buffer._uuid=Jr()),i.byteOffset===0&&i.byteLength===i.buffer.byteLength?i.buffer._uuid:i.buffer._uuid+":"+i.byteOffset+":"+i.byteLength}var jt=new k,ks=class i{constructor(e,t,n,r=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=e,this.itemSize=t,this.offset=n,this.normalized=r,this._normalizationScale=e!==void 0?Xc(e.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(e){this.data.needsUpdate=e}applyMatrix4(e){for(let t=0,n=this.data.count;t<n;t++)jt.fromBufferAttribute(this,t),jt.applyMatrix4(e),this.setXYZ(t,jt.x,jt.y,jt.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)jt.fromBufferAttribute(this,t),jt.applyNormalMatrix(e),this.setXYZ(t,jt.x,jt.y,jt.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)jt.fromBufferAttribute(this,t),jt.transformDirection(e),this.setXYZ(t,jt.x,jt.y,jt.z);return this}getComponent(e,t){let n=this.array[e*this.data.stride+this.offset+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.data.array[e*this.data.stride+this.offset+t]=n,this}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset]=t,this}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+1]=t,this}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+2]=t,this}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+3]=t,this}getX(e){let t=this.data.array[e*this.data.stride+this.offset];return this.normalized&&(t=this._denormalize(t)),t}getY(e){let t=this.data.array[e*this.data.stride+this.offset+1];return this.normalized&&(t=this._denormalize(t)),t}getZ(e){let t=this.data.array[e*this.data.stride+this.offset+2];return this.normalized&&(t=this._denormalize(t)),t}getW(e){let t=this.data.array[e*this.data.stride+this.offset+3];return this.normalized&&(t=this._denormalize(t)),t}setXY(e,t,n){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.data.array[e+0]=t,this.data.array[e+1]=n,this}setXYZ(e,t,n,r){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n),r=this._normalize(r)),this.data.array[e+0]=t,this.data.array[e+1]=n,this.data.array[e+2]=r,this}setXYZW(e,t,n,r,s){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n),r=this._normalize(r),s=this._normalize(s)),this.data.array[e+0]=t,this.data.array[e+1]=n,this.data.array[e+2]=r,this.data.array[e+3]=s,this}clone(e){if(e===void 0){Ia("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let n=0;n<this.count;n++){let r=n*this.data.stride+this.offset;for(let s=0;s<this.itemSize;s++)t.push(this.data.array[r+s])}return new At(new this.array.constructor(t),this.itemSize,this.normalized)}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.clone(e)),new i(e.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(e){if(e===void 0){Ia("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let n=0;n<this.count;n++){let r=n*this.data.stride+this.offset;for(let s=0;s<this.itemSize;s++)t.push(this.data.array[r+s])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:t,normalized:this.normalized}}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.toJSON(e)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):j0(e,this.data.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Q0(e,this.data.array)}},nd=new k,fy=new k,my=new Fe,ei=class{constructor(e=new k(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,r){return this.normal.set(e,t,n),this.constant=r,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let r=nd.subVectors(n,t).cross(fy.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(r,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,n=!0){let r=e.delta(nd),s=this.normal.dot(r);if(s===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let a=-(e.start.dot(this.normal)+this.constant)/s;return n===!0&&(a<0||a>1)?null:t.copy(e.start).addScaledVector(r,a)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let n=t||my.getNormalMatrix(e),r=this.coplanarPoint(nd).applyMatrix4(e),s=this.normal.applyMatrix3(n).normalize();return this.constant=-r.dot(s),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},gy=0,lr=class extends mi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:gy++}),this.uuid=Jr(),this.name="",this.type="Material",this.blending=Ws,this.side=dr,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=gd,this.blendDst=bd,this.blendEquation=$r,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Ge(0,0,0),this.blendAlpha=0,this.depthFunc=Ds,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=q0,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Pl,this.stencilZFail=Pl,this.stencilZPass=Pl,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){Ne(`Material: parameter '${t}' has value of undefined.`);continue}let r=this[t];if(r===void 0){Ne(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}r&&r.isColor?r.set(n):r&&r.isVector2&&n&&n.isVector2||r&&r.isEuler&&n&&n.isEuler||r&&r.isVector3&&n&&n.isVector3?r.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(s=>s.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function r(s){let a=[];for(let o in s){let l=s[o];delete l.metadata,a.push(l)}return a}if(t){let s=r(e.textures),a=r(e.images);s.length>0&&(n.textures=s),a.length>0&&(n.images=a)}return n}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new Ge().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(n=>new ei().fromJSON(n))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let n=e.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new $e().fromArray(n)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new $e().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;if(t!==null){let r=t.length;n=new Array(r);for(let s=0;s!==r;++s)n[s]=t[s].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var Pi=new k,id=new k,fl=new k,ml=new k,Oa=class{constructor(e=new k,t=new k(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Pi)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=Pi.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Pi.copy(this.origin).addScaledVector(this.direction,t),Pi.distanceToSquared(e))}distanceSqToSegment(e,t,n,r){id.copy(e).add(t).multiplyScalar(.5),fl.copy(t).sub(e).normalize(),ml.copy(this.origin).sub(id);let s=e.distanceTo(t)*.5,a=-this.direction.dot(fl),o=ml.dot(this.direction),l=-ml.dot(fl),c=ml.lengthSq(),h=Math.abs(1-a*a),d,u,p,f;if(h>0)if(d=a*l-o,u=a*o-l,f=s*h,d>=0)if(u>=-f)if(u<=f){let b=1/h;d*=b,u*=b,p=d*(d+a*u+2*o)+u*(a*d+u+2*l)+c}else u=s,d=Math.max(0,-(a*u+o)),p=-d*d+u*(u+2*l)+c;else u=-s,d=Math.max(0,-(a*u+o)),p=-d*d+u*(u+2*l)+c;else u<=-f?(d=Math.max(0,-(-a*s+o)),u=d>0?-s:Math.min(Math.max(-s,-l),s),p=-d*d+u*(u+2*l)+c):u<=f?(d=0,u=Math.min(Math.max(-s,-l),s),p=u*(u+2*l)+c):(d=Math.max(0,-(a*s+o)),u=d>0?s:Math.min(Math.max(-s,-l),s),p=-d*d+u*(u+2*l)+c);else u=a>0?-s:s,d=Math.max(0,-(a*u+o)),p=-d*d+u*(u+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,d),r&&r.copy(id).addScaledVector(fl,u),p}intersectSphere(e,t){if(e.radius<0)return null;Pi.subVectors(e.center,this.origin);let n=Pi.dot(this.direction),r=Pi.dot(Pi)-n*n,s=e.radius*e.radius;if(r>s)return null;let a=Math.sqrt(s-r),o=n-a,l=n+a;return l<0?null:o<0?this.at(l,t):this.at(o,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,r,s,a,o,l,c=1/this.direction.x,h=1/this.direction.y,d=1/this.direction.z,u=this.origin;return c>=0?(n=(e.min.x-u.x)*c,r=(e.max.x-u.x)*c):(n=(e.max.x-u.x)*c,r=(e.min.x-u.x)*c),h>=0?(s=(e.min.y-u.y)*h,a=(e.max.y-u.y)*h):(s=(e.max.y-u.y)*h,a=(e.min.y-u.y)*h),n>a||s>r||((s>n||isNaN(n))&&(n=s),(a<r||isNaN(r))&&(r=a),d>=0?(o=(e.min.z-u.z)*d,l=(e.max.z-u.z)*d):(o=(e.max.z-u.z)*d,l=(e.min.z-u.z)*d),n>l||o>r)||((o>n||n!==n)&&(n=o),(l<r||r!==r)&&(r=l),r<0)?null:this.at(n>=0?n:r,t)}intersectsBox(e){return this.intersectBox(e,Pi)!==null}intersectTriangle(e,t,n,r,s){let a=this.origin,o=this.direction,l=o.x,c=o.y,h=o.z,d=e.x-a.x,u=e.y-a.y,p=e.z-a.z,f=t.x-a.x,b=t.y-a.y,m=t.z-a.z,g=n.x-a.x,v=n.y-a.y,M=n.z-a.z,x=Math.abs(l),E=Math.abs(c),w=Math.abs(h),y,A,D,R,N,F,V,P,G,W,O,Q;if(x>=E&&x>=w?(D=l,F=d,G=f,Q=g,l>=0?(y=c,A=h,R=u,N=p,V=b,P=m,W=v,O=M):(y=h,A=c,R=p,N=u,V=m,P=b,W=M,O=v)):E>=w?(D=c,F=u,G=b,Q=v,c>=0?(y=h,A=l,R=p,N=d,V=m,P=f,W=M,O=g):(y=l,A=h,R=d,N=p,V=f,P=m,W=g,O=M)):(D=h,F=p,G=m,Q=M,h>=0?(y=l,A=c,R=d,N=u,V=f,P=b,W=g,O=v):(y=c,A=l,R=u,N=d,V=b,P=f,W=v,O=g)),D===0)return null;let H=y/D,J=A/D,te=1/D,ve=R-H*F,Ee=N-J*F,X=V-H*G,re=P-J*G,me=W-H*Q,Me=O-J*Q,pe=me*re-Me*X,Le=ve*Me-Ee*me,ft=X*Ee-re*ve;if(r){if(pe<0||Le<0||ft<0)return null}else if((pe<0||Le<0||ft<0)&&(pe>0||Le>0||ft>0))return null;let Ce=pe+Le+ft;if(Ce===0)return null;let et=te*(pe*F+Le*G+ft*Q);return(Ce>0?et<0:et>0)?null:this.at(et/Ce,s)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Wl=class extends lr{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Ge(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ar,this.combine=yd,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},r0=new pt,Br=new Oa,gl=new Vr,s0=new k,bl=new k,yl=new k,vl=new k,rd=new k,xl=new k,a0=new k,_l=new k,Yt=class extends _n{constructor(e=new cn,t=new Wl){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let r=t[n[0]];if(r!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let s=0,a=r.length;s<a;s++){let o=r[s].name||String(s);this.morphTargetInfluences.push(0),this.morphTargetDictionary[o]=s}}}}getVertexPosition(e,t){let n=this.geometry,r=n.attributes.position,s=n.morphAttributes.position,a=n.morphTargetsRelative;t.fromBufferAttribute(r,e);let o=this.morphTargetInfluences;if(s&&o){xl.set(0,0,0);for(let l=0,c=s.length;l<c;l++){let h=o[l],d=s[l];h!==0&&(rd.fromBufferAttribute(d,e),a?xl.addScaledVector(rd,h):xl.addScaledVector(rd.sub(t),h))}t.add(xl)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,r=this.material,s=this.matrixWorld;r!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),gl.copy(n.boundingSphere),gl.applyMatrix4(s),Br.copy(e.ray).recast(e.near),!(gl.containsPoint(Br.origin)===!1&&(Br.intersectSphere(gl,s0)===null||Br.origin.distanceToSquared(s0)>(e.far-e.near)**2))&&(r0.copy(s).invert(),Br.copy(e.ray).applyMatrix4(r0),!(n.boundingBox!==null&&Br.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,Br)))}_computeIntersections(e,t,n){let r,s=this.geometry,a=this.material,o=s.index,l=s.attributes.position,c=s.attributes.uv,h=s.attributes.uv1,d=s.attributes.normal,u=s.groups,p=s.drawRange;if(o!==null)if(Array.isArray(a))for(let f=0,b=u.length;f<b;f++){let m=u[f],g=a[m.materialIndex],v=Math.max(m.start,p.start),M=Math.min(o.count,Math.min(m.start+m.count,p.start+p.count));for(let x=v,E=M;x<E;x+=3){let w=o.getX(x),y=o.getX(x+1),A=o.getX(x+2);r=Sl(this,g,e,n,c,h,d,w,y,A),r&&(r.faceIndex=Math.floor(x/3),r.face.materialIndex=m.materialIndex,t.push(r))}}else{let f=Math.max(0,p.start),b=Math.min(o.count,p.start+p.count);for(let m=f,g=b;m<g;m+=3){let v=o.getX(m),M=o.getX(m+1),x=o.getX(m+2);r=Sl(this,a,e,n,c,h,d,v,M,x),r&&(r.faceIndex=Math.floor(m/3),t.push(r))}}else if(l!==void 0)if(Array.isArray(a))for(let f=0,b=u.length;f<b;f++){let m=u[f],g=a[m.materialIndex],v=Math.max(m.start,p.start),M=Math.min(l.count,Math.min(m.start+m.count,p.start+p.count));for(let x=v,E=M;x<E;x+=3){let w=x,y=x+1,A=x+2;r=Sl(this,g,e,n,c,h,d,w,y,A),r&&(r.faceIndex=Math.floor(x/3),r.face.materialIndex=m.materialIndex,t.push(r))}}else{let f=Math.max(0,p.start),b=Math.min(l.count,p.start+p.count);for(let m=f,g=b;m<g;m+=3){let v=m,M=m+1,x=m+2;r=Sl(this,a,e,n,c,h,d,v,M,x),r&&(r.faceIndex=Math.floor(m/3),t.push(r))}}}};function by(i,e,t,n,r,s,a,o){let l;if(e.side===en?l=n.intersectTriangle(a,s,r,!0,o):l=n.intersectTriangle(r,s,a,e.side===dr,o),l===null)return null;_l.copy(o),_l.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(_l);return c<t.near||c>t.far?null:{distance:c,point:_l.clone(),object:i}}function Sl(i,e,t,n,r,s,a,o,l,c){i.getVertexPosition(o,bl),i.getVertexPosition(l,yl),i.getVertexPosition(c,vl);let h=by(i,e,t,n,bl,yl,vl,a0);if(h){let d=new k;sr.getBarycoord(a0,bl,yl,vl,d),r&&(h.uv=sr.getInterpolatedAttribute(r,o,l,c,d,new $e)),s&&(h.uv1=sr.getInterpolatedAttribute(s,o,l,c,d,new $e)),a&&(h.normal=sr.getInterpolatedAttribute(a,o,l,c,d,new k),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let u={a:o,b:l,c,normal:new k,materialIndex:0};sr.getNormal(bl,yl,vl,u.normal),h.face=u,h.barycoord=d}return h}var Hr=class extends Qt{constructor(e=null,t=1,n=1,r,s,a,o,l,c=Et,h=Et,d,u){super(null,a,o,l,c,h,r,s,d,u),this.isDataTexture=!0,this.image={data:e,width:t,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var qr=new Vr,yy=new $e(.5,.5),Ml=new k,Gr=class{constructor(e=new ei,t=new ei,n=new ei,r=new ei,s=new ei,a=new ei){this.planes=[e,t,n,r,s,a]}set(e,t,n,r,s,a){let o=this.planes;return o[0].copy(e),o[1].copy(t),o[2].copy(n),o[3].copy(r),o[4].copy(s),o[5].copy(a),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=Dn,n=!1){let r=this.planes,s=e.elements,a=s[0],o=s[1],l=s[2],c=s[3],h=s[4],d=s[5],u=s[6],p=s[7],f=s[8],b=s[9],m=s[10],g=s[11],v=s[12],M=s[13],x=s[14],E=s[15];if(r[0].setComponents(c-a,p-h,g-f,E-v).normalize(),r[1].setComponents(c+a,p+h,g+f,E+v).normalize(),r[2].setComponents(c+o,p+d,g+b,E+M).normalize(),r[3].setComponents(c-o,p-d,g-b,E-M).normalize(),n)r[4].setComponents(l,u,m,x).normalize(),r[5].setComponents(c-l,p-u,g-m,E-x).normalize();else if(r[4].setComponents(c-l,p-u,g-m,E-x).normalize(),t===Dn)r[5].setComponents(c+l,p+u,g+m,E+x).normalize();else if(t===Ra)r[5].setComponents(l,u,m,x).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),qr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),qr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(qr)}intersectsSprite(e){qr.center.set(0,0,0);let t=yy.distanceTo(e.center);return qr.radius=.7071067811865476+t,qr.applyMatrix4(e.matrixWorld),this.intersectsSphere(qr)}intersectsSphere(e){let t=this.planes,n=e.center,r=-e.radius;for(let s=0;s<6;s++)if(t[s].distanceToPoint(n)<r)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let r=t[n];if(Ml.x=r.normal.x>0?e.max.x:e.min.x,Ml.y=r.normal.y>0?e.max.y:e.min.y,Ml.z=r.normal.z>0?e.max.z:e.min.z,r.distanceToPoint(Ml)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},o0=new pt,$l=class i{constructor(){this.coordinateSystem=Dn,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,n=this._frustums;for(let r=0;r<t.length;r++){let s=t[r];o0.multiplyMatrices(s.projectionMatrix,s.matrixWorldInverse),n[r]===void 0&&(n[r]=new Gr),n[r].setFromProjectionMatrix(o0,s.coordinateSystem,s.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,n=e._frustums;for(let r=0;r<e._count;r++)t[r]===void 0&&(t[r]=new Gr),t[r].copy(n[r]);return this._count=e._count,this}clone(){return new i().copy(this)}};var Xl=class extends lr{constructor(e){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new Ge(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.alphaMap=e.alphaMap,this.size=e.size,this.sizeAttenuation=e.sizeAttenuation,this.fog=e.fog,this}},l0=new pt,cd=new Oa,wl=new Vr,Al=new k,Bs=class extends _n{constructor(e=new cn,t=new Xl){super(),this.isPoints=!0,this.type="Points",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,r=this.matrixWorld,s=e.params.Points.threshold,a=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),wl.copy(n.boundingSphere),wl.applyMatrix4(r),wl.radius+=s,e.ray.intersectsSphere(wl)===!1)return;l0.copy(r).invert(),cd.copy(e.ray).applyMatrix4(l0);let o=s/((this.scale.x+this.scale.y+this.scale.z)/3),l=o*o,c=n.index,d=n.attributes.position;if(c!==null){let u=Math.max(0,a.start),p=Math.min(c.count,a.start+a.count);for(let f=u,b=p;f<b;f++){let m=c.getX(f);Al.fromBufferAttribute(d,m),c0(Al,m,l,r,e,t,this)}}else{let u=Math.max(0,a.start),p=Math.min(d.count,a.start+a.count);for(let f=u,b=p;f<b;f++)Al.fromBufferAttribute(d,f),c0(Al,f,l,r,e,t,this)}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let r=t[n[0]];if(r!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let s=0,a=r.length;s<a;s++){let o=r[s].name||String(s);this.morphTargetInfluences.push(0),this.morphTargetDictionary[o]=s}}}}};function c0(i,e,t,n,r,s,a){let o=cd.distanceSqToPoint(i);if(o<t){let l=new k;cd.closestPointToPoint(i,l),l.applyMatrix4(n);let c=r.ray.origin.distanceTo(l);if(c<r.near||c>r.far)return;s.push({distance:c,distanceToRay:Math.sqrt(o),point:l,index:e,face:null,faceIndex:null,barycoord:null,object:a})}}var Ua=class extends Qt{constructor(e=[],t=Xr,n,r,s,a,o,l,c,h){super(e,t,n,r,s,a,o,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}},ka=class extends Qt{constructor(e,t,n,r,s,a,o,l,c){super(e,t,n,r,s,a,o,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}};var Di=class extends Qt{constructor(e,t,n=ti,r,s,a,o=Et,l=Et,c,h=Li,d=1){if(h!==Li&&h!==Fi)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let u={width:e,height:t,depth:d};super(u,r,s,a,o,l,h,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Os(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},Ba=class extends Di{constructor(e,t=ti,n=Xr,r,s,a=Et,o=Et,l,c=Li){let h={width:e,height:e,depth:1},d=[h,h,h,h,h,h];super(e,e,t,n,r,s,a,o,l,c),this.image=d,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},qa=class extends Qt{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},qs=class i extends cn{constructor(e=1,t=1,n=1,r=1,s=1,a=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:r,heightSegments:s,depthSegments:a};let o=this;r=Math.floor(r),s=Math.floor(s),a=Math.floor(a);let l=[],c=[],h=[],d=[],u=0,p=0;f("z","y","x",-1,-1,n,t,e,a,s,0),f("z","y","x",1,-1,n,t,-e,a,s,1),f("x","z","y",1,1,e,n,t,r,a,2),f("x","z","y",1,-1,e,n,-t,r,a,3),f("x","y","z",1,-1,e,t,n,r,s,4),f("x","y","z",-1,-1,e,t,-n,r,s,5),this.setIndex(l),this.setAttribute("position",new zn(c,3)),this.setAttribute("normal",new zn(h,3)),this.setAttribute("uv",new zn(d,2));function f(b,m,g,v,M,x,E,w,y,A,D){let R=x/y,N=E/A,F=x/2,V=E/2,P=w/2,G=y+1,W=A+1,O=0,Q=0,H=new k;for(let J=0;J<W;J++){let te=J*N-V;for(let ve=0;ve<G;ve++){let Ee=ve*R-F;H[b]=Ee*v,H[m]=te*M,H[g]=P,c.push(H.x,H.y,H.z),H[b]=0,H[m]=0,H[g]=w>0?1:-1,h.push(H.x,H.y,H.z),d.push(ve/y),d.push(1-J/A),O+=1}}for(let J=0;J<A;J++)for(let te=0;te<y;te++){let ve=u+te+G*J,Ee=u+te+G*(J+1),X=u+(te+1)+G*(J+1),re=u+(te+1)+G*J;l.push(ve,Ee,re),l.push(Ee,X,re),Q+=6}o.addGroup(p,Q,D),p+=Q,u+=O}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var Va=class i extends cn{constructor(e=1,t=1,n=1,r=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:r};let s=e/2,a=t/2,o=Math.floor(n),l=Math.floor(r),c=o+1,h=l+1,d=e/o,u=t/l,p=[],f=[],b=[],m=[];for(let g=0;g<h;g++){let v=g*u-a;for(let M=0;M<c;M++){let x=M*d-s;f.push(x,-v,0),b.push(0,0,1),m.push(M/o),m.push(1-g/l)}}for(let g=0;g<l;g++)for(let v=0;v<o;v++){let M=v+c*g,x=v+c*(g+1),E=v+1+c*(g+1),w=v+1+c*g;p.push(M,x,w),p.push(x,E,w)}this.setIndex(p),this.setAttribute("position",new zn(f,3)),this.setAttribute("normal",new zn(b,3)),this.setAttribute("uv",new zn(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.widthSegments,e.heightSegments)}};function Zr(i){let e={};for(let t in i){e[t]={};for(let n in i[t]){let r=i[t][n];if(h0(r))r.isRenderTargetTexture?(Ne("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=r.clone();else if(Array.isArray(r))if(h0(r[0])){let s=[];for(let a=0,o=r.length;a<o;a++)s[a]=r[a].clone();e[t][n]=s}else e[t][n]=r.slice();else e[t][n]=r}}return e}function Zt(i){let e={};for(let t=0;t<i.length;t++){let n=Zr(i[t]);for(let r in n)e[r]=n[r]}return e}function h0(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function vy(i){let e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function Ud(i){let e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:Ke.workingColorSpace}var tg={clone:Zr,merge:Zt},xy=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,_y=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Jt=class extends lr{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=xy,this.fragmentShader=_y,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Zr(e.uniforms),this.uniformsGroups=vy(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let r in this.uniforms){let a=this.uniforms[r].value;a&&a.isTexture?t.uniforms[r]={type:"t",value:a.toJSON(e).uuid}:a&&a.isColor?t.uniforms[r]={type:"c",value:a.getHex()}:a&&a.isVector2?t.uniforms[r]={type:"v2",value:a.toArray()}:a&&a.isVector3?t.uniforms[r]={type:"v3",value:a.toArray()}:a&&a.isVector4?t.uniforms[r]={type:"v4",value:a.toArray()}:a&&a.isMatrix3?t.uniforms[r]={type:"m3",value:a.toArray()}:a&&a.isMatrix4?t.uniforms[r]={type:"m4",value:a.toArray()}:t.uniforms[r]={value:a}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let n={};for(let r in this.extensions)this.extensions[r]===!0&&(n[r]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let n in e.uniforms){let r=e.uniforms[n];switch(this.uniforms[n]={},r.type){case"t":this.uniforms[n].value=t[r.value]||null;break;case"c":this.uniforms[n].value=new Ge().setHex(r.value);break;case"v2":this.uniforms[n].value=new $e().fromArray(r.value);break;case"v3":this.uniforms[n].value=new k().fromArray(r.value);break;case"v4":this.uniforms[n].value=new ht().fromArray(r.value);break;case"m3":this.uniforms[n].value=new Fe().fromArray(r.value);break;case"m4":this.uniforms[n].value=new pt().fromArray(r.value);break;default:this.uniforms[n].value=r.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let n in e.extensions)this.extensions[n]=e.extensions[n];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},Yl=class extends Jt{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Jl=class extends lr{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=k0,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},Zl=class extends lr{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function Ps(i,e){return!i||i.constructor===e?i:typeof e.BYTES_PER_ELEMENT=="number"?new e(i):Array.prototype.slice.call(i)}function El(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var cr=class{constructor(e,t,n,r){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=r!==void 0?r:new t.constructor(n),this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,r=t[n],s=t[n-1];e:{t:{let a;n:{i:if(!(e<r)){for(let o=n+2;;){if(r===void 0){if(e<s)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===o)break;if(s=r,r=t[++n],e<r)break t}a=t.length;break n}if(!(e>=s)){let o=t[1];e<o&&(n=2,s=o);for(let l=n-2;;){if(s===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(r=s,s=t[--n-1],e>=s)break t}a=n,n=0;break n}break e}for(;n<a;){let o=n+a>>>1;e<t[o]?a=o:n=o+1}if(r=t[n],s=t[n-1],s===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(r===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,s,r)}return this.interpolate_(n,s,e,r)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,r=this.valueSize,s=e*r;for(let a=0;a!==r;++a)t[a]=n[s+a];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Kl=class extends cr{constructor(e,t,n,r){super(e,t,n,r),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:ad,endingEnd:ad}}intervalChanged_(e,t,n){let r=this.parameterPositions,s=e-2,a=e+1,o=r[s],l=r[a];if(o===void 0)switch(this.getSettings_().endingStart){case od:s=e,o=2*t-n;break;case ld:s=r.length-2,o=t+r[s]-r[s+1];break;default:s=e,o=n}if(l===void 0)switch(this.getSettings_().endingEnd){case od:a=e,l=2*n-t;break;case ld:a=1,l=n+r[1]-r[0];break;default:a=e-1,l=t}let c=(n-t)*.5,h=this.valueSize;this._weightPrev=c/(t-o),this._weightNext=c/(l-n),this._offsetPrev=s*h,this._offsetNext=a*h}interpolate_(e,t,n,r){let s=this.resultBuffer,a=this.sampleValues,o=this.valueSize,l=e*o,c=l-o,h=this._offsetPrev,d=this._offsetNext,u=this._weightPrev,p=this._weightNext,f=(n-t)/(r-t),b=f*f,m=b*f,g=-u*m+2*u*b-u*f,v=(1+u)*m+(-1.5-2*u)*b+(-.5+u)*f+1,M=(-1-p)*m+(1.5+p)*b+.5*f,x=p*m-p*b;for(let E=0;E!==o;++E)s[E]=g*a[h+E]+v*a[c+E]+M*a[l+E]+x*a[d+E];return s}},jl=class extends cr{constructor(e,t,n,r){super(e,t,n,r)}interpolate_(e,t,n,r){let s=this.resultBuffer,a=this.sampleValues,o=this.valueSize,l=e*o,c=l-o,h=(n-t)/(r-t),d=1-h;for(let u=0;u!==o;++u)s[u]=a[c+u]*d+a[l+u]*h;return s}},Ql=class extends cr{constructor(e,t,n,r){super(e,t,n,r)}interpolate_(e){return this.copySampleValue_(e-1)}},ec=class extends cr{interpolate_(e,t,n,r){let s=this.resultBuffer,a=this.sampleValues,o=this.valueSize,l=e*o,c=l-o,h=this.inTangents,d=this.outTangents;if(!h||!d){let f=(n-t)/(r-t),b=1-f;for(let m=0;m!==o;++m)s[m]=a[c+m]*b+a[l+m]*f;return s}let u=o*2,p=e-1;for(let f=0;f!==o;++f){let b=a[c+f],m=a[l+f],g=p*u+f*2,v=d[g],M=d[g+1],x=e*u+f*2,E=h[x],w=h[x+1],y=My(n,t,v,E,r);s[f]=ng(y,b,M,w,m)}return s}};function ng(i,e,t,n,r){let s=1-i;return s*s*s*e+3*s*s*i*t+3*s*i*i*n+i*i*i*r}function Sy(i,e,t,n,r){let s=1-i;return 3*s*s*(t-e)+6*s*i*(n-t)+3*i*i*(r-n)}function My(i,e,t,n,r){let s=(i-e)/(r-e);for(let a=0;a<8;a++){let o=ng(s,e,t,n,r)-i;if(Math.abs(o)<1e-10)break;let l=Sy(s,e,t,n,r);if(Math.abs(l)<1e-10)break;s=Math.max(0,Math.min(1,s-o/l))}return s}var Sn=class{constructor(e,t,n,r){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Ps(t,this.TimeBufferType),this.values=Ps(n,this.ValueBufferType),this.setInterpolation(r||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:Ps(e.times,Array),values:Ps(e.values,Array)};let r=e.getInterpolation();r!==e.DefaultInterpolation&&(n.interpolation=r),El(e.settings)&&(n.settings={inTangents:Ps(e.settings.inTangents,Array),outTangents:Ps(e.settings.outTangents,Array)})}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new Ql(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new jl(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new Kl(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new ec(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case Ea:t=this.InterpolantFactoryMethodDiscrete;break;case kl:t=this.InterpolantFactoryMethodLinear;break;case Rl:t=this.InterpolantFactoryMethodSmooth;break;case sd:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return Ne("KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Ea;case this.InterpolantFactoryMethodLinear:return kl;case this.InterpolantFactoryMethodSmooth:return Rl;case this.InterpolantFactoryMethodBezier:return sd}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,r=t.length;n!==r;++n)t[n]+=e;El(this.settings)&&(u0(this.settings.inTangents,e),u0(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,r=t.length;n!==r;++n)t[n]*=e;El(this.settings)&&(d0(this.settings.inTangents,e),d0(this.settings.outTangents,e))}return this}trim(e,t){let n=this.times,r=n.length,s=0,a=r-1;for(;s!==r&&n[s]<e;)++s;for(;a!==-1&&n[a]>t;)--a;if(++a,s!==0||a!==r){s>=a&&(a=Math.max(a,1),s=a-1);let o=this.getValueSize();this.times=n.slice(s,a),this.values=this.values.slice(s*o,a*o)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(De("KeyframeTrack: Invalid value size in track.",this),e=!1);let n=this.times,r=this.values,s=n.length;s===0&&(De("KeyframeTrack: Track is empty.",this),e=!1);let a=null;for(let o=0;o!==s;o++){let l=n[o];if(typeof l=="number"&&isNaN(l)){De("KeyframeTrack: Time is not a valid number.",this,o,l),e=!1;break}if(a!==null&&a>l){De("KeyframeTrack: Out of order keys.",this,o,l,a),e=!1;break}a=l}if(r!==void 0&&Qb(r))for(let o=0,l=r.length;o!==l;++o){let c=r[o];if(isNaN(c)){De("KeyframeTrack: Value is not a valid number.",this,o,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),r=this.getInterpolation()===Rl,s=e.length-1,a=1;for(let o=1;o<s;++o){let l=!1,c=e[o],h=e[o+1];if(c!==h&&(o!==1||c!==e[0]))if(r)l=!0;else{let d=o*n,u=d-n,p=d+n;for(let f=0;f!==n;++f){let b=t[d+f];if(b!==t[u+f]||b!==t[p+f]){l=!0;break}}}if(l){if(o!==a){e[a]=e[o];let d=o*n,u=a*n;for(let p=0;p!==n;++p)t[u+p]=t[d+p]}++a}}if(s>0){e[a]=e[s];for(let o=s*n,l=a*n,c=0;c!==n;++c)t[l+c]=t[o+c];++a}return a!==e.length?(this.times=e.slice(0,a),this.values=t.slice(0,a*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,r=new n(this.name,e,t);return r.createInterpolant=this.createInterpolant,El(this.settings)&&(r.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),r}};function u0(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]+=e}function d0(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]*=e}Sn.prototype.ValueTypeName="";Sn.prototype.TimeBufferType=Float32Array;Sn.prototype.ValueBufferType=Float32Array;Sn.prototype.DefaultInterpolation=kl;var hr=class extends Sn{constructor(e,t,n){super(e,t,n)}};hr.prototype.ValueTypeName="bool";hr.prototype.ValueBufferType=Array;hr.prototype.DefaultInterpolation=Ea;hr.prototype.InterpolantFactoryMethodLinear=void 0;hr.prototype.InterpolantFactoryMethodSmooth=void 0;var tc=class extends Sn{constructor(e,t,n,r){super(e,t,n,r)}};tc.prototype.ValueTypeName="color";var nc=class extends Sn{constructor(e,t,n,r){super(e,t,n,r)}};nc.prototype.ValueTypeName="number";var ic=class extends cr{constructor(e,t,n,r){super(e,t,n,r)}interpolate_(e,t,n,r){let s=this.resultBuffer,a=this.sampleValues,o=this.valueSize,l=(n-t)/(r-t),c=e*o;for(let h=c+o;c!==h;c+=4)gi.slerpFlat(s,0,a,c-o,a,c,l);return s}},Ha=class extends Sn{constructor(e,t,n,r){super(e,t,n,r)}InterpolantFactoryMethodLinear(e){return new ic(this.times,this.values,this.getValueSize(),e)}};Ha.prototype.ValueTypeName="quaternion";Ha.prototype.InterpolantFactoryMethodSmooth=void 0;var ur=class extends Sn{constructor(e,t,n){super(e,t,n)}};ur.prototype.ValueTypeName="string";ur.prototype.ValueBufferType=Array;ur.prototype.DefaultInterpolation=Ea;ur.prototype.InterpolantFactoryMethodLinear=void 0;ur.prototype.InterpolantFactoryMethodSmooth=void 0;var rc=class extends Sn{constructor(e,t,n,r){super(e,t,n,r)}};rc.prototype.ValueTypeName="vector";var sc=class{constructor(e,t,n){let r=this,s=!1,a=0,o=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this._abortController=null,this.itemStart=function(h){o++,s===!1&&r.onStart!==void 0&&r.onStart(h,a,o),s=!0},this.itemEnd=function(h){a++,r.onProgress!==void 0&&r.onProgress(h,a,o),a===o&&(s=!1,r.onLoad!==void 0&&r.onLoad())},this.itemError=function(h){r.onError!==void 0&&r.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,d){return c.push(h,d),this},this.removeHandler=function(h){let d=c.indexOf(h);return d!==-1&&c.splice(d,2),this},this.getHandler=function(h){for(let d=0,u=c.length;d<u;d+=2){let p=c[d],f=c[d+1];if(p.global&&(p.lastIndex=0),p.test(h))return f}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},ig=new sc,ac=class{constructor(e){this.manager=e!==void 0?e:ig,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let n=this;return new Promise(function(r,s){n.load(e,r,t,s)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};ac.DEFAULT_MATERIAL_NAME="__DEFAULT";var Tl=new k,Cl=new gi,pi=new k,Ga=class extends _n{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new pt,this.projectionMatrix=new pt,this.projectionMatrixInverse=new pt,this.coordinateSystem=Dn,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(Tl,Cl,pi),pi.x===1&&pi.y===1&&pi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Tl,Cl,pi.set(1,1,1)).invert()}updateWorldMatrix(e,t,n=!1){super.updateWorldMatrix(e,t,n),this.matrixWorld.decompose(Tl,Cl,pi),pi.x===1&&pi.y===1&&pi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Tl,Cl,pi.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},rr=new k,p0=new $e,f0=new $e,Xt=class extends Ga{constructor(e=50,t=1,n=.1,r=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=r,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=Bl*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(Uu*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Bl*2*Math.atan(Math.tan(Uu*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){rr.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(rr.x,rr.y).multiplyScalar(-e/rr.z),rr.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(rr.x,rr.y).multiplyScalar(-e/rr.z)}getViewSize(e,t){return this.getViewBounds(e,p0,f0),t.subVectors(f0,p0)}setViewOffset(e,t,n,r,s,a){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=r,this.view.width=s,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(Uu*.5*this.fov)/this.zoom,n=2*t,r=this.aspect*n,s=-.5*r,a=this.view;if(this.view!==null&&this.view.enabled){let l=a.fullWidth,c=a.fullHeight;s+=a.offsetX*r/l,t-=a.offsetY*n/c,r*=a.width/l,n*=a.height/c}let o=this.filmOffset;o!==0&&(s+=e*o/this.getFilmWidth()),this.projectionMatrix.makePerspective(s,s+r,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var Vs=class extends Ga{constructor(e=-1,t=1,n=1,r=-1,s=.1,a=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=r,this.near=s,this.far=a,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,r,s,a){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=r,this.view.width=s,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,r=(this.top+this.bottom)/2,s=n-e,a=n+e,o=r+t,l=r-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;s+=c*this.view.offsetX,a=s+c*this.view.width,o-=h*this.view.offsetY,l=o-h*this.view.height}this.projectionMatrix.makeOrthographic(s,a,o,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}};var Wa=class extends cn{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(e){return super.copy(e),this.instanceCount=e.instanceCount,this}toJSON(){let e=super.toJSON();return e.instanceCount=this.instanceCount,e.isInstancedBufferGeometry=!0,e}};var Is=-90,Ns=1,Hs=class extends _n{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let r=new Xt(Is,Ns,e,t);r.layers=this.layers,this.add(r);let s=new Xt(Is,Ns,e,t);s.layers=this.layers,this.add(s);let a=new Xt(Is,Ns,e,t);a.layers=this.layers,this.add(a);let o=new Xt(Is,Ns,e,t);o.layers=this.layers,this.add(o);let l=new Xt(Is,Ns,e,t);l.layers=this.layers,this.add(l);let c=new Xt(Is,Ns,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[n,r,s,a,o,l]=t;for(let c of t)this.remove(c);if(e===Dn)n.up.set(0,1,0),n.lookAt(1,0,0),r.up.set(0,1,0),r.lookAt(-1,0,0),s.up.set(0,0,-1),s.lookAt(0,1,0),a.up.set(0,0,1),a.lookAt(0,-1,0),o.up.set(0,1,0),o.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===Ra)n.up.set(0,-1,0),n.lookAt(-1,0,0),r.up.set(0,-1,0),r.lookAt(1,0,0),s.up.set(0,0,1),s.lookAt(0,1,0),a.up.set(0,0,-1),a.lookAt(0,-1,0),o.up.set(0,-1,0),o.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:r}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[s,a,o,l,c,h]=this.children,d=e.getRenderTarget(),u=e.getActiveCubeFace(),p=e.getActiveMipmapLevel(),f=e.xr.enabled;e.xr.enabled=!1;let b=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let m=!1;e.isWebGLRenderer===!0?m=e.state.buffers.depth.getReversed():m=e.reversedDepthBuffer,e.setRenderTarget(n,0,r),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,s),e.setRenderTarget(n,1,r),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(n,2,r),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(n,3,r),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(n,4,r),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),n.texture.mipmapsAutoUpdate=b,e.setRenderTarget(n,5,r),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,h),e.setRenderTarget(d,u,p),e.xr.enabled=f,n.texture.needsPMREMUpdate=!0}},oc=class extends Xt{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var kd="\\[\\]\\.:\\/",wy=new RegExp("["+kd+"]","g"),Bd="[^"+kd+"]",Ay="[^"+kd.replace("\\.","")+"]",Ey=/((?:WC+[\/:])*)/.source.replace("WC",Bd),Ty=/(WCOD+)?/.source.replace("WCOD",Ay),Cy=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Bd),Ry=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Bd),Py=new RegExp("^"+Ey+Ty+Cy+Ry+"$"),Iy=["material","materials","bones","map"],hd=class{constructor(e,t,n){let r=n||dt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,r)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,r=this._bindings[n];r!==void 0&&r.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let r=this._targetGroup.nCachedObjects_,s=n.length;r!==s;++r)n[r].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},dt=class i{constructor(e,t,n){this.path=t,this.parsedPath=n||i.parseTrackName(t),this.node=i.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){return e&&e.isAnimationObjectGroup?new i.Composite(e,t,n):new i(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(wy,"")}static parseTrackName(e){let t=Py.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},r=n.nodeName&&n.nodeName.lastIndexOf(".");if(r!==void 0&&r!==-1){let s=n.nodeName.substring(r+1);Iy.indexOf(s)!==-1&&(n.nodeName=n.nodeName.substring(0,r),n.objectName=s)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=function(s){for(let a=0;a<s.length;a++){let o=s[a];if(o.name===t||o.uuid===t)return o;let l=n(o.children);if(l)return l}return null},r=n(e.children);if(r)return r}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let r=0,s=n.length;r!==s;++r)e[t++]=n[r]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let r=0,s=n.length;r!==s;++r)n[r]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let r=0,s=n.length;r!==s;++r)n[r]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let r=0,s=n.length;r!==s;++r)n[r]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,n=t.objectName,r=t.propertyName,s=t.propertyIndex;if(e||(e=i.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Ne("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=t.objectIndex;switch(n){case"materials":if(!e.material){De("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){De("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){De("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let h=0;h<e.length;h++)if(e[h].name===c){c=h;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){De("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){De("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){De("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(c!==void 0){if(e[c]===void 0){De("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let a=e[r];if(a===void 0){let c=t.nodeName;De("PropertyBinding: Trying to update property for track: "+c+"."+r+" but it wasn't found.",e);return}let o=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?o=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(o=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(s!==void 0){if(r==="morphTargetInfluences"){if(!e.geometry){De("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){De("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[s]!==void 0&&(s=e.morphTargetDictionary[s])}l=this.BindingType.ArrayElement,this.resolvedProperty=a,this.propertyIndex=s}else a.fromArray!==void 0&&a.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=a):Array.isArray(a)?(l=this.BindingType.EntireArray,this.resolvedProperty=a):this.propertyName=r;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][o]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};dt.Composite=hd;dt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};dt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};dt.prototype.GetterByBindingType=[dt.prototype._getValue_direct,dt.prototype._getValue_array,dt.prototype._getValue_arrayElement,dt.prototype._getValue_toArray];dt.prototype.SetterByBindingTypeAndVersioning=[[dt.prototype._setValue_direct,dt.prototype._setValue_direct_setNeedsUpdate,dt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[dt.prototype._setValue_array,dt.prototype._setValue_array_setNeedsUpdate,dt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[dt.prototype._setValue_arrayElement,dt.prototype._setValue_arrayElement_setNeedsUpdate,dt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[dt.prototype._setValue_fromArray,dt.prototype._setValue_fromArray_setNeedsUpdate,dt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var _T=new Float32Array(1);var $a=class extends Gl{constructor(e,t,n=1){super(e,t),this.isInstancedInterleavedBuffer=!0,this.meshPerAttribute=n}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}clone(e){let t=super.clone(e);return t.meshPerAttribute=this.meshPerAttribute,t}toJSON(e){let t=super.toJSON(e);return t.isInstancedInterleavedBuffer=!0,t.meshPerAttribute=this.meshPerAttribute,t}};var ud=class{static{this.prototype.isMatrix2=!0}constructor(e,t,n,r){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,n,r)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let n=0;n<4;n++)this.elements[n]=e[n+t];return this}set(e,t,n,r){let s=this.elements;return s[0]=e,s[2]=t,s[1]=n,s[3]=r,this}};function qd(i,e,t,n){let r=Ny(n);switch(t){case Id:return i*e;case Ja:return i*e/r.components*r.byteLength;case fc:return i*e/r.components*r.byteLength;case pr:return i*e*2/r.components*r.byteLength;case mc:return i*e*2/r.components*r.byteLength;case Nd:return i*e*3/r.components*r.byteLength;case wn:return i*e*4/r.components*r.byteLength;case gc:return i*e*4/r.components*r.byteLength;case Za:case Ka:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case ja:case Qa:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case yc:case xc:return Math.max(i,16)*Math.max(e,8)/4;case bc:case vc:return Math.max(i,8)*Math.max(e,8)/2;case _c:case Sc:case wc:case Ac:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Mc:case eo:case Ec:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Tc:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Cc:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case Rc:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case Pc:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case Ic:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case Nc:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case Lc:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case Dc:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case zc:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case Fc:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case Oc:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case Uc:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case kc:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case Bc:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case qc:case Vc:case Hc:return Math.ceil(i/4)*Math.ceil(e/4)*16;case Gc:case Wc:return Math.ceil(i/4)*Math.ceil(e/4)*8;case to:case $c:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function Ny(i){switch(i){case tn:case Td:return{byteLength:1,components:1};case Xs:case Cd:case ni:return{byteLength:2,components:1};case dc:case pc:return{byteLength:2,components:4};case ti:case uc:case Mn:return{byteLength:4,components:1};case Rd:case Pd:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Ne("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Ag(){let i=null,e=!1,t=null,n=null;function r(s,a){n=i.requestAnimationFrame(r),t(s,a)}return{start:function(){e!==!0&&t!==null&&i!==null&&(n=i.requestAnimationFrame(r),e=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(s){t=s},setContext:function(s){i=s}}}function Dy(i){let e=new WeakMap;function t(o,l){let c=o.array,h=o.usage,d=c.byteLength,u=i.createBuffer();i.bindBuffer(l,u),i.bufferData(l,c,h),o.onUploadCallback();let p;if(c instanceof Float32Array)p=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)p=i.HALF_FLOAT;else if(c instanceof Uint16Array)o.isFloat16BufferAttribute?p=i.HALF_FLOAT:p=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)p=i.SHORT;else if(c instanceof Uint32Array)p=i.UNSIGNED_INT;else if(c instanceof Int32Array)p=i.INT;else if(c instanceof Int8Array)p=i.BYTE;else if(c instanceof Uint8Array)p=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)p=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:u,type:p,bytesPerElement:c.BYTES_PER_ELEMENT,version:o.version,size:d}}function n(o,l,c){let h=l.array,d=l.updateRanges;if(i.bindBuffer(c,o),d.length===0)i.bufferSubData(c,0,h);else{d.sort((p,f)=>p.start-f.start);let u=0;for(let p=1;p<d.length;p++){let f=d[u],b=d[p];b.start<=f.start+f.count+1?f.count=Math.max(f.count,b.start+b.count-f.start):(++u,d[u]=b)}d.length=u+1;for(let p=0,f=d.length;p<f;p++){let b=d[p];i.bufferSubData(c,b.start*h.BYTES_PER_ELEMENT,h,b.start,b.count)}l.clearUpdateRanges()}l.onUploadCallback()}function r(o){return o.isInterleavedBufferAttribute&&(o=o.data),e.get(o)}function s(o){o.isInterleavedBufferAttribute&&(o=o.data);let l=e.get(o);l&&(i.deleteBuffer(l.buffer),e.delete(o))}function a(o,l){if(o.isInterleavedBufferAttribute&&(o=o.data),o.isGLBufferAttribute){let h=e.get(o);(!h||h.version<o.version)&&e.set(o,{buffer:o.buffer,type:o.type,bytesPerElement:o.elementSize,version:o.version});return}let c=e.get(o);if(c===void 0)e.set(o,t(o,l));else if(c.version<o.version){if(c.size!==o.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,o,l),c.version=o.version}}return{get:r,remove:s,update:a}}var zy=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,Fy=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,Oy=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,Uy=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,ky=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,By=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,qy=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,Vy=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,Hy=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,Gy=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,Wy=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,$y=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,Xy=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,Yy=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,Jy=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,Zy=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,Ky=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,jy=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Qy=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,ev=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,tv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,nv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,iv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,rv=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,sv=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,av=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,ov=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,lv=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,cv=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,hv="gl_FragColor = linearToOutputTexel( gl_FragColor );",uv=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,dv=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,pv=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,fv=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,mv=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,gv=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,bv=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,yv=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,vv=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,xv=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,_v=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,Sv=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Mv=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,wv=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Av=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,Ev=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,Tv=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,Cv=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Rv=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Pv=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,Iv=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,Nv=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,Lv=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,Dv=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,zv=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Fv=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,Ov=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Uv=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,kv=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Bv=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,qv=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Vv=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Hv=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,Gv=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Wv=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,$v=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,Xv=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Yv=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,Jv=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Zv=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,Kv=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,jv=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,Qv=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,ex=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,tx=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,nx=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,ix=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,rx=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,sx=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,ax=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,ox=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,lx=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,cx=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,hx=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,ux=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,dx=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,px=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,fx=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,mx=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,gx=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,bx=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,yx=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,vx=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,xx=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,_x=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,Sx=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,Mx=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,wx=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,Ax=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,Ex=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,Tx=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,Cx=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,Rx=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,Px=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,Ix=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,Nx=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,Lx=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,Dx=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,zx=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Fx=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Ox=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Ux=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,kx=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Bx=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,qx=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,Vx=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,Hx=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,Gx=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,Wx=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,$x=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,Xx=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Yx=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,Jx=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Zx=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Kx=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,jx=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,Qx=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,e_=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,t_=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,n_=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,i_=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,r_=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,s_=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,a_=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,o_=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,l_=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,c_=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,h_=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,u_=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,d_=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,p_=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,We={alphahash_fragment:zy,alphahash_pars_fragment:Fy,alphamap_fragment:Oy,alphamap_pars_fragment:Uy,alphatest_fragment:ky,alphatest_pars_fragment:By,aomap_fragment:qy,aomap_pars_fragment:Vy,batching_pars_vertex:Hy,batching_vertex:Gy,begin_vertex:Wy,beginnormal_vertex:$y,bsdfs:Xy,iridescence_fragment:Yy,bumpmap_pars_fragment:Jy,clipping_planes_fragment:Zy,clipping_planes_pars_fragment:Ky,clipping_planes_pars_vertex:jy,clipping_planes_vertex:Qy,color_fragment:ev,color_pars_fragment:tv,color_pars_vertex:nv,color_vertex:iv,common:rv,defaultnormal_vertex:sv,displacementmap_pars_vertex:av,displacementmap_vertex:ov,emissivemap_fragment:lv,emissivemap_pars_fragment:cv,colorspace_fragment:hv,colorspace_pars_fragment:uv,envmap_fragment:dv,envmap_common_pars_fragment:pv,envmap_pars_fragment:fv,envmap_pars_vertex:mv,envmap_physical_pars_fragment:Ev,envmap_vertex:gv,fog_vertex:bv,fog_pars_vertex:yv,fog_fragment:vv,fog_pars_fragment:xv,gradientmap_pars_fragment:_v,lightmap_pars_fragment:Sv,lights_lambert_fragment:Mv,lights_lambert_pars_fragment:wv,lights_pars_begin:Av,lights_toon_fragment:Tv,lights_toon_pars_fragment:Cv,lights_phong_fragment:Rv,lights_phong_pars_fragment:Pv,lights_physical_fragment:Iv,lights_physical_pars_fragment:Nv,lights_fragment_begin:Lv,lights_fragment_maps:Dv,lights_fragment_end:zv,lightprobes_pars_fragment:Fv,logdepthbuf_fragment:Ov,logdepthbuf_pars_fragment:Uv,logdepthbuf_pars_vertex:kv,logdepthbuf_vertex:Bv,map_fragment:qv,map_pars_fragment:Vv,map_particle_fragment:Hv,map_particle_pars_fragment:Gv,metalnessmap_fragment:Wv,metalnessmap_pars_fragment:$v,morphinstance_vertex:Xv,morphcolor_vertex:Yv,morphnormal_vertex:Jv,morphtarget_pars_vertex:Zv,morphtarget_vertex:Kv,normal_fragment_begin:jv,normal_fragment_maps:Qv,normal_pars_fragment:ex,normal_pars_vertex:tx,normal_vertex:nx,normalmap_pars_fragment:ix,clearcoat_normal_fragment_begin:rx,clearcoat_normal_fragment_maps:sx,clearcoat_pars_fragment:ax,iridescence_pars_fragment:ox,opaque_fragment:lx,packing:cx,premultiplied_alpha_fragment:hx,project_vertex:ux,dithering_fragment:dx,dithering_pars_fragment:px,roughnessmap_fragment:fx,roughnessmap_pars_fragment:mx,shadowmap_pars_fragment:gx,shadowmap_pars_vertex:bx,shadowmap_vertex:yx,shadowmask_pars_fragment:vx,skinbase_vertex:xx,skinning_pars_vertex:_x,skinning_vertex:Sx,skinnormal_vertex:Mx,specularmap_fragment:wx,specularmap_pars_fragment:Ax,tonemapping_fragment:Ex,tonemapping_pars_fragment:Tx,transmission_fragment:Cx,transmission_pars_fragment:Rx,uv_pars_fragment:Px,uv_pars_vertex:Ix,uv_vertex:Nx,worldpos_vertex:Lx,background_vert:Dx,background_frag:zx,backgroundCube_vert:Fx,backgroundCube_frag:Ox,cube_vert:Ux,cube_frag:kx,depth_vert:Bx,depth_frag:qx,distance_vert:Vx,distance_frag:Hx,equirect_vert:Gx,equirect_frag:Wx,linedashed_vert:$x,linedashed_frag:Xx,meshbasic_vert:Yx,meshbasic_frag:Jx,meshlambert_vert:Zx,meshlambert_frag:Kx,meshmatcap_vert:jx,meshmatcap_frag:Qx,meshnormal_vert:e_,meshnormal_frag:t_,meshphong_vert:n_,meshphong_frag:i_,meshphysical_vert:r_,meshphysical_frag:s_,meshtoon_vert:a_,meshtoon_frag:o_,points_vert:l_,points_frag:c_,shadow_vert:h_,shadow_frag:u_,sprite_vert:d_,sprite_frag:p_},be={common:{diffuse:{value:new Ge(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new Fe},alphaMap:{value:null},alphaMapTransform:{value:new Fe},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new Fe}},envmap:{envMap:{value:null},envMapRotation:{value:new Fe},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new Fe}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new Fe}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new Fe},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new Fe},normalScale:{value:new $e(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new Fe},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new Fe}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new Fe}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new Fe}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Ge(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Ge(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new Fe},alphaTest:{value:0},uvTransform:{value:new Fe}},sprite:{diffuse:{value:new Ge(16777215)},opacity:{value:1},center:{value:new $e(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new Fe},alphaMap:{value:null},alphaMapTransform:{value:new Fe},alphaTest:{value:0}}},vi={basic:{uniforms:Zt([be.common,be.specularmap,be.envmap,be.aomap,be.lightmap,be.fog]),vertexShader:We.meshbasic_vert,fragmentShader:We.meshbasic_frag},lambert:{uniforms:Zt([be.common,be.specularmap,be.envmap,be.aomap,be.lightmap,be.emissivemap,be.bumpmap,be.normalmap,be.displacementmap,be.fog,be.lights,{emissive:{value:new Ge(0)},envMapIntensity:{value:1}}]),vertexShader:We.meshlambert_vert,fragmentShader:We.meshlambert_frag},phong:{uniforms:Zt([be.common,be.specularmap,be.envmap,be.aomap,be.lightmap,be.emissivemap,be.bumpmap,be.normalmap,be.displacementmap,be.fog,be.lights,{emissive:{value:new Ge(0)},specular:{value:new Ge(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:We.meshphong_vert,fragmentShader:We.meshphong_frag},standard:{uniforms:Zt([be.common,be.envmap,be.aomap,be.lightmap,be.emissivemap,be.bumpmap,be.normalmap,be.displacementmap,be.roughnessmap,be.metalnessmap,be.fog,be.lights,{emissive:{value:new Ge(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:We.meshphysical_vert,fragmentShader:We.meshphysical_frag},toon:{uniforms:Zt([be.common,be.aomap,be.lightmap,be.emissivemap,be.bumpmap,be.normalmap,be.displacementmap,be.gradientmap,be.fog,be.lights,{emissive:{value:new Ge(0)}}]),vertexShader:We.meshtoon_vert,fragmentShader:We.meshtoon_frag},matcap:{uniforms:Zt([be.common,be.bumpmap,be.normalmap,be.displacementmap,be.fog,{matcap:{value:null}}]),vertexShader:We.meshmatcap_vert,fragmentShader:We.meshmatcap_frag},points:{uniforms:Zt([be.points,be.fog]),vertexShader:We.points_vert,fragmentShader:We.points_frag},dashed:{uniforms:Zt([be.common,be.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:We.linedashed_vert,fragmentShader:We.linedashed_frag},depth:{uniforms:Zt([be.common,be.displacementmap]),vertexShader:We.depth_vert,fragmentShader:We.depth_frag},normal:{uniforms:Zt([be.common,be.bumpmap,be.normalmap,be.displacementmap,{opacity:{value:1}}]),vertexShader:We.meshnormal_vert,fragmentShader:We.meshnormal_frag},sprite:{uniforms:Zt([be.sprite,be.fog]),vertexShader:We.sprite_vert,fragmentShader:We.sprite_frag},background:{uniforms:{uvTransform:{value:new Fe},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:We.background_vert,fragmentShader:We.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new Fe}},vertexShader:We.backgroundCube_vert,fragmentShader:We.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:We.cube_vert,fragmentShader:We.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:We.equirect_vert,fragmentShader:We.equirect_frag},distance:{uniforms:Zt([be.common,be.displacementmap,{referencePosition:{value:new k},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:We.distance_vert,fragmentShader:We.distance_frag},shadow:{uniforms:Zt([be.lights,be.fog,{color:{value:new Ge(0)},opacity:{value:1}}]),vertexShader:We.shadow_vert,fragmentShader:We.shadow_frag}};vi.physical={uniforms:Zt([vi.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new Fe},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new Fe},clearcoatNormalScale:{value:new $e(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new Fe},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new Fe},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new Fe},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new Fe},sheen:{value:0},sheenColor:{value:new Ge(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new Fe},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new Fe},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new Fe},transmissionSamplerSize:{value:new $e},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new Fe},attenuationDistance:{value:0},attenuationColor:{value:new Ge(0)},specularColor:{value:new Ge(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new Fe},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new Fe},anisotropyVector:{value:new $e},anisotropyMap:{value:null},anisotropyMapTransform:{value:new Fe}}]),vertexShader:We.meshphysical_vert,fragmentShader:We.meshphysical_frag};var Yc={r:0,b:0,g:0},f_=new pt,Eg=new Fe;Eg.set(-1,0,0,0,1,0,0,0,1);function m_(i,e,t,n,r,s){let a=new Ge(0),o=r===!0?0:1,l,c,h=null,d=0,u=null;function p(v){let M=v.isScene===!0?v.background:null;if(M&&M.isTexture){let x=v.backgroundBlurriness>0;M=e.get(M,x)}return M}function f(v){let M=!1,x=p(v);x===null?m(a,o):x&&x.isColor&&(m(x,1),M=!0);let E=i.xr.getEnvironmentBlendMode();E==="additive"?t.buffers.color.setClear(0,0,0,1,s):E==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,s),(i.autoClear||M)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function b(v,M){let x=p(M);x&&x.isCubeTexture?(c===void 0&&(c=new Yt(new qs(1,1,1),new Jt({name:"BackgroundCubeMaterial",uniforms:Zr(vi.backgroundCube.uniforms),vertexShader:vi.backgroundCube.vertexShader,fragmentShader:vi.backgroundCube.fragmentShader,side:en,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(E,w,y){this.matrixWorld.copyPosition(y.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=x,c.material.uniforms.backgroundBlurriness.value=M.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(f_.makeRotationFromEuler(M.backgroundRotation)).transpose(),x.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Eg),c.material.toneMapped=Ke.getTransfer(x.colorSpace)!==at,(h!==x||d!==x.version||u!==i.toneMapping)&&(c.material.needsUpdate=!0,h=x,d=x.version,u=i.toneMapping),c.layers.enableAll(),v.unshift(c,c.geometry,c.material,0,0,null)):x&&x.isTexture&&(l===void 0&&(l=new Yt(new Va(2,2),new Jt({name:"BackgroundMaterial",uniforms:Zr(vi.background.uniforms),vertexShader:vi.background.vertexShader,fragmentShader:vi.background.fragmentShader,side:dr,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=x,l.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,l.material.toneMapped=Ke.getTransfer(x.colorSpace)!==at,x.matrixAutoUpdate===!0&&x.updateMatrix(),l.material.uniforms.uvTransform.value.copy(x.matrix),(h!==x||d!==x.version||u!==i.toneMapping)&&(l.material.needsUpdate=!0,h=x,d=x.version,u=i.toneMapping),l.layers.enableAll(),v.unshift(l,l.geometry,l.material,0,0,null))}function m(v,M){v.getRGB(Yc,Ud(i)),t.buffers.color.setClear(Yc.r,Yc.g,Yc.b,M,s)}function g(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return a},setClearColor:function(v,M=1){a.set(v),o=M,m(a,o)},getClearAlpha:function(){return o},setClearAlpha:function(v){o=v,m(a,o)},render:f,addToRenderList:b,dispose:g}}function g_(i,e){let t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},r=u(null),s=r,a=!1;function o(N,F,V,P,G){let W=!1,O=d(N,P,V,F);s!==O&&(s=O,c(s.object)),W=p(N,P,V,G),W&&f(N,P,V,G),G!==null&&e.update(G,i.ELEMENT_ARRAY_BUFFER),(W||a)&&(a=!1,x(N,F,V,P),G!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get(G).buffer))}function l(){return i.createVertexArray()}function c(N){return i.bindVertexArray(N)}function h(N){return i.deleteVertexArray(N)}function d(N,F,V,P){let G=P.wireframe===!0,W=n[F.id];W===void 0&&(W={},n[F.id]=W);let O=N.isInstancedMesh===!0?N.id:0,Q=W[O];Q===void 0&&(Q={},W[O]=Q);let H=Q[V.id];H===void 0&&(H={},Q[V.id]=H);let J=H[G];return J===void 0&&(J=u(l()),H[G]=J),J}function u(N){let F=[],V=[],P=[];for(let G=0;G<t;G++)F[G]=0,V[G]=0,P[G]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:F,enabledAttributes:V,attributeDivisors:P,object:N,attributes:{},index:null}}function p(N,F,V,P){let G=s.attributes,W=F.attributes,O=0,Q=V.getAttributes();for(let H in Q)if(Q[H].location>=0){let te=G[H],ve=W[H];if(ve===void 0&&(H==="instanceMatrix"&&N.instanceMatrix&&(ve=N.instanceMatrix),H==="instanceColor"&&N.instanceColor&&(ve=N.instanceColor)),te===void 0||te.attribute!==ve||ve&&te.data!==ve.data)return!0;O++}return s.attributesNum!==O||s.index!==P}function f(N,F,V,P){let G={},W=F.attributes,O=0,Q=V.getAttributes();for(let H in Q)if(Q[H].location>=0){let te=W[H];te===void 0&&(H==="instanceMatrix"&&N.instanceMatrix&&(te=N.instanceMatrix),H==="instanceColor"&&N.instanceColor&&(te=N.instanceColor));let ve={};ve.attribute=te,te&&te.data&&(ve.data=te.data),G[H]=ve,O++}s.attributes=G,s.attributesNum=O,s.index=P}function b(){let N=s.newAttributes;for(let F=0,V=N.length;F<V;F++)N[F]=0}function m(N){g(N,0)}function g(N,F){let V=s.newAttributes,P=s.enabledAttributes,G=s.attributeDivisors;V[N]=1,P[N]===0&&(i.enableVertexAttribArray(N),P[N]=1),G[N]!==F&&(i.vertexAttribDivisor(N,F),G[N]=F)}function v(){let N=s.newAttributes,F=s.enabledAttributes;for(let V=0,P=F.length;V<P;V++)F[V]!==N[V]&&(i.disableVertexAttribArray(V),F[V]=0)}function M(N,F,V,P,G,W,O){O===!0?i.vertexAttribIPointer(N,F,V,G,W):i.vertexAttribPointer(N,F,V,P,G,W)}function x(N,F,V,P){b();let G=P.attributes,W=V.getAttributes(),O=F.defaultAttributeValues;for(let Q in W){let H=W[Q];if(H.location>=0){let J=G[Q];if(J===void 0&&(Q==="instanceMatrix"&&N.instanceMatrix&&(J=N.instanceMatrix),Q==="instanceColor"&&N.instanceColor&&(J=N.instanceColor)),J!==void 0){let te=J.normalized,ve=J.itemSize,Ee=e.get(J);if(Ee===void 0)continue;let X=Ee.buffer,re=Ee.type,me=Ee.bytesPerElement,Me=re===i.INT||re===i.UNSIGNED_INT||J.gpuType===uc;if(J.isInterleavedBufferAttribute){let pe=J.data,Le=pe.isInterleavedBuffer===!0?pe.stride:pe.itemSize,ft=J.offset;if(pe.isInstancedInterleavedBuffer||pe.isInstancedBufferAttribute){for(let Ce=0;Ce<H.locationSize;Ce++)g(H.location+Ce,pe.meshPerAttribute);N.isInstancedMesh!==!0&&P._maxInstanceCount===void 0&&(P._maxInstanceCount=pe.meshPerAttribute*pe.count)}else for(let Ce=0;Ce<H.locationSize;Ce++)m(H.location+Ce);i.bindBuffer(i.ARRAY_BUFFER,X);for(let Ce=0;Ce<H.locationSize;Ce++)M(H.location+Ce,ve/H.locationSize,re,te,Le*me,(ft+ve/H.locationSize*Ce)*me,Me)}else{if(J.isInstancedBufferAttribute){for(let pe=0;pe<H.locationSize;pe++)g(H.location+pe,J.meshPerAttribute);N.isInstancedMesh!==!0&&P._maxInstanceCount===void 0&&(P._maxInstanceCount=J.meshPerAttribute*J.count)}else for(let pe=0;pe<H.locationSize;pe++)m(H.location+pe);i.bindBuffer(i.ARRAY_BUFFER,X);for(let pe=0;pe<H.locationSize;pe++)M(H.location+pe,ve/H.locationSize,re,te,ve*me,ve/H.locationSize*pe*me,Me)}}else if(O!==void 0){let te=O[Q];if(te!==void 0)switch(te.length){case 2:i.vertexAttrib2fv(H.location,te);break;case 3:i.vertexAttrib3fv(H.location,te);break;case 4:i.vertexAttrib4fv(H.location,te);break;default:i.vertexAttrib1fv(H.location,te)}}}}v()}function E(){D();for(let N in n){let F=n[N];for(let V in F){let P=F[V];for(let G in P){let W=P[G];for(let O in W)h(W[O].object),delete W[O];delete P[G]}}delete n[N]}}function w(N){if(n[N.id]===void 0)return;let F=n[N.id];for(let V in F){let P=F[V];for(let G in P){let W=P[G];for(let O in W)h(W[O].object),delete W[O];delete P[G]}}delete n[N.id]}function y(N){for(let F in n){let V=n[F];for(let P in V){let G=V[P];if(G[N.id]===void 0)continue;let W=G[N.id];for(let O in W)h(W[O].object),delete W[O];delete G[N.id]}}}function A(N){for(let F in n){let V=n[F],P=N.isInstancedMesh===!0?N.id:0,G=V[P];if(G!==void 0){for(let W in G){let O=G[W];for(let Q in O)h(O[Q].object),delete O[Q];delete G[W]}delete V[P],Object.keys(V).length===0&&delete n[F]}}}function D(){R(),a=!0,s!==r&&(s=r,c(s.object))}function R(){r.geometry=null,r.program=null,r.wireframe=!1}return{setup:o,reset:D,resetDefaultState:R,dispose:E,releaseStatesOfGeometry:w,releaseStatesOfObject:A,releaseStatesOfProgram:y,initAttributes:b,enableAttribute:m,disableUnusedAttributes:v}}function b_(i,e,t){let n;function r(l){n=l}function s(l,c){i.drawArrays(n,l,c),t.update(c,n,1)}function a(l,c,h){h!==0&&(i.drawArraysInstanced(n,l,c,h),t.update(c,n,h))}function o(l,c,h){if(h===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,h);let u=0;for(let p=0;p<h;p++)u+=c[p];t.update(u,n,1)}this.setMode=r,this.render=s,this.renderInstances=a,this.renderMultiDraw=o}function y_(i,e,t,n){let r;function s(){if(r!==void 0)return r;if(e.has("EXT_texture_filter_anisotropic")===!0){let y=e.get("EXT_texture_filter_anisotropic");r=i.getParameter(y.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else r=0;return r}function a(y){return!(y!==wn&&n.convert(y)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function o(y){let A=y===ni&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(y!==tn&&y!==Mn&&!A&&n.convert(y)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(y){if(y==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";y="mediump"}return y==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",h=l(c);h!==c&&(Ne("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let d=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),u=t.logarithmicDepthBuffer===!0&&d===!1;t.reversedDepthBuffer===!0&&d===!1&&Ne("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&d===!0&&Ne("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let p=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),f=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),b=i.getParameter(i.MAX_TEXTURE_SIZE),m=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),g=i.getParameter(i.MAX_VERTEX_ATTRIBS),v=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),M=i.getParameter(i.MAX_VARYING_VECTORS),x=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),E=i.getParameter(i.MAX_SAMPLES),w=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:s,getMaxPrecision:l,textureFormatReadable:a,textureTypeReadable:o,precision:c,logarithmicDepthBuffer:u,reversedDepthBuffer:d,maxTextures:p,maxVertexTextures:f,maxTextureSize:b,maxCubemapSize:m,maxAttributes:g,maxVertexUniforms:v,maxVaryings:M,maxFragmentUniforms:x,maxSamples:E,samples:w}}function v_(i){let e=this,t=null,n=0,r=!1,s=!1,a=new ei,o=new Fe,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(d,u){let p=d.length!==0||u||n!==0||r;return r=u,n=d.length,p},this.beginShadows=function(){s=!0,h(null)},this.endShadows=function(){s=!1},this.setGlobalState=function(d,u){t=h(d,u,0)},this.setState=function(d,u,p){let f=d.clippingPlanes,b=d.clipIntersection,m=d.clipShadows,g=i.get(d);if(!r||f===null||f.length===0||s&&!m)s?h(null):c();else{let v=s?0:n,M=v*4,x=g.clippingState||null;l.value=x,x=h(f,u,M,p);for(let E=0;E!==M;++E)x[E]=t[E];g.clippingState=x,this.numIntersection=b?this.numPlanes:0,this.numPlanes+=v}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function h(d,u,p,f){let b=d!==null?d.length:0,m=null;if(b!==0){if(m=l.value,f!==!0||m===null){let g=p+b*4,v=u.matrixWorldInverse;o.getNormalMatrix(v),(m===null||m.length<g)&&(m=new Float32Array(g));for(let M=0,x=p;M!==b;++M,x+=4)a.copy(d[M]).applyMatrix4(v,o),a.normal.toArray(m,x),m[x+3]=a.constant}l.value=m,l.needsUpdate=!0}return e.numPlanes=b,e.numIntersection=0,m}}var ro=class extends xn{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},r=[n,n,n,n,n,n];this.texture=new Ua(r),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},r=new qs(5,5,5),s=new Jt({name:"CubemapFromEquirect",uniforms:Zr(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:en,blending:Wr});s.uniforms.tEquirect.value=t;let a=new Yt(r,s),o=t.minFilter;return t.minFilter===zi&&(t.minFilter=Ft),new Hs(1,10,this).update(e,a),t.minFilter=o,a.geometry.dispose(),a.material.dispose(),this}clear(e,t=!0,n=!0,r=!0){let s=e.getRenderTarget();for(let a=0;a<6;a++)e.setRenderTarget(this,a),e.clear(t,n,r);e.setRenderTarget(s)}},rg=256,x_=3,__=20,Tg=256,Cg=16,S_=3,M_=new k,w_=new Ge,Zc=class i{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Hs(1,10,null),this._boxMesh=new Yt(new qs(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,n=.1,r=100,s={}){let{size:a=256,position:o=M_}=s,l=this._renderer;this._setSize(a);let c=this._allocateTarget(),h=this._getSourceTarget(!0);t>0&&(h.texture.mipmapsAutoUpdate=!1);let d=l.autoClear,u=l.autoClearColor,p=l.autoClearDepth,f=l.autoClearStencil,b=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,b===null&&(e.background=l.getClearColor(w_));let m=new Hs(n,r,h);return m.position.copy(o),m.update(l,e),l.autoClear=d,l.autoClearColor=u,l.autoClearDepth=p,l.autoClearStencil=f,e.background=b,t>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=og(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=ag(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(rg,K0(e))}_fromTexture(e,t){e.mapping===Xr||e.mapping===$s?this._setSize(e.image.length===0?rg:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let n=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(n),n}_allocateTarget(){let e=this._cubeSize,t=sg(e,!1,!1),n=Math.log2(e)-x_;for(let r=0;r<=n;r++)t.texture.mipmaps.push({width:e>>r,height:e>>r});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==t||e&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=sg(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,n){let r=this._boxMesh,s=this._cubeCamera;r.material=n,s.renderTarget=e,s.activeMipmapLevel=t;let a=e.width>>t;e.viewport.set(0,0,a,a),s.update(this._renderer,r),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===Xr||e.mapping===$s?(this._cubemapMaterial===null&&(this._cubemapMaterial=og()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=ag()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=A_(),this._integrationMaterial=E_());let t=this._cubeSize,n=e.texture.mipmaps.length-1,r=this._ggxMaterial.uniforms;r.envMap.value=this._sourceTarget.texture;let s=this._integrationMaterial.uniforms;s.envMap.value=this._sourceTarget.texture,s.sourceLod.value=Math.log2(t/Cg);for(let a=0;a<=n;a++){let o=i.lodToRoughness(a,n);if(a>n-S_)s.roughness.value=o,this._renderCube(e,a,this._integrationMaterial);else{let l=o>0?Math.log2(t)+.5*Math.log2(6/(Tg*Math.pow(o,4)))+.5:0;r.roughness.value=o,r.lodBias.value=l,this._renderCube(e,a,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=T_());let n=this._blurMaterial,r=n.uniforms,s=this._sourceTarget;r.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,r.envMap.value=s.texture,this._renderCube(e,0,n),r.envMap.value=e.texture,this._renderCube(s,0,n)}};function sg(i,e,t){return new ro(i,{minFilter:zi,generateMipmaps:e,type:ni,colorSpace:Ta,depthBuffer:t})}function so(i,e,t){return new Jt({name:i,uniforms:e,vertexShader:We.cube_vert,fragmentShader:t,side:en,blending:Wr,depthTest:!1,depthWrite:!1})}function A_(){return so("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Tg}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function E_(){return so("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Cg}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function T_(){return so("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${__}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function ag(){return so("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function og(){return so("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function C_(i){let e=new WeakMap,t=new WeakMap,n=null;function r(u,p=!1){return u==null?null:p?a(u):s(u)}function s(u){if(u&&u.isTexture){let p=u.mapping;if(p===lc||p===cc)if(e.has(u)){let f=e.get(u).texture;return o(f,u.mapping)}else{let f=u.image;if(f&&f.height>0){let b=new ro(f.height);return b.fromEquirectangularTexture(i,u),e.set(u,b),u.addEventListener("dispose",c),o(b.texture,u.mapping)}else return null}}return u}function a(u){if(u&&u.isTexture&&u.isPMREMTexture!==!0){let p=u.mapping,f=p===lc||p===cc,b=p===Xr||p===$s;if(f||b){let m=t.get(u),g=m!==void 0?m.texture.pmremVersion:0;if(u.isRenderTargetTexture&&u.pmremVersion!==g)return n===null&&(n=new Zc(i)),m=f?n.fromEquirectangular(u,m):n.fromCubemap(u,m),m.texture.pmremVersion=u.pmremVersion,t.set(u,m),m.texture;if(m!==void 0)return m.texture;{let v=u.image;return f&&v&&v.height>0||b&&v&&l(v)?(n===null&&(n=new Zc(i)),m=f?n.fromEquirectangular(u):n.fromCubemap(u),m.texture.pmremVersion=u.pmremVersion,t.set(u,m),u.addEventListener("dispose",h),m.texture):null}}}return u}function o(u,p){return p===lc?u.mapping=Xr:p===cc&&(u.mapping=$s),u}function l(u){let p=0,f=6;for(let b=0;b<f;b++)u[b]!==void 0&&p++;return p===f}function c(u){let p=u.target;p.removeEventListener("dispose",c);let f=e.get(p);f!==void 0&&(e.delete(p),f.dispose())}function h(u){let p=u.target;p.removeEventListener("dispose",h);let f=t.get(p);f!==void 0&&(t.delete(p),f.dispose())}function d(){e=new WeakMap,t=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:r,dispose:d}}function R_(i){let e={};function t(n){if(e[n]!==void 0)return e[n];let r=i.getExtension(n);return e[n]=r,r}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){let r=t(n);return r===null&&Aa("WebGLRenderer: "+n+" extension not supported."),r}}}function P_(i,e,t,n){let r={},s=new WeakMap,a=new FinalizationRegistry(f=>delete r[f]);function o(f){l(f.target)}function l(f){f.index!==null&&e.remove(f.index);for(let m in f.attributes)e.remove(f.attributes[m]);f.removeEventListener("dispose",o),delete r[f.id],a.unregister(f);let b=s.get(f);b&&(e.remove(b),s.delete(f)),n.releaseStatesOfGeometry(f),f.isInstancedBufferGeometry===!0&&delete f._maxInstanceCount,t.memory.geometries--}function c(f,b){return r[b.id]!==void 0||(b.addEventListener("dispose",o),r[b.id]=new WeakRef(b),a.register(b,b.id,b),t.memory.geometries++),b}function h(f){let b=f.attributes;for(let m in b)e.update(b[m],i.ARRAY_BUFFER)}function d(f){let b=f.index,m=f.attributes.position,g=0;if(m===void 0)return;let v=b!==null?b.array.length:m.array.length/3-1,M=m.count>=65535?Fa:za,x=new M(Math.ceil(v/3)*6,1),E=x.array;if(b!==null){let y=b.array;g=b.version;for(let A=0,D=0;A<v;A+=3){let R=y[A+0],N=y[A+1],F=y[A+2];E[D++]=R,E[D++]=N,E[D++]=N,E[D++]=F,E[D++]=F,E[D++]=R}}else{g=m.version;for(let y=0,A=0;y<v;y+=3){let D=y+0,R=y+1,N=y+2;E[A++]=D,E[A++]=R,E[A++]=R,E[A++]=N,E[A++]=N,E[A++]=D}}x.version=g;let w=s.get(f);w&&e.remove(w),s.set(f,x)}function u(f){let b=s.get(f);if(b){let m=f.index;m!==null&&b.version<m.version&&d(f)}else d(f);return s.get(f)}function p(){for(let f in r){let b=r[f].deref();b!==void 0&&l(b)}}return{get:c,update:h,getWireframeAttribute:u,dispose:p}}function I_(i,e,t){let n;function r(d){n=d}let s,a;function o(d){s=d.type,a=d.bytesPerElement}function l(d,u){i.drawElements(n,u,s,d*a),t.update(u,n,1)}function c(d,u,p){p!==0&&(i.drawElementsInstanced(n,u,s,d*a,p),t.update(u,n,p))}function h(d,u,p){if(p===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,u,0,s,d,0,p);let b=0;for(let m=0;m<p;m++)b+=u[m];t.update(b,n,1)}this.setMode=r,this.setIndex=o,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function N_(i){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(s,a,o){switch(t.calls++,a){case i.TRIANGLES:t.triangles+=o*(s/3);break;case i.LINES:t.lines+=o*(s/2);break;case i.LINE_STRIP:t.lines+=o*(s-1);break;case i.LINE_LOOP:t.lines+=o*s;break;case i.POINTS:t.points+=o*s;break;default:De("WebGLInfo: Unknown draw mode:",a);break}}function r(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:r,update:n}}function L_(i,e,t){let n=new WeakMap,r=new ht;function s(a,o,l){let c=a.morphTargetInfluences,h=o.morphAttributes.position||o.morphAttributes.normal||o.morphAttributes.color,d=h!==void 0?h.length:0,u=n.get(o);if(u===void 0||u.count!==d){let D=function(){y.dispose(),n.delete(o),o.removeEventListener("dispose",D)};u!==void 0&&u.texture.dispose();let p=o.morphAttributes.position!==void 0,f=o.morphAttributes.normal!==void 0,b=o.morphAttributes.color!==void 0,m=o.morphAttributes.position||[],g=o.morphAttributes.normal||[],v=o.morphAttributes.color||[],M=0;p===!0&&(M=1),f===!0&&(M=2),b===!0&&(M=3);let x=o.attributes.position.count*M,E=1;x>e.maxTextureSize&&(E=Math.ceil(x/e.maxTextureSize),x=e.maxTextureSize);let w=new Float32Array(x*E*4*d),y=new Na(w,x,E,d);y.type=Mn,y.needsUpdate=!0;let A=M*4;for(let R=0;R<d;R++){let N=m[R],F=g[R],V=v[R],P=x*E*4*R;for(let G=0;G<N.count;G++){let W=G*A;p===!0&&(r.fromBufferAttribute(N,G),w[P+W+0]=r.x,w[P+W+1]=r.y,w[P+W+2]=r.z,w[P+W+3]=0),f===!0&&(r.fromBufferAttribute(F,G),w[P+W+4]=r.x,w[P+W+5]=r.y,w[P+W+6]=r.z,w[P+W+7]=0),b===!0&&(r.fromBufferAttribute(V,G),w[P+W+8]=r.x,w[P+W+9]=r.y,w[P+W+10]=r.z,w[P+W+11]=V.itemSize===4?r.w:1)}}u={count:d,texture:y,size:new $e(x,E)},n.set(o,u),o.addEventListener("dispose",D)}if(a.isInstancedMesh===!0&&a.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",a.morphTexture,t);else{let p=0;for(let b=0;b<c.length;b++)p+=c[b];let f=o.morphTargetsRelative?1:1-p;l.getUniforms().setValue(i,"morphTargetBaseInfluence",f),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",u.texture,t),l.getUniforms().setValue(i,"morphTargetsTextureSize",u.size)}return{update:s}}function D_(i,e,t,n,r){let s=new WeakMap;function a(c){let h=r.render.frame,d=c.geometry,u=e.get(c,d);if(s.get(u)!==h&&(e.update(u),s.set(u,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),s.get(c)!==h&&(t.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,i.ARRAY_BUFFER),s.set(c,h))),c.isSkinnedMesh){let p=c.skeleton;s.get(p)!==h&&(p.update(),s.set(p,h))}return u}function o(){s=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),n.releaseStatesOfObject(h),t.remove(h.instanceMatrix),h.instanceColor!==null&&t.remove(h.instanceColor)}return{update:a,dispose:o}}var z_={[vd]:"LINEAR_TONE_MAPPING",[xd]:"REINHARD_TONE_MAPPING",[_d]:"CINEON_TONE_MAPPING",[Sd]:"ACES_FILMIC_TONE_MAPPING",[wd]:"AGX_TONE_MAPPING",[Ad]:"NEUTRAL_TONE_MAPPING",[Md]:"CUSTOM_TONE_MAPPING"};function F_(i,e,t,n,r,s){let a=new xn(e,t,{type:i,depthBuffer:r,stencilBuffer:s,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),o=null,l=null,c=null,h=new cn;h.setAttribute("position",new zn([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new zn([0,2,0,0,2,0],2));let d=new Yl({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),u=new Yt(h,d),p=new Vs(-1,1,1,-1,0,1),f=null,b=null,m=!1,g,v=null,M=[],x=!1;this.setSize=function(E,w){a.setSize(E,w),o!==null&&o.setSize(E,w),l!==null&&l.setSize(E,w);for(let y=0;y<M.length;y++){let A=M[y];A.setSize&&A.setSize(E,w)}},this.setEffects=function(E){M=E,x=M.length>0&&M[0].isRenderPass===!0;let w=a.width,y=a.height;M.length>0&&o===null&&(o=new xn(w,y,{type:ni,depthBuffer:!1,stencilBuffer:!1}),l=new xn(w,y,{type:ni,depthBuffer:!1,stencilBuffer:!1}));let A=r===!0&&M.some(D=>D.needsDepthTexture===!0);A!==(a.depthTexture!==null)&&(A===!0&&c===null&&(c=new Di(w,y),s===!0&&(c.format=Fi,c.type=Yr)),a.dispose(),a.depthTexture=A?c:null,a.resolveDepthBuffer=A,a.storeMultisampledDepthBuffer=A);for(let D=0;D<M.length;D++){let R=M[D];R.setSize&&R.setSize(w,y),A&&R.needsDepthTexture===!0&&R.setDepthTexture&&R.setDepthTexture(c)}},this.begin=function(E,w){if(m||E.toneMapping===bi&&M.length===0)return!1;if(v=w,w!==null){let y=w.width,A=w.height;(a.width!==y||a.height!==A)&&this.setSize(y,A)}return x===!1&&E.setRenderTarget(a),g=E.toneMapping,E.toneMapping=bi,!0},this.hasRenderPass=function(){return x},this.end=function(E,w){E.toneMapping=g,m=!0;let y=a,A=o;for(let D=0;D<M.length;D++){let R=M[D];R.enabled!==!1&&(R.render(E,A,y,w),R.needsSwap!==!1&&(y=A,A=A===o?l:o))}if(f!==E.outputColorSpace||b!==E.toneMapping){f=E.outputColorSpace,b=E.toneMapping,d.defines={},Ke.getTransfer(f)===at&&(d.defines.SRGB_TRANSFER="");let D=z_[b];D&&(d.defines[D]=""),d.needsUpdate=!0}d.uniforms.tDiffuse.value=y.texture,E.setRenderTarget(v),E.render(u,p),v=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){a.dispose(),o!==null&&o.dispose(),l!==null&&l.dispose(),h.dispose(),d.dispose()}}var Rg=new Qt,Pg=new Di(1,1),Ig=new Ba(1),Ng=new Na,Lg=new Hl,Dg=new Ua,lg=[],cg=[],hg=new Float32Array(16),ug=new Float32Array(9),dg=new Float32Array(4);function Zs(i,e,t){let n=i[0];if(n<=0||n>0)return i;let r=e*t,s=lg[r];if(s===void 0&&(s=new Float32Array(r),lg[r]=s),e!==0){n.toArray(s,0);for(let a=1,o=0;a!==e;++a)o+=t,i[a].toArray(s,o)}return s}function Pt(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function It(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function jc(i,e){let t=cg[e];t===void 0&&(t=new Int32Array(e),cg[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function O_(i,e){let t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function U_(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Pt(t,e))return;i.uniform2fv(this.addr,e),It(t,e)}}function k_(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Pt(t,e))return;i.uniform3fv(this.addr,e),It(t,e)}}function B_(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Pt(t,e))return;i.uniform4fv(this.addr,e),It(t,e)}}function q_(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(Pt(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),It(t,e)}else{if(Pt(t,n))return;dg.set(n),i.uniformMatrix2fv(this.addr,!1,dg),It(t,n)}}function V_(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(Pt(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),It(t,e)}else{if(Pt(t,n))return;ug.set(n),i.uniformMatrix3fv(this.addr,!1,ug),It(t,n)}}function H_(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(Pt(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),It(t,e)}else{if(Pt(t,n))return;hg.set(n),i.uniformMatrix4fv(this.addr,!1,hg),It(t,n)}}function G_(i,e){let t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function W_(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Pt(t,e))return;i.uniform2iv(this.addr,e),It(t,e)}}function $_(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Pt(t,e))return;i.uniform3iv(this.addr,e),It(t,e)}}function X_(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Pt(t,e))return;i.uniform4iv(this.addr,e),It(t,e)}}function Y_(i,e){let t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function J_(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Pt(t,e))return;i.uniform2uiv(this.addr,e),It(t,e)}}function Z_(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Pt(t,e))return;i.uniform3uiv(this.addr,e),It(t,e)}}function K_(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Pt(t,e))return;i.uniform4uiv(this.addr,e),It(t,e)}}function Qc(i){return i.version===0&&(i.compareFunction=Fd,i.needsUpdate=!0),i}function j_(i,e,t){let n=this.cache,r=t.allocateTextureUnit();n[0]!==r&&(i.uniform1i(this.addr,r),n[0]=r);let s;this.type===i.SAMPLER_2D_SHADOW?s=Qc(Pg):s=Rg,t.setTexture2D(e||s,r)}function Q_(i,e,t){let n=this.cache,r=t.allocateTextureUnit();n[0]!==r&&(i.uniform1i(this.addr,r),n[0]=r),t.setTexture3D(e||Lg,r)}function eS(i,e,t){let n=this.cache,r=t.allocateTextureUnit();n[0]!==r&&(i.uniform1i(this.addr,r),n[0]=r);let s;this.type===i.SAMPLER_CUBE_SHADOW?s=Qc(Ig):s=Dg,t.setTextureCube(e||s,r)}function tS(i,e,t){let n=this.cache,r=t.allocateTextureUnit();n[0]!==r&&(i.uniform1i(this.addr,r),n[0]=r),t.setTexture2DArray(e||Ng,r)}function nS(i){switch(i){case 5126:return O_;case 35664:return U_;case 35665:return k_;case 35666:return B_;case 35674:return q_;case 35675:return V_;case 35676:return H_;case 5124:case 35670:return G_;case 35667:case 35671:return W_;case 35668:case 35672:return $_;case 35669:case 35673:return X_;case 5125:return Y_;case 36294:return J_;case 36295:return Z_;case 36296:return K_;case 35678:case 36198:case 36298:case 36306:case 35682:return j_;case 35679:case 36299:case 36307:return Q_;case 35680:case 36300:case 36308:case 36293:return eS;case 36289:case 36303:case 36311:case 36292:return tS}}function iS(i,e){i.uniform1fv(this.addr,e)}function rS(i,e){let t=Zs(e,this.size,2);i.uniform2fv(this.addr,t)}function sS(i,e){let t=Zs(e,this.size,3);i.uniform3fv(this.addr,t)}function aS(i,e){let t=Zs(e,this.size,4);i.uniform4fv(this.addr,t)}function oS(i,e){let t=Zs(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function lS(i,e){let t=Zs(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function cS(i,e){let t=Zs(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function hS(i,e){i.uniform1iv(this.addr,e)}function uS(i,e){i.uniform2iv(this.addr,e)}function dS(i,e){i.uniform3iv(this.addr,e)}function pS(i,e){i.uniform4iv(this.addr,e)}function fS(i,e){i.uniform1uiv(this.addr,e)}function mS(i,e){i.uniform2uiv(this.addr,e)}function gS(i,e){i.uniform3uiv(this.addr,e)}function bS(i,e){i.uniform4uiv(this.addr,e)}function yS(i,e,t){let n=this.cache,r=e.length,s=jc(t,r);Pt(n,s)||(i.uniform1iv(this.addr,s),It(n,s));let a;this.type===i.SAMPLER_2D_SHADOW?a=Qc(Pg):a=Rg;for(let o=0;o!==r;++o)t.setTexture2D(e[o]||a,s[o])}function vS(i,e,t){let n=this.cache,r=e.length,s=jc(t,r);Pt(n,s)||(i.uniform1iv(this.addr,s),It(n,s));for(let a=0;a!==r;++a)t.setTexture3D(e[a]||Lg,s[a])}function xS(i,e,t){let n=this.cache,r=e.length,s=jc(t,r);Pt(n,s)||(i.uniform1iv(this.addr,s),It(n,s));let a;this.type===i.SAMPLER_CUBE_SHADOW?a=Qc(Ig):a=Dg;for(let o=0;o!==r;++o)t.setTextureCube(e[o]||a,s[o])}function _S(i,e,t){let n=this.cache,r=e.length,s=jc(t,r);Pt(n,s)||(i.uniform1iv(this.addr,s),It(n,s));for(let a=0;a!==r;++a)t.setTexture2DArray(e[a]||Ng,s[a])}function SS(i){switch(i){case 5126:return iS;case 35664:return rS;case 35665:return sS;case 35666:return aS;case 35674:return oS;case 35675:return lS;case 35676:return cS;case 5124:case 35670:return hS;case 35667:case 35671:return uS;case 35668:case 35672:return dS;case 35669:case 35673:return pS;case 5125:return fS;case 36294:return mS;case 36295:return gS;case 36296:return bS;case 35678:case 36198:case 36298:case 36306:case 35682:return yS;case 35679:case 36299:case 36307:return vS;case 35680:case 36300:case 36308:case 36293:return xS;case 36289:case 36303:case 36311:case 36292:return _S}}var Gd=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=nS(t.type)}},Wd=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=SS(t.type)}},$d=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let r=this.seq;for(let s=0,a=r.length;s!==a;++s){let o=r[s];o.setValue(e,t[o.id],n)}}},Vd=/(\w+)(\])?(\[|\.)?/g;function pg(i,e){i.seq.push(e),i.map[e.id]=e}function MS(i,e,t){let n=i.name,r=n.length;for(Vd.lastIndex=0;;){let s=Vd.exec(n),a=Vd.lastIndex,o=s[1],l=s[2]==="]",c=s[3];if(l&&(o=o|0),c===void 0||c==="["&&a+2===r){pg(t,c===void 0?new Gd(o,i,e):new Wd(o,i,e));break}else{let d=t.map[o];d===void 0&&(d=new $d(o),pg(t,d)),t=d}}}var Js=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let a=0;a<n;++a){let o=e.getActiveUniform(t,a),l=e.getUniformLocation(t,o.name);MS(o,l,this)}let r=[],s=[];for(let a of this.seq)a.type===e.SAMPLER_2D_SHADOW||a.type===e.SAMPLER_CUBE_SHADOW||a.type===e.SAMPLER_2D_ARRAY_SHADOW?r.push(a):s.push(a);r.length>0&&(this.seq=r.concat(s))}setValue(e,t,n,r){let s=this.map[t];s!==void 0&&s.setValue(e,n,r)}setOptional(e,t,n){let r=t[n];r!==void 0&&this.setValue(e,n,r)}static upload(e,t,n,r){for(let s=0,a=t.length;s!==a;++s){let o=t[s],l=n[o.id];l.needsUpdate!==!1&&o.setValue(e,l.value,r)}}static seqWithValue(e,t){let n=[];for(let r=0,s=e.length;r!==s;++r){let a=e[r];a.id in t&&n.push(a)}return n}};function fg(i,e,t){let n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}var wS=37297,AS=0;function ES(i,e){let t=i.split(`
`),n=[],r=Math.max(e-6,0),s=Math.min(e+6,t.length);for(let a=r;a<s;a++){let o=a+1;n.push(`${o===e?">":" "} ${o}: ${t[a]}`)}return n.join(`
`)}var mg=new Fe;function TS(i){Ke._getMatrix(mg,Ke.workingColorSpace,i);let e=`mat3( ${mg.elements.map(t=>t.toFixed(4))} )`;switch(Ke.getTransfer(i)){case Ca:return[e,"LinearTransferOETF"];case at:return[e,"sRGBTransferOETF"];default:return Ne("WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function gg(i,e,t){let n=i.getShaderParameter(e,i.COMPILE_STATUS),s=(i.getShaderInfoLog(e)||"").trim();if(n&&s==="")return"";let a=/ERROR: 0:(\d+)/.exec(s);if(a){let o=parseInt(a[1]);return t.toUpperCase()+`

`+s+`

`+ES(i.getShaderSource(e),o)}else return s}function CS(i,e){let t=TS(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var RS={[vd]:"Linear",[xd]:"Reinhard",[_d]:"Cineon",[Sd]:"ACESFilmic",[wd]:"AgX",[Ad]:"Neutral",[Md]:"Custom"};function PS(i,e){let t=RS[e];return t===void 0?(Ne("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var Jc=new k;function IS(){Ke.getLuminanceCoefficients(Jc);let i=Jc.x.toFixed(4),e=Jc.y.toFixed(4),t=Jc.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function NS(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(io).join(`
`)}function LS(i){let e=[];for(let t in i){let n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function DS(i,e){let t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let r=0;r<n;r++){let s=i.getActiveAttrib(e,r),a=s.name,o=1;s.type===i.FLOAT_MAT2&&(o=2),s.type===i.FLOAT_MAT3&&(o=3),s.type===i.FLOAT_MAT4&&(o=4),t[a]={type:s.type,location:i.getAttribLocation(e,a),locationSize:o}}return t}function io(i){return i!==""}function bg(i,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function yg(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var zS=/^[ \t]*#include +<([\w\d./]+)>/gm;function Xd(i){return i.replace(zS,FS)}function FS(i,e){let t=We[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return Xd(t)}var OS=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function vg(i){return i.replace(OS,US)}function US(i,e,t,n){let r="";for(let s=parseInt(e);s<parseInt(t);s++)r+=n.replace(/\[\s*i\s*\]/g,"[ "+s+" ]").replace(/UNROLLED_LOOP_INDEX/g,s);return r}function xg(i){let e=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?e+=`
#define HIGH_PRECISION`:i.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var kS={[Xa]:"SHADOWMAP_TYPE_PCF",[Gs]:"SHADOWMAP_TYPE_VSM"};function BS(i){return kS[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var qS={[$s]:"ENVMAP_MODE_REFRACTION"};function VS(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":qS[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var HS={[yd]:"ENVMAP_BLENDING_MULTIPLY",[F0]:"ENVMAP_BLENDING_MIX",[O0]:"ENVMAP_BLENDING_ADD"};function GS(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":HS[i.combine]||"ENVMAP_BLENDING_NONE"}function WS(i,e,t,n){let r=i.getContext(),s=t.defines,a=t.vertexShader,o=t.fragmentShader,l=BS(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=VS(t),d=GS(t),u=NS(t),p=LS(s),f=r.createProgram(),b,m,g=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(b=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p].filter(io).join(`
`),b.length>0&&(b+=`
`),m=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p].filter(io).join(`
`),m.length>0&&(m+=`
`)):(b=[xg(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+h:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(io).join(`
`),m=[xg(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+h:"",t.envMap?"#define "+d:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==bi?"#define TONE_MAPPING":"",t.toneMapping!==bi?We.tonemapping_pars_fragment:"",t.toneMapping!==bi?PS("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",We.colorspace_pars_fragment,CS("linearToOutputTexel",t.outputColorSpace),IS(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(io).join(`
`)),a=Xd(a),a=bg(a,t),a=yg(a,t),o=Xd(o),o=bg(o,t),o=yg(o,t),a=vg(a),o=vg(o),t.isRawShaderMaterial!==!0&&(g=`#version 300 es
`,b=[u,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+b,m=["#define varying in",t.glslVersion===Ui?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Ui?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let v=g+b+a,M=g+m+o,x=fg(r,r.VERTEX_SHADER,v),E=fg(r,r.FRAGMENT_SHADER,M);r.attachShader(f,x),r.attachShader(f,E),t.index0AttributeName!==void 0?r.bindAttribLocation(f,0,t.index0AttributeName):t.hasPositionAttribute===!0&&r.bindAttribLocation(f,0,"position"),r.linkProgram(f);function w(R){if(i.debug.checkShaderErrors){let N=r.getProgramInfoLog(f)||"",F=r.getShaderInfoLog(x)||"",V=r.getShaderInfoLog(E)||"",P=N.trim(),G=F.trim(),W=V.trim(),O=!0,Q=!0;if(r.getProgramParameter(f,r.LINK_STATUS)===!1)if(O=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(r,f,x,E);else{let H=gg(r,x,"vertex"),J=gg(r,E,"fragment");De("WebGLProgram: Shader Error "+r.getError()+" - VALIDATE_STATUS "+r.getProgramParameter(f,r.VALIDATE_STATUS)+`

Material Name: `+R.name+`
Material Type: `+R.type+`

Program Info Log: `+P+`
`+H+`
`+J)}else P!==""?Ne("WebGLProgram: Program Info Log:",P):(G===""||W==="")&&(Q=!1);Q&&(R.diagnostics={runnable:O,programLog:P,vertexShader:{log:G,prefix:b},fragmentShader:{log:W,prefix:m}})}r.deleteShader(x),r.deleteShader(E),y=new Js(r,f),A=DS(r,f)}let y;this.getUniforms=function(){return y===void 0&&w(this),y};let A;this.getAttributes=function(){return A===void 0&&w(this),A};let D=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return D===!1&&(D=r.getProgramParameter(f,wS)),D},this.destroy=function(){n.releaseStatesOfProgram(this),r.deleteProgram(f),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=AS++,this.cacheKey=e,this.usedTimes=1,this.program=f,this.vertexShader=x,this.fragmentShader=E,this}var $S=0,Yd=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,n){let r=this._getShaderCacheForMaterial(e);return r.has(t)===!1&&(r.add(t),t.usedTimes++),r.has(n)===!1&&(r.add(n),n.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new Jd(e),t.set(e,n)),n}},Jd=class{constructor(e){this.id=$S++,this.code=e,this.usedTimes=0}};function XS(i){return i===pr||i===eo||i===to}function YS(i,e,t,n,r,s){let a=new La,o=new Yd,l=new Set,c=[],h=new Map,d=n.logarithmicDepthBuffer,u={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function p(y){return l.add(y),y===0?"uv":`uv${y}`}function f(y,A,D,R,N,F){let V=R.fog,P=N.geometry,G=y.isMeshStandardMaterial||y.isMeshLambertMaterial||y.isMeshPhongMaterial?R.environment:null,W=y.isMeshStandardMaterial||y.isMeshLambertMaterial&&!y.envMap||y.isMeshPhongMaterial&&!y.envMap,O=e.get(y.envMap||G,W),Q=u[y.type],H=n.precision;y.precision!==null&&(H=n.getMaxPrecision(y.precision),H!==y.precision&&Ne("WebGLProgram.getParameters:",y.precision,"not supported, using",H,"instead."));let J=P.morphAttributes.position||P.morphAttributes.normal||P.morphAttributes.color,te=J!==void 0?J.length:0,ve=0;P.morphAttributes.position!==void 0&&(ve=1),P.morphAttributes.normal!==void 0&&(ve=2),P.morphAttributes.color!==void 0&&(ve=3);let Ee,X,re,me;if(Q){let ge=vi[Q];Ee=ge.vertexShader,X=ge.fragmentShader}else{Ee=y.vertexShader,X=y.fragmentShader;let ge=o.getVertexShaderStage(y),ot=o.getFragmentShaderStage(y);o.update(y,ge,ot),re=ge.id,me=ot.id}let Me=i.getRenderTarget(),pe=i.state.buffers.depth.getReversed(),Le=N.isInstancedMesh===!0,ft=N.isBatchedMesh===!0,Ce=!!y.map,et=!!y.matcap,it=!!O,Xe=it&&O.isPMREMTexture===!0,Ot=!!y.aoMap,Tt=!!y.lightMap,nn=!!y.bumpMap&&y.wireframe===!1,bt=!!y.normalMap,ii=!!y.displacementMap,Nt=!!y.emissiveMap,An=!!y.metalnessMap,En=!!y.roughnessMap,Tn=y.anisotropy>0,z=y.clearcoat>0,Cn=y.diffuseRoughness>0,mt=y.dispersion>0,gt=y.retroreflectivity>0,fe=y.iridescence>0,Ct=y.sheen>0,Re=y.transmission>0,Oe=Tn&&!!y.anisotropyMap,C=z&&!!y.clearcoatMap,_=z&&!!y.clearcoatNormalMap,B=z&&!!y.clearcoatRoughnessMap,ne=Cn&&!!y.diffuseRoughnessMap,ee=fe&&!!y.iridescenceMap,ae=fe&&!!y.iridescenceThicknessMap,ue=Ct&&!!y.sheenColorMap,Z=Ct&&!!y.sheenRoughnessMap,K=!!y.specularMap,le=!!y.specularColorMap,I=!!y.specularIntensityMap,j=Re&&!!y.transmissionMap,Y=Re&&!!y.thicknessMap,ce=!!y.gradientMap,se=!!y.alphaMap,oe=y.alphaTest>0,Ae=!!y.alphaHash,qe=!!y.extensions,ie=bi;y.toneMapped&&(Me===null||Me.isXRRenderTarget===!0)&&(ie=i.toneMapping);let Te=Xe?O.isCompressedCubeTexture?O.image[0].mipmaps:O.mipmaps:null,Be={shaderID:Q,shaderType:y.type,shaderName:y.name,vertexShader:Ee,fragmentShader:X,defines:y.defines,customVertexShaderID:re,customFragmentShaderID:me,isRawShaderMaterial:y.isRawShaderMaterial===!0,glslVersion:y.glslVersion,precision:H,batching:ft,batchingColor:ft&&N._colorsTexture!==null,instancing:Le,instancingColor:Le&&N.instanceColor!==null,instancingMorph:Le&&N.morphTexture!==null,outputColorSpace:Me===null?i.outputColorSpace:Me.isXRRenderTarget===!0?Me.texture.colorSpace:Ke.workingColorSpace,alphaToCoverage:!!y.alphaToCoverage,map:Ce,matcap:et,envMap:it,envMapMode:it&&O.mapping,envMapPMREM:Xe,envMapMaxLod:Xe?Te.length-1:null,envMapSize:Xe?Te[0].width:null,aoMap:Ot,lightMap:Tt,bumpMap:nn,normalMap:bt,displacementMap:ii,emissiveMap:Nt,normalMapObjectSpace:bt&&y.normalMapType===B0,normalMapTangentSpace:bt&&y.normalMapType===Ld,packedNormalMap:bt&&y.normalMapType===Ld&&XS(y.normalMap.format),metalnessMap:An,roughnessMap:En,anisotropy:Tn,anisotropyMap:Oe,clearcoat:z,clearcoatMap:C,clearcoatNormalMap:_,clearcoatRoughnessMap:B,diffuseRoughness:Cn,diffuseRoughnessMap:ne,dispersion:mt,retroreflection:gt,iridescence:fe,iridescenceMap:ee,iridescenceThicknessMap:ae,sheen:Ct,sheenColorMap:ue,sheenRoughnessMap:Z,specularMap:K,specularColorMap:le,specularIntensityMap:I,transmission:Re,transmissionMap:j,thicknessMap:Y,gradientMap:ce,opaque:y.transparent===!1&&y.blending===Ws&&y.alphaToCoverage===!1,alphaMap:se,alphaTest:oe,alphaHash:Ae,combine:y.combine,mapUv:Ce&&p(y.map.channel),aoMapUv:Ot&&p(y.aoMap.channel),lightMapUv:Tt&&p(y.lightMap.channel),bumpMapUv:nn&&p(y.bumpMap.channel),normalMapUv:bt&&p(y.normalMap.channel),displacementMapUv:ii&&p(y.displacementMap.channel),emissiveMapUv:Nt&&p(y.emissiveMap.channel),metalnessMapUv:An&&p(y.metalnessMap.channel),roughnessMapUv:En&&p(y.roughnessMap.channel),anisotropyMapUv:Oe&&p(y.anisotropyMap.channel),clearcoatMapUv:C&&p(y.clearcoatMap.channel),clearcoatNormalMapUv:_&&p(y.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:B&&p(y.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ne&&p(y.diffuseRoughnessMap.channel),iridescenceMapUv:ee&&p(y.iridescenceMap.channel),iridescenceThicknessMapUv:ae&&p(y.iridescenceThicknessMap.channel),sheenColorMapUv:ue&&p(y.sheenColorMap.channel),sheenRoughnessMapUv:Z&&p(y.sheenRoughnessMap.channel),specularMapUv:K&&p(y.specularMap.channel),specularColorMapUv:le&&p(y.specularColorMap.channel),specularIntensityMapUv:I&&p(y.specularIntensityMap.channel),transmissionMapUv:j&&p(y.transmissionMap.channel),thicknessMapUv:Y&&p(y.thicknessMap.channel),alphaMapUv:se&&p(y.alphaMap.channel),vertexTangents:!!P.attributes.tangent&&(bt||Tn),vertexNormals:!!P.attributes.normal,vertexColors:y.vertexColors,vertexAlphas:y.vertexColors===!0&&!!P.attributes.color&&P.attributes.color.itemSize===4,pointsUvs:N.isPoints===!0&&!!P.attributes.uv&&(Ce||se),fog:!!V,useFog:y.fog===!0,fogExp2:!!V&&V.isFogExp2,flatShading:y.wireframe===!1&&(y.flatShading===!0||P.attributes.normal===void 0&&bt===!1&&(y.isMeshLambertMaterial||y.isMeshPhongMaterial||y.isMeshStandardMaterial||y.isMeshPhysicalMaterial)),sizeAttenuation:y.sizeAttenuation===!0,logarithmicDepthBuffer:d,reversedDepthBuffer:pe,skinning:N.isSkinnedMesh===!0,hasPositionAttribute:P.attributes.position!==void 0,morphTargets:P.morphAttributes.position!==void 0,morphNormals:P.morphAttributes.normal!==void 0,morphColors:P.morphAttributes.color!==void 0,morphTargetsCount:te,morphTextureStride:ve,numSunLights:A.sun.length,numDirLights:A.directional.length,numPointLights:A.point.length,numSpotLights:A.spot.length,numSpotLightMaps:A.spotLightMap.length,numRectAreaLights:A.rectArea.length,numHemiLights:A.hemi.length,numSunLightShadows:A.sunShadowMap.length,numDirLightShadows:A.directionalShadowMap.length,numPointLightShadows:A.pointShadowMap.length,numSpotLightShadows:A.spotShadowMap.length,numSpotLightShadowsWithMaps:A.numSpotLightShadowsWithMaps,numLightProbes:A.numLightProbes,numLightProbeGrids:F.filter(ge=>ge.texture!==null).length,numClippingPlanes:s.numPlanes,numClipIntersection:s.numIntersection,dithering:y.dithering,shadowMapEnabled:i.shadowMap.enabled&&D.length>0,shadowMapType:i.shadowMap.type,toneMapping:ie,decodeVideoTexture:Ce&&y.map.isVideoTexture===!0&&Ke.getTransfer(y.map.colorSpace)===at,decodeVideoTextureEmissive:Nt&&y.emissiveMap.isVideoTexture===!0&&Ke.getTransfer(y.emissiveMap.colorSpace)===at,premultipliedAlpha:y.premultipliedAlpha,doubleSided:y.side===Fn,flipSided:y.side===en,useDepthPacking:y.depthPacking>=0,depthPacking:y.depthPacking||0,index0AttributeName:y.index0AttributeName,extensionClipCullDistance:qe&&y.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(qe&&y.extensions.multiDraw===!0||ft)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:y.customProgramCacheKey()};return Be.vertexUv1s=l.has(1),Be.vertexUv2s=l.has(2),Be.vertexUv3s=l.has(3),l.clear(),Be}function b(y){let A=[];if(y.shaderID?A.push(y.shaderID):(A.push(y.customVertexShaderID),A.push(y.customFragmentShaderID)),y.defines!==void 0)for(let D in y.defines)A.push(D),A.push(y.defines[D]);return y.isRawShaderMaterial===!1&&(m(A,y),g(A,y),A.push(i.outputColorSpace)),A.push(y.customProgramCacheKey),A.join()}function m(y,A){y.push(A.precision),y.push(A.outputColorSpace),y.push(A.envMapMode),y.push(A.envMapPMREM),y.push(A.envMapMaxLod),y.push(A.envMapSize),y.push(A.mapUv),y.push(A.alphaMapUv),y.push(A.lightMapUv),y.push(A.aoMapUv),y.push(A.bumpMapUv),y.push(A.normalMapUv),y.push(A.displacementMapUv),y.push(A.emissiveMapUv),y.push(A.metalnessMapUv),y.push(A.roughnessMapUv),y.push(A.anisotropyMapUv),y.push(A.clearcoatMapUv),y.push(A.clearcoatNormalMapUv),y.push(A.clearcoatRoughnessMapUv),y.push(A.diffuseRoughnessMapUv),y.push(A.iridescenceMapUv),y.push(A.iridescenceThicknessMapUv),y.push(A.sheenColorMapUv),y.push(A.sheenRoughnessMapUv),y.push(A.specularMapUv),y.push(A.specularColorMapUv),y.push(A.specularIntensityMapUv),y.push(A.transmissionMapUv),y.push(A.thicknessMapUv),y.push(A.combine),y.push(A.fogExp2),y.push(A.sizeAttenuation),y.push(A.morphTargetsCount),y.push(A.numSunLights),y.push(A.numDirLights),y.push(A.numPointLights),y.push(A.numSpotLights),y.push(A.numSpotLightMaps),y.push(A.numHemiLights),y.push(A.numRectAreaLights),y.push(A.numSunLightShadows),y.push(A.numDirLightShadows),y.push(A.numPointLightShadows),y.push(A.numSpotLightShadows),y.push(A.numSpotLightShadowsWithMaps),y.push(A.numLightProbes),y.push(A.numLightProbeGrids),y.push(A.shadowMapType),y.push(A.toneMapping),y.push(A.numClippingPlanes),y.push(A.numClipIntersection),y.push(A.depthPacking)}function g(y,A){a.disableAll(),A.instancing&&a.enable(0),A.instancingColor&&a.enable(1),A.instancingMorph&&a.enable(2),A.matcap&&a.enable(3),A.envMap&&a.enable(4),A.normalMapObjectSpace&&a.enable(5),A.normalMapTangentSpace&&a.enable(6),A.clearcoat&&a.enable(7),A.iridescence&&a.enable(8),A.alphaTest&&a.enable(9),A.vertexColors&&a.enable(10),A.vertexAlphas&&a.enable(11),A.vertexUv1s&&a.enable(12),A.vertexUv2s&&a.enable(13),A.vertexUv3s&&a.enable(14),A.vertexTangents&&a.enable(15),A.anisotropy&&a.enable(16),A.alphaHash&&a.enable(17),A.batching&&a.enable(18),A.dispersion&&a.enable(19),A.retroreflection&&a.enable(24),A.diffuseRoughness&&a.enable(25),A.batchingColor&&a.enable(20),A.gradientMap&&a.enable(21),A.packedNormalMap&&a.enable(22),A.vertexNormals&&a.enable(23),y.push(a.mask),a.disableAll(),A.fog&&a.enable(0),A.useFog&&a.enable(1),A.flatShading&&a.enable(2),A.logarithmicDepthBuffer&&a.enable(3),A.reversedDepthBuffer&&a.enable(4),A.skinning&&a.enable(5),A.morphTargets&&a.enable(6),A.morphNormals&&a.enable(7),A.morphColors&&a.enable(8),A.premultipliedAlpha&&a.enable(9),A.shadowMapEnabled&&a.enable(10),A.doubleSided&&a.enable(11),A.flipSided&&a.enable(12),A.useDepthPacking&&a.enable(13),A.dithering&&a.enable(14),A.transmission&&a.enable(15),A.sheen&&a.enable(16),A.opaque&&a.enable(17),A.pointsUvs&&a.enable(18),A.decodeVideoTexture&&a.enable(19),A.decodeVideoTextureEmissive&&a.enable(20),A.alphaToCoverage&&a.enable(21),A.numLightProbeGrids>0&&a.enable(22),A.hasPositionAttribute&&a.enable(23),y.push(a.mask)}function v(y){let A=u[y.type],D;if(A){let R=vi[A];D=tg.clone(R.uniforms)}else D=y.uniforms;return D}function M(y,A){let D=h.get(A);return D!==void 0?++D.usedTimes:(D=new WS(i,A,y,r),c.push(D),h.set(A,D)),D}function x(y){if(--y.usedTimes===0){let A=c.indexOf(y);c[A]=c[c.length-1],c.pop(),h.delete(y.cacheKey),y.destroy()}}function E(y){o.remove(y)}function w(){o.dispose()}return{getParameters:f,getProgramCacheKey:b,getUniforms:v,acquireProgram:M,releaseProgram:x,releaseShaderCache:E,programs:c,dispose:w}}function JS(){let i=new WeakMap;function e(a){return i.has(a)}function t(a){let o=i.get(a);return o===void 0&&(o={},i.set(a,o)),o}function n(a){i.delete(a)}function r(a,o,l){i.get(a)[o]=l}function s(){i=new WeakMap}return{has:e,get:t,remove:n,update:r,dispose:s}}function ZS(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.materialVariant!==e.materialVariant?i.materialVariant-e.materialVariant:i.z!==e.z?i.z-e.z:i.id-e.id}function _g(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function Sg(){let i=[],e=0,t=[],n=[],r=[];function s(){e=0,t.length=0,n.length=0,r.length=0}function a(u){let p=0;return u.isInstancedMesh&&(p+=2),u.isSkinnedMesh&&(p+=1),p}function o(u,p,f,b,m,g){let v=i[e];return v===void 0?(v={id:u.id,object:u,geometry:p,material:f,materialVariant:a(u),groupOrder:b,renderOrder:u.renderOrder,z:m,group:g},i[e]=v):(v.id=u.id,v.object=u,v.geometry=p,v.material=f,v.materialVariant=a(u),v.groupOrder=b,v.renderOrder=u.renderOrder,v.z=m,v.group=g),e++,v}function l(u,p,f,b,m,g,v){v.reversedDepth===!0&&(m=-m);let M=o(u,p,f,b,m,g);f.transmission>0?n.push(M):f.transparent===!0?r.push(M):t.push(M)}function c(u,p,f,b,m,g){let v=o(u,p,f,b,m,g);f.transmission>0?n.unshift(v):f.transparent===!0?r.unshift(v):t.unshift(v)}function h(u,p){t.length>1&&t.sort(u||ZS),n.length>1&&n.sort(p||_g),r.length>1&&r.sort(p||_g)}function d(){for(let u=e,p=i.length;u<p;u++){let f=i[u];if(f.id===null)break;f.id=null,f.object=null,f.geometry=null,f.material=null,f.group=null}}return{opaque:t,transmissive:n,transparent:r,init:s,push:l,unshift:c,finish:d,sort:h}}function KS(){let i=new WeakMap;function e(n,r){let s=i.get(n),a;return s===void 0?(a=new Sg,i.set(n,[a])):r>=s.length?(a=new Sg,s.push(a)):a=s[r],a}function t(){i=new WeakMap}return{get:e,dispose:t}}function jS(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new k,color:new Ge};break;case"SpotLight":t={position:new k,direction:new k,color:new Ge,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new k,color:new Ge,distance:0,decay:0};break;case"HemisphereLight":t={direction:new k,skyColor:new Ge,groundColor:new Ge};break;case"RectAreaLight":t={color:new Ge,position:new k,halfWidth:new k,halfHeight:new k};break}return i[e.id]=t,t}}}function QS(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new $e};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new $e};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new $e,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}var eM=0;function tM(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function nM(i){let e=new jS,t=QS(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new k);let r=new k,s=new pt,a=new pt;function o(c){let h=0,d=0,u=0;for(let F=0;F<9;F++)n.probe[F].set(0,0,0);let p=0,f=0,b=0,m=0,g=0,v=0,M=0,x=0,E=0,w=0,y=0,A=0,D=0,R=0;c.sort(tM);for(let F=0,V=c.length;F<V;F++){let P=c[F],G=P.color,W=P.intensity,O=P.distance,Q=null;if(P.shadow&&P.shadow.map&&(P.shadow.map.texture.format===pr?Q=P.shadow.map.texture:Q=P.shadow.map.depthTexture||P.shadow.map.texture),P.isAmbientLight)h+=G.r*W,d+=G.g*W,u+=G.b*W;else if(P.isLightProbe){for(let H=0;H<9;H++)n.probe[H].addScaledVector(P.sh.coefficients[H],W);R++}else if(P.isSunLight){let H=e.get(P);if(H.color.copy(P.color).multiplyScalar(P.intensity),P.castShadow){let J=P.shadow,te=t.get(P);te.shadowIntensity=J.intensity,te.shadowBias=J.bias,te.shadowNormalBias=J.normalBias,te.shadowRadius=J.radius,te.shadowMapSize.copy(J.mapSize).multiply(J.getFrameExtents()),n.sunShadow[f]=te,n.sunShadowMap[f]=Q;let ve=J.getViewportCount();for(let Ee=0;Ee<ve;Ee++)n.sunShadowMatrix[b+Ee]=J.getMatrix(Ee),n.sunShadowCascade[b+Ee]=J._cascadeData[Ee];b+=ve,f++}n.sun[p]=H,p++}else if(P.isDirectionalLight){let H=e.get(P);if(H.color.copy(P.color).multiplyScalar(P.intensity),P.castShadow){let J=P.shadow,te=t.get(P);te.shadowIntensity=J.intensity,te.shadowBias=J.bias,te.shadowNormalBias=J.normalBias,te.shadowRadius=J.radius,te.shadowMapSize=J.mapSize,n.directionalShadow[m]=te,n.directionalShadowMap[m]=Q,n.directionalShadowMatrix[m]=P.shadow.matrix,E++}n.directional[m]=H,m++}else if(P.isSpotLight){let H=e.get(P);H.position.setFromMatrixPosition(P.matrixWorld),H.color.copy(G).multiplyScalar(W),H.distance=O,H.coneCos=Math.cos(P.angle),H.penumbraCos=Math.cos(P.angle*(1-P.penumbra)),H.decay=P.decay,n.spot[v]=H;let J=P.shadow;if(P.map&&(n.spotLightMap[A]=P.map,A++,J.updateMatrices(P),P.castShadow&&D++),n.spotLightMatrix[v]=J.matrix,P.castShadow){let te=t.get(P);te.shadowIntensity=J.intensity,te.shadowBias=J.bias,te.shadowNormalBias=J.normalBias,te.shadowRadius=J.radius,te.shadowMapSize=J.mapSize,n.spotShadow[v]=te,n.spotShadowMap[v]=Q,y++}v++}else if(P.isRectAreaLight){let H=e.get(P);H.color.copy(G).multiplyScalar(W),H.halfWidth.set(P.width*.5,0,0),H.halfHeight.set(0,P.height*.5,0),n.rectArea[M]=H,M++}else if(P.isPointLight){let H=e.get(P);if(H.color.copy(P.color).multiplyScalar(P.intensity),H.distance=P.distance,H.decay=P.decay,P.castShadow){let J=P.shadow,te=t.get(P);te.shadowIntensity=J.intensity,te.shadowBias=J.bias,te.shadowNormalBias=J.normalBias,te.shadowRadius=J.radius,te.shadowMapSize=J.mapSize,te.shadowCameraNear=J.camera.near,te.shadowCameraFar=J.camera.far,n.pointShadow[g]=te,n.pointShadowMap[g]=Q,n.pointShadowMatrix[g]=P.shadow.matrix,w++}n.point[g]=H,g++}else if(P.isHemisphereLight){let H=e.get(P);H.skyColor.copy(P.color).multiplyScalar(W),H.groundColor.copy(P.groundColor).multiplyScalar(W),n.hemi[x]=H,x++}}M>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=be.LTC_FLOAT_1,n.rectAreaLTC2=be.LTC_FLOAT_2):(n.rectAreaLTC1=be.LTC_HALF_1,n.rectAreaLTC2=be.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=d,n.ambient[2]=u;let N=n.hash;(N.sunLength!==p||N.directionalLength!==m||N.pointLength!==g||N.spotLength!==v||N.rectAreaLength!==M||N.hemiLength!==x||N.numSunShadows!==f||N.numDirectionalShadows!==E||N.numPointShadows!==w||N.numSpotShadows!==y||N.numSpotMaps!==A||N.numLightProbes!==R)&&(n.sun.length=p,n.directional.length=m,n.spot.length=v,n.rectArea.length=M,n.point.length=g,n.hemi.length=x,n.sunShadow.length=f,n.sunShadowMap.length=f,n.sunShadowMatrix.length=b,n.sunShadowCascade.length=b,n.directionalShadow.length=E,n.directionalShadowMap.length=E,n.directionalShadowMatrix.length=E,n.pointShadow.length=w,n.pointShadowMap.length=w,n.pointShadowMatrix.length=w,n.spotShadow.length=y,n.spotShadowMap.length=y,n.spotLightMatrix.length=y+A-D,n.spotLightMap.length=A,n.numSpotLightShadowsWithMaps=D,n.numLightProbes=R,N.sunLength=p,N.directionalLength=m,N.pointLength=g,N.spotLength=v,N.rectAreaLength=M,N.hemiLength=x,N.numSunShadows=f,N.numDirectionalShadows=E,N.numPointShadows=w,N.numSpotShadows=y,N.numSpotMaps=A,N.numLightProbes=R,n.version=eM++)}function l(c,h){let d=0,u=0,p=0,f=0,b=0,m=0,g=h.matrixWorldInverse;for(let v=0,M=c.length;v<M;v++){let x=c[v];if(x.isSunLight){let E=n.sun[d];E.direction.setFromMatrixPosition(x.matrixWorld),E.direction.transformDirection(g),d++}else if(x.isDirectionalLight){let E=n.directional[u];E.direction.setFromMatrixPosition(x.matrixWorld),r.setFromMatrixPosition(x.target.matrixWorld),E.direction.sub(r),E.direction.transformDirection(g),u++}else if(x.isSpotLight){let E=n.spot[f];E.position.setFromMatrixPosition(x.matrixWorld),E.position.applyMatrix4(g),E.direction.setFromMatrixPosition(x.matrixWorld),r.setFromMatrixPosition(x.target.matrixWorld),E.direction.sub(r),E.direction.transformDirection(g),f++}else if(x.isRectAreaLight){let E=n.rectArea[b];E.position.setFromMatrixPosition(x.matrixWorld),E.position.applyMatrix4(g),a.identity(),s.copy(x.matrixWorld),s.premultiply(g),a.extractRotation(s),E.halfWidth.set(x.width*.5,0,0),E.halfHeight.set(0,x.height*.5,0),E.halfWidth.applyMatrix4(a),E.halfHeight.applyMatrix4(a),b++}else if(x.isPointLight){let E=n.point[p];E.position.setFromMatrixPosition(x.matrixWorld),E.position.applyMatrix4(g),p++}else if(x.isHemisphereLight){let E=n.hemi[m];E.direction.setFromMatrixPosition(x.matrixWorld),E.direction.transformDirection(g),m++}}}return{setup:o,setupView:l,state:n}}function Mg(i){let e=new nM(i),t=[],n=[],r=[];function s(d){h.camera=d,t.length=0,n.length=0,r.length=0}function a(d){d.isLightProbeGrid?r.push(d):t.push(d)}function o(d){n.push(d)}function l(){e.setup(t),r.sort((d,u)=>d.priority-u.priority||d.id-u.id)}function c(d){e.setupView(t,d)}let h={lightsArray:t,shadowsArray:n,lightProbeGridArray:r,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:s,state:h,setupLights:l,setupLightsView:c,pushLight:a,pushShadow:o}}function iM(i){let e=new WeakMap;function t(r,s=0){let a=e.get(r),o;return a===void 0?(o=new Mg(i),e.set(r,[o])):s>=a.length?(o=new Mg(i),a.push(o)):o=a[s],o}function n(){e=new WeakMap}return{get:t,dispose:n}}var rM=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,sM=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,aM=[new k(1,0,0),new k(-1,0,0),new k(0,1,0),new k(0,-1,0),new k(0,0,1),new k(0,0,-1)],oM=[new k(0,-1,0),new k(0,-1,0),new k(0,0,1),new k(0,0,-1),new k(0,-1,0),new k(0,-1,0)],wg=new pt,no=new k,Hd=new k;function lM(i,e,t){let n=new Gr,r=new $e,s=new $e,a=new ht,o=new Jl,l=new Zl,c={},h=t.maxTextureSize,d={[dr]:en,[en]:dr,[Fn]:Fn},u=new Jt({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new $e},radius:{value:4}},vertexShader:rM,fragmentShader:sM}),p=u.clone();p.defines.HORIZONTAL_PASS=1;let f=new cn;f.setAttribute("position",new At(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let b=new Yt(f,u),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Xa;let g=this.type;this.render=function(w,y,A){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||w.length===0)return;this.type===b0&&(Ne("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Xa);let D=i.getRenderTarget(),R=i.getActiveCubeFace(),N=i.getActiveMipmapLevel(),F=i.state;F.setBlending(Wr),F.buffers.depth.getReversed()===!0?F.buffers.color.setClear(0,0,0,0):F.buffers.color.setClear(1,1,1,1),F.buffers.depth.setTest(!0),F.setScissorTest(!1);let V=g!==this.type;V&&y.traverse(function(P){P.material&&(Array.isArray(P.material)?P.material.forEach(G=>G.needsUpdate=!0):P.material.needsUpdate=!0)});for(let P=0,G=w.length;P<G;P++){let W=w[P],O=W.shadow;if(O===void 0){Ne("WebGLShadowMap:",W,"has no shadow.");continue}if(O.autoUpdate===!1&&O.needsUpdate===!1)continue;r.copy(O.mapSize);let Q=O.getFrameExtents();r.multiply(Q),s.copy(O.mapSize),(r.x>h||r.y>h)&&(r.x>h&&(s.x=Math.floor(h/Q.x),r.x=s.x*Q.x,O.mapSize.x=s.x),r.y>h&&(s.y=Math.floor(h/Q.y),r.y=s.y*Q.y,O.mapSize.y=s.y));let H=i.state.buffers.depth.getReversed();if(O.camera._reversedDepth=H,O.map===null||V===!0){if(O.map!==null&&(O.map.depthTexture!==null&&(O.map.depthTexture.dispose(),O.map.depthTexture=null),O.map.dispose()),this.type===Gs){if(W.isPointLight){Ne("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}O.map=new xn(r.x,r.y,{format:pr,type:ni,minFilter:Ft,magFilter:Ft,generateMipmaps:!1}),O.map.texture.name=W.name+".shadowMap",O.map.depthTexture=new Di(r.x,r.y,Mn),O.map.depthTexture.name=W.name+".shadowMapDepth",O.map.depthTexture.format=Li,O.map.depthTexture.compareFunction=null,O.map.depthTexture.minFilter=Et,O.map.depthTexture.magFilter=Et}else W.isPointLight?(O.map=new ro(r.x),O.map.depthTexture=new Ba(r.x,ti)):(O.map=new xn(r.x,r.y),O.map.depthTexture=new Di(r.x,r.y,ti)),O.map.depthTexture.name=W.name+".shadowMap",O.map.depthTexture.format=Li,this.type===Xa?(O.map.depthTexture.compareFunction=H?zd:Dd,O.map.depthTexture.minFilter=Ft,O.map.depthTexture.magFilter=Ft):(O.map.depthTexture.compareFunction=null,O.map.depthTexture.minFilter=Et,O.map.depthTexture.magFilter=Et);O.camera.updateProjectionMatrix()}O.map.isWebGLCubeRenderTarget!==!0&&(O.map.width!==r.x||O.map.height!==r.y)&&O.map.setSize(r.x,r.y);let J=O.map.isWebGLCubeRenderTarget?6:O.getViewportCount();W.isPointLight!==!0&&O.updateMatrices(W,A);let te=(O.camera.layers.mask&4294967294)!==0?O.camera.layers:A.layers;for(let ve=0;ve<J;ve++){let Ee=O.getCamera(ve);if(W.isPointLight){let X=O.camera,re=O.matrix,me=W.distance||X.far;me!==X.far&&(X.far=me,X.updateProjectionMatrix()),no.setFromMatrixPosition(W.matrixWorld),X.position.copy(no),Hd.copy(X.position),Hd.add(aM[ve]),X.up.copy(oM[ve]),X.lookAt(Hd),X.updateMatrixWorld(),re.makeTranslation(-no.x,-no.y,-no.z),wg.multiplyMatrices(X.projectionMatrix,X.matrixWorldInverse),O._frustum.setFromProjectionMatrix(wg,X.coordinateSystem,X.reversedDepth)}if(O.map.isWebGLCubeRenderTarget)i.setRenderTarget(O.map,ve),i.clear();else{ve===0&&(i.setRenderTarget(O.map),i.clear());let X=O.getViewport(ve);a.set(s.x*X.x,s.y*X.y,s.x*X.z,s.y*X.w),F.viewport(a)}n=O.getFrustum(ve),x(y,A,Ee,W,te,this.type)}O.isPointLightShadow!==!0&&this.type===Gs&&v(O,A),O.needsUpdate=!1}g=this.type,m.needsUpdate=!1,i.setRenderTarget(D,R,N)};function v(w,y){let A=e.update(b);u.defines.VSM_SAMPLES!==w.blurSamples&&(u.defines.VSM_SAMPLES=w.blurSamples,p.defines.VSM_SAMPLES=w.blurSamples,u.needsUpdate=!0,p.needsUpdate=!0),w.mapPass===null?w.mapPass=new xn(r.x,r.y,{format:pr,type:ni}):(w.mapPass.width!==w.map.width||w.mapPass.height!==w.map.height)&&w.mapPass.setSize(w.map.width,w.map.height),u.uniforms.shadow_pass.value=w.map.depthTexture,u.uniforms.resolution.value.set(w.map.width,w.map.height),u.uniforms.radius.value=w.radius,i.setRenderTarget(w.mapPass),i.clear(),i.renderBufferDirect(y,null,A,u,b,null),p.uniforms.shadow_pass.value=w.mapPass.texture,p.uniforms.resolution.value.set(w.map.width,w.map.height),p.uniforms.radius.value=w.radius,i.setRenderTarget(w.map),i.clear(),i.renderBufferDirect(y,null,A,p,b,null)}function M(w,y,A,D){let R=null,N=A.isPointLight===!0?w.customDistanceMaterial:w.customDepthMaterial;if(N!==void 0)R=N;else if(R=A.isPointLight===!0?l:o,i.localClippingEnabled&&y.clipShadows===!0&&Array.isArray(y.clippingPlanes)&&y.clippingPlanes.length!==0||y.displacementMap&&y.displacementScale!==0||y.alphaMap&&y.alphaTest>0||y.map&&y.alphaTest>0||y.alphaToCoverage===!0){let F=R.uuid,V=y.uuid,P=c[F];P===void 0&&(P={},c[F]=P);let G=P[V];G===void 0&&(G=R.clone(),P[V]=G,y.addEventListener("dispose",E)),R=G}if(R.visible=y.visible,R.wireframe=y.wireframe,D===Gs?R.side=y.shadowSide!==null?y.shadowSide:y.side:R.side=y.shadowSide!==null?y.shadowSide:d[y.side],R.alphaMap=y.alphaMap,R.alphaTest=y.alphaToCoverage===!0?.5:y.alphaTest,R.map=y.map,R.clipShadows=y.clipShadows,R.clippingPlanes=y.clippingPlanes,R.clipIntersection=y.clipIntersection,R.displacementMap=y.displacementMap,R.displacementScale=y.displacementScale,R.displacementBias=y.displacementBias,R.wireframeLinewidth=y.wireframeLinewidth,R.linewidth=y.linewidth,A.isPointLight===!0&&R.isMeshDistanceMaterial===!0){let F=i.properties.get(R);F.light=A}return R}function x(w,y,A,D,R,N){if(w.visible===!1)return;if(w.layers.test(R)&&(w.isMesh||w.isLine||w.isPoints)&&(w.castShadow||w.receiveShadow&&N===Gs)&&(!w.frustumCulled||w.intersectsFrustum(n))){w.modelViewMatrix.multiplyMatrices(A.matrixWorldInverse,w.matrixWorld);let P=e.update(w),G=w.material;if(Array.isArray(G)){let W=P.groups;for(let O=0,Q=W.length;O<Q;O++){let H=W[O],J=G[H.materialIndex];if(J&&J.visible){let te=M(w,J,D,N);w.onBeforeShadow(i,w,y,A,P,te,H),i.renderBufferDirect(A,null,P,te,w,H),w.onAfterShadow(i,w,y,A,P,te,H)}}}else if(G.visible){let W=M(w,G,D,N);w.onBeforeShadow(i,w,y,A,P,W,null),i.renderBufferDirect(A,null,P,W,w,null),w.onAfterShadow(i,w,y,A,P,W,null)}}let V=w.children;for(let P=0,G=V.length;P<G;P++)x(V[P],y,A,D,R,N)}function E(w){w.target.removeEventListener("dispose",E);for(let A in c){let D=c[A],R=w.target.uuid;R in D&&(D[R].dispose(),delete D[R])}}}function cM(i,e){function t(){let I=!1,j=new ht,Y=null,ce=new ht(0,0,0,0);return{setMask:function(se){Y!==se&&!I&&(i.colorMask(se,se,se,se),Y=se)},setLocked:function(se){I=se},setClear:function(se,oe,Ae,qe,ie){ie===!0&&(se*=qe,oe*=qe,Ae*=qe),j.set(se,oe,Ae,qe),ce.equals(j)===!1&&(i.clearColor(se,oe,Ae,qe),ce.copy(j))},reset:function(){I=!1,Y=null,ce.set(-1,0,0,0)}}}function n(){let I=!1,j=!1,Y=null,ce=null,se=null;return{setReversed:function(oe){if(j!==oe){let Ae=e.get("EXT_clip_control");oe?Ae.clipControlEXT(Ae.LOWER_LEFT_EXT,Ae.ZERO_TO_ONE_EXT):Ae.clipControlEXT(Ae.LOWER_LEFT_EXT,Ae.NEGATIVE_ONE_TO_ONE_EXT),j=oe;let qe=se;se=null,this.setClear(qe)}},getReversed:function(){return j},setTest:function(oe){oe?pe(i.DEPTH_TEST):Le(i.DEPTH_TEST)},setMask:function(oe){Y!==oe&&!I&&(i.depthMask(oe),Y=oe)},setFunc:function(oe){if(j&&(oe=Z0[oe]),ce!==oe){switch(oe){case Il:i.depthFunc(i.NEVER);break;case Nl:i.depthFunc(i.ALWAYS);break;case Ll:i.depthFunc(i.LESS);break;case Ds:i.depthFunc(i.LEQUAL);break;case Dl:i.depthFunc(i.EQUAL);break;case zl:i.depthFunc(i.GEQUAL);break;case zs:i.depthFunc(i.GREATER);break;case Fl:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}ce=oe}},setLocked:function(oe){I=oe},setClear:function(oe){se!==oe&&(se=oe,j&&(oe=1-oe),i.clearDepth(oe))},reset:function(){I=!1,Y=null,ce=null,se=null,j=!1}}}function r(){let I=!1,j=null,Y=null,ce=null,se=null,oe=null,Ae=null,qe=null,ie=null;return{setTest:function(Te){I||(Te?pe(i.STENCIL_TEST):Le(i.STENCIL_TEST))},setMask:function(Te){j!==Te&&!I&&(i.stencilMask(Te),j=Te)},setFunc:function(Te,Be,ge){(Y!==Te||ce!==Be||se!==ge)&&(i.stencilFunc(Te,Be,ge),Y=Te,ce=Be,se=ge)},setOp:function(Te,Be,ge){(oe!==Te||Ae!==Be||qe!==ge)&&(i.stencilOp(Te,Be,ge),oe=Te,Ae=Be,qe=ge)},setLocked:function(Te){I=Te},setClear:function(Te){ie!==Te&&(i.clearStencil(Te),ie=Te)},reset:function(){I=!1,j=null,Y=null,ce=null,se=null,oe=null,Ae=null,qe=null,ie=null}}}let s=new t,a=new n,o=new r,l={},c=new WeakMap,h={},d={},u={},p=new WeakMap,f=[],b=null,m=!1,g=null,v=null,M=null,x=null,E=null,w=null,y=null,A=new Ge(0,0,0),D=0,R=!1,N=null,F=null,V=null,P=null,G=null,W=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),O=!1,Q=0,H=i.getParameter(i.VERSION);H.indexOf("WebGL")!==-1?(Q=parseFloat(/^WebGL (\d)/.exec(H)[1]),O=Q>=1):H.indexOf("OpenGL ES")!==-1&&(Q=parseFloat(/^OpenGL ES (\d)/.exec(H)[1]),O=Q>=2);let J=null,te={},ve=i.getParameter(i.SCISSOR_BOX),Ee=i.getParameter(i.VIEWPORT),X=new ht().fromArray(ve),re=new ht().fromArray(Ee);function me(I,j,Y,ce){let se=new Uint8Array(4),oe=i.createTexture();i.bindTexture(I,oe),i.texParameteri(I,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(I,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Ae=0;Ae<Y;Ae++)I===i.TEXTURE_3D||I===i.TEXTURE_2D_ARRAY?i.texImage3D(j,0,i.RGBA,1,1,ce,0,i.RGBA,i.UNSIGNED_BYTE,se):i.texImage2D(j+Ae,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,se);return oe}let Me={};Me[i.TEXTURE_2D]=me(i.TEXTURE_2D,i.TEXTURE_2D,1),Me[i.TEXTURE_CUBE_MAP]=me(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Me[i.TEXTURE_2D_ARRAY]=me(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Me[i.TEXTURE_3D]=me(i.TEXTURE_3D,i.TEXTURE_3D,1,1),s.setClear(0,0,0,1),a.setClear(1),o.setClear(0),pe(i.DEPTH_TEST),a.setFunc(Ds),nn(!1),bt(dd),pe(i.CULL_FACE),Ot(Wr);function pe(I){h[I]!==!0&&(i.enable(I),h[I]=!0)}function Le(I){h[I]!==!1&&(i.disable(I),h[I]=!1)}function ft(I,j){return u[I]!==j?(i.bindFramebuffer(I,j),u[I]=j,I===i.DRAW_FRAMEBUFFER&&(u[i.FRAMEBUFFER]=j),I===i.FRAMEBUFFER&&(u[i.DRAW_FRAMEBUFFER]=j),!0):!1}function Ce(I,j){let Y=f,ce=!1;if(I){Y=p.get(j),Y===void 0&&(Y=[],p.set(j,Y));let se=I.textures;if(Y.length!==se.length||Y[0]!==i.COLOR_ATTACHMENT0){for(let oe=0,Ae=se.length;oe<Ae;oe++)Y[oe]=i.COLOR_ATTACHMENT0+oe;Y.length=se.length,ce=!0}}else Y[0]!==i.BACK&&(Y[0]=i.BACK,ce=!0);ce&&i.drawBuffers(Y)}function et(I){return b!==I?(i.useProgram(I),b=I,!0):!1}let it={[$r]:i.FUNC_ADD,[v0]:i.FUNC_SUBTRACT,[x0]:i.FUNC_REVERSE_SUBTRACT};it[_0]=i.MIN,it[S0]=i.MAX;let Xe={[M0]:i.ZERO,[w0]:i.ONE,[A0]:i.SRC_COLOR,[gd]:i.SRC_ALPHA,[I0]:i.SRC_ALPHA_SATURATE,[R0]:i.DST_COLOR,[T0]:i.DST_ALPHA,[E0]:i.ONE_MINUS_SRC_COLOR,[bd]:i.ONE_MINUS_SRC_ALPHA,[P0]:i.ONE_MINUS_DST_COLOR,[C0]:i.ONE_MINUS_DST_ALPHA,[N0]:i.CONSTANT_COLOR,[L0]:i.ONE_MINUS_CONSTANT_COLOR,[D0]:i.CONSTANT_ALPHA,[z0]:i.ONE_MINUS_CONSTANT_ALPHA};function Ot(I,j,Y,ce,se,oe,Ae,qe,ie,Te){if(I===Wr){m===!0&&(Le(i.BLEND),m=!1);return}if(m===!1&&(pe(i.BLEND),m=!0),I!==y0){if(I!==g||Te!==R){if((v!==$r||E!==$r)&&(i.blendEquation(i.FUNC_ADD),v=$r,E=$r),Te)switch(I){case Ws:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case pd:i.blendFunc(i.ONE,i.ONE);break;case fd:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case md:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:De("WebGLState: Invalid blending: ",I);break}else switch(I){case Ws:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case pd:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case fd:De("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case md:De("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:De("WebGLState: Invalid blending: ",I);break}M=null,x=null,w=null,y=null,A.set(0,0,0),D=0,g=I,R=Te}return}se=se||j,oe=oe||Y,Ae=Ae||ce,(j!==v||se!==E)&&(i.blendEquationSeparate(it[j],it[se]),v=j,E=se),(Y!==M||ce!==x||oe!==w||Ae!==y)&&(i.blendFuncSeparate(Xe[Y],Xe[ce],Xe[oe],Xe[Ae]),M=Y,x=ce,w=oe,y=Ae),(qe.equals(A)===!1||ie!==D)&&(i.blendColor(qe.r,qe.g,qe.b,ie),A.copy(qe),D=ie),g=I,R=!1}function Tt(I,j){I.side===Fn?Le(i.CULL_FACE):pe(i.CULL_FACE);let Y=I.side===en;j&&(Y=!Y),nn(Y),I.blending===Ws&&I.transparent===!1?Ot(Wr):Ot(I.blending,I.blendEquation,I.blendSrc,I.blendDst,I.blendEquationAlpha,I.blendSrcAlpha,I.blendDstAlpha,I.blendColor,I.blendAlpha,I.premultipliedAlpha),a.setFunc(I.depthFunc),a.setTest(I.depthTest),a.setMask(I.depthWrite),s.setMask(I.colorWrite);let ce=I.stencilWrite;o.setTest(ce),ce&&(o.setMask(I.stencilWriteMask),o.setFunc(I.stencilFunc,I.stencilRef,I.stencilFuncMask),o.setOp(I.stencilFail,I.stencilZFail,I.stencilZPass)),Nt(I.polygonOffset,I.polygonOffsetFactor,I.polygonOffsetUnits),I.alphaToCoverage===!0?pe(i.SAMPLE_ALPHA_TO_COVERAGE):Le(i.SAMPLE_ALPHA_TO_COVERAGE)}function nn(I){N!==I&&(I?i.frontFace(i.CW):i.frontFace(i.CCW),N=I)}function bt(I){I!==m0?(pe(i.CULL_FACE),I!==F&&(I===dd?i.cullFace(i.BACK):I===g0?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Le(i.CULL_FACE),F=I}function ii(I){I!==V&&(O&&i.lineWidth(I),V=I)}function Nt(I,j,Y){I?(pe(i.POLYGON_OFFSET_FILL),(P!==j||G!==Y)&&(P=j,G=Y,a.getReversed()&&(j=-j,Y=-Y),i.polygonOffset(j,Y))):Le(i.POLYGON_OFFSET_FILL)}function An(I){I?pe(i.SCISSOR_TEST):Le(i.SCISSOR_TEST)}function En(I){I===void 0&&(I=i.TEXTURE0+W-1),J!==I&&(i.activeTexture(I),J=I)}function Tn(I,j,Y){Y===void 0&&(J===null?Y=i.TEXTURE0+W-1:Y=J);let ce=te[Y];ce===void 0&&(ce={type:void 0,texture:void 0},te[Y]=ce),(ce.type!==I||ce.texture!==j)&&(J!==Y&&(i.activeTexture(Y),J=Y),i.bindTexture(I,j||Me[I]),ce.type=I,ce.texture=j)}function z(){let I=te[J];I!==void 0&&I.type!==void 0&&(i.bindTexture(I.type,null),I.type=void 0,I.texture=void 0)}function Cn(){try{i.compressedTexImage2D(...arguments)}catch(I){De("WebGLState:",I)}}function mt(){try{i.compressedTexImage3D(...arguments)}catch(I){De("WebGLState:",I)}}function gt(){try{i.texSubImage2D(...arguments)}catch(I){De("WebGLState:",I)}}function fe(){try{i.texSubImage3D(...arguments)}catch(I){De("WebGLState:",I)}}function Ct(){try{i.compressedTexSubImage2D(...arguments)}catch(I){De("WebGLState:",I)}}function Re(){try{i.compressedTexSubImage3D(...arguments)}catch(I){De("WebGLState:",I)}}function Oe(){try{i.texStorage2D(...arguments)}catch(I){De("WebGLState:",I)}}function C(){try{i.texStorage3D(...arguments)}catch(I){De("WebGLState:",I)}}function _(){try{i.texImage2D(...arguments)}catch(I){De("WebGLState:",I)}}function B(){try{i.texImage3D(...arguments)}catch(I){De("WebGLState:",I)}}function ne(I){return d[I]!==void 0?d[I]:i.getParameter(I)}function ee(I,j){d[I]!==j&&(i.pixelStorei(I,j),d[I]=j)}function ae(I){X.equals(I)===!1&&(i.scissor(I.x,I.y,I.z,I.w),X.copy(I))}function ue(I){re.equals(I)===!1&&(i.viewport(I.x,I.y,I.z,I.w),re.copy(I))}function Z(I,j){let Y=c.get(j);Y===void 0&&(Y=new WeakMap,c.set(j,Y));let ce=Y.get(I);ce===void 0&&(ce=i.getUniformBlockIndex(j,I.name),i.uniformBlockBinding(j,ce,ce),Y.set(I,ce))}function K(I,j,Y){let se=c.get(j).get(I);l[se]!==Y&&(i.bindBufferBase(i.UNIFORM_BUFFER,se,Y),l[se]=Y)}function le(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),a.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),h={},d={},J=null,te={},u={},l={},p=new WeakMap,f=[],b=null,m=!1,g=null,v=null,M=null,x=null,E=null,w=null,y=null,A=new Ge(0,0,0),D=0,R=!1,N=null,F=null,V=null,P=null,G=null,X.set(0,0,i.canvas.width,i.canvas.height),re.set(0,0,i.canvas.width,i.canvas.height),s.reset(),a.reset(),o.reset()}return{buffers:{color:s,depth:a,stencil:o},enable:pe,disable:Le,bindFramebuffer:ft,drawBuffers:Ce,useProgram:et,setBlending:Ot,setMaterial:Tt,setFlipSided:nn,setCullFace:bt,setLineWidth:ii,setPolygonOffset:Nt,setScissorTest:An,activeTexture:En,bindTexture:Tn,unbindTexture:z,compressedTexImage2D:Cn,compressedTexImage3D:mt,texImage2D:_,texImage3D:B,pixelStorei:ee,getParameter:ne,updateUBOMapping:Z,uniformBlockBinding:K,texStorage2D:Oe,texStorage3D:C,texSubImage2D:gt,texSubImage3D:fe,compressedTexSubImage2D:Ct,compressedTexSubImage3D:Re,scissor:ae,viewport:ue,reset:le}}function hM(i,e,t,n,r,s,a){let o=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new $e,h=new WeakMap,d=new Set,u,p=new WeakMap,f=new Set,b=new FinalizationRegistry(C=>f.delete(C)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(C,_){return m?new OffscreenCanvas(C,_):Pa("canvas")}function v(C,_,B){let ne=1,ee=Oe(C);if((ee.width>B||ee.height>B)&&(ne=B/Math.max(ee.width,ee.height)),ne<1)if(typeof HTMLImageElement<"u"&&C instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&C instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&C instanceof ImageBitmap||typeof VideoFrame<"u"&&C instanceof VideoFrame){let ae=Math.floor(ne*ee.width),ue=Math.floor(ne*ee.height);u===void 0&&(u=g(ae,ue));let Z=_?g(ae,ue):u;return Z.width=ae,Z.height=ue,Z.getContext("2d").drawImage(C,0,0,ae,ue),Ne("WebGLRenderer: Texture has been resized from ("+ee.width+"x"+ee.height+") to ("+ae+"x"+ue+")."),Z}else return"data"in C&&Ne("WebGLRenderer: Image in DataTexture is too big ("+ee.width+"x"+ee.height+")."),C;return C}function M(C){return C.generateMipmaps}function x(C){i.generateMipmap(C)}function E(C){return C.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:C.isWebGL3DRenderTarget?i.TEXTURE_3D:C.isWebGLArrayRenderTarget||C.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function w(C,_,B,ne,ee,ae=!1){if(C!==null){if(i[C]!==void 0)return i[C];Ne("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+C+"'")}let ue;ne&&(ue=e.get("EXT_texture_norm16"),ue||Ne("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let Z=_;if(_===i.RED&&(B===i.FLOAT&&(Z=i.R32F),B===i.HALF_FLOAT&&(Z=i.R16F),B===i.UNSIGNED_BYTE&&(Z=i.R8),B===i.UNSIGNED_SHORT&&ue&&(Z=ue.R16_EXT),B===i.SHORT&&ue&&(Z=ue.R16_SNORM_EXT)),_===i.RED_INTEGER&&(B===i.UNSIGNED_BYTE&&(Z=i.R8UI),B===i.UNSIGNED_SHORT&&(Z=i.R16UI),B===i.UNSIGNED_INT&&(Z=i.R32UI),B===i.BYTE&&(Z=i.R8I),B===i.SHORT&&(Z=i.R16I),B===i.INT&&(Z=i.R32I)),_===i.RG&&(B===i.FLOAT&&(Z=i.RG32F),B===i.HALF_FLOAT&&(Z=i.RG16F),B===i.UNSIGNED_BYTE&&(Z=i.RG8),B===i.UNSIGNED_SHORT&&ue&&(Z=ue.RG16_EXT),B===i.SHORT&&ue&&(Z=ue.RG16_SNORM_EXT)),_===i.RG_INTEGER&&(B===i.UNSIGNED_BYTE&&(Z=i.RG8UI),B===i.UNSIGNED_SHORT&&(Z=i.RG16UI),B===i.UNSIGNED_INT&&(Z=i.RG32UI),B===i.BYTE&&(Z=i.RG8I),B===i.SHORT&&(Z=i.RG16I),B===i.INT&&(Z=i.RG32I)),_===i.RGB_INTEGER&&(B===i.UNSIGNED_BYTE&&(Z=i.RGB8UI),B===i.UNSIGNED_SHORT&&(Z=i.RGB16UI),B===i.UNSIGNED_INT&&(Z=i.RGB32UI),B===i.BYTE&&(Z=i.RGB8I),B===i.SHORT&&(Z=i.RGB16I),B===i.INT&&(Z=i.RGB32I)),_===i.RGBA_INTEGER&&(B===i.UNSIGNED_BYTE&&(Z=i.RGBA8UI),B===i.UNSIGNED_SHORT&&(Z=i.RGBA16UI),B===i.UNSIGNED_INT&&(Z=i.RGBA32UI),B===i.BYTE&&(Z=i.RGBA8I),B===i.SHORT&&(Z=i.RGBA16I),B===i.INT&&(Z=i.RGBA32I)),_===i.RGB&&(B===i.UNSIGNED_SHORT&&ue&&(Z=ue.RGB16_EXT),B===i.SHORT&&ue&&(Z=ue.RGB16_SNORM_EXT),B===i.UNSIGNED_INT_5_9_9_9_REV&&(Z=i.RGB9_E5),B===i.UNSIGNED_INT_10F_11F_11F_REV&&(Z=i.R11F_G11F_B10F)),_===i.RGBA){let K=ae?Ca:Ke.getTransfer(ee);B===i.FLOAT&&(Z=i.RGBA32F),B===i.HALF_FLOAT&&(Z=i.RGBA16F),B===i.UNSIGNED_BYTE&&(Z=K===at?i.SRGB8_ALPHA8:i.RGBA8),B===i.UNSIGNED_SHORT&&ue&&(Z=ue.RGBA16_EXT),B===i.SHORT&&ue&&(Z=ue.RGBA16_SNORM_EXT),B===i.UNSIGNED_SHORT_4_4_4_4&&(Z=i.RGBA4),B===i.UNSIGNED_SHORT_5_5_5_1&&(Z=i.RGB5_A1)}return(Z===i.R16F||Z===i.R32F||Z===i.RG16F||Z===i.RG32F||Z===i.RGBA16F||Z===i.RGBA32F)&&e.get("EXT_color_buffer_float"),Z}function y(C,_){let B;return C?_===null||_===ti||_===Yr?B=i.DEPTH24_STENCIL8:_===Mn?B=i.DEPTH32F_STENCIL8:_===Xs&&(B=i.DEPTH24_STENCIL8,Ne("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):_===null||_===ti||_===Yr?B=i.DEPTH_COMPONENT24:_===Mn?B=i.DEPTH_COMPONENT32F:_===Xs&&(B=i.DEPTH_COMPONENT16),B}function A(C,_){return M(C)===!0||C.isFramebufferTexture&&C.minFilter!==Et&&C.minFilter!==Ft?Math.log2(Math.max(_.width,_.height))+1:C.mipmaps.length>0?C.mipmaps.length:C.isCompressedTexture&&Array.isArray(C.image)?_.mipmaps.length:1}function D(C){let _=new WeakRef(C);n.get(C).__ref=_,f.add(_),b.register(C,_,_)}function R(C){let _=n.get(C).__ref;_!==void 0&&(f.delete(_),b.unregister(_))}function N(C){V(C.target)}function F(C){P(C.target)}function V(C){C.removeEventListener("dispose",N),R(C),W(C),C.isVideoTexture&&h.delete(C),C.isHTMLTexture&&d.delete(C)}function P(C){C.removeEventListener("dispose",F),R(C),Q(C)}function G(){for(let C of f){let _=C.deref();_!==void 0&&(_.isRenderTarget===!0?P(_):V(_))}f.clear(),d.clear()}function W(C){let _=n.get(C);if(_.__webglInit===void 0)return;let B=C.source,ne=p.get(B);if(ne){let ee=ne[_.__cacheKey];ee.usedTimes--,ee.usedTimes===0&&O(C),Object.keys(ne).length===0&&p.delete(B)}n.remove(C)}function O(C){let _=n.get(C);i.deleteTexture(_.__webglTexture);let B=C.source,ne=p.get(B);delete ne[_.__cacheKey],a.memory.textures--}function Q(C){let _=n.get(C);_.__depthDisposeCallback&&_.__depthDisposeCallback();let B=C.depthTexture;if(B&&B.renderTarget===C&&V(B),C.isWebGLCubeRenderTarget)for(let ee=0;ee<6;ee++){if(Array.isArray(_.__webglFramebuffer[ee]))for(let ae=0;ae<_.__webglFramebuffer[ee].length;ae++)i.deleteFramebuffer(_.__webglFramebuffer[ee][ae]);else i.deleteFramebuffer(_.__webglFramebuffer[ee]);_.__webglDepthbuffer&&i.deleteRenderbuffer(_.__webglDepthbuffer[ee])}else{if(Array.isArray(_.__webglFramebuffer))for(let ee=0;ee<_.__webglFramebuffer.length;ee++)i.deleteFramebuffer(_.__webglFramebuffer[ee]);else i.deleteFramebuffer(_.__webglFramebuffer);if(_.__webglDepthbuffer&&i.deleteRenderbuffer(_.__webglDepthbuffer),_.__webglMultisampledFramebuffer&&i.deleteFramebuffer(_.__webglMultisampledFramebuffer),_.__webglColorRenderbuffer)for(let ee=0;ee<_.__webglColorRenderbuffer.length;ee++)_.__webglColorRenderbuffer[ee]&&i.deleteRenderbuffer(_.__webglColorRenderbuffer[ee]);_.__webglDepthRenderbuffer&&i.deleteRenderbuffer(_.__webglDepthRenderbuffer)}let ne=C.textures;for(let ee=0,ae=ne.length;ee<ae;ee++){let ue=n.get(ne[ee]);ue.__webglTexture&&(i.deleteTexture(ue.__webglTexture),a.memory.textures--),n.remove(ne[ee])}n.remove(C)}let H=0;function J(){H=0}function te(){return H}function ve(C){H=C}function Ee(){let C=H;return C>=r.maxTextures&&Ne("WebGLTextures: Trying to use "+(C+1)+" texture units while this GPU supports only "+r.maxTextures),H+=1,C}function X(C){let _=[];return _.push(C.wrapS),_.push(C.wrapT),_.push(C.wrapR||0),_.push(C.magFilter),_.push(C.minFilter),_.push(C.anisotropy),_.push(C.internalFormat),_.push(C.format),_.push(C.type),_.push(C.generateMipmaps),_.push(C.mipmapsAutoUpdate),_.push(C.premultiplyAlpha),_.push(C.flipY),_.push(C.unpackAlignment),_.push(C.colorSpace),_.join()}function re(C,_){let B=n.get(C);if(C.isVideoTexture&&Ct(C),C.isRenderTargetTexture===!1&&C.isExternalTexture!==!0&&C.version>0&&B.__version!==C.version){let ne=C.image;if(ne===null)Ne("WebGLRenderer: Texture marked for update but no image data found.");else if(ne.complete===!1)Ne("WebGLRenderer: Texture marked for update but image is incomplete");else{Tt(B,C,_);return}}else C.isExternalTexture&&(B.__webglTexture=C.sourceTexture?C.sourceTexture:null);t.bindTexture(i.TEXTURE_2D,B.__webglTexture,i.TEXTURE0+_)}function me(C,_){let B=n.get(C);if(C.isRenderTargetTexture===!1&&C.version>0&&B.__version!==C.version){Tt(B,C,_);return}else C.isExternalTexture&&(B.__webglTexture=C.sourceTexture?C.sourceTexture:null);t.bindTexture(i.TEXTURE_2D_ARRAY,B.__webglTexture,i.TEXTURE0+_)}function Me(C,_){let B=n.get(C);if(C.isRenderTargetTexture===!1&&C.version>0&&B.__version!==C.version){Tt(B,C,_);return}t.bindTexture(i.TEXTURE_3D,B.__webglTexture,i.TEXTURE0+_)}function pe(C,_){let B=n.get(C);if(C.version>0&&B.__version!==C.version){nn(B,C,_);return}t.bindTexture(i.TEXTURE_CUBE_MAP,B.__webglTexture,i.TEXTURE0+_)}let Le={[Ol]:i.REPEAT,[fi]:i.CLAMP_TO_EDGE,[Ul]:i.MIRRORED_REPEAT},ft={[Et]:i.NEAREST,[U0]:i.NEAREST_MIPMAP_NEAREST,[Ya]:i.NEAREST_MIPMAP_LINEAR,[Ft]:i.LINEAR,[hc]:i.LINEAR_MIPMAP_NEAREST,[zi]:i.LINEAR_MIPMAP_LINEAR},Ce={[V0]:i.NEVER,[Fd]:i.ALWAYS,[H0]:i.LESS,[Dd]:i.LEQUAL,[G0]:i.EQUAL,[zd]:i.GEQUAL,[W0]:i.GREATER,[$0]:i.NOTEQUAL};function et(C,_){if(_.type===Mn&&e.has("OES_texture_float_linear")===!1&&(_.magFilter===Ft||_.magFilter===hc||_.magFilter===Ya||_.magFilter===zi||_.minFilter===Ft||_.minFilter===hc||_.minFilter===Ya||_.minFilter===zi)&&Ne("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(C,i.TEXTURE_WRAP_S,Le[_.wrapS]),i.texParameteri(C,i.TEXTURE_WRAP_T,Le[_.wrapT]),(C===i.TEXTURE_3D||C===i.TEXTURE_2D_ARRAY)&&i.texParameteri(C,i.TEXTURE_WRAP_R,Le[_.wrapR]),i.texParameteri(C,i.TEXTURE_MAG_FILTER,ft[_.magFilter]),i.texParameteri(C,i.TEXTURE_MIN_FILTER,ft[_.minFilter]),_.compareFunction&&(i.texParameteri(C,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(C,i.TEXTURE_COMPARE_FUNC,Ce[_.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(_.magFilter===Et||_.minFilter!==Ya&&_.minFilter!==zi||_.type===Mn&&e.has("OES_texture_float_linear")===!1)return;if(_.anisotropy>1||n.get(_).__currentAnisotropy){let B=e.get("EXT_texture_filter_anisotropic");i.texParameterf(C,B.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(_.anisotropy,r.getMaxAnisotropy())),n.get(_).__currentAnisotropy=_.anisotropy}}}function it(C,_){let B=!1;C.__webglInit===void 0&&(C.__webglInit=!0,_.addEventListener("dispose",N),D(_));let ne=_.source,ee=p.get(ne);ee===void 0&&(ee={},p.set(ne,ee));let ae=X(_);if(ae!==C.__cacheKey){ee[ae]===void 0&&(ee[ae]={texture:i.createTexture(),usedTimes:0},a.memory.textures++,B=!0),ee[ae].usedTimes++;let ue=ee[C.__cacheKey];ue!==void 0&&(ee[C.__cacheKey].usedTimes--,ue.usedTimes===0&&O(_)),C.__cacheKey=ae,C.__webglTexture=ee[ae].texture}return B}function Xe(C,_,B){return Math.floor(Math.floor(C/B)/_)}function Ot(C,_,B,ne){let ae=C.updateRanges;if(ae.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,_.width,_.height,B,ne,_.data);else{ae.sort((I,j)=>I.start-j.start);let ue=0;for(let I=1;I<ae.length;I++){let j=ae[ue],Y=ae[I],ce=j.start+j.count,se=Xe(Y.start,_.width,4),oe=Xe(j.start,_.width,4);Y.start<=ce+1&&se===oe&&Xe(Y.start+Y.count-1,_.width,4)===se?j.count=Math.max(j.count,Y.start+Y.count-j.start):(++ue,ae[ue]=Y)}ae.length=ue+1;let Z=t.getParameter(i.UNPACK_ROW_LENGTH),K=t.getParameter(i.UNPACK_SKIP_PIXELS),le=t.getParameter(i.UNPACK_SKIP_ROWS);t.pixelStorei(i.UNPACK_ROW_LENGTH,_.width);for(let I=0,j=ae.length;I<j;I++){let Y=ae[I],ce=Math.floor(Y.start/4),se=Math.ceil(Y.count/4),oe=ce%_.width,Ae=Math.floor(ce/_.width),qe=se,ie=1;t.pixelStorei(i.UNPACK_SKIP_PIXELS,oe),t.pixelStorei(i.UNPACK_SKIP_ROWS,Ae),t.texSubImage2D(i.TEXTURE_2D,0,oe,Ae,qe,ie,B,ne,_.data)}C.clearUpdateRanges(),t.pixelStorei(i.UNPACK_ROW_LENGTH,Z),t.pixelStorei(i.UNPACK_SKIP_PIXELS,K),t.pixelStorei(i.UNPACK_SKIP_ROWS,le)}}function Tt(C,_,B){let ne=i.TEXTURE_2D;(_.isDataArrayTexture||_.isCompressedArrayTexture)&&(ne=i.TEXTURE_2D_ARRAY),_.isData3DTexture&&(ne=i.TEXTURE_3D);let ee=it(C,_),ae=_.source;t.bindTexture(ne,C.__webglTexture,i.TEXTURE0+B);let ue=n.get(ae);if(ae.version!==ue.__version||ee===!0){if(t.activeTexture(i.TEXTURE0+B),(typeof ImageBitmap<"u"&&_.image instanceof ImageBitmap)===!1){let ie=Ke.getPrimaries(Ke.workingColorSpace),Te=_.colorSpace===Oi?null:Ke.getPrimaries(_.colorSpace),Be=_.colorSpace===Oi||ie===Te?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,_.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,_.premultiplyAlpha),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Be)}t.pixelStorei(i.UNPACK_ALIGNMENT,_.unpackAlignment);let K=v(_.image,!1,r.maxTextureSize);K=Re(_,K);let le=s.convert(_.format,_.colorSpace),I=s.convert(_.type),j=w(_.internalFormat,le,I,_.normalized,_.colorSpace,_.isVideoTexture);et(ne,_);let Y,ce=_.mipmaps,se=_.isVideoTexture!==!0,oe=ue.__version===void 0||ee===!0,Ae=ae.dataReady,qe=A(_,K);if(_.isDepthTexture)j=y(_.format===Fi,_.type),oe&&(se?t.texStorage2D(i.TEXTURE_2D,1,j,K.width,K.height):t.texImage2D(i.TEXTURE_2D,0,j,K.width,K.height,0,le,I,null));else if(_.isDataTexture)if(ce.length>0){se&&oe&&t.texStorage2D(i.TEXTURE_2D,qe,j,ce[0].width,ce[0].height);for(let ie=0,Te=ce.length;ie<Te;ie++)Y=ce[ie],se?Ae&&t.texSubImage2D(i.TEXTURE_2D,ie,0,0,Y.width,Y.height,le,I,Y.data):t.texImage2D(i.TEXTURE_2D,ie,j,Y.width,Y.height,0,le,I,Y.data);_.generateMipmaps=!1}else se?(oe&&t.texStorage2D(i.TEXTURE_2D,qe,j,K.width,K.height),Ae&&Ot(_,K,le,I)):t.texImage2D(i.TEXTURE_2D,0,j,K.width,K.height,0,le,I,K.data);else if(_.isCompressedTexture)if(_.isCompressedArrayTexture){se&&oe&&t.texStorage3D(i.TEXTURE_2D_ARRAY,qe,j,ce[0].width,ce[0].height,K.depth);for(let ie=0,Te=ce.length;ie<Te;ie++)if(Y=ce[ie],_.format!==wn)if(le!==null)if(se){if(Ae)if(_.layerUpdates.size>0){let Be=qd(Y.width,Y.height,_.format,_.type);for(let ge of _.layerUpdates){let ot=Y.data.subarray(ge*Be/Y.data.BYTES_PER_ELEMENT,(ge+1)*Be/Y.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ie,0,0,ge,Y.width,Y.height,1,le,ot)}}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ie,0,0,0,Y.width,Y.height,K.depth,le,Y.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,ie,j,Y.width,Y.height,K.depth,0,Y.data,0,0);else Ne("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else se?Ae&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,ie,0,0,0,Y.width,Y.height,K.depth,le,I,Y.data):t.texImage3D(i.TEXTURE_2D_ARRAY,ie,j,Y.width,Y.height,K.depth,0,le,I,Y.data);_.layerUpdates.size>0&&_.clearLayerUpdates()}else{se&&oe&&t.texStorage2D(i.TEXTURE_2D,qe,j,ce[0].width,ce[0].height);for(let ie=0,Te=ce.length;ie<Te;ie++)Y=ce[ie],_.format!==wn?le!==null?se?Ae&&t.compressedTexSubImage2D(i.TEXTURE_2D,ie,0,0,Y.width,Y.height,le,Y.data):t.compressedTexImage2D(i.TEXTURE_2D,ie,j,Y.width,Y.height,0,Y.data):Ne("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):se?Ae&&t.texSubImage2D(i.TEXTURE_2D,ie,0,0,Y.width,Y.height,le,I,Y.data):t.texImage2D(i.TEXTURE_2D,ie,j,Y.width,Y.height,0,le,I,Y.data)}else if(_.isDataArrayTexture)if(se){if(oe&&t.texStorage3D(i.TEXTURE_2D_ARRAY,qe,j,K.width,K.height,K.depth),Ae)if(_.layerUpdates.size>0){let ie=qd(K.width,K.height,_.format,_.type);for(let Te of _.layerUpdates){let Be=K.data.subarray(Te*ie/K.data.BYTES_PER_ELEMENT,(Te+1)*ie/K.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,Te,K.width,K.height,1,le,I,Be)}_.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,K.width,K.height,K.depth,le,I,K.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,j,K.width,K.height,K.depth,0,le,I,K.data);else if(_.isData3DTexture)se?(oe&&t.texStorage3D(i.TEXTURE_3D,qe,j,K.width,K.height,K.depth),Ae&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,K.width,K.height,K.depth,le,I,K.data)):t.texImage3D(i.TEXTURE_3D,0,j,K.width,K.height,K.depth,0,le,I,K.data);else if(_.isFramebufferTexture){if(oe)if(se)t.texStorage2D(i.TEXTURE_2D,qe,j,K.width,K.height);else{let ie=K.width,Te=K.height;for(let Be=0;Be<qe;Be++)t.texImage2D(i.TEXTURE_2D,Be,j,ie,Te,0,le,I,null),ie>>=1,Te>>=1}}else if(_.isHTMLTexture){if("texElementImage2D"in i){let ie=i.canvas;if(ie.hasAttribute("layoutsubtree")||ie.setAttribute("layoutsubtree","true"),K.parentNode!==ie){ie.appendChild(K),d.add(_),ie.onpaint=Te=>{let Be=Te.changedElements;for(let ge of d)Be.includes(ge.image)&&(ge.needsUpdate=!0)},ie.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,K);else{let Be=i.RGBA,ge=i.RGBA,ot=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,Be,ge,ot,K)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(ce.length>0){if(se&&oe){let ie=Oe(ce[0]);t.texStorage2D(i.TEXTURE_2D,qe,j,ie.width,ie.height)}for(let ie=0,Te=ce.length;ie<Te;ie++)Y=ce[ie],se?Ae&&t.texSubImage2D(i.TEXTURE_2D,ie,0,0,le,I,Y):t.texImage2D(i.TEXTURE_2D,ie,j,le,I,Y);_.generateMipmaps=!1}else if(se){if(oe){let ie=Oe(K);t.texStorage2D(i.TEXTURE_2D,qe,j,ie.width,ie.height)}Ae&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,le,I,K)}else t.texImage2D(i.TEXTURE_2D,0,j,le,I,K);M(_)&&_.mipmapsAutoUpdate===!0&&x(ne),ue.__version=ae.version,_.onUpdate&&_.onUpdate(_)}C.__version=_.version}function nn(C,_,B){if(_.image.length!==6)return;let ne=it(C,_),ee=_.source;t.bindTexture(i.TEXTURE_CUBE_MAP,C.__webglTexture,i.TEXTURE0+B);let ae=n.get(ee);if(ee.version!==ae.__version||ne===!0){t.activeTexture(i.TEXTURE0+B);let ue=Ke.getPrimaries(Ke.workingColorSpace),Z=_.colorSpace===Oi?null:Ke.getPrimaries(_.colorSpace),K=_.colorSpace===Oi||ue===Z?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,_.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,_.premultiplyAlpha),t.pixelStorei(i.UNPACK_ALIGNMENT,_.unpackAlignment),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,K);let le=_.isCompressedTexture||_.image[0].isCompressedTexture,I=_.image[0]&&_.image[0].isDataTexture,j=[];for(let ge=0;ge<6;ge++)!le&&!I?j[ge]=v(_.image[ge],!0,r.maxCubemapSize):j[ge]=I?_.image[ge].image:_.image[ge],j[ge]=Re(_,j[ge]);let Y=j[0],ce=s.convert(_.format,_.colorSpace),se=s.convert(_.type),oe=w(_.internalFormat,ce,se,_.normalized,_.colorSpace),Ae=_.isVideoTexture!==!0,qe=ae.__version===void 0||ne===!0,ie=ee.dataReady,Te=A(_,Y);et(i.TEXTURE_CUBE_MAP,_);let Be;if(_.isDepthTexture){if(oe=y(_.format===Fi,_.type),qe)if(Ae)t.texStorage2D(i.TEXTURE_CUBE_MAP,1,oe,Y.width,Y.height);else for(let ge=0;ge<6;ge++)t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,0,oe,Y.width,Y.height,0,ce,se,null)}else if(le){Ae&&qe&&t.texStorage2D(i.TEXTURE_CUBE_MAP,Te,oe,Y.width,Y.height);for(let ge=0;ge<6;ge++){Be=j[ge].mipmaps;for(let ot=0;ot<Be.length;ot++){let Lt=Be[ot];_.format!==wn?ce!==null?Ae?ie&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,ot,0,0,Lt.width,Lt.height,ce,Lt.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,ot,oe,Lt.width,Lt.height,0,Lt.data):Ne("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Ae?ie&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,ot,0,0,Lt.width,Lt.height,ce,se,Lt.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,ot,oe,Lt.width,Lt.height,0,ce,se,Lt.data)}}}else{if(Be=_.mipmaps,Ae&&qe){Be.length>0&&Te++;let ge=Oe(j[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,Te,oe,ge.width,ge.height)}for(let ge=0;ge<6;ge++)if(I){Ae?ie&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,0,0,0,j[ge].width,j[ge].height,ce,se,j[ge].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,0,oe,j[ge].width,j[ge].height,0,ce,se,j[ge].data);for(let ot=0;ot<Be.length;ot++){let ki=Be[ot].image[ge].image;Ae?ie&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,ot+1,0,0,ki.width,ki.height,ce,se,ki.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,ot+1,oe,ki.width,ki.height,0,ce,se,ki.data)}}else{Ae?ie&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,0,0,0,ce,se,j[ge]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,0,oe,ce,se,j[ge]);for(let ot=0;ot<Be.length;ot++){let Lt=Be[ot];Ae?ie&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,ot+1,0,0,ce,se,Lt.image[ge]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,ot+1,oe,ce,se,Lt.image[ge])}}}M(_)&&_.mipmapsAutoUpdate===!0&&x(i.TEXTURE_CUBE_MAP),ae.__version=ee.version,_.onUpdate&&_.onUpdate(_)}C.__version=_.version}function bt(C,_,B,ne,ee,ae){let ue=s.convert(B.format,B.colorSpace),Z=s.convert(B.type),K=w(B.internalFormat,ue,Z,B.normalized,B.colorSpace),le=n.get(_),I=n.get(B);if(I.__renderTarget=_,!le.__hasExternalTextures){let j=Math.max(1,_.width>>ae),Y=Math.max(1,_.height>>ae);ee===i.TEXTURE_3D||ee===i.TEXTURE_2D_ARRAY?t.texImage3D(ee,ae,K,j,Y,_.depth,0,ue,Z,null):t.texImage2D(ee,ae,K,j,Y,0,ue,Z,null)}t.bindFramebuffer(i.FRAMEBUFFER,C),fe(_)?o.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ne,ee,I.__webglTexture,0,gt(_)):(ee===i.TEXTURE_2D||ee>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&ee<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,ne,ee,I.__webglTexture,ae),t.bindFramebuffer(i.FRAMEBUFFER,null)}function ii(C,_,B){if(i.bindRenderbuffer(i.RENDERBUFFER,C),_.depthBuffer){let ne=_.depthTexture,ee=ne&&ne.isDepthTexture?ne.type:null,ae=y(_.stencilBuffer,ee),ue=_.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;fe(_)?o.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,gt(_),ae,_.width,_.height):B?i.renderbufferStorageMultisample(i.RENDERBUFFER,gt(_),ae,_.width,_.height):i.renderbufferStorage(i.RENDERBUFFER,ae,_.width,_.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,ue,i.RENDERBUFFER,C)}else{let ne=_.textures;for(let ee=0;ee<ne.length;ee++){let ae=ne[ee],ue=s.convert(ae.format,ae.colorSpace),Z=s.convert(ae.type),K=w(ae.internalFormat,ue,Z,ae.normalized,ae.colorSpace);fe(_)?o.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,gt(_),K,_.width,_.height):B?i.renderbufferStorageMultisample(i.RENDERBUFFER,gt(_),K,_.width,_.height):i.renderbufferStorage(i.RENDERBUFFER,K,_.width,_.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function Nt(C,_,B){let ne=_.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(i.FRAMEBUFFER,C),!(_.depthTexture&&_.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ee=n.get(_.depthTexture);ee.__renderTarget=_;let ae=ne?_.depthTexture.image[0]:_.depthTexture.image;(!ee.__webglTexture||ae.width!==_.width||ae.height!==_.height)&&(ae.width=_.width,ae.height=_.height,_.depthTexture.needsUpdate=!0),ne?pe(_.depthTexture,0):re(_.depthTexture,0);let ue=ee.__webglTexture,Z=gt(_),K=ne?i.TEXTURE_CUBE_MAP_POSITIVE_X+B:i.TEXTURE_2D,le=_.depthTexture.format===Fi?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(_.depthTexture.format===Li)fe(_)?o.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,le,K,ue,0,Z):i.framebufferTexture2D(i.FRAMEBUFFER,le,K,ue,0);else if(_.depthTexture.format===Fi)fe(_)?o.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,le,K,ue,0,Z):i.framebufferTexture2D(i.FRAMEBUFFER,le,K,ue,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function An(C){let _=n.get(C),B=C.isWebGLCubeRenderTarget===!0;if(_.__boundDepthTexture!==C.depthTexture){let ne=C.depthTexture;if(_.__depthDisposeCallback&&_.__depthDisposeCallback(),ne){let ee=()=>{delete _.__boundDepthTexture,delete _.__depthDisposeCallback,ne.removeEventListener("dispose",ee)};ne.addEventListener("dispose",ee),_.__depthDisposeCallback=ee}_.__boundDepthTexture=ne}if(C.depthTexture&&!_.__autoAllocateDepthBuffer)if(B)for(let ne=0;ne<6;ne++)Nt(_.__webglFramebuffer[ne],C,ne);else C.texture.mipmaps.length>0?Nt(_.__webglFramebuffer[0],C,0):Nt(_.__webglFramebuffer,C,0);else if(B){_.__webglDepthbuffer=[];for(let ne=0;ne<6;ne++)if(t.bindFramebuffer(i.FRAMEBUFFER,_.__webglFramebuffer[ne]),_.__webglDepthbuffer[ne]===void 0)_.__webglDepthbuffer[ne]=i.createRenderbuffer(),ii(_.__webglDepthbuffer[ne],C,!1);else{let ee=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ae=_.__webglDepthbuffer[ne];i.bindRenderbuffer(i.RENDERBUFFER,ae),i.framebufferRenderbuffer(i.FRAMEBUFFER,ee,i.RENDERBUFFER,ae)}}else if(C.texture.mipmaps.length>0?t.bindFramebuffer(i.FRAMEBUFFER,_.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,_.__webglFramebuffer),_.__webglDepthbuffer===void 0)_.__webglDepthbuffer=i.createRenderbuffer(),ii(_.__webglDepthbuffer,C,!1);else{let ee=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ae=_.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,ae),i.framebufferRenderbuffer(i.FRAMEBUFFER,ee,i.RENDERBUFFER,ae)}t.bindFramebuffer(i.FRAMEBUFFER,null)}function En(C,_,B){let ne=n.get(C);_!==void 0&&bt(ne.__webglFramebuffer,C,C.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),B!==void 0&&An(C)}function Tn(C){let _=C.texture,B=n.get(C),ne=n.get(_);C.addEventListener("dispose",F),D(C);let ee=C.textures,ae=C.isWebGLCubeRenderTarget===!0,ue=ee.length>1;if(ue||(ne.__webglTexture===void 0&&(ne.__webglTexture=i.createTexture()),ne.__version=_.version,a.memory.textures++),ae){B.__webglFramebuffer=[];for(let Z=0;Z<6;Z++)if(_.mipmaps.length>0){B.__webglFramebuffer[Z]=[];for(let K=0;K<_.mipmaps.length;K++)B.__webglFramebuffer[Z][K]=i.createFramebuffer()}else B.__webglFramebuffer[Z]=i.createFramebuffer()}else{if(_.mipmaps.length>0){B.__webglFramebuffer=[];for(let Z=0;Z<_.mipmaps.length;Z++)B.__webglFramebuffer[Z]=i.createFramebuffer()}else B.__webglFramebuffer=i.createFramebuffer();if(ue)for(let Z=0,K=ee.length;Z<K;Z++){let le=n.get(ee[Z]);le.__webglTexture===void 0&&(le.__webglTexture=i.createTexture(),a.memory.textures++)}if(C.samples>0&&fe(C)===!1){B.__webglMultisampledFramebuffer=i.createFramebuffer(),B.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,B.__webglMultisampledFramebuffer);for(let Z=0;Z<ee.length;Z++){let K=ee[Z];B.__webglColorRenderbuffer[Z]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,B.__webglColorRenderbuffer[Z]);let le=s.convert(K.format,K.colorSpace),I=s.convert(K.type),j=w(K.internalFormat,le,I,K.normalized,K.colorSpace,C.isXRRenderTarget===!0),Y=gt(C);i.renderbufferStorageMultisample(i.RENDERBUFFER,Y,j,C.width,C.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Z,i.RENDERBUFFER,B.__webglColorRenderbuffer[Z])}i.bindRenderbuffer(i.RENDERBUFFER,null),C.depthBuffer&&(B.__webglDepthRenderbuffer=i.createRenderbuffer(),ii(B.__webglDepthRenderbuffer,C,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(ae){t.bindTexture(i.TEXTURE_CUBE_MAP,ne.__webglTexture),et(i.TEXTURE_CUBE_MAP,_);for(let Z=0;Z<6;Z++)if(_.mipmaps.length>0)for(let K=0;K<_.mipmaps.length;K++)bt(B.__webglFramebuffer[Z][K],C,_,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+Z,K);else bt(B.__webglFramebuffer[Z],C,_,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+Z,0);M(_)?x(i.TEXTURE_CUBE_MAP):_.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,_.mipmaps.length-1),t.unbindTexture()}else if(ue){for(let Z=0,K=ee.length;Z<K;Z++){let le=ee[Z],I=n.get(le),j=i.TEXTURE_2D;(C.isWebGL3DRenderTarget||C.isWebGLArrayRenderTarget)&&(j=C.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(j,I.__webglTexture),et(j,le),bt(B.__webglFramebuffer,C,le,i.COLOR_ATTACHMENT0+Z,j,0),M(le)&&x(j)}t.unbindTexture()}else{let Z=i.TEXTURE_2D;if((C.isWebGL3DRenderTarget||C.isWebGLArrayRenderTarget)&&(Z=C.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(Z,ne.__webglTexture),et(Z,_),_.mipmaps.length>0)for(let K=0;K<_.mipmaps.length;K++)bt(B.__webglFramebuffer[K],C,_,i.COLOR_ATTACHMENT0,Z,K);else bt(B.__webglFramebuffer,C,_,i.COLOR_ATTACHMENT0,Z,0);M(_)?x(Z):_.mipmaps.length>0&&i.texParameteri(Z,i.TEXTURE_MAX_LEVEL,_.mipmaps.length-1),t.unbindTexture()}C.depthBuffer&&An(C)}function z(C){let _=C.textures;for(let B=0,ne=_.length;B<ne;B++){let ee=_[B];if(M(ee)&&ee.mipmapsAutoUpdate===!0){let ae=E(C),ue=n.get(ee).__webglTexture;t.bindTexture(ae,ue),x(ae),t.unbindTexture()}}}let Cn=[];function mt(C){if(C.samples>0){if(fe(C)===!1){let _=C.textures,B=C.width,ne=C.height,ee=i.COLOR_BUFFER_BIT,ae=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ue=n.get(C),Z=_.length>1;if(Z)for(let le=0;le<_.length;le++)t.bindFramebuffer(i.FRAMEBUFFER,ue.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+le,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,ue.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+le,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,ue.__webglMultisampledFramebuffer),C.texture.mipmaps.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ue.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ue.__webglFramebuffer);for(let le=0;le<_.length;le++){if(C.resolveDepthBuffer&&(C.depthBuffer&&(ee|=i.DEPTH_BUFFER_BIT),C.stencilBuffer&&C.resolveStencilBuffer&&(ee|=i.STENCIL_BUFFER_BIT)),Z){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,ue.__webglColorRenderbuffer[le]);let I=n.get(_[le]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,I,0)}i.blitFramebuffer(0,0,B,ne,0,0,B,ne,ee,i.NEAREST),l===!0&&(Cn.length=0,Cn.push(i.COLOR_ATTACHMENT0+le),C.depthBuffer&&C.storeMultisampledDepthBuffer===!1&&Cn.push(ae),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Cn))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),Z)for(let le=0;le<_.length;le++){t.bindFramebuffer(i.FRAMEBUFFER,ue.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+le,i.RENDERBUFFER,ue.__webglColorRenderbuffer[le]);let I=n.get(_[le]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,ue.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+le,i.TEXTURE_2D,I,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ue.__webglMultisampledFramebuffer)}else if(C.depthBuffer&&C.storeMultisampledDepthBuffer===!1&&l){let _=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[_])}}}function gt(C){return Math.min(r.maxSamples,C.samples)}function fe(C){let _=n.get(C);return C.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&_.__useRenderToTexture!==!1}function Ct(C){let _=a.render.frame;h.get(C)!==_&&(h.set(C,_),C.update())}function Re(C,_){let B=C.colorSpace,ne=C.format,ee=C.type;return C.isCompressedTexture===!0||C.isVideoTexture===!0||B!==Ta&&B!==Oi&&(Ke.getTransfer(B)===at?(ne!==wn||ee!==tn)&&Ne("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):De("WebGLTextures: Unsupported texture color space:",B)),_}function Oe(C){return typeof HTMLImageElement<"u"&&C instanceof HTMLImageElement?(c.width=C.naturalWidth||C.width,c.height=C.naturalHeight||C.height):typeof VideoFrame<"u"&&C instanceof VideoFrame?(c.width=C.displayWidth,c.height=C.displayHeight):(c.width=C.width,c.height=C.height),c}this.allocateTextureUnit=Ee,this.resetTextureUnits=J,this.getTextureUnits=te,this.setTextureUnits=ve,this.setTexture2D=re,this.setTexture2DArray=me,this.setTexture3D=Me,this.setTextureCube=pe,this.rebindTextures=En,this.setupRenderTarget=Tn,this.updateRenderTargetMipmap=z,this.updateMultisampleRenderTarget=mt,this.setupDepthRenderbuffer=An,this.setupFrameBufferTexture=bt,this.useMultisampledRTT=fe,this.dispose=G}function uM(i,e){function t(n,r=Oi){let s,a=Ke.getTransfer(r);if(n===tn)return i.UNSIGNED_BYTE;if(n===dc)return i.UNSIGNED_SHORT_4_4_4_4;if(n===pc)return i.UNSIGNED_SHORT_5_5_5_1;if(n===Rd)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===Pd)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===Td)return i.BYTE;if(n===Cd)return i.SHORT;if(n===Xs)return i.UNSIGNED_SHORT;if(n===uc)return i.INT;if(n===ti)return i.UNSIGNED_INT;if(n===Mn)return i.FLOAT;if(n===ni)return i.HALF_FLOAT;if(n===Id)return i.ALPHA;if(n===Nd)return i.RGB;if(n===wn)return i.RGBA;if(n===Li)return i.DEPTH_COMPONENT;if(n===Fi)return i.DEPTH_STENCIL;if(n===Ja)return i.RED;if(n===fc)return i.RED_INTEGER;if(n===pr)return i.RG;if(n===mc)return i.RG_INTEGER;if(n===gc)return i.RGBA_INTEGER;if(n===Za||n===Ka||n===ja||n===Qa)if(a===at)if(s=e.get("WEBGL_compressed_texture_s3tc_srgb"),s!==null){if(n===Za)return s.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===Ka)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===ja)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===Qa)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(s=e.get("WEBGL_compressed_texture_s3tc"),s!==null){if(n===Za)return s.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===Ka)return s.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===ja)return s.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===Qa)return s.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===bc||n===yc||n===vc||n===xc)if(s=e.get("WEBGL_compressed_texture_pvrtc"),s!==null){if(n===bc)return s.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===yc)return s.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===vc)return s.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===xc)return s.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===_c||n===Sc||n===Mc||n===wc||n===Ac||n===eo||n===Ec)if(s=e.get("WEBGL_compressed_texture_etc"),s!==null){if(n===_c||n===Sc)return a===at?s.COMPRESSED_SRGB8_ETC2:s.COMPRESSED_RGB8_ETC2;if(n===Mc)return a===at?s.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:s.COMPRESSED_RGBA8_ETC2_EAC;if(n===wc)return s.COMPRESSED_R11_EAC;if(n===Ac)return s.COMPRESSED_SIGNED_R11_EAC;if(n===eo)return s.COMPRESSED_RG11_EAC;if(n===Ec)return s.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===Tc||n===Cc||n===Rc||n===Pc||n===Ic||n===Nc||n===Lc||n===Dc||n===zc||n===Fc||n===Oc||n===Uc||n===kc||n===Bc)if(s=e.get("WEBGL_compressed_texture_astc"),s!==null){if(n===Tc)return a===at?s.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:s.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===Cc)return a===at?s.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:s.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===Rc)return a===at?s.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:s.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===Pc)return a===at?s.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:s.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===Ic)return a===at?s.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:s.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===Nc)return a===at?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:s.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===Lc)return a===at?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:s.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===Dc)return a===at?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:s.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===zc)return a===at?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:s.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===Fc)return a===at?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:s.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===Oc)return a===at?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:s.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===Uc)return a===at?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:s.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===kc)return a===at?s.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:s.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===Bc)return a===at?s.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:s.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===qc||n===Vc||n===Hc)if(s=e.get("EXT_texture_compression_bptc"),s!==null){if(n===qc)return a===at?s.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:s.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===Vc)return s.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===Hc)return s.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===Gc||n===Wc||n===to||n===$c)if(s=e.get("EXT_texture_compression_rgtc"),s!==null){if(n===Gc)return s.COMPRESSED_RED_RGTC1_EXT;if(n===Wc)return s.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===to)return s.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===$c)return s.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===Yr?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}var dM=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,pM=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,Zd=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new qa(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new Jt({vertexShader:dM,fragmentShader:pM,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Yt(new Va(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Kd=class extends mi{constructor(e,t){super();let n=this,r=null,s=1,a=null,o="local-floor",l=1,c=null,h=null,d=null,u=null,p=null,f=null,b=typeof XRWebGLBinding<"u",m=new Zd,g={},v=t.getContextAttributes(),M=null,x=null,E=[],w=[],y=new $e,A=null,D=null,R=new Xt;R.viewport=new ht;let N=new Xt;N.viewport=new ht;let F=[R,N],V=new oc,P=null,G=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(X){let re=E[X];return re===void 0&&(re=new Us,E[X]=re),re.getTargetRaySpace()},this.getControllerGrip=function(X){let re=E[X];return re===void 0&&(re=new Us,E[X]=re),re.getGripSpace()},this.getHand=function(X){let re=E[X];return re===void 0&&(re=new Us,E[X]=re),re.getHandSpace()};function W(X){let re=w.indexOf(X.inputSource);if(re===-1)return;let me=E[re];me!==void 0&&(me.update(X.inputSource,X.frame,c||a),me.dispatchEvent({type:X.type,data:X.inputSource}))}function O(){r.removeEventListener("select",W),r.removeEventListener("selectstart",W),r.removeEventListener("selectend",W),r.removeEventListener("squeeze",W),r.removeEventListener("squeezestart",W),r.removeEventListener("squeezeend",W),r.removeEventListener("end",O),r.removeEventListener("inputsourceschange",Q);for(let X=0;X<E.length;X++){let re=w[X];re!==null&&(w[X]=null,E[X].disconnect(re))}P=null,G=null,m.reset();for(let X in g)delete g[X];if(e.setRenderTarget(M),p=null,u=null,d=null,r=null,x=null,Ee.stop(),n.isPresenting=!1,e.setPixelRatio(A),e.setSize(y.width,y.height,!1),D!==null){let X=D.camera;X.fov=D.fov,X.zoom=D.zoom,X.updateProjectionMatrix(),D=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(X){s=X,n.isPresenting===!0&&Ne("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(X){o=X,n.isPresenting===!0&&Ne("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||a},this.setReferenceSpace=function(X){c=X},this.getBaseLayer=function(){return u!==null?u:p},this.getBinding=function(){return d===null&&b&&(d=new XRWebGLBinding(r,t)),d},this.getFrame=function(){return f},this.getSession=function(){return r},this.setSession=async function(X){if(r=X,r!==null){if(M=e.getRenderTarget(),r.addEventListener("select",W),r.addEventListener("selectstart",W),r.addEventListener("selectend",W),r.addEventListener("squeeze",W),r.addEventListener("squeezestart",W),r.addEventListener("squeezeend",W),r.addEventListener("end",O),r.addEventListener("inputsourceschange",Q),v.xrCompatible!==!0&&await t.makeXRCompatible(),A=e.getPixelRatio(),e.getSize(y),b&&"createProjectionLayer"in XRWebGLBinding.prototype){let me=null,Me=null,pe=null;v.depth&&(pe=v.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,me=v.stencil?Fi:Li,Me=v.stencil?Yr:ti);let Le={colorFormat:t.RGBA8,depthFormat:pe,scaleFactor:s};d=this.getBinding(),u=d.createProjectionLayer(Le),r.updateRenderState({layers:[u]}),e.setPixelRatio(1),e.setSize(u.textureWidth,u.textureHeight,!1),x=new xn(u.textureWidth,u.textureHeight,{format:wn,type:tn,depthTexture:new Di(u.textureWidth,u.textureHeight,Me,void 0,void 0,void 0,void 0,void 0,void 0,me),stencilBuffer:v.stencil,colorSpace:e.outputColorSpace,samples:v.antialias?4:0,resolveDepthBuffer:u.ignoreDepthValues===!1,resolveStencilBuffer:u.ignoreDepthValues===!1,storeMultisampledDepthBuffer:u.ignoreDepthValues===!1,storeMultisampledStencilBuffer:u.ignoreDepthValues===!1})}else{let me={antialias:v.antialias,alpha:!0,depth:v.depth,stencil:v.stencil,framebufferScaleFactor:s};p=new XRWebGLLayer(r,t,me),r.updateRenderState({baseLayer:p}),e.setPixelRatio(1),e.setSize(p.framebufferWidth,p.framebufferHeight,!1),x=new xn(p.framebufferWidth,p.framebufferHeight,{format:wn,type:tn,colorSpace:e.outputColorSpace,stencilBuffer:v.stencil,resolveDepthBuffer:p.ignoreDepthValues===!1,resolveStencilBuffer:p.ignoreDepthValues===!1,storeMultisampledDepthBuffer:p.ignoreDepthValues===!1,storeMultisampledStencilBuffer:p.ignoreDepthValues===!1})}x.isXRRenderTarget=!0,this.setFoveation(l),c=null,a=await r.requestReferenceSpace(o),Ee.setContext(r),Ee.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(r!==null)return r.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function Q(X){for(let re=0;re<X.removed.length;re++){let me=X.removed[re],Me=w.indexOf(me);Me>=0&&(w[Me]=null,E[Me].disconnect(me))}for(let re=0;re<X.added.length;re++){let me=X.added[re],Me=w.indexOf(me);if(Me===-1){for(let Le=0;Le<E.length;Le++)if(Le>=w.length){w.push(me),Me=Le;break}else if(w[Le]===null){w[Le]=me,Me=Le;break}if(Me===-1)break}let pe=E[Me];pe&&pe.connect(me)}}function H(X,re){re===null?X.matrixWorld.copy(X.matrix):X.matrixWorld.multiplyMatrices(re.matrixWorld,X.matrix),X.matrixWorldInverse.copy(X.matrixWorld).invert()}this.updateCamera=function(X){if(r===null)return;let re=X.near,me=X.far;m.texture!==null&&(m.depthNear>0&&(re=m.depthNear),m.depthFar>0&&(me=m.depthFar)),V.near=N.near=R.near=re,V.far=N.far=R.far=me,(P!==V.near||G!==V.far)&&(r.updateRenderState({depthNear:V.near,depthFar:V.far}),P=V.near,G=V.far),V.layers.mask=X.layers.mask|6,R.layers.mask=V.layers.mask&-5,N.layers.mask=V.layers.mask&-3;let Me=X.parent,pe=V.cameras;H(V,Me);for(let Le=0;Le<pe.length;Le++)H(pe[Le],Me);V.projectionMatrix.copy(R.projectionMatrix),V.projectionMatrixInverse.copy(R.projectionMatrixInverse),D===null&&X.isPerspectiveCamera&&(D={camera:X,fov:X.fov,zoom:X.zoom}),J(X,V,Me)};function J(X,re,me){me===null?X.matrix.copy(re.matrixWorld):(X.matrix.copy(me.matrixWorld),X.matrix.invert(),X.matrix.multiply(re.matrixWorld)),X.matrix.decompose(X.position,X.quaternion,X.scale),X.updateMatrixWorld(!0),X.projectionMatrix.copy(re.projectionMatrix),X.projectionMatrixInverse.copy(re.projectionMatrixInverse),X.isPerspectiveCamera&&(X.fov=Bl*2*Math.atan(1/X.projectionMatrix.elements[5]),X.zoom=1)}this.getCamera=function(){return V},this.getFoveation=function(){if(!(u===null&&p===null))return l},this.setFoveation=function(X){l=X,u!==null&&(u.fixedFoveation=X),p!==null&&p.fixedFoveation!==void 0&&(p.fixedFoveation=X)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(V)},this.getCameraTexture=function(X){return g[X]};let te=null;function ve(X,re){if(h=re.getViewerPose(c||a),f=re,h!==null){let me=h.views;p!==null&&(e.setRenderTargetFramebuffer(x,p.framebuffer),e.setRenderTarget(x));let Me=!1;me.length!==V.cameras.length&&(V.cameras.length=0,Me=!0);for(let Ce=0;Ce<me.length;Ce++){let et=me[Ce],it=null;if(p!==null)it=p.getViewport(et);else{let Ot=d.getViewSubImage(u,et);it=Ot.viewport,Ce===0&&(e.setRenderTargetTextures(x,Ot.colorTexture,Ot.depthStencilTexture),e.setRenderTarget(x))}let Xe=F[Ce];Xe===void 0&&(Xe=new Xt,Xe.layers.enable(Ce),Xe.viewport=new ht,F[Ce]=Xe),Xe.matrix.fromArray(et.transform.matrix),Xe.matrix.decompose(Xe.position,Xe.quaternion,Xe.scale),Xe.projectionMatrix.fromArray(et.projectionMatrix),Xe.projectionMatrixInverse.copy(Xe.projectionMatrix).invert(),Xe.viewport.set(it.x,it.y,it.width,it.height),Ce===0&&(V.matrix.copy(Xe.matrix),V.matrix.decompose(V.position,V.quaternion,V.scale)),Me===!0&&V.cameras.push(Xe)}let pe=r.enabledFeatures;if(pe&&pe.includes("depth-sensing")&&r.depthUsage=="gpu-optimized"&&b){d=n.getBinding();let Ce=d.getDepthInformation(me[0]);Ce&&Ce.isValid&&Ce.texture&&m.init(Ce,r.renderState)}if(pe&&pe.includes("camera-access")&&b){e.state.unbindTexture(),d=n.getBinding();for(let Ce=0;Ce<me.length;Ce++){let et=me[Ce].camera;if(et){let it=g[et];it||(it=new qa,g[et]=it);let Xe=d.getCameraImage(et);it.sourceTexture=Xe}}}}for(let me=0;me<E.length;me++){let Me=w[me],pe=E[me];Me!==null&&pe!==void 0&&pe.update(Me,re,c||a)}te&&te(X,re),re.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:re}),f=null}let Ee=new Ag;Ee.setAnimationLoop(ve),this.setAnimationLoop=function(X){te=X},this.dispose=function(){}}},fM=new pt,zg=new Fe;zg.set(-1,0,0,0,1,0,0,0,1);function mM(i,e){function t(m,g){m.matrixAutoUpdate===!0&&m.updateMatrix(),g.value.copy(m.matrix)}function n(m,g){g.color.getRGB(m.fogColor.value,Ud(i)),g.isFog?(m.fogNear.value=g.near,m.fogFar.value=g.far):g.isFogExp2&&(m.fogDensity.value=g.density)}function r(m,g,v,M,x){g.isNodeMaterial?g.uniformsNeedUpdate=!1:g.isMeshBasicMaterial?s(m,g):g.isMeshLambertMaterial?(s(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshToonMaterial?(s(m,g),d(m,g)):g.isMeshPhongMaterial?(s(m,g),h(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshStandardMaterial?(s(m,g),u(m,g),g.isMeshPhysicalMaterial&&p(m,g,x)):g.isMeshMatcapMaterial?(s(m,g),f(m,g)):g.isMeshDepthMaterial?s(m,g):g.isMeshDistanceMaterial?(s(m,g),b(m,g)):g.isMeshNormalMaterial?s(m,g):g.isLineBasicMaterial?(a(m,g),g.isLineDashedMaterial&&o(m,g)):g.isPointsMaterial?l(m,g,v,M):g.isSpriteMaterial?c(m,g):g.isShadowMaterial?(m.color.value.copy(g.color),m.opacity.value=g.opacity):g.isShaderMaterial&&(g.uniformsNeedUpdate=!1)}function s(m,g){m.opacity.value=g.opacity,g.color&&m.diffuse.value.copy(g.color),g.emissive&&m.emissive.value.copy(g.emissive).multiplyScalar(g.emissiveIntensity),g.map&&(m.map.value=g.map,t(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,t(g.alphaMap,m.alphaMapTransform)),g.bumpMap&&(m.bumpMap.value=g.bumpMap,t(g.bumpMap,m.bumpMapTransform),m.bumpScale.value=g.bumpScale,g.side===en&&(m.bumpScale.value*=-1)),g.normalMap&&(m.normalMap.value=g.normalMap,t(g.normalMap,m.normalMapTransform),m.normalScale.value.copy(g.normalScale),g.side===en&&m.normalScale.value.negate()),g.displacementMap&&(m.displacementMap.value=g.displacementMap,t(g.displacementMap,m.displacementMapTransform),m.displacementScale.value=g.displacementScale,m.displacementBias.value=g.displacementBias),g.emissiveMap&&(m.emissiveMap.value=g.emissiveMap,t(g.emissiveMap,m.emissiveMapTransform)),g.specularMap&&(m.specularMap.value=g.specularMap,t(g.specularMap,m.specularMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest);let v=e.get(g),M=v.envMap,x=v.envMapRotation;M&&(m.envMap.value=M,m.envMapRotation.value.setFromMatrix4(fM.makeRotationFromEuler(x)).transpose(),M.isCubeTexture&&M.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(zg),m.reflectivity.value=g.reflectivity,m.ior.value=g.ior,m.refractionRatio.value=g.refractionRatio),g.lightMap&&(m.lightMap.value=g.lightMap,m.lightMapIntensity.value=g.lightMapIntensity,t(g.lightMap,m.lightMapTransform)),g.aoMap&&(m.aoMap.value=g.aoMap,m.aoMapIntensity.value=g.aoMapIntensity,t(g.aoMap,m.aoMapTransform))}function a(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,g.map&&(m.map.value=g.map,t(g.map,m.mapTransform))}function o(m,g){m.dashSize.value=g.dashSize,m.totalSize.value=g.dashSize+g.gapSize,m.scale.value=g.scale}function l(m,g,v,M){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.size.value=g.size*v,m.scale.value=M*.5,g.map&&(m.map.value=g.map,t(g.map,m.uvTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,t(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function c(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.rotation.value=g.rotation,g.map&&(m.map.value=g.map,t(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,t(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function h(m,g){m.specular.value.copy(g.specular),m.shininess.value=Math.max(g.shininess,1e-4)}function d(m,g){g.gradientMap&&(m.gradientMap.value=g.gradientMap)}function u(m,g){m.metalness.value=g.metalness,g.metalnessMap&&(m.metalnessMap.value=g.metalnessMap,t(g.metalnessMap,m.metalnessMapTransform)),m.roughness.value=g.roughness,g.roughnessMap&&(m.roughnessMap.value=g.roughnessMap,t(g.roughnessMap,m.roughnessMapTransform)),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)}function p(m,g,v){m.ior.value=g.ior,g.diffuseRoughness>0&&(m.diffuseRoughness.value=g.diffuseRoughness,g.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=g.diffuseRoughnessMap,t(g.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),g.sheen>0&&(m.sheenColor.value.copy(g.sheenColor).multiplyScalar(g.sheen),m.sheenRoughness.value=g.sheenRoughness,g.sheenColorMap&&(m.sheenColorMap.value=g.sheenColorMap,t(g.sheenColorMap,m.sheenColorMapTransform)),g.sheenRoughnessMap&&(m.sheenRoughnessMap.value=g.sheenRoughnessMap,t(g.sheenRoughnessMap,m.sheenRoughnessMapTransform))),g.clearcoat>0&&(m.clearcoat.value=g.clearcoat,m.clearcoatRoughness.value=g.clearcoatRoughness,g.clearcoatMap&&(m.clearcoatMap.value=g.clearcoatMap,t(g.clearcoatMap,m.clearcoatMapTransform)),g.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=g.clearcoatRoughnessMap,t(g.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),g.clearcoatNormalMap&&(m.clearcoatNormalMap.value=g.clearcoatNormalMap,t(g.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(g.clearcoatNormalScale),g.side===en&&m.clearcoatNormalScale.value.negate())),g.dispersion>0&&(m.dispersion.value=g.dispersion),g.retroreflectivity>0&&(m.retroreflectivity.value=g.retroreflectivity),g.iridescence>0&&(m.iridescence.value=g.iridescence,m.iridescenceIOR.value=g.iridescenceIOR,m.iridescenceThicknessMinimum.value=g.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=g.iridescenceThicknessMaximum,g.iridescenceMap&&(m.iridescenceMap.value=g.iridescenceMap,t(g.iridescenceMap,m.iridescenceMapTransform)),g.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=g.iridescenceThicknessMap,t(g.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),g.transmission>0&&(m.transmission.value=g.transmission,m.transmissionSamplerMap.value=v.texture,m.transmissionSamplerSize.value.set(v.width,v.height),g.transmissionMap&&(m.transmissionMap.value=g.transmissionMap,t(g.transmissionMap,m.transmissionMapTransform)),m.thickness.value=g.thickness,g.thicknessMap&&(m.thicknessMap.value=g.thicknessMap,t(g.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=g.attenuationDistance,m.attenuationColor.value.copy(g.attenuationColor)),g.anisotropy>0&&(m.anisotropyVector.value.set(g.anisotropy*Math.cos(g.anisotropyRotation),g.anisotropy*Math.sin(g.anisotropyRotation)),g.anisotropyMap&&(m.anisotropyMap.value=g.anisotropyMap,t(g.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=g.specularIntensity,m.specularColor.value.copy(g.specularColor),g.specularColorMap&&(m.specularColorMap.value=g.specularColorMap,t(g.specularColorMap,m.specularColorMapTransform)),g.specularIntensityMap&&(m.specularIntensityMap.value=g.specularIntensityMap,t(g.specularIntensityMap,m.specularIntensityMapTransform))}function f(m,g){g.matcap&&(m.matcap.value=g.matcap)}function b(m,g){let v=e.get(g).light;m.referencePosition.value.setFromMatrixPosition(v.matrixWorld),m.nearDistance.value=v.shadow.camera.near,m.farDistance.value=v.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:r}}function gM(i,e,t,n){let r={},s={};function a(v,M){let x=M.program;n.uniformBlockBinding(v,x,r[v.id])}function o(v,M){let x=r[v.id];x===void 0&&(f(v),x=l(v),r[v.id]=x,v.addEventListener("dispose",m));let E=M.program;n.updateUBOMapping(v,E);let w=e.render.frame;s[v.id]!==w&&(c(v),s[v.id]=w)}function l(v){let M=i.createBuffer(),x=v.__size,E=v.usage;return i.bindBuffer(i.UNIFORM_BUFFER,M),i.bufferData(i.UNIFORM_BUFFER,x,E),i.bindBuffer(i.UNIFORM_BUFFER,null),M}function c(v){let M=r[v.id],x=v.uniforms,E=v.__cache;i.bindBuffer(i.UNIFORM_BUFFER,M);for(let w=0,y=x.length;w<y;w++){let A=x[w];if(Array.isArray(A))for(let D=0,R=A.length;D<R;D++)h(A[D],w,D,E);else h(A,w,0,E)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function h(v,M,x,E){if(u(v,M,x,E)===!0){let w=v.__offset,y=v.value;if(Array.isArray(y)){let A=0;for(let D=0;D<y.length;D++){let R=y[D],N=b(R,!0);d(R,v.__data,A),A+=N.storage/Float32Array.BYTES_PER_ELEMENT}}else d(y,v.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,w,v.__data)}}function d(v,M,x){typeof v=="number"||typeof v=="boolean"?M[x]=v:v.isMatrix3?(M[x]=v.elements[0],M[x+1]=v.elements[1],M[x+2]=v.elements[2],M[x+3]=0,M[x+4]=v.elements[3],M[x+5]=v.elements[4],M[x+6]=v.elements[5],M[x+7]=0,M[x+8]=v.elements[6],M[x+9]=v.elements[7],M[x+10]=v.elements[8],M[x+11]=0):ArrayBuffer.isView(v)?M.set(v.subarray(0,M.length-x),x):v.toArray(M,x)}function u(v,M,x,E){let w=v.value,y=M+"_"+x;if(Array.isArray(w)){E[y]===void 0&&(E[y]=[]);let A=E[y],D=!1;for(let R=0;R<w.length;R++)p(w[R],A,R)===!0&&(D=!0);return D}return p(w,E,y)}function p(v,M,x){if(M[x]===void 0)return typeof v=="number"||typeof v=="boolean"?M[x]=v:ArrayBuffer.isView(v)?M[x]=v.slice():M[x]=v.clone(),!0;{let E=M[x];if(typeof v=="number"||typeof v=="boolean"){if(E!==v)return M[x]=v,!0}else{if(ArrayBuffer.isView(v))return!0;if(E.equals(v)===!1)return E.copy(v),!0}}return!1}function f(v){let M=v.uniforms,x=0,E=16;for(let y=0,A=M.length;y<A;y++){let D=Array.isArray(M[y])?M[y]:[M[y]];for(let R=0,N=D.length;R<N;R++){let F=D[R],V=Array.isArray(F.value)?F.value:[F.value],P=Array.isArray(M[y])||Array.isArray(F.value),G=x;for(let O=0,Q=V.length;O<Q;O++){let H=V[O],J=b(H,P),te=x%E,ve=te%J.boundary,Ee=te+ve;x+=ve,Ee!==0&&E-Ee<J.storage&&(x+=E-Ee),O===0&&(G=x),x+=J.storage}let W=F.type==="int"?Int32Array:F.type==="uint"?Uint32Array:Float32Array;F.__data=new W((x-G)/Float32Array.BYTES_PER_ELEMENT),F.__offset=G}}let w=x%E;return w>0&&(x+=E-w),v.__size=x,v.__cache={},this}function b(v,M){let x={boundary:0,storage:0};return typeof v=="number"||typeof v=="boolean"?(x.boundary=4,x.storage=4):v.isVector2?(x.boundary=8,x.storage=8):v.isVector3||v.isColor?(x.boundary=16,x.storage=12):v.isVector4?(x.boundary=16,x.storage=16):v.isMatrix3?(x.boundary=16,x.storage=48):v.isMatrix4?(x.boundary=16,x.storage=64):v.isTexture?Ne("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(v)?(x.boundary=16,x.storage=v.byteLength):Ne("WebGLRenderer: Unsupported uniform value type.",v),M===!0&&(x.boundary=16,x.storage=Math.ceil(x.storage/16)*16),x}function m(v){let M=v.target;M.removeEventListener("dispose",m),i.deleteBuffer(r[M.id]),delete r[M.id],delete s[M.id]}function g(){for(let v in r)i.deleteBuffer(r[v]);r={},s={}}return{bind:a,update:o,dispose:g}}var bM=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),yi=null;function yM(){return yi===null&&(yi=new Hr(bM,16,16,pr,ni),yi.name="DFG_LUT",yi.minFilter=Ft,yi.magFilter=Ft,yi.wrapS=fi,yi.wrapT=fi,yi.generateMipmaps=!1,yi.needsUpdate=!0),yi}var Kc=class{constructor(e={}){let{canvas:t=X0(),context:n=null,depth:r=!0,stencil:s=!1,alpha:a=!1,antialias:o=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:d=!1,reversedDepthBuffer:u=!1,outputBufferType:p=tn}=e;this.isWebGLRenderer=!0;let f;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");f=n.getContextAttributes().alpha}else f=a;let b=p,m=new Set([gc,mc,fc]),g=new Set([tn,ti,Xs,Yr,dc,pc]),v=new Uint32Array(4),M=new Int32Array(4),x={textures:[],min:[],max:[],resolution:[]},E=null,w=null,y=[],A=[],D=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=bi,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let R=this,N=!1,F=null,V=null,P=null,G=null;this._outputColorSpace=vn;let W=0,O=0,Q=null,H=-1,J=null,te=new ht,ve=new ht,Ee=null,X=new Ge(0),re=0,me=t.width,Me=t.height,pe=1,Le=null,ft=null,Ce=new ht(0,0,me,Me),et=new ht(0,0,me,Me),it=!1,Xe=new Gr,Ot=new $l,Tt=!1,nn=!1,bt=new pt,ii=new k,Nt=new ht,An={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},En=!1;function Tn(){return Q===null?pe:1}let z=n;function Cn(S,L){return t.getContext(S,L)}let mt,gt,fe,Ct,Re,Oe,C,_,B,ne,ee,ae,ue,Z,K,le,I,j,Y,ce,se,oe,Ae;try{let S={alpha:!0,depth:r,stencil:s,antialias:o,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:d};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",Te,!1),t.addEventListener("webglcontextrestored",Be,!1),t.addEventListener("webglcontextcreationerror",ge,!1),z===null){let L="webgl2";if(z=Cn(L,S),z===null)throw Cn(L)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}qe()}catch(S){throw t.removeEventListener("webglcontextlost",Te,!1),t.removeEventListener("webglcontextrestored",Be,!1),t.removeEventListener("webglcontextcreationerror",ge,!1),De("WebGLRenderer: "+S.message),S}function qe(){mt=new R_(z),mt.init(),se=new uM(z,mt),gt=new y_(z,mt,e,se),fe=new cM(z,mt),gt.reversedDepthBuffer&&u&&fe.buffers.depth.setReversed(!0),V=z.createFramebuffer(),P=z.createFramebuffer(),G=z.createFramebuffer(),Ct=new N_(z),Re=new JS,Oe=new hM(z,mt,fe,Re,gt,se,Ct),C=new C_(R),_=new Dy(z),oe=new g_(z,_),B=new P_(z,_,Ct,oe),ne=new D_(z,B,_,oe,Ct),j=new L_(z,gt,Oe),K=new v_(Re),ee=new YS(R,C,mt,gt,oe,K),ae=new mM(R,Re),ue=new KS,Z=new iM(mt),I=new m_(R,C,fe,ne,f,l),le=new lM(R,ne,gt),Ae=new gM(z,Ct,gt,fe),Y=new b_(z,mt,Ct),ce=new I_(z,mt,Ct),Ct.programs=ee.programs,R.capabilities=gt,R.extensions=mt,R.properties=Re,R.renderLists=ue,R.shadowMap=le,R.state=fe,R.info=Ct}b!==tn&&(D=new F_(b,t.width,t.height,o,r,s));let ie=new Kd(R,z);this.xr=ie,this.getContext=function(){return z},this.getContextAttributes=function(){return z.getContextAttributes()},this.forceContextLoss=function(){let S=mt.get("WEBGL_lose_context");S&&S.loseContext()},this.forceContextRestore=function(){let S=mt.get("WEBGL_lose_context");S&&S.restoreContext()},this.getPixelRatio=function(){return pe},this.setPixelRatio=function(S){S!==void 0&&(pe=S,this.setSize(me,Me,!1))},this.getSize=function(S){return S.set(me,Me)},this.setSize=function(S,L,$=!0){if(ie.isPresenting){Ne("WebGLRenderer: Can't change size while VR device is presenting.");return}me=S,Me=L,t.width=Math.floor(S*pe),t.height=Math.floor(L*pe),$===!0&&(t.style.width=S+"px",t.style.height=L+"px"),D!==null&&D.setSize(t.width,t.height),this.setViewport(0,0,S,L)},this.getDrawingBufferSize=function(S){return S.set(me*pe,Me*pe).floor()},this.setDrawingBufferSize=function(S,L,$){me=S,Me=L,pe=$,t.width=Math.floor(S*$),t.height=Math.floor(L*$),this.setViewport(0,0,S,L)},this.setEffects=function(S){if(b===tn){De("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(S){for(let L=0;L<S.length;L++)if(S[L].isOutputPass===!0){Ne("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}D.setEffects(S||[])},this.getCurrentViewport=function(S){return S.copy(te)},this.getViewport=function(S){return S.copy(Ce)},this.setViewport=function(S,L,$,U){S.isVector4?Ce.set(S.x,S.y,S.z,S.w):Ce.set(S,L,$,U),fe.viewport(te.copy(Ce).multiplyScalar(Tn()).round())},this.getScissor=function(S){return S.copy(et)},this.setScissor=function(S,L,$,U){S.isVector4?et.set(S.x,S.y,S.z,S.w):et.set(S,L,$,U),fe.scissor(ve.copy(et).multiplyScalar(Tn()).round())},this.getScissorTest=function(){return it},this.setScissorTest=function(S){fe.setScissorTest(it=S)},this.setOpaqueSort=function(S){Le=S},this.setTransparentSort=function(S){ft=S},this.getClearColor=function(S){return S.copy(I.getClearColor())},this.setClearColor=function(){I.setClearColor(...arguments)},this.getClearAlpha=function(){return I.getClearAlpha()},this.setClearAlpha=function(){I.setClearAlpha(...arguments)},this.clear=function(S=!0,L=!0,$=!0){let U=0;if(S){let q=!1;if(Q!==null){let de=Q.texture.format;q=m.has(de)}if(q){let de=Q.texture.type,xe=g.has(de),he=I.getClearColor(),ye=I.getClearAlpha(),we=he.r,ke=he.g,Ye=he.b;xe?(v[0]=we,v[1]=ke,v[2]=Ye,v[3]=ye,z.clearBufferuiv(z.COLOR,0,v)):(M[0]=we,M[1]=ke,M[2]=Ye,M[3]=ye,z.clearBufferiv(z.COLOR,0,M))}else U|=z.COLOR_BUFFER_BIT}L&&(U|=z.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),$&&(U|=z.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),U!==0&&z.clear(U)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(S){S.setRenderer(this),F=S},this.dispose=function(){t.removeEventListener("webglcontextlost",Te,!1),t.removeEventListener("webglcontextrestored",Be,!1),t.removeEventListener("webglcontextcreationerror",ge,!1),I.dispose(),ue.dispose(),Z.dispose(),Oe.dispose(),Re.dispose(),C.dispose(),ne.dispose(),B.dispose(),oe.dispose(),Ae.dispose(),ee.dispose(),ie.dispose(),ie.removeEventListener("sessionstart",dp),ie.removeEventListener("sessionend",pp),br.stop()};function Te(S){S.preventDefault(),Ia("WebGLRenderer: Context Lost."),N=!0}function Be(){Ia("WebGLRenderer: Context Restored."),N=!1;let S=Ct.autoReset,L=le.enabled,$=le.autoUpdate,U=le.needsUpdate,q=le.type;qe(),Ct.autoReset=S,le.enabled=L,le.autoUpdate=$,le.needsUpdate=U,le.type=q}function ge(S){De("WebGLRenderer: A WebGL context could not be created. Reason: ",S.statusMessage)}function ot(S){let L=S.target;L.removeEventListener("dispose",ot),Lt(L)}function Lt(S){ki(S),Re.remove(S)}function ki(S){let L=Re.get(S).programs;L!==void 0&&(L.forEach(function($){ee.releaseProgram($)}),S.isShaderMaterial&&ee.releaseShaderCache(S))}this.renderBufferDirect=function(S,L,$,U,q,de){L===null&&(L=An);let xe=q.isMesh&&q.matrixWorld.determinantAffine()<0,he=M1(S,L,$,U,q);fe.setMaterial(U,xe);let ye=$.index,we=1;if(U.wireframe===!0){if(ye=B.getWireframeAttribute($),ye===void 0)return;we=2}let ke=$.drawRange,Ye=$.attributes.position,_e=ke.start*we,Je=(ke.start+ke.count)*we;de!==null&&(_e=Math.max(_e,de.start*we),Je=Math.min(Je,(de.start+de.count)*we)),ye!==null?(_e=Math.max(_e,0),Je=Math.min(Je,ye.count)):Ye!=null&&(_e=Math.max(_e,0),Je=Math.min(Je,Ye.count));let _t=Je-_e;if(_t<0||_t===1/0)return;oe.setup(q,U,he,$,ye);let ut,ct=Y;if(ye!==null&&(ut=_.get(ye),ct=ce,ct.setIndex(ut)),q.isMesh)U.wireframe===!0?(fe.setLineWidth(U.wireframeLinewidth*Tn()),ct.setMode(z.LINES)):ct.setMode(z.TRIANGLES);else if(q.isLine){let Vt=U.linewidth;Vt===void 0&&(Vt=1),fe.setLineWidth(Vt*Tn()),q.isLineSegments?ct.setMode(z.LINES):q.isLineLoop?ct.setMode(z.LINE_LOOP):ct.setMode(z.LINE_STRIP)}else q.isPoints?ct.setMode(z.POINTS):q.isSprite&&ct.setMode(z.TRIANGLES);if(q.isBatchedMesh)if(mt.get("WEBGL_multi_draw"))ct.renderMultiDraw(q._multiDrawStarts,q._multiDrawCounts,q._multiDrawCount);else{let Vt=q._multiDrawStarts,Se=q._multiDrawCounts,Kt=q._multiDrawCount,rt=ye?_.get(ye).bytesPerElement:1,yr=Re.get(U).currentProgram.getUniforms();for(let Ht=0;Ht<Kt;Ht++)yr.setValue(z,"_gl_DrawID",Ht),ct.render(Vt[Ht]/rt,Se[Ht])}else if(q.isInstancedMesh)ct.renderInstances(_e,_t,q.count);else if($.isInstancedBufferGeometry){let Vt=$._maxInstanceCount!==void 0?$._maxInstanceCount:1/0,Se=Math.min($.instanceCount,Vt);ct.renderInstances(_e,_t,Se)}else ct.render(_e,_t)};function up(S,L,$,U){F!==null&&S.isNodeMaterial&&F.setObject(U,S),Tt===!0&&K.setState(S,$,!1),S.transparent===!0&&S.side===Fn&&S.forceSinglePass===!1?(S.side=en,S.needsUpdate=!0,Qs(S,L,U),S.side=dr,S.needsUpdate=!0,Qs(S,L,U),S.side=Fn):Qs(S,L,U)}this.compile=function(S,L,$=null){$===null&&($=S),F!==null&&F.renderStart(S,L,$),w=Z.get($),w.init(L),A.push(w),$.traverseVisible(function(q){q.isLight&&q.layers.test(L.layers)&&(w.pushLight(q),q.castShadow&&w.pushShadow(q))}),S!==$&&S.traverseVisible(function(q){q.isLight&&q.layers.test(L.layers)&&(w.pushLight(q),q.castShadow&&w.pushShadow(q))}),w.setupLights(),F!==null&&F.updateLights(w.state.lightsArray),nn=this.localClippingEnabled,Tt=K.init(this.clippingPlanes,nn),Tt===!0&&K.setGlobalState(this.clippingPlanes,L),F!==null&&le.render(w.state.shadowsArray,$,L);let U=new Set;return S.traverse(function(q){if(!(q.isMesh||q.isPoints||q.isLine||q.isSprite))return;let de=q.material;if(de)if(Array.isArray(de))for(let xe=0;xe<de.length;xe++){let he=de[xe];up(he,$,L,q),U.add(he)}else up(de,$,L,q),U.add(de)}),w=A.pop(),F!==null&&F.renderEnd(),U},this.compileAsync=function(S,L,$=null){let U=this.compile(S,L,$);return new Promise(q=>{function de(){if(U.forEach(function(xe){let ye=Re.get(xe).currentProgram;(ye===void 0||ye.isReady())&&U.delete(xe)}),U.size===0){q(S);return}setTimeout(de,10)}mt.get("KHR_parallel_shader_compile")!==null?de():setTimeout(de,10)})};let Ih=null;function _1(S){Ih&&Ih(S)}function dp(){br.stop()}function pp(){br.start()}let br=new Ag;br.setAnimationLoop(_1),typeof self<"u"&&br.setContext(self),this.setAnimationLoop=function(S){Ih=S,ie.setAnimationLoop(S),S===null?br.stop():br.start()},ie.addEventListener("sessionstart",dp),ie.addEventListener("sessionend",pp),this.render=function(S,L){if(L!==void 0&&L.isCamera!==!0){De("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(N===!0)return;F!==null&&F.renderStart(S,L);let $=ie.enabled===!0&&ie.isPresenting===!0,U=D!==null&&(Q===null||$)&&D.begin(R,Q);if(S.matrixWorldAutoUpdate===!0&&S.updateMatrixWorld(),L.parent===null&&L.matrixWorldAutoUpdate===!0&&L.updateMatrixWorld(),ie.enabled===!0&&ie.isPresenting===!0&&(D===null||D.isCompositing()===!1)&&(ie.cameraAutoUpdate===!0&&ie.updateCamera(L),L=ie.getCamera()),S.isScene===!0&&S.onBeforeRender(R,S,L,Q),w=Z.get(S,A.length),w.init(L),w.state.textureUnits=Oe.getTextureUnits(),A.push(w),bt.multiplyMatrices(L.projectionMatrix,L.matrixWorldInverse),L.isArrayCamera?Ot.setFromArrayCamera(L):Xe.setFromProjectionMatrix(bt,Dn,L.reversedDepth),nn=this.localClippingEnabled,Tt=K.init(this.clippingPlanes,nn),E=ue.get(S,y.length),E.init(),y.push(E),this.info.render.frame++,ie.enabled===!0&&ie.isPresenting===!0){let xe=R.xr.getDepthSensingMesh();xe!==null&&Nh(xe,L,-1/0,R.sortObjects)}Nh(S,L,0,R.sortObjects),E.finish(),F!==null&&F.updateLights(w.state.lightsArray),R.sortObjects===!0&&E.sort(Le,ft),En=ie.enabled===!1||ie.isPresenting===!1||ie.hasDepthSensing()===!1,En&&I.addToRenderList(E,S),this.info.autoReset===!0&&this.info.reset(),Tt===!0&&K.beginShadows();let q=w.state.shadowsArray;if(le.render(q,S,L),Tt===!0&&K.endShadows(),(U&&D.hasRenderPass())===!1){let xe=E.opaque,he=E.transmissive;if(w.setupLights(),L.isArrayCamera){let ye=L.cameras;if(he.length>0)for(let we=0,ke=ye.length;we<ke;we++){let Ye=ye[we];mp(xe,he,S,Ye)}En&&I.render(S);for(let we=0,ke=ye.length;we<ke;we++){let Ye=ye[we];fp(E,S,Ye,Ye.viewport)}}else he.length>0&&mp(xe,he,S,L),En&&I.render(S),fp(E,S,L)}Q!==null&&O===0&&(Oe.updateMultisampleRenderTarget(Q),Oe.updateRenderTargetMipmap(Q)),U&&D.end(R),S.isScene===!0&&S.onAfterRender(R,S,L),oe.resetDefaultState(),H=-1,J=null,A.pop(),A.length>0?(w=A[A.length-1],Oe.setTextureUnits(w.state.textureUnits),Tt===!0&&K.setGlobalState(R.clippingPlanes,w.state.camera)):w=null,y.pop(),y.length>0?E=y[y.length-1]:E=null,F!==null&&F.renderEnd()};function Nh(S,L,$,U){if(S.visible===!1)return;if(S.layers.test(L.layers)){if(S.isGroup)$=S.renderOrder;else if(S.isLOD)S.autoUpdate===!0&&S.update(L);else if(S.isLight)w.pushLight(S),S.castShadow&&w.pushShadow(S);else if(S.isSprite){let xe=L.isArrayCamera?Ot:Xe;if(!S.frustumCulled||S.intersectsFrustum(xe)){U&&Nt.setFromMatrixPosition(S.matrixWorld).applyMatrix4(bt);let he=ne.update(S),ye=S.material;ye.visible&&E.push(S,he,ye,$,Nt.z,null,L)}}else if(S.isMesh||S.isLine||S.isPoints){let xe=L.isArrayCamera?Ot:Xe;if(!S.frustumCulled||S.intersectsFrustum(xe)){let he=ne.update(S),ye=S.material;if(U&&(S.boundingSphere!==void 0?(S.boundingSphere===null&&S.computeBoundingSphere(),Nt.copy(S.boundingSphere.center)):(he.boundingSphere===null&&he.computeBoundingSphere(),Nt.copy(he.boundingSphere.center)),Nt.applyMatrix4(S.matrixWorld).applyMatrix4(bt)),Array.isArray(ye)){let we=he.groups;for(let ke=0,Ye=we.length;ke<Ye;ke++){let _e=we[ke],Je=ye[_e.materialIndex];Je&&Je.visible&&E.push(S,he,Je,$,Nt.z,_e,L)}}else ye.visible&&E.push(S,he,ye,$,Nt.z,null,L)}}}let de=S.children;for(let xe=0,he=de.length;xe<he;xe++)Nh(de[xe],L,$,U)}function fp(S,L,$,U){let{opaque:q,transmissive:de,transparent:xe}=S;w.setupLightsView($),Tt===!0&&K.setGlobalState(R.clippingPlanes,$),U&&fe.viewport(te.copy(U)),q.length>0&&mo(q,L,$),de.length>0&&mo(de,L,$),xe.length>0&&mo(xe,L,$),fe.buffers.depth.setTest(!0),fe.buffers.depth.setMask(!0),fe.buffers.color.setMask(!0),fe.setPolygonOffset(!1)}function mp(S,L,$,U){if(($.isScene===!0?$.overrideMaterial:null)!==null)return;if(w.state.transmissionRenderTarget[U.id]===void 0){let _e=mt.has("EXT_color_buffer_half_float")||mt.has("EXT_color_buffer_float");w.state.transmissionRenderTarget[U.id]=new xn(1,1,{generateMipmaps:!0,type:_e?ni:tn,minFilter:zi,samples:Math.max(4,gt.samples),stencilBuffer:s,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:Ke.workingColorSpace})}let de=w.state.transmissionRenderTarget[U.id],xe=U.viewport||te;de.setSize(xe.z*R.transmissionResolutionScale,xe.w*R.transmissionResolutionScale);let he=R.getRenderTarget(),ye=R.getActiveCubeFace(),we=R.getActiveMipmapLevel();R.setRenderTarget(de),R.getClearColor(X),re=R.getClearAlpha(),re<1&&R.setClearColor(16777215,.5),R.clear(),En&&I.render($);let ke=R.toneMapping;R.toneMapping=bi;let Ye=U.viewport;if(U.viewport!==void 0&&(U.viewport=void 0),w.setupLightsView(U),Tt===!0&&K.setGlobalState(R.clippingPlanes,U),mo(S,$,U),Oe.updateMultisampleRenderTarget(de),Oe.updateRenderTargetMipmap(de),mt.has("WEBGL_multisampled_render_to_texture")===!1){let _e=!1;for(let Je=0,_t=L.length;Je<_t;Je++){let ut=L[Je],{object:ct,geometry:Vt,material:Se,group:Kt}=ut;if(Se.side===Fn&&ct.layers.test(U.layers)){let rt=Se.side;Se.side=en,Se.needsUpdate=!0,gp(ct,$,U,Vt,Se,Kt),Se.side=rt,Se.needsUpdate=!0,_e=!0}}_e===!0&&(Oe.updateMultisampleRenderTarget(de),Oe.updateRenderTargetMipmap(de))}R.setRenderTarget(he,ye,we),R.setClearColor(X,re),Ye!==void 0&&(U.viewport=Ye),R.toneMapping=ke}function mo(S,L,$){let U=L.isScene===!0?L.overrideMaterial:null;for(let q=0,de=S.length;q<de;q++){let xe=S[q],{object:he,geometry:ye,group:we}=xe,ke=xe.material;ke.allowOverride===!0&&U!==null&&(ke=U),he.layers.test($.layers)&&gp(he,L,$,ye,ke,we)}}function gp(S,L,$,U,q,de){F!==null&&q.isNodeMaterial&&F.setObject(S,q),S.onBeforeRender(R,L,$,U,q,de),S.modelViewMatrix.multiplyMatrices($.matrixWorldInverse,S.matrixWorld),S.normalMatrix.getNormalMatrix(S.modelViewMatrix),q.onBeforeRender(R,L,$,U,S,de),q.transparent===!0&&q.side===Fn&&q.forceSinglePass===!1?(q.side=en,q.needsUpdate=!0,R.renderBufferDirect($,L,U,q,S,de),q.side=dr,q.needsUpdate=!0,R.renderBufferDirect($,L,U,q,S,de),q.side=Fn):R.renderBufferDirect($,L,U,q,S,de),S.onAfterRender(R,L,$,U,q,de)}function bp(S){let L=0;for(let $ of S)$.texture!==null&&L++;return L}function Qs(S,L,$){L.isScene!==!0&&(L=An);let U=Re.get(S),q=w.state.lights,de=w.state.shadowsArray,xe=q.state.version,he=ee.getParameters(S,q.state,de,L,$,w.state.lightProbeGridArray),ye=ee.getProgramCacheKey(he),we=U.programs;U.environment=S.isMeshStandardMaterial||S.isMeshLambertMaterial||S.isMeshPhongMaterial?L.environment:null,U.fog=L.fog;let ke=S.isMeshStandardMaterial||S.isMeshLambertMaterial&&!S.envMap||S.isMeshPhongMaterial&&!S.envMap;U.envMap=C.get(S.envMap||U.environment,ke),U.envMapRotation=U.environment!==null&&S.envMap===null?L.environmentRotation:S.envMapRotation,we===void 0&&(S.addEventListener("dispose",ot),we=new Map,U.programs=we,U.programVariants=new Map);let Ye=we.get(ye);if(Ye!==void 0){if(U.currentProgram===Ye&&U.lightsStateVersion===xe)return vp(S,he),Ye}else he.uniforms=ee.getUniforms(S),F!==null&&S.isNodeMaterial&&F.build(S,$,he),S.onBeforeCompile(he,R),Ye=ee.acquireProgram(he,ye),we.set(ye,Ye),U.uniforms=he.uniforms;let _e=U.uniforms;return(!S.isShaderMaterial&&!S.isRawShaderMaterial||S.clipping===!0)&&(_e.clippingPlanes=K.uniform),vp(S,he),U.needsLights=A1(S),U.lightsStateVersion=xe,U.needsLights&&(_e.ambientLightColor.value=q.state.ambient,_e.lightProbe.value=q.state.probe,_e.sunLights.value=q.state.sun,_e.sunLightShadows.value=q.state.sunShadow,_e.directionalLights.value=q.state.directional,_e.directionalLightShadows.value=q.state.directionalShadow,_e.spotLights.value=q.state.spot,_e.spotLightShadows.value=q.state.spotShadow,_e.rectAreaLights.value=q.state.rectArea,_e.ltc_1.value=q.state.rectAreaLTC1,_e.ltc_2.value=q.state.rectAreaLTC2,_e.pointLights.value=q.state.point,_e.pointLightShadows.value=q.state.pointShadow,_e.hemisphereLights.value=q.state.hemi,_e.sunShadowMatrix.value=q.state.sunShadowMatrix,_e.sunShadowCascade.value=q.state.sunShadowCascade,_e.directionalShadowMatrix.value=q.state.directionalShadowMatrix,_e.spotLightMatrix.value=q.state.spotLightMatrix,_e.spotLightMap.value=q.state.spotLightMap,_e.pointShadowMatrix.value=q.state.pointShadowMatrix),U.numLightProbeGrids=bp(w.state.lightProbeGridArray),U.currentProgram=Ye,U.uniformsList=null,Ye}function S1(S,L,$,U,q){let de=Re.get(S),xe=de.currentProgram.id+","+U+","+q,he=de.programVariants.get(xe);return he===void 0?(he=Qs(S,L,$),de.programVariants.set(xe,he)):(de.currentProgram=he,de.uniformsList=null,de.outputColorSpace=U,de.toneMapping=q),he}function yp(S){if(S.uniformsList===null){let L=S.currentProgram.getUniforms();S.uniformsList=Js.seqWithValue(L.seq,S.uniforms)}return S.uniformsList}function vp(S,L){let $=Re.get(S);$.outputColorSpace=L.outputColorSpace,$.batching=L.batching,$.batchingColor=L.batchingColor,$.instancing=L.instancing,$.instancingColor=L.instancingColor,$.instancingMorph=L.instancingMorph,$.skinning=L.skinning,$.morphTargets=L.morphTargets,$.morphNormals=L.morphNormals,$.morphColors=L.morphColors,$.morphTargetsCount=L.morphTargetsCount,$.numClippingPlanes=L.numClippingPlanes,$.numIntersection=L.numClipIntersection,$.vertexAlphas=L.vertexAlphas,$.vertexTangents=L.vertexTangents,$.toneMapping=L.toneMapping}function M1(S,L,$,U,q){L.isScene!==!0&&(L=An),Oe.resetTextureUnits();let de=L.fog,xe=U.isMeshStandardMaterial||U.isMeshLambertMaterial||U.isMeshPhongMaterial?L.environment:null,he=Q===null?R.outputColorSpace:Q.isXRRenderTarget===!0?Q.texture.colorSpace:Ke.workingColorSpace,ye=U.isMeshStandardMaterial||U.isMeshLambertMaterial&&!U.envMap||U.isMeshPhongMaterial&&!U.envMap,we=C.get(U.envMap||xe,ye),ke=U.vertexColors===!0&&!!$.attributes.color&&$.attributes.color.itemSize===4,Ye=!!$.attributes.tangent&&(!!U.normalMap||U.anisotropy>0),_e=!!$.morphAttributes.position,Je=!!$.morphAttributes.normal,_t=!!$.morphAttributes.color,ut=bi;U.toneMapped&&(Q===null||Q.isXRRenderTarget===!0)&&(ut=R.toneMapping);let ct=$.morphAttributes.position||$.morphAttributes.normal||$.morphAttributes.color,Vt=ct!==void 0?ct.length:0,Se=Re.get(U),Kt=w.state.lights;if(Tt===!0&&(nn===!0||S!==J)){let yt=S===J&&U.id===H;K.setState(U,S,yt)}let rt=!1,yr=!1;U.version===Se.__version?Se.needsLights&&Se.lightsStateVersion!==Kt.state.version||q.isBatchedMesh&&Se.batching===!1||!q.isBatchedMesh&&Se.batching===!0||q.isBatchedMesh&&Se.batchingColor===!0&&q._colorsTexture===null||q.isBatchedMesh&&Se.batchingColor===!1&&q._colorsTexture!==null||q.isInstancedMesh&&Se.instancing===!1||!q.isInstancedMesh&&Se.instancing===!0||q.isSkinnedMesh&&Se.skinning===!1||!q.isSkinnedMesh&&Se.skinning===!0||q.isInstancedMesh&&Se.instancingColor===!0&&q.instanceColor===null||q.isInstancedMesh&&Se.instancingColor===!1&&q.instanceColor!==null||q.isInstancedMesh&&Se.instancingMorph===!0&&q.morphTexture===null||q.isInstancedMesh&&Se.instancingMorph===!1&&q.morphTexture!==null||Se.envMap!==we||U.fog===!0&&Se.fog!==de||Se.numClippingPlanes!==void 0&&(Se.numClippingPlanes!==K.numPlanes||Se.numIntersection!==K.numIntersection)||Se.vertexAlphas!==ke||Se.vertexTangents!==Ye||Se.morphTargets!==_e||Se.morphNormals!==Je||Se.morphColors!==_t||Se.morphTargetsCount!==Vt||Se.numLightProbeGrids!==bp(w.state.lightProbeGridArray)?rt=!0:(Se.outputColorSpace!==he||Se.toneMapping!==ut)&&(yr=!0):(rt=!0,Se.__version=U.version);let Ht=Se.currentProgram;(rt===!0||yr===!0)&&(Ht=yr===!0?S1(U,L,q,he,ut):Qs(U,L,q),F&&U.isNodeMaterial&&F.onUpdateProgram(U,Ht,Se));let go=!1,Bi=!1,vr=!1,tt=Ht.getUniforms(),Ut=Se.uniforms;if(fe.useProgram(Ht.program)&&(go=!0,Bi=!0,vr=!0),U.id!==H&&(H=U.id,Bi=!0),go||J!==S){fe.buffers.depth.getReversed()&&S.reversedDepth!==!0&&(S._reversedDepth=!0,S.updateProjectionMatrix()),tt.setValue(z,"projectionMatrix",S.projectionMatrix),tt.setValue(z,"viewMatrix",S.matrixWorldInverse);let Dt=tt.map.cameraPosition;Dt!==void 0&&Dt.setValue(z,ii.setFromMatrixPosition(S.matrixWorld)),gt.logarithmicDepthBuffer&&tt.setValue(z,"logDepthBufFC",2/(Math.log(S.far+1)/Math.LN2)),(U.isMeshPhongMaterial||U.isMeshToonMaterial||U.isMeshLambertMaterial||U.isMeshBasicMaterial||U.isMeshStandardMaterial||U.isShaderMaterial)&&tt.setValue(z,"isOrthographic",S.isOrthographicCamera===!0),J!==S&&(J=S,Bi=!0,vr=!0)}if(Se.needsLights&&(Kt.state.sunShadowMap.length>0&&tt.setValue(z,"sunShadowMap",Kt.state.sunShadowMap,Oe),Kt.state.directionalShadowMap.length>0&&tt.setValue(z,"directionalShadowMap",Kt.state.directionalShadowMap,Oe),Kt.state.spotShadowMap.length>0&&tt.setValue(z,"spotShadowMap",Kt.state.spotShadowMap,Oe),Kt.state.pointShadowMap.length>0&&tt.setValue(z,"pointShadowMap",Kt.state.pointShadowMap,Oe)),q.isSkinnedMesh){tt.setOptional(z,q,"bindMatrix"),tt.setOptional(z,q,"bindMatrixInverse");let yt=q.skeleton;yt&&(yt.boneTexture===null&&yt.computeBoneTexture(),tt.setValue(z,"boneTexture",yt.boneTexture,Oe))}q.isBatchedMesh&&(tt.setOptional(z,q,"batchingTexture"),tt.setValue(z,"batchingTexture",q._matricesTexture,Oe),tt.setOptional(z,q,"batchingIdTexture"),tt.setValue(z,"batchingIdTexture",q._indirectTexture,Oe),tt.setOptional(z,q,"batchingColorTexture"),q._colorsTexture!==null&&tt.setValue(z,"batchingColorTexture",q._colorsTexture,Oe));let Un=$.morphAttributes;if((Un.position!==void 0||Un.normal!==void 0||Un.color!==void 0)&&j.update(q,$,Ht),(Bi||Se.receiveShadow!==q.receiveShadow)&&(Se.receiveShadow=q.receiveShadow,tt.setValue(z,"receiveShadow",q.receiveShadow)),(U.isMeshStandardMaterial||U.isMeshLambertMaterial||U.isMeshPhongMaterial)&&U.envMap===null&&L.environment!==null&&(Ut.envMapIntensity.value=L.environmentIntensity),Ut.dfgLUT!==void 0&&(Ut.dfgLUT.value=yM()),Bi){if(tt.setValue(z,"toneMappingExposure",R.toneMappingExposure),Se.needsLights&&w1(Ut,vr),de&&U.fog===!0&&ae.refreshFogUniforms(Ut,de),ae.refreshMaterialUniforms(Ut,U,pe,Me,w.state.transmissionRenderTarget[S.id]),Se.needsLights&&Se.numLightProbeGrids>0){let yt=x,Dt=0;for(let xi of w.state.lightProbeGridArray)xi.texture!==null&&(yt.textures[Dt]=xi.texture,yt.min[Dt]=xi.boundingBox.min,yt.max[Dt]=xi.boundingBox.max,yt.resolution[Dt]=xi.resolution,Dt++);for(let xi in yt)yt[xi].length=Dt;Ut.probesSH.value=yt.textures,Ut.probesMin.value=yt.min,Ut.probesMax.value=yt.max,Ut.probesResolution.value=yt.resolution}Js.upload(z,yp(Se),Ut,Oe)}if(U.isShaderMaterial&&U.uniformsNeedUpdate===!0&&(Js.upload(z,yp(Se),Ut,Oe),U.uniformsNeedUpdate=!1),U.isSpriteMaterial&&tt.setValue(z,"center",q.center),tt.setValue(z,"modelViewMatrix",q.modelViewMatrix),tt.setValue(z,"normalMatrix",q.normalMatrix),tt.setValue(z,"modelMatrix",q.matrixWorld),U.uniformsGroups!==void 0){let yt=U.uniformsGroups;for(let Dt=0,xi=yt.length;Dt<xi;Dt++){let _p=yt[Dt];Ae.update(_p,Ht),Ae.bind(_p,Ht)}}return Ht}function w1(S,L){S.ambientLightColor.needsUpdate=L,S.lightProbe.needsUpdate=L,S.sunLights.needsUpdate=L,S.sunLightShadows.needsUpdate=L,S.directionalLights.needsUpdate=L,S.directionalLightShadows.needsUpdate=L,S.pointLights.needsUpdate=L,S.pointLightShadows.needsUpdate=L,S.spotLights.needsUpdate=L,S.spotLightShadows.needsUpdate=L,S.rectAreaLights.needsUpdate=L,S.hemisphereLights.needsUpdate=L}function A1(S){return S.isMeshLambertMaterial||S.isMeshToonMaterial||S.isMeshPhongMaterial||S.isMeshStandardMaterial||S.isShadowMaterial||S.isShaderMaterial&&S.lights===!0}this.getActiveCubeFace=function(){return W},this.getActiveMipmapLevel=function(){return O},this.getRenderTarget=function(){return Q},this.setRenderTargetTextures=function(S,L,$){let U=Re.get(S);U.__autoAllocateDepthBuffer=S.resolveDepthBuffer===!1,U.__autoAllocateDepthBuffer===!1&&(U.__useRenderToTexture=!1),Re.get(S.texture).__webglTexture=L,Re.get(S.depthTexture).__webglTexture=U.__autoAllocateDepthBuffer?void 0:$,U.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(S,L){let $=Re.get(S);$.__webglFramebuffer=L,$.__useDefaultFramebuffer=L===void 0},this.setRenderTarget=function(S,L=0,$=0){Q=S,W=L,O=$;let U=null,q=!1,de=!1;if(S){let he=Re.get(S);if(he.__useDefaultFramebuffer!==void 0){fe.bindFramebuffer(z.FRAMEBUFFER,he.__webglFramebuffer),te.copy(S.viewport),ve.copy(S.scissor),Ee=S.scissorTest,fe.viewport(te),fe.scissor(ve),fe.setScissorTest(Ee),H=-1;return}else if(he.__webglFramebuffer===void 0)Oe.setupRenderTarget(S);else if(he.__hasExternalTextures)Oe.rebindTextures(S,Re.get(S.texture).__webglTexture,Re.get(S.depthTexture).__webglTexture);else if(S.depthBuffer){let ke=S.depthTexture;if(he.__boundDepthTexture!==ke){if(ke!==null&&Re.has(ke)&&(S.width!==ke.image.width||S.height!==ke.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Oe.setupDepthRenderbuffer(S)}}let ye=S.texture;(ye.isData3DTexture||ye.isDataArrayTexture||ye.isCompressedArrayTexture)&&(de=!0);let we=Re.get(S).__webglFramebuffer;S.isWebGLCubeRenderTarget?(Array.isArray(we[L])?U=we[L][$]:U=we[L],q=!0):S.samples>0&&Oe.useMultisampledRTT(S)===!1?U=Re.get(S).__webglMultisampledFramebuffer:Array.isArray(we)?U=we[$]:U=we,te.copy(S.viewport),ve.copy(S.scissor),Ee=S.scissorTest}else te.copy(Ce).multiplyScalar(pe).floor(),ve.copy(et).multiplyScalar(pe).floor(),Ee=it;if($!==0&&(U=V),fe.bindFramebuffer(z.FRAMEBUFFER,U)&&fe.drawBuffers(S,U),fe.viewport(te),fe.scissor(ve),fe.setScissorTest(Ee),q){let he=Re.get(S.texture);z.framebufferTexture2D(z.FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_CUBE_MAP_POSITIVE_X+L,he.__webglTexture,$)}else if(de){let he=L;for(let ye=0;ye<S.textures.length;ye++){let we=Re.get(S.textures[ye]);z.framebufferTextureLayer(z.FRAMEBUFFER,z.COLOR_ATTACHMENT0+ye,we.__webglTexture,$,he)}}else if(S!==null&&$!==0){let he=Re.get(S.texture);z.framebufferTexture2D(z.FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_2D,he.__webglTexture,$)}H=-1};function xp(S){let L=Re.get(S);return(L.__readFormat!==S.format||L.__readType!==S.type)&&(L.__readFormat=S.format,L.__readType=S.type,L.__formatReadable=gt.textureFormatReadable(S.format),L.__typeReadable=gt.textureTypeReadable(S.type)),L}this.readRenderTargetPixels=function(S,L,$,U,q,de,xe,he=0){if(!(S&&S.isWebGLRenderTarget)){De("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let ye=Re.get(S).__webglFramebuffer;if(S.isWebGLCubeRenderTarget&&xe!==void 0&&(ye=ye[xe],Array.isArray(ye)&&(ye=ye[0])),ye){fe.bindFramebuffer(z.FRAMEBUFFER,ye);try{let we=S.textures[he],ke=we.format,Ye=we.type;S.textures.length>1&&z.readBuffer(z.COLOR_ATTACHMENT0+he);let _e=xp(we);if(_e.__formatReadable===!1){De("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(_e.__typeReadable===!1){De("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}L>=0&&L<=S.width-U&&$>=0&&$<=S.height-q&&z.readPixels(L,$,U,q,se.convert(ke),se.convert(Ye),de)}finally{let we=Q!==null?Re.get(Q).__webglFramebuffer:null;fe.bindFramebuffer(z.FRAMEBUFFER,we)}}},this.readRenderTargetPixelsAsync=async function(S,L,$,U,q,de,xe,he=0){if(!(S&&S.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let ye=Re.get(S).__webglFramebuffer;if(S.isWebGLCubeRenderTarget&&xe!==void 0&&(ye=ye[xe],Array.isArray(ye)&&(ye=ye[0])),ye)if(L>=0&&L<=S.width-U&&$>=0&&$<=S.height-q){fe.bindFramebuffer(z.FRAMEBUFFER,ye);let we=S.textures[he],ke=we.format,Ye=we.type;S.textures.length>1&&z.readBuffer(z.COLOR_ATTACHMENT0+he);let _e=xp(we);if(_e.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(_e.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let Je=z.createBuffer();z.bindBuffer(z.PIXEL_PACK_BUFFER,Je),z.bufferData(z.PIXEL_PACK_BUFFER,de.byteLength,z.STREAM_READ),z.readPixels(L,$,U,q,se.convert(ke),se.convert(Ye),0),z.bindBuffer(z.PIXEL_PACK_BUFFER,null);let _t=Q!==null?Re.get(Q).__webglFramebuffer:null;fe.bindFramebuffer(z.FRAMEBUFFER,_t);let ut=z.fenceSync(z.SYNC_GPU_COMMANDS_COMPLETE,0);return z.flush(),await J0(z,ut,4),z.bindBuffer(z.PIXEL_PACK_BUFFER,Je),z.getBufferSubData(z.PIXEL_PACK_BUFFER,0,de),z.bindBuffer(z.PIXEL_PACK_BUFFER,null),z.deleteBuffer(Je),z.deleteSync(ut),de}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(S,L=null,$=0){let U=Math.pow(2,-$),q=Math.floor(S.image.width*U),de=Math.floor(S.image.height*U),xe=L!==null?L.x:0,he=L!==null?L.y:0;Oe.setTexture2D(S,0),z.copyTexSubImage2D(z.TEXTURE_2D,$,0,0,xe,he,q,de),fe.unbindTexture()},this.copyTextureToTexture=function(S,L,$=null,U=null,q=0,de=0){let xe,he,ye,we,ke,Ye,_e,Je,_t,ut=S.isCompressedTexture?S.mipmaps[de]:S.image;if($!==null)xe=$.max.x-$.min.x,he=$.max.y-$.min.y,ye=$.isBox3?$.max.z-$.min.z:1,we=$.min.x,ke=$.min.y,Ye=$.isBox3?$.min.z:0;else{let tt=Math.pow(2,-q);xe=Math.floor(ut.width*tt),he=Math.floor(ut.height*tt),S.isDataArrayTexture?ye=ut.depth:S.isData3DTexture?ye=Math.floor(ut.depth*tt):ye=1,we=0,ke=0,Ye=0}U!==null?(_e=U.x,Je=U.y,_t=U.z):(_e=0,Je=0,_t=0);let ct=se.convert(L.format),Vt=se.convert(L.type),Se;L.isData3DTexture?(Oe.setTexture3D(L,0),Se=z.TEXTURE_3D):L.isDataArrayTexture||L.isCompressedArrayTexture?(Oe.setTexture2DArray(L,0),Se=z.TEXTURE_2D_ARRAY):(Oe.setTexture2D(L,0),Se=z.TEXTURE_2D),fe.activeTexture(z.TEXTURE0),fe.pixelStorei(z.UNPACK_FLIP_Y_WEBGL,L.flipY),fe.pixelStorei(z.UNPACK_PREMULTIPLY_ALPHA_WEBGL,L.premultiplyAlpha),fe.pixelStorei(z.UNPACK_ALIGNMENT,L.unpackAlignment);let Kt=fe.getParameter(z.UNPACK_ROW_LENGTH),rt=fe.getParameter(z.UNPACK_IMAGE_HEIGHT),yr=fe.getParameter(z.UNPACK_SKIP_PIXELS),Ht=fe.getParameter(z.UNPACK_SKIP_ROWS),go=fe.getParameter(z.UNPACK_SKIP_IMAGES);fe.pixelStorei(z.UNPACK_ROW_LENGTH,ut.width),fe.pixelStorei(z.UNPACK_IMAGE_HEIGHT,ut.height),fe.pixelStorei(z.UNPACK_SKIP_PIXELS,we),fe.pixelStorei(z.UNPACK_SKIP_ROWS,ke),fe.pixelStorei(z.UNPACK_SKIP_IMAGES,Ye);let Bi=S.isDataArrayTexture||S.isData3DTexture,vr=L.isDataArrayTexture||L.isData3DTexture;if(S.isDepthTexture){let tt=Re.get(S),Ut=Re.get(L),Un=Re.get(tt.__renderTarget),yt=Re.get(Ut.__renderTarget);fe.bindFramebuffer(z.READ_FRAMEBUFFER,Un.__webglFramebuffer),fe.bindFramebuffer(z.DRAW_FRAMEBUFFER,yt.__webglFramebuffer);for(let Dt=0;Dt<ye;Dt++)Bi&&(z.framebufferTextureLayer(z.READ_FRAMEBUFFER,z.COLOR_ATTACHMENT0,Re.get(S).__webglTexture,q,Ye+Dt),z.framebufferTextureLayer(z.DRAW_FRAMEBUFFER,z.COLOR_ATTACHMENT0,Re.get(L).__webglTexture,de,_t+Dt)),z.blitFramebuffer(we,ke,we+xe,ke+he,_e,Je,_e+xe,Je+he,z.DEPTH_BUFFER_BIT,z.NEAREST);fe.bindFramebuffer(z.READ_FRAMEBUFFER,null),fe.bindFramebuffer(z.DRAW_FRAMEBUFFER,null)}else if(q!==0||S.isRenderTargetTexture||Re.has(S)){let tt=Re.get(S),Ut=Re.get(L);fe.bindFramebuffer(z.READ_FRAMEBUFFER,P),fe.bindFramebuffer(z.DRAW_FRAMEBUFFER,G);for(let Un=0;Un<ye;Un++)Bi?z.framebufferTextureLayer(z.READ_FRAMEBUFFER,z.COLOR_ATTACHMENT0,tt.__webglTexture,q,Ye+Un):z.framebufferTexture2D(z.READ_FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_2D,tt.__webglTexture,q),vr?z.framebufferTextureLayer(z.DRAW_FRAMEBUFFER,z.COLOR_ATTACHMENT0,Ut.__webglTexture,de,_t+Un):z.framebufferTexture2D(z.DRAW_FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_2D,Ut.__webglTexture,de),q!==0?z.blitFramebuffer(we,ke,we+xe,ke+he,_e,Je,_e+xe,Je+he,z.COLOR_BUFFER_BIT,z.NEAREST):vr?z.copyTexSubImage3D(Se,de,_e,Je,_t+Un,we,ke,xe,he):z.copyTexSubImage2D(Se,de,_e,Je,we,ke,xe,he);fe.bindFramebuffer(z.READ_FRAMEBUFFER,null),fe.bindFramebuffer(z.DRAW_FRAMEBUFFER,null)}else vr?S.isDataTexture||S.isData3DTexture?z.texSubImage3D(Se,de,_e,Je,_t,xe,he,ye,ct,Vt,ut.data):L.isCompressedArrayTexture?z.compressedTexSubImage3D(Se,de,_e,Je,_t,xe,he,ye,ct,ut.data):z.texSubImage3D(Se,de,_e,Je,_t,xe,he,ye,ct,Vt,ut):S.isDataTexture?z.texSubImage2D(z.TEXTURE_2D,de,_e,Je,xe,he,ct,Vt,ut.data):S.isCompressedTexture?z.compressedTexSubImage2D(z.TEXTURE_2D,de,_e,Je,ut.width,ut.height,ct,ut.data):z.texSubImage2D(z.TEXTURE_2D,de,_e,Je,xe,he,ct,Vt,ut);fe.pixelStorei(z.UNPACK_ROW_LENGTH,Kt),fe.pixelStorei(z.UNPACK_IMAGE_HEIGHT,rt),fe.pixelStorei(z.UNPACK_SKIP_PIXELS,yr),fe.pixelStorei(z.UNPACK_SKIP_ROWS,Ht),fe.pixelStorei(z.UNPACK_SKIP_IMAGES,go),de===0&&L.generateMipmaps===!0&&L.mipmapsAutoUpdate===!0&&z.generateMipmap(Se),fe.unbindTexture()},this.initRenderTarget=function(S){Re.get(S).__webglFramebuffer===void 0&&Oe.setupRenderTarget(S)},this.initTexture=function(S){S.isCubeTexture?Oe.setTextureCube(S,0):S.isData3DTexture?Oe.setTexture3D(S,0):S.isDataArrayTexture||S.isCompressedArrayTexture?Oe.setTexture2DArray(S,0):Oe.setTexture2D(S,0),fe.unbindTexture()},this.resetState=function(){W=0,O=0,Q=null,fe.reset(),oe.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Dn}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=Ke._getDrawingBufferColorSpace(e),t.unpackColorSpace=Ke._getUnpackColorSpace()}};function th(i,e,t,n){let r=new Float64Array(12);for(let s=0;s<e-1;s++)for(let a=0;a<e-1;a++){let o=s*e+a,l=[o,o+e,o+e+1,o+1],c=i(l[0]),h=i(l[1]),d=i(l[2]),u=i(l[3]);if(!(Math.min(c,h,d,u)<0&&Math.max(c,h,d,u)>0))continue;let p=0;p=eh(t,l[0],l[1],c,h,r,p),p=eh(t,l[1],l[2],h,d,r,p),p=eh(t,l[2],l[3],d,u,r,p),p=eh(t,l[3],l[0],u,c,r,p);for(let f=0;f+1<p;f+=2)n.segment(r[3*f],r[3*f+1],r[3*f+2],r[3*f+3],r[3*f+4],r[3*f+5])}}function eh(i,e,t,n,r,s,a){if(n<0==r<0||a>3)return a;let o=n/(n-r);for(let l=0;l<3;l++)s[3*a+l]=i[3*e+l]+o*(i[3*t+l]-i[3*e+l]);return a+1}var vM=`
in vec3 start;
in vec3 end;
uniform vec2 viewport;
uniform float width;
uniform float lift;
out float across;
void main() {
  vec4 a = projectionMatrix * modelViewMatrix * vec4(start, 1.0);
  vec4 b = projectionMatrix * modelViewMatrix * vec4(end, 1.0);
  vec2 p = a.xy / a.w * viewport, q = b.xy / b.w * viewport;
  vec2 along = q - p;
  float size = length(along);
  along = size > 1e-6 ? along / size : vec2(1.0, 0.0);
  vec2 side = vec2(-along.y, along.x);
  vec4 here = position.x < 0.5 ? a : b;
  float half_ = 0.5 * width + 0.75;
  vec2 shift = side * position.y * half_ + along * (position.x - 0.5) * width;
  across = position.y * half_;
  here.xy += shift / viewport * here.w;
  here.z -= lift * here.w;
  gl_Position = here;
}`,xM=`
precision highp float;
in float across;
uniform vec4 colour;
uniform float width;
uniform float veil;
layout(location = 0) out vec4 pixel;
void main() {
  float edge = 1.0 - smoothstep(0.5 * width - 0.25, 0.5 * width + 0.75, abs(across));
  pixel = vec4(colour.rgb, colour.a * veil * edge);
}`,nh=class{constructor(e,t,n=1,r=!1,s=0){this.width=t;let a=new Ge().setStyle(e,"srgb-linear");this.material=new Jt({glslVersion:Ui,vertexShader:vM,fragmentShader:xM,transparent:!0,depthWrite:!1,depthTest:!r,uniforms:{viewport:{value:new $e(1,1)},width:{value:t},colour:{value:new ht(a.r,a.g,a.b,n)},lift:{value:r?0:4e-4},veil:{value:1}}}),this.geometry=this.allocate(),this.mesh=new Yt(this.geometry,this.material),this.mesh.frustumCulled=!1,this.mesh.renderOrder=r?3:2,this.behind=s?Fg(this.mesh,this.material,s):null}width;mesh;material;behind;data=new Float32Array(6*256);count=0;geometry;set colour(e){let t=new Ge().setStyle(e,"srgb-linear"),n=this.material.uniforms.colour.value;n.set(t.r,t.g,t.b,n.w)}resize(e,t,n,r){this.material.uniforms.viewport.value.set(.5*e,.5*t),this.material.uniforms.width.value=r*n}get drawn(){let{x:e,y:t,z:n,w:r}=this.material.uniforms.colour.value;return{ends:this.data.subarray(0,6*this.count),colour:`rgb(${[e,t,n].map(s=>Math.round(255*s)).join(" ")})`,width:this.width,opacity:r}}begin(){this.count=0}segment(e,t,n,r,s,a){let o=6*this.count;if(e-e+t-t+n-n+r-r+s-s+a-a!==0)return;if(o+6>this.data.length){let c=new Float32Array(2*this.data.length);c.set(this.data),this.data=c,this.geometry.dispose(),this.geometry=this.allocate(),this.mesh.geometry=this.geometry,this.behind&&(this.behind.geometry=this.geometry)}let l=this.data;l[o]=e,l[o+1]=t,l[o+2]=n,l[o+3]=r,l[o+4]=s,l[o+5]=a,this.count++}join(e,t){this.segment(e[0],e[1],e[2],t[0],t[1],t[2])}end(){this.geometry.instanceCount=this.count,this.mesh.visible=this.count>0;let e=this.geometry.getAttribute("start");e.data.needsUpdate=!0}dispose(){this.geometry.dispose(),this.material.dispose()}allocate(){let e=new Wa,t=new Float32Array([0,-1,0,1,-1,0,1,1,0,0,-1,0,1,1,0,0,1,0]);e.setAttribute("position",new At(t,3));let n=new $a(this.data,6,1);return n.setUsage(Ys),e.setAttribute("start",new ks(n,3,0)),e.setAttribute("end",new ks(n,3,3)),e}};function Fg(i,{uniforms:e,vertexShader:t,fragmentShader:n},r){let s=new Jt({glslVersion:Ui,vertexShader:t,fragmentShader:n,transparent:!0,depthWrite:!1,depthFunc:zs,uniforms:{...e,veil:{value:r}}}),a=i instanceof Yt?new Yt(i.geometry,s):new Bs(i.geometry,s);return a.frustumCulled=!1,a.renderOrder=i.renderOrder,i.add(a),a}var _M=`
in vec4 tint;
uniform float size;
uniform float lift;
out vec4 shade_;
void main() {
  shade_ = tint;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  gl_Position.z -= lift * gl_Position.w;
  gl_PointSize = size * (tint.a > 1.5 ? 1.45 : 1.0);
}`,SM=`
precision highp float;
in vec4 shade_;
uniform float size;
uniform vec3 rim;
uniform float veil;
layout(location = 0) out vec4 pixel;
void main() {
  float big = shade_.a > 1.5 ? size * 1.45 : size;
  float r = length(gl_PointCoord - 0.5) * big;
  float edge = 0.5 * big - 0.5;
  float inside = 1.0 - smoothstep(edge - 1.0, edge, r);
  if (inside < 0.02) discard;
  float hollow = shade_.a < 0.75 ? 1.0 : 0.0;
  float core = 1.0 - smoothstep(edge - 0.22 * big - 0.5, edge - 0.22 * big + 0.5, r);
  vec3 colour = mix(rim, mix(shade_.rgb, rim, hollow), core);
  colour = mix(colour, shade_.rgb, hollow * (1.0 - core));
  pixel = vec4(colour, veil * inside * (hollow > 0.5 ? 0.75 : 1.0));
}`,ao=class{mesh;material;geometry=new cn;constructor(e=!1){this.material=new Jt({glslVersion:Ui,vertexShader:_M,fragmentShader:SM,transparent:!0,depthTest:!e,depthWrite:!1,uniforms:{size:{value:10},lift:{value:.002},veil:{value:1},rim:{value:new Ge(1,1,1)}}}),this.mesh=new Bs(this.geometry,this.material),this.mesh.frustumCulled=!1,this.mesh.renderOrder=e?5:4,e||Fg(this.mesh,this.material,.3)}resize(e){this.material.uniforms.size.value=11*e}get drawn(){let e=t=>this.geometry.getAttribute(t)?.array??[];return{places:e("position"),tints:e("tint")}}fill(e,t){this.geometry.setAttribute("position",new At(Float32Array.from(e.flat()),3)),this.geometry.setAttribute("tint",new At(Float32Array.from(t.flat()),4)),this.mesh.visible=e.length>0}dispose(){this.geometry.dispose(),this.material.dispose()}};var ih=Math.PI/180,Og=.34,oo={x:[0,0],y:[90,0],z:[0,90]};function Ks({sectionAzimuth:i,sectionTilt:e}){let[t,n]=jd(e),[r,s]=jd(i);return[t*r,t*s,n]}function Kr(i,e){return[...Ks(i),i.sectionAt*e.scale]}function jr(i,e){let[t,n,r,s]=Kr(i,e),a=o=>[t*o,n*o,r*o];return{move:a(s),tilt:a(s+Og)}}function Ug(i,e,t,n){let[r,s,a]=e;if(i==="move"){let[h,d,u]=Ks(t);return{sectionAt:Number(((h*r+d*s+u*a)/n.scale).toPrecision(6))}}let o=t.sectionAt*n.scale+Og<0?-1:1,l=Math.hypot(r,s);return{sectionAzimuth:l>.02?Math.round(Math.atan2(o*s,o*r)/ih):t.sectionAzimuth,sectionTilt:Math.round(Math.atan2(o*a,l)/ih)}}function kg(i,e){let[t,n,r,s]=Kr(i,e),a=e.half.map(g=>1.06*g+.04),o=g=>t*g[0]+n*g[1]+r*g[2]-s,l=Array.from({length:8},(g,v)=>a.map((M,x)=>v>>x&1?M:-M)),c=l.flatMap((g,v)=>[1,2,4].filter(M=>!(v&M)).flatMap(M=>{let x=l[v|M],E=o(g),w=o(x);return E<0==w<0?[]:[g.map((y,A)=>y+E/(E-w)*(x[A]-y))]})),h=[0,1,2].map(g=>c.reduce((v,M)=>v+M[g],0)/c.length),[d,u]=jd(i.sectionAzimuth),p=[-u,d,0],f=[-r*d,-r*u,t*d+n*u],b=(g,v)=>g.reduce((M,x,E)=>M+(x-h[E])*v[E],0),m=g=>Math.atan2(b(g,f),b(g,p));return c.sort((g,v)=>m(g)-m(v))}function jd(i){return i%90?[Math.cos(i*ih),Math.sin(i*ih)]:[[1,0],[0,1],[-1,0],[0,-1]][(i/90%4+4)%4]}var fr={curve:{width:2.75,light:"#101418",dark:"#ffffff",opacity:1},net:{width:1.25,light:"#44566c",dark:"#c3d0e0",opacity:.75,hidden:.35},first:{width:1.75,light:"#101418",dark:"#ffffff",opacity:.95},second:{width:1.25,light:"#7a4b00",dark:"#ffd28a",opacity:.95},normals:{width:1.5,light:"#00785a",dark:"#58dcae",opacity:.95},teethU:{width:1,light:"#0060a8",dark:"#7cc4ff",opacity:.55},teethV:{width:1,light:"#b04500",dark:"#ffae70",opacity:.55},combU:{width:1.75,light:"#0060a8",dark:"#7cc4ff",opacity:1},combV:{width:1.75,light:"#b04500",dark:"#ffae70",opacity:1},zeroK:{width:2.75,light:"#101418",dark:"#ffffff",opacity:1},zeroH:{width:2.75,light:"#a3008f",dark:"#ff9cf2",opacity:1},edge:{width:2.5,light:"#c4007a",dark:"#ff7ac8",opacity:1},plane:{width:1.25,light:"#c2102e",dark:"#ff6b81",opacity:.55},arm:{width:1.75,light:"#c2102e",dark:"#ff6b81",opacity:.8,onTop:!0},section:{width:3,light:"#c2102e",dark:"#ff6b81",opacity:1}},Qr=Object.keys(fr),Qd=Qr.filter(i=>i!=="net"&&i!=="edge"&&i!=="curve"),tp=(i,e)=>fr[i][e?"dark":"light"],Bg=[.76,.06,.18,1],qg=ms.relative,rh=class{group=new Ii;points=new ao;grips=new ao(!0);curvePoints=[];netPoints=[];lines=Object.fromEntries(Qr.map(e=>[e,new nh(fr[e].light,fr[e].width,fr[e].opacity,fr[e].onTop,fr[e].hidden)]));constructor(){for(let e of Qr)this.group.add(this.lines[e].mesh);this.group.add(this.points.mesh,this.grips.mesh),this.grips.fill([],[]),this.lines.curve.end()}get drawn(){return{lines:Qr.map(e=>this.lines[e].drawn),points:[this.points.drawn,this.grips.drawn]}}resize(e,t,n){for(let r of Qr)this.lines[r].resize(e,t,n,fr[r].width);this.points.resize(n),this.grips.resize(n)}theme(e){for(let t of Qr)this.lines[t].colour=tp(t,e)}update(e,t,n,r){let s=e.side;for(let a of Qd)this.lines[a].begin();if(s>1){t.directions&&this.directions(e),t.normals&&this.normals(e),(t.combs==="u"||t.combs==="both")&&this.combs(e,!0,r),(t.combs==="v"||t.combs==="both")&&this.combs(e,!1,r);let{planes:a,stride:o}=e.grid,l=(c,h)=>d=>{if(!e.covered[d])return NaN;let u=a[c*o+d],p=a[ze.curvedness*o+d];return Math.abs(u)<=qg*p**h?0:u};if(t.zeroK&&th(l(ze.gaussian,2),s,e.position,this.lines.zeroK),t.zeroH&&th(l(ze.mean,1),s,e.position,this.lines.zeroH),t.section){let[c,h,d,u]=Kr(t,n),p=e.position;th(f=>e.covered[f]?c*p[3*f]+h*p[3*f+1]+d*p[3*f+2]-u:NaN,s,p,this.lines.section),this.showPlane(t,n)}else this.grips.fill([],[])}for(let a of Qd)this.lines[a].end()}curve(e,t,n){let{curve:r,teethU:s,combU:a}=this.lines,o=[...Qd,"curve"];for(let h of o)this.lines[h].begin();this.grips.fill([],[]);let l=e.map(({point:h})=>qt(t,h)),c=n?e.map(({bend:h},d)=>l[d].map((u,p)=>u-n*h[p])):[];for(let h=0;h+1<l.length;h++)r.join(l[h],l[h+1]),n&&a.join(c[h],c[h+1]);for(let h=0;h<c.length;h+=MM)s.join(l[h],c[h]);for(let h of o)this.lines[h].end();this.curvePoints=[...l,...c.filter(h=>h.every(Number.isFinite))]}showPlane(e,t){let n=kg(e,t),{move:r,tilt:s}=jr(e,t);n.forEach((a,o)=>this.lines.plane.join(a,n[(o+1)%n.length])),this.lines.arm.join(r,s),this.grips.fill([r,s],[Bg,[...Bg.slice(0,3),.5]])}net(e,t,n,r){let{net:s}=this.lines;s.begin(),this.netPoints=[];for(let o of e){let l=o.map(c=>qt(r,c));this.netPoints.push(...l);for(let c=0;c+1<l.length;c++)s.join(l[c],l[c+1])}s.end();let a=o=>o.id===n?[.93,.42,.05,2]:o.mirrored?[.25,.38,.55,.5]:[...o.tint,1];this.points.fill(t.map(o=>qt(r,o.position)),t.map(a))}edge(e,t){let{edge:n}=this.lines;n.begin();for(let r of e){let s=r.map(a=>qt(t,a));for(let a=0;a+1<s.length;a++)n.join(s[a],s[a+1])}n.end()}dispose(){for(let e of Qr)this.lines[e].dispose();this.points.dispose(),this.grips.dispose()}directions(e){let{planes:t,stride:n,size:r}=e.grid;Vg(e,(s,a)=>{let o=t[ze.halfDifference*n+s];if(!(o>qg*t[ze.curvedness*n+s]&&t[ze.curvedness*n+s]*r>1e-9))return;qo(t[s],t[n+s],t[2*n+s],o);let l=e.position.subarray(3*s,3*s+3),c=.36*a,h=[0,0,0],d=[0,0,0];for(let p=0;p<3;p++){let f=t[(ze.e1+p)*n+s],b=t[(ze.e2+p)*n+s];h[p]=c*(Lr*f+Dr*b),d[p]=c*(Lr*b-Dr*f)}let u=(p,f)=>p.segment(l[0]-f[0],l[1]-f[1],l[2]-f[2],l[0]+f[0],l[1]+f[1],l[2]+f[2]);u(this.lines.first,h),u(this.lines.second,d)})}normals(e){let{planes:t,stride:n}=e.grid;Vg(e,(r,s)=>{let a=e.position.subarray(3*r,3*r+3),o=.9*s,l=c=>o*t[(ze.normal+c)*n+r];this.lines.normals.segment(a[0],a[1],a[2],a[0]+l(0),a[1]+l(1),a[2]+l(2))})}combs(e,t,n){let{planes:r,stride:s,nu:a}=e.grid,o=t?this.lines.teethU:this.lines.teethV,l=t?this.lines.combU:this.lines.combV,c=ep,h=Math.max(1,Math.round((a-1)/60)),d=(u,p)=>{let f=Math.round(u*(a-1)/(c-1));return t?p*a+f:f*a+p};for(let u=0;u<c;u++){let p=null;for(let f=0;f<a;f+=h){let b=d(u,Math.min(f,a-1)),m=e.position.subarray(3*b,3*b+3),g=-n*Hg(e,t,b),v=[0,1,2].map(M=>m[M]+g*r[(ze.normal+M)*s+b]);if(!e.covered[b]||v.some(Number.isNaN)){p=null;continue}o.segment(m[0],m[1],m[2],v[0],v[1],v[2]),p&&l.join(p,v),p=v}}}},ep=7,MM=3;function Hg(i,e,t){let{planes:n,stride:r}=i.grid,s=ze.forms+(e?0:2);return n[(s+3)*r+t]/n[s*r+t]}function Gg(i,e,t){let n=0,r=0;for(let s of i){let a=s.grid.nu;r=Math.max(r,s.grid.size);for(let o=0;o<ep;o++){let l=Math.round(o*(a-1)/(ep-1));for(let c=0;c<a;c+=3){let h=(d,u)=>s.covered[u]&&Math.abs(Hg(s,d,u))||0;e.combs!=="v"&&(n=Math.max(n,h(!0,c*a+l))),e.combs!=="u"&&(n=Math.max(n,h(!1,l*a+c)))}}}return n*r>1e-9?.22*e.combScale*r*t.scale/n:0}function Wg(i,e,t){let n=Math.max(0,...i.flat().map(({curvature:s})=>Math.abs(s)||0).filter(Number.isFinite)),r=2*Math.hypot(...t.half)/t.scale;return n*r>1e-9?.15*e*r*t.scale/n:0}function Vg(i,e){let t=i.side,n=Math.min(t,17),r=i.position,s=u=>[r[3*u],r[3*u+1],r[3*u+2]],[a,o,l,c]=[s(0),s(t*(t-1)),s(t-1),s(t*t-1)],h=(u,p)=>Math.hypot(u[0]-p[0],u[1]-p[1],u[2]-p[2]),d=Math.min(.1,Math.max(.035,(h(a,o)+h(a,l)+h(l,c)+h(o,c))/(4*(n-1))));for(let u=0;u<n;u++)for(let p=0;p<n;p++){let f=Math.round(u*(t-1)/(n-1))*t+Math.round(p*(t-1)/(n-1));i.covered[f]&&e(f,d)}}var sh=class{constructor(e){this.store=e;this.surfaces=[ui("Colour",!0,...this.colour()),ui("Light lines",!0,...this.stripes()),ui("Section",!1,...this.cut())];let[t,n,r]=this.surfaces;this.element.append(ui("Shape",!0,this.shape),t,ui("Show",!0,...this.overlays()),n,r),e.subscribe((s,a)=>{(s.model!==a.model||s.patch!==a.patch)&&this.showShape(s)})}store;element=T("aside",{class:"panel right","aria-label":"Shape and analysis"});shape=T("div",{class:"shape"});fixed=T("p",{class:"hint",hidden:!0},"Four sets are shown side by side; choose “One” to set the shape.");bindings=[];surfaces;controls=[];curves=!1;some=!1;shapeFor="";fields=[];refresh(e,t){let{patches:n}=e.model;this.curves=n.every(nt),this.some=n.some(nt);for(let r of this.surfaces)r.hidden=this.curves;for(let r of this.bindings)r(e.settings,t);this.showShape(e)}showShape(e){let t=Ve(e),n=wi(t),r=n.length?pn(t):[],s=t.unchecked_shape===!0,a=Object.entries(st[t.kind].fields).filter(([,h])=>h.type==="number"||h.type==="positive").map(([h])=>h),o=JSON.stringify([t.kind,t.basis,n,s]);o!==this.shapeFor&&(this.shapeFor=o,this.build(t,n,a,s)),r.forEach((h,d)=>this.controls[d]?.update(h));for(let{key:h,control:d}of this.fields)d.update(Pe(t,h));let l=e.compare==="sets"&&vs(t).length>0;this.fixed.hidden=!l;for(let{element:h}of this.controls)for(let d of h.querySelectorAll("input"))d.disabled=l;for(let h of this.shape.querySelectorAll(".chip"))h.disabled=l;let c=JSON.stringify(r);for(let h of this.shape.querySelectorAll(".chip"))h.setAttribute("aria-pressed",String(h.dataset.shape===c))}build(e,t,n,r){let{store:s}=this,a=(u,p)=>{let f=Ve(s.state);s.editPatch({...f,shape:pn(f).map((b,m)=>m===u?p:b)},`shape ${u}`)};this.controls=t.map((u,p)=>{let{low:f,high:b,open:m,label:g}=u,v=10**Math.floor(Math.log10((b-f)/200));return Jn({label:km(g),name:Cu(g).filter(Boolean).join(" "),step:v,marks:AM(f,b),hard:!r,min:f+v*Number(m[0]),max:m[1]?f+v*Math.ceil((b-f)/v-1-1e-9):b,allowed:{holds:M=>as(u,M),words:`a number in ${os(u)}`},onInput:M=>a(p,M),onSettle:()=>s.settle()})});let o=wM(e),l=new Set(t.map(u=>u.of)).size>1||!Rr(e),c=[];this.controls.forEach((u,p)=>{let{of:f}=t[p];l&&o[f]&&f!==t[p-1]?.of&&c.push(T("div",{class:"subtitle"},o[f])),c.push(u.element)}),this.fields=n.map(u=>{let p=(b,m)=>s.editPatch({...Ve(s.state),[u]:b},m);if(u==="scale"){let b=Jn({label:Ai("\\lambda"),name:"lambda",min:.1,max:4,step:.01,marks:[1,1.5,3],onInput:m=>p(m,"scale"),onSettle:()=>s.settle()});return{key:u,control:b}}let f=st[e.kind].fields[u].type==="positive";return{key:u,control:hi({label:Rt(u),name:Rt(u),positive:f,step:.1,onChange:b=>p(b,null)})}}),this.fields.length&&c.push(T("div",{class:"subtitle"},e.kind==="swung"?"scale of the trajectory":"dimensions"),...this.fields.map(u=>u.control.element));let h=vs(e);h.length&&c.push(T("div",{class:"subtitle"},"sets of the thesis"),T("div",{class:"chips"},...[...h,h[0].map(()=>0)].map(u=>{let p=Qe(`(${u.join(", ").replaceAll("-","−")})`,`Set the shape parameters to ${u.join(", ")}`,()=>s.editPatch({...Ve(s.state),shape:u}),"chip");return p.dataset.shape=JSON.stringify(u),p})));let d=nt(e)?"curve":"surface";c.length||c.push(T("p",{class:"hint"},$i(e)?"On the Bernstein basis no shape parameters act: drag the control points.":`This ${d} has no shape parameters: drag its control points.`)),this.shape.replaceChildren(this.fixed,...c)}colour(){let{store:e}=this,t=(u,p)=>({label:u,options:ci.filter(f=>f.colour!=="vector"&&p(f)).map(f=>({value:f.key,label:`${Rt(f.name)}${f.colour==="classes"?"":`  ${f.symbol}`}`}))}),n=u=>"EFGLMN".includes(u.key),r=u=>/^(beta|gamma)\d/.test(u.key),s=Or("Colour by",[{label:"",options:[{value:"none",label:"No colour"}]},t("Curvature",u=>u.colour!=="classes"&&!n(u)&&!r(u)),t("Types",u=>u.colour==="classes"),t("Invariants, plane metric",u=>r(u)&&!u.key.endsWith("_surface")),t("Invariants, surface metric",u=>u.key.endsWith("_surface")),t("Fundamental forms",n)],u=>e.setting({quantity:u,range:e.state.settings.range==="fixed"?"robust":e.state.settings.range})),a=gn("Range of colours",[{value:"robust",label:"Percentiles",title:"Leave out a few extreme values at either end"},{value:"full",label:"All",title:"From the least to the greatest value"},{value:"fixed",label:"Fixed",title:"Ends given by hand"}],u=>e.setting({range:u})),o=Jn({label:"cut",name:"Percentile cut at either end",min:0,max:20,step:.5,marks:[2,5,10],hard:!0,onInput:u=>e.setting({percentile:u})}),l=hi({label:"from",name:"Lowest colour",onChange:u=>e.setting({low:u})}),c=hi({label:"to",name:"Highest colour",onChange:u=>e.setting({high:u})}),h=T("div",{class:"pair"},l.element,c.element),d=ln("Contour lines",u=>e.setting({contours:u}),void 0,"Ten steps from end to end");return this.bindings.push(u=>{let p=ci.find(b=>b.key===u.quantity),f=p!==void 0&&p.colour!=="classes";s.update(u.quantity),a.update(u.range),o.update(u.percentile),l.update(u.low),c.update(u.high),d.update(u.contours),a.element.hidden=d.element.hidden=!f,o.element.hidden=!f||u.range!=="robust",h.hidden=!f||u.range!=="fixed"}),[s.element,a.element,o.element,h,d.element]}overlays(){let{store:e}=this,t=(...l)=>{let c=T("span",{class:"keys"},...l.map(()=>T("span",{class:"key"})));return this.bindings.push((h,d)=>l.forEach((u,p)=>c.children[p].style.background=tp(u,d))),c},n=(l,c,h,d="")=>{let u=ln(c,p=>e.setting({[l]:p}),h,d);return this.bindings.push(p=>{u.update(p[l]),u.element.hidden=l==="comb"?!this.some:l!=="net"&&this.curves}),u.element},r=(l,...c)=>T("span",{},Ai(l),...c),s=gn("Combs along iso-curves",[{value:"off",label:"Off"},{value:"u",label:T("i",{},"u")},{value:"v",label:T("i",{},"v")},{value:"both",label:"Both"}],l=>e.setting({combs:l})),a=Jn({label:"size",name:"Size of the combs",min:.1,max:3,step:.1,marks:[1],onInput:l=>e.setting({combScale:l})});this.bindings.push(l=>{s.update(l.combs),a.update(l.combScale),s.element.parentElement.hidden=this.curves,a.element.hidden=!(this.some&&l.comb)&&(this.curves||l.combs==="off")});let o=T("span",{});return this.bindings.push(()=>o.textContent=this.curves?"Polygon":"Control net"),[T("div",{class:"switches"},n("net",o,t("net")),n("comb","Comb",t("combU"),"Curvature comb: teeth as long as the curvature, on the outer side of the bend"),n("curves","Iso-curves"),n("directions","Directions",t("first","second"),"Principal directions. Strong: of κ1; light: of κ2"),n("normals","Normals",t("normals")),n("zeroK",r("K"," = 0"),t("zeroK"),"Parabolic lines"),n("zeroH",r("H"," = 0"),t("zeroH")),n("minRadius","Smallest radius"),n("wireframe","Wireframe")),T("div",{class:"row"},T("span",{class:"caption"},"Combs"),s.element),a.element]}stripes(){let{store:e}=this,t=gn("Light lines",[{value:"none",label:"Off"},{value:"zebra",label:"Zebra",title:"Stripes of a striped room, reflected"},{value:"isophotes",label:"Isophotes",title:"Lines of equal angle between normal and light"},{value:"reflection",label:"Reflect",title:"Reflections of parallel tube lights"},{value:"highlight",label:"Highlight",title:"Highlight lines: where the normal meets a tube light; the same from everywhere"}],c=>e.setting({stripes:c})),n=Jn({label:"lines",name:"Number of lines",min:4,max:80,step:1,onInput:c=>e.setting({density:c}),onSettle:()=>e.settle()}),r=Jn({label:"turn",name:"Azimuth of the light in degrees",min:-180,max:180,step:1,marks:[-90,0,90],onInput:c=>e.setting({lightAzimuth:c})}),s=Jn({label:"height",name:"Height of the light in degrees",min:-90,max:90,step:1,marks:[0,45],onInput:c=>e.setting({lightElevation:c})}),a=T("div",{class:"light-ball",title:"Drag the light"},T("span",{})),o=c=>{let h=a.getBoundingClientRect(),d=(c.clientX-h.left)/h.width*2-1,u=1-(c.clientY-h.top)/h.height*2,p=Math.min(1,Math.hypot(d,u));e.setting({lightAzimuth:Math.round(Math.atan2(u,d)*180/Math.PI),lightElevation:Math.round(Math.acos(p)*180/Math.PI)})};a.addEventListener("pointerdown",c=>{a.setPointerCapture(c.pointerId),o(c)}),a.addEventListener("pointermove",c=>{a.hasPointerCapture(c.pointerId)&&o(c)});let l=T("div",{class:"light"},a,T("div",{class:"stack"},r.element,s.element));return this.bindings.push(c=>{t.update(c.stripes),n.update(c.density),r.update(c.lightAzimuth),s.update(c.lightElevation),n.element.hidden=l.hidden=c.stripes==="none";let h=c.lightAzimuth*Math.PI/180,d=Math.cos(c.lightElevation*Math.PI/180),u=a.firstElementChild;u.style.left=`${50+50*d*Math.cos(h)}%`,u.style.top=`${50-50*d*Math.sin(h)}%`,u.classList.toggle("under",c.lightElevation<0)}),[t.element,n.element,l]}cut(){let{store:e}=this,t=ln("Section by a plane",h=>e.setting({section:h})),n=ln("Cut the front away",h=>e.setting({clip:h})),r=gn("Normal of the plane",["x","y","z"].map(h=>({value:h,label:T("i",{},h),title:`Plane across ${h}`})),h=>e.setting({sectionAzimuth:oo[h][0],sectionTilt:oo[h][1],sectionAt:0})),s=Jn({label:"turn",name:"Azimuth of the plane's normal in degrees",min:-180,max:180,step:1,marks:[-90,0,90],onInput:h=>e.setting({sectionAzimuth:h})}),a=Jn({label:"tilt",name:"Tilt of the plane's normal in degrees",min:-90,max:90,step:1,marks:[-45,0,45],hard:!0,onInput:h=>e.setting({sectionTilt:h})}),o=T("p",{class:"hint"}),l=Jn({label:"at",name:"Place of the section plane",min:-1,max:1,step:.01,onInput:h=>e.setting({sectionAt:h-this.middle})}),c=[T("div",{class:"row"},T("span",{class:"caption"},"Across"),r.element),s.element,a.element,l.element,o,n.element];return this.bindings.push(h=>{t.update(h.section),n.update(h.clip);let d=["x","y","z"].find(u=>h.sectionTilt===oo[u][1]&&(u==="z"||h.sectionAzimuth===oo[u][0]));r.update(d??"free"),s.update(h.sectionAzimuth),a.update(h.sectionTilt);for(let u of c)u.hidden=!h.section;h.section&&(o.textContent=`${this.showOffset(h,l)}; drag the red points in the picture`)}),[t.element,...c]}middle=0;box={low:[0,0,0],high:[1,1,1]};sectionBox(e){this.box=e}showOffset(e,t){let n=Ks(e),{low:r,high:s}=this.box;this.middle=n.reduce((h,d,u)=>h+.5*d*(r[u]+s[u]),0);let a=n.reduce((h,d,u)=>h+.5*Math.abs(d)*(s[u]-r[u]),0)||1;t.bounds(this.middle-a,this.middle+a,10**Math.floor(Math.log10(a/500)));let o=this.middle+e.sectionAt,{unit:l}=this.store.state.model;return t.update(Number(o.toPrecision(5))),`${n.map((h,d)=>[Number(h.toFixed(3)),"xyz"[d]]).filter(([h])=>h!==0).map(([h,d],u)=>`${h<0?"− ":u?"+ ":""}${Math.abs(h)===1?"":`${Math.abs(h)} `}${d}`).join(" ")} = ${He(o)}${l?` ${l}`:""}`}};function wM(i){try{let e=Vn(i),t=i.kind==="ruled"?["first curve","second curve"]:e.length>1?["along u","along v"]:[""];return e.map(({entry:n},r)=>[t[r],Rr(i)?"":n.title].filter(Boolean).join(": "))}catch{return[]}}function AM(i,e){for(let t of[1,2,5,10,20,50,100]){let n=Math.ceil(i/t),r=Math.floor(e/t)-n+1;if(r>=2&&r<=6)return Array.from({length:r},(s,a)=>(n+a)*t)}return[i,e].map(t=>Number(t.toPrecision(3)))}var $g=256,es=lo(Ue.palette.undefined),ah=lo(Ue.palette.front),js=lo(Ue.palette.back),PP=Ue.palette.series;function mr(i){let e=(i.colour==="diverging"?Ue.palette.diverging:Ue.palette.sequential).map(lo);return Array.from({length:$g},(t,n)=>{let r=n/($g-1)*(e.length-1),s=Math.min(Math.floor(r),e.length-2);return[0,1,2].map(a=>Math.round(e[s][a]+(r-s)*(e[s+1][a]-e[s][a])))})}var gr=i=>Ue.palette.classes[i].map(lo),Xg=i=>Uint8Array.from(i.flatMap(e=>[...e,255])),On=([i,e,t])=>`rgb(${i} ${e} ${t})`;function lo(i){return[1,3,5].map(e=>parseInt(i.slice(e,e+2),16))}var lh=class{element=T("figure",{class:"legend","aria-label":"Legend"});bar=T("canvas",{class:"colours",width:1,height:256});plot=T("canvas",{class:"histogram",width:64,height:192,"aria-hidden":"true"});shown="";ticks=[];note=T("figcaption",{});real(e,t,n,r){this.element.hidden=!1;let s=lt[e],a=Om(Math.max(Math.abs(t.low),Math.abs(t.high)));if(this.shown!==`${e} ${n} ${a}`){this.shown=`${e} ${n} ${a}`;let u=this.bar.getContext("2d");mr(s).forEach((f,b,m)=>{u.fillStyle=On(f),u.fillRect(0,m.length-1-b,1,1)}),this.ticks=Array.from({length:5},()=>T("span",{class:"tick"}));let p=`${a?`10${Eu(a)} `:""}${di(s,n)}`.trim();this.element.replaceChildren(T("div",{class:"legend-title"},T("span",{},Rt(s.name)),T("span",{class:"legend-symbol"},Ai(s.latex),p?T("span",{class:"unit"},p):null)),T("div",{class:"scale"},this.plot,this.bar,T("div",{class:"ticks"},...this.ticks)),this.note)}let{low:o,high:l}=t,c=u=>He(Math.abs(u)<=t.noise?0:u/10**a,3);this.ticks.forEach((u,p)=>{let f=p/(this.ticks.length-1);u.textContent=c(o+(l-o)*f),u.style.bottom=`${100*f}%`}),this.histogram(t,r);let h=t.finite?[T("dl",{class:"facts"},T("dt",{},"max"),T("dd",{},c(t.most)),T("dt",{},"mean"),T("dd",{},c(t.mean)),T("dt",{},"min"),T("dd",{},c(t.least)))]:["no point has a finite value"];t.below+t.above>0&&h.push(T("div",{},`${Tu(t.below+t.above)} beyond ends`));let d=[[t.missing-t.infinite,"undefined"],[t.infinite,"infinite"]];for(let[u,p]of d)u&&h.push(T("div",{class:"missing"},oh(On(es)),`${u} ${p}`));this.note.replaceChildren(...h)}classes(e,t){this.shown="",this.element.hidden=!1;let n=lt[e],r=gr(e),s=r.map((l,c)=>t.reduce((h,d)=>h+(d[c]??0),0)),a=s.reduce((l,c)=>l+c,0),o=n.classes.map((l,c)=>({name:l,code:c})).filter(({code:l})=>l>0||s[0]>0);this.element.replaceChildren(T("div",{class:"legend-title"},T("span",{},Rt(n.name))),T("ul",{class:"types"},...o.map(({name:l,code:c})=>T("li",{class:s[c]?"":"absent",title:Vo(e,c)||!1},oh(On(r[c])),T("span",{},l),T("span",{class:"share"},s[c]?Tu(s[c]/a):"–")))))}plain(e){this.element.hidden=e,this.shown!=="plain"&&(this.shown="plain",this.element.replaceChildren(T("ul",{class:"types"},T("li",{},oh(On(ah)),T("span",{},"side the normal points to")),T("li",{},oh(On(js)),T("span",{},"other side")))))}histogram(e,t){let{width:n,height:r}=this.plot,s=this.plot.getContext("2d");s.clearRect(0,0,n,r);let a=Math.max(...e.histogram,1),o=r/e.histogram.length;s.fillStyle=t?"rgb(255 255 255 / 38%)":"rgb(20 30 45 / 30%)",e.histogram.forEach((l,c)=>{let h=l?Math.max(2,Math.sqrt(l/a)*n):0;s.fillRect(n-h,r-(c+1)*o,h,o-1)})}},oh=i=>{let e=T("span",{class:"swatch"});return e.style.background=i,e};function ip(i,e){if(e===i.kind)return i;if(nt(i)||!["trigonometric","bernstein",void 0].includes(Pe(i,"basis")))return null;let t=EM(i);if(!t)return null;let n=i.kind==="nurbs"||Pe(i,"basis")==="bernstein",{name:r}=i,s=np(i,"flip");if(e==="tensor")return{kind:e,name:r,points:t,...np(i,"shape"),...np(i,"unchecked_shape"),...n?{basis:"bernstein"}:{},...s};if(e!=="nurbs"||!n)return null;let a=[t.length-1,t[0].length-1];return{kind:e,name:r,degrees:a,knots:a.map(Yg),points:t,...s}}function EM(i){let e=t=>Pe(i,t);switch(i.kind){case"tensor":return e("points");case"symmetric":{let t=e("points"),n=Pe(i,"mirror");return[...t,...t.map(r=>r.map(s=>us(s,n))).reverse()]}case"swept":return e("section").map(t=>e("trajectory").map(n=>t.map((r,s)=>r+n[s])));case"swung":{let t=Pe(i,"scale");return e("profile").map(([n,r])=>e("trajectory").map(([s,a])=>[t*n*s,t*n*a,r]))}case"ruled":{let t=e("first"),n=e("second");return Pe(i,"basis")==="bernstein"&&t.length===n.length?t.map((r,s)=>[r,n[s]]):null}case"nurbs":return TM(i)?e("points"):null;default:return null}}function TM(i){let e=Pe(i,"weights")?.flat()??[],t=Pe(i,"degrees"),n=Pe(i,"knots"),r=Pe(i,"trim");return e.every(s=>s===e[0])&&!r?.length&&t.every(s=>s<=63)&&t.every((s,a)=>String(n[a])===String(Yg(s)))}var Yg=i=>[...Array(i+1).fill(0),...Array(i+1).fill(1)],np=(i,e)=>i[e]===void 0?{}:{[e]:i[e]};var ch=class{constructor(e){this.store=e}store;element=T("div",{class:"stack bases"});shown="";refresh(e){let t=hh(e),n=CM(e),r=JSON.stringify([t.map(({entry:o,points:l})=>[o.name,l]),Object.values(n).map(({name:o,sizes:l})=>[o,l]),e.kind]);if(r===this.shown)return;let s=this.element.getRootNode().activeElement,a=[...this.element.querySelectorAll("select")].indexOf(s);this.shown=r,this.element.replaceChildren(...t.map((o,l)=>this.row(e,t,o,l,Object.values(n)))),a>=0&&this.element.querySelectorAll("select")[a]?.focus()}row(e,t,{entry:n,points:r},s,a){let o=t.length<2?"Basis":e.kind==="ruled"?`Basis of the ${["first","second"][s]} curve`:`Basis in ${"uv"[s]}`,l=p=>p.has(r),c=Object.values(qn).filter(p=>l(p)&&(p.name!=="quintic"||n.name==="quintic")&&(p.name!=="trigonometric"||n.name!=="quintic")),h=p=>p.map(({name:f,title:b})=>({value:f,label:b})),d=Or(o,[{label:"Of this model",options:h(a.filter(l))},{label:`For ${r} points`,options:h(c)}].filter(p=>p.options.length),p=>this.choose(s,p));d.update(n.name);let u=t.length<2?"Basis":e.kind==="ruled"?["Basis of first","Basis of second"][s]:o;return T("label",{class:"row basis"},T("span",{class:"caption"},u),d.element)}choose(e,t){let n=Ve(this.store.state),r=hh(n).map(({entry:s},a)=>a===e?t:s.name);this.store.editPatch(uh(n,r))}};function uh(i,e,t=i.bases){let{shape:n,bases:r,basis:s,...a}=i,o=e.every(p=>p===e[0]),l=o?e[0]:e,c={...a,kind:i.kind,name:i.name,basis:l,...t===void 0?{}:{bases:t}},h={...c,shape:n},d=p=>String(wi(p).map(f=>f.label)),u=d(h)===d(i)||$i(h)||$i(i);try{return n===void 0||!u?c:(Jh(h,Vn(h)),h)}catch{return c}}function hh(i){try{return st[i.kind].fields.basis?Vn(i):[]}catch{return[]}}function CM(i){try{return Er(Pe(i,"bases"))}catch{return{}}}var RM=120,dh=class{constructor(e){this.store=e;let t=gn("Which text",[{value:"file",label:"Whole file",title:"The model as a TOML file"},{value:"bases",label:"Own bases",title:"The [bases.NAME] tables: functions as formulas, parameters with ranges"}],n=>{this.part=n,t.update(n),this.write()});t.update(this.part),this.copy=Qe("Copy the basis to a basis of your own","Copy the formulas of the basis into the model, to change them",()=>this.own(),"button"),this.element=ui("Model as text",!1,t.element,this.wrong,this.text,this.copy,this.hint),this.element.classList.add("model-text"),this.element.addEventListener("toggle",()=>this.refresh(e.state)),this.text.addEventListener("input",()=>{clearTimeout(this.timer),this.timer=window.setTimeout(()=>this.read(),RM)}),this.text.addEventListener("blur",()=>{this.timer&&this.read(),e.settle()}),this.text.addEventListener("keydown",n=>{n.stopPropagation(),n.key==="Escape"&&this.write()})}store;element;text=T("textarea",{spellcheck:"false",autocapitalize:"off",rows:14});wrong=T("p",{class:"hint error",role:"alert",hidden:!0});copy;hint=T("p",{class:"hint"});part="file";shown=null;shownPatch=-1;timer=0;refresh({model:e,patch:t}){!this.element.open||e===this.shown&&t===this.shownPatch||(this.text.getRootNode().activeElement===this.text?this.shown=e:this.write())}write(){let{state:e}=this.store,{model:t}=e,n=Ve(e).bases;clearTimeout(this.timer),this.timer=0,this.shown=t,this.shownPatch=e.patch,this.text.value=this.part==="file"?Wn(t):n?du({bases:n}).trimStart():"",this.text.setAttribute("aria-label",this.part==="file"?"The model file":"The model's own bases"),this.wrong.hidden=!0;let r=st[Ve(e).kind].fields.bases!==void 0;this.copy.hidden=this.part==="file"||!r||!!n,this.text.disabled=this.part==="bases"&&!r,this.hint.textContent=this.part==="file"?"":r?"In formulas stand t, r = 1 − t, s = sin(πt/2), c = cos(πt/2), a = 1 − s, b = 1 − c, pi, the parameters, + − * / ^, and sin, cos, sinh, cosh, sqrt, exp.":"A surface of this kind has no basis."}read(){clearTimeout(this.timer),this.timer=0;try{let e=this.part==="file"?vt(ps(this.text.value)):this.withBases(ps(this.text.value));this.wrong.hidden=!0,this.shown=e,this.store.edit(e,"text")}catch(e){this.wrong.hidden=!1,this.wrong.textContent=e.message}}withBases({bases:e={},...t}){let{model:n,patch:r}=this.store.state,s=Object.keys(t)[0];if(s)throw new Error(`unknown key '${s}': expected [bases.NAME] tables alone`);let a=JSON.stringify(n.patches[r].bases),o=n.patches.map((l,c)=>c===r||a&&JSON.stringify(l.bases)===a?PM(l,e):l);return vt(on({...n,patches:o}))}own(){let e=Ve(this.store.state),t={},n=hh(e).map(({entry:r,points:s},a,o)=>{let l=o.some(p=>p.entry===r&&p.points!==s)?`my_${r.name}_${s}`:`my_${r.name}`,{functions:c,parameters:h}=r.basis(s),d=(p,f)=>.001*(f-p),u=h.map(({name:p,low:f,high:b,start:m,open:g})=>[p,[f+d(f,b)*Number(g[0]),b-d(f,b)*Number(g[1]),m]]);return t[l]={functions:c,...u.length?{parameters:Object.fromEntries(u)}:{}},l});n.length&&(this.store.editPatch(uh(e,n,t)),this.write())}};function PM(i,e){let t=i.basis??[],n=[t].flat(),{bases:r,...s}=i,a=Object.keys(e).length?{...s,kind:i.kind,name:i.name,bases:e}:{...s,kind:i.kind,name:i.name};return n.length&&i.shape!==void 0?uh(a,n,a.bases):a}var fh=class{constructor(e){this.store=e;let t=[{label:"Constructions",options:ph(n=>n.construction&&n.surface)},{label:"Curves",options:ph(n=>!n.surface)},{label:"Closed forms",options:ph(n=>!n.construction&&!n.fields.points)},{label:"From CAD",options:ph(n=>!n.construction&&!!n.fields.points)}];this.kind=Or("Construction",t,n=>{this.become(n)}),this.unit=Or("Unit of length",[{label:"",options:[{value:"",label:"no unit"},...Lo.map(n=>({value:n,label:n}))]}],n=>e.edit({...e.state.model,unit:n})),this.flip=ln("Turn the normal",n=>e.editPatch({...Ve(e.state),flip:n}),void 0,"The signs of H, κ1, κ2 and S follow the normal"),this.close=ln("End in the first point",n=>this.closed(n),void 0,"A closed curve: the first control point counts once more, as the last"),this.basis=new ch(e),this.text=new dh(e),this.locks=["x","y","z"].map((n,r)=>ln(n,s=>{let a=[...e.state.settings.locks];a[r]=s,e.setting({locks:a})},void 0,`Keep ${n} while dragging`)),this.snap=ln("Snap to",n=>e.setting({snap:n}),void 0,"Round coordinates while dragging"),this.step=hi({label:"",name:"Snap step",positive:!0,onChange:n=>e.setting({snapStep:n})}),this.element.append(this.patches,T("div",{class:"stack"},T("label",{class:"row"},T("span",{class:"caption"},"Construction"),this.kind.element),this.about,T("label",{class:"row"},T("span",{class:"caption"},"Unit"),this.unit.element),this.basis.element,this.flip.element,this.close.element),ui("Control points",!0,this.points,T("div",{class:"drag-tools"},T("div",{class:"locks",role:"group","aria-label":"Axes kept while dragging"},T("span",{class:"caption"},"Keep"),...this.locks.map(n=>n.element)),T("div",{class:"snap"},this.snap.element,this.step.element))),this.text.element),e.subscribe((n,r)=>{(n.model!==r.model||n.patch!==r.patch||n.selected!==r.selected||n.settings!==r.settings)&&this.refresh(n)})}store;element=T("aside",{class:"panel left","aria-label":"Model"});patches=T("div",{class:"patches",role:"listbox","aria-label":"Patches"});kind;unit;flip;basis;text;close;about=T("p",{class:"hint"});points=T("div",{class:"points"});locks;snap;step;names="";list=[];shownPatch=null;tab="";coordinates=[];form=null;refresh(e){let t=Ve(e),n=st[t.kind];this.kind.update(t.kind),this.unit.update(e.model.unit),this.flip.update(Pe(t,"flip")===!0),this.flip.element.hidden=!n.surface,this.close.element.hidden=!n.fields.close,this.close.update(Pe(t,"close")===!0),this.basis.refresh(t),this.text.refresh(e),this.about.textContent=Rt(n.title),e.settings.locks.forEach((s,a)=>this.locks[a].update(s)),this.snap.update(e.settings.snap),this.step.update(e.settings.snapStep),this.patches.hidden=e.model.patches.length<2;let r=JSON.stringify([e.patch,e.model.patches.map(s=>[s.name,s.kind])]);r!==this.names&&this.patches.replaceChildren(...e.model.patches.map((s,a)=>T("button",{type:"button",class:"patch",role:"option","aria-selected":a===e.patch,on:{click:()=>this.store.set({patch:a,selected:null})}},T("span",{},s.name),T("small",{},s.kind.replaceAll("_"," "))))),this.names=r,this.showPoints(e,t)}showPoints(e,t){t!==this.shownPatch&&(this.list=mn(t).filter(f=>!f.mirrored),this.shownPatch=t);let n=this.points.parentElement.parentElement;if(n.hidden=!this.list.length,!this.list.length)return;let r=this.list.find(f=>f.id===e.selected?.replace("′","")),s=[...new Set(this.list.map(f=>f.key))];r&&(this.tab=r.key),s.includes(this.tab)||(this.tab=s[0]);let a={patch:t,chosen:r?.id,tab:this.tab};if(a.patch===this.form?.patch&&a.chosen===this.form.chosen&&a.tab===this.form.tab)return;this.form=a;let o=gn("Which points",s.map(f=>({value:f,label:Rt(f)})),f=>{this.tab=f,this.store.set({selected:null}),this.showPoints(this.store.state,t)});o.update(this.tab);let l=this.list.filter(f=>f.key===this.tab),c=Math.max(...l.map(f=>f.index.at(-1)))+1,h=T("div",{class:"net",role:"group","aria-label":`${Rt(this.tab)}: choose one`},...l.map((f,b)=>T("button",{type:"button",class:"knob",title:f.label,"aria-label":f.label,"aria-pressed":f===r,tabindex:f===r||!r&&b===0?0:-1,on:{click:()=>this.store.set({selected:f===r?null:f.id})}},f.index.length>1?"":f.index[0])));h.style.setProperty("--columns",String(c)),h.addEventListener("keydown",f=>this.walk(f,l,c));let d=this.points.getRootNode().activeElement,u=d?.classList.contains("knob")??!1,p=this.coordinates.findIndex(f=>f.element.contains(d));this.coordinates=r?this.fields(r):[],this.points.replaceChildren(s.length>1?o.element:"",h,r?T("div",{class:"coordinates"},T("span",{class:"caption"},r.label),...this.coordinates.map(f=>f.element)):T("p",{class:"hint"},`${l.length} points: choose one here, or drag one in the picture`)),u&&h.querySelector('[tabindex="0"]')?.focus(),p>=0&&this.coordinates[p]?.element.querySelector("input")?.focus()}fields(e){let t=Ve(this.store.state),n=Pe(t,e.key);for(let a of e.index)n=n[a];let r=n,s=nt(t)?["x","y","z"]:e.along?["a","b","c","d"]:t.kind==="swung"?e.key==="profile"?["r","z"]:["x","y"]:["x","y","z"];return r.map((a,o)=>{let l=hi({label:T("i",{class:"math"},s[o]),name:`${e.label} ${s[o]}`,onChange:c=>this.store.editPatch(ba(Ve(this.store.state),e.key,e.index,r.map((h,d)=>d===o?c:h)))});return l.update(a),l})}walk(e,t,n){let r={ArrowRight:1,ArrowLeft:-1,ArrowDown:n,ArrowUp:-n}[e.key];if(!r)return;e.preventDefault(),e.stopPropagation();let s=t.findIndex(o=>o.id===this.store.state.selected),a=t[Math.min(t.length-1,Math.max(0,s+r))];this.store.set({selected:a.id})}closed(e){let{store:t}=this,n=Ve(t.state),r=Pe(n,"points"),[s,a]=[r[0],r.at(-1)],o=s.every((c,h)=>c===a[h]),l={...n,close:e,points:e?r.slice(0,-1):o?r:[...r,s]};try{St(l),t.editPatch(l)}catch(c){t.set({message:{kind:"error",text:c.message}}),this.close.update(!e)}}async become(e){let{store:t}=this,n=Ve(t.state),{patch:r,opened:s}=t.state,a=ip(n,e);if(!a){let l=this.element.closest(".studio");await Zn(l,"Another surface?",[T("p",{},`“${n.name}” cannot be kept exactly as “${Zg(e)}”: a new surface to start from would take its place.`)],[["stay","Keep it"],["replace","Start anew"]])==="replace"&&(a={...Ko(e).patches[0],name:n.name})}let o=t.state.patch===r&&t.state.opened===s&&Ve(t.state)===n;if(!a||!o)return this.kind.update(Ve(t.state).kind);t.set({selected:null}),t.editPatch(a)}};function Jg(i,e){let t=Ve(i.state),n=mn(t).find(r=>r.id===i.state.selected);n&&i.editPatch(Xo(t,n,n.position.map((r,s)=>r+e[s])),`nudge ${n.id}`)}var ph=i=>Object.entries(st).filter(([,e])=>i(e)).map(([e])=>({value:e,label:Rt(Zg(e))})),Zg=i=>i==="nurbs"?"NURBS":i.replaceAll("_"," ");var mh=class{constructor(e){this.store=e;this.element.append(this.left,this.warning,T("span",{class:"spacer"}),this.right),e.subscribe(t=>{t.message!==this.shown&&this.say(t.message)})}store;element=T("footer",{class:"status"});banner=T("div",{class:"banners"});left=T("span",{});warning=T("span",{class:"warning"});right=T("span",{class:"quiet"});shown=null;timer=0;refresh(e,t){let{unit:n}=e.model;if(t.curve){this.left.textContent=NM(t.curve,n),this.warning.textContent=t.warning,this.right.textContent="";return}this.left.replaceChildren(...t.surface?["Normal ",cs(t.surface)," ",T("i",{class:"math"},"S"),T("sub",{},"u")," × ",T("i",{class:"math"},"S"),T("sub",{},"v")]:["No surface"],n?` · lengths in ${n}`:" · no unit",t.sharp?` · smallest radius ${He(t.sharp.radius)}${n?` ${n}`:""} at u = ${He(t.sharp.u)}, v = ${He(t.sharp.v)}`:"");let r=t.singular===t.points&&!t.warning?"No point has a tangent plane: this is a curve":"",s=!t.singular||t.singular===t.points?r:`${t.singular} of ${t.points} points singular (grey)`;this.warning.textContent=[s,t.warning].filter(Boolean).join(" · "),this.right.textContent=`${t.side} × ${t.side} points, ${t.cost.toFixed(1)} ms`}offer(e,t,n,r,s){let a=T("div",{class:"banner",role:"alert"},T("span",{},e));return a.append(Qe(t,t,()=>{a.remove(),n()},"button primary"),Qe(r,r,()=>{a.remove(),s()})),this.banner.append(a),()=>a.remove()}warn(e){this.store.set({message:{kind:"error",text:e}})}say(e){this.shown=e,clearTimeout(this.timer),this.banner.querySelector(".message")?.remove(),e&&(this.banner.append(T("div",{class:`banner message ${e.kind}`,role:e.kind==="error"?"alert":"status"},T("div",{},e.text,e.lines?.length?T("ul",{},...e.lines.map(t=>T("li",{},t))):null),...(e.actions??[]).map(({label:t,act:n})=>Qe(t,t,n)),Qe(xt(Mt.close),"Close",()=>this.store.set({message:null}),"tiny"))),e.kind==="note"&&!e.lines&&!e.actions&&(this.timer=window.setTimeout(()=>this.store.set({message:null}),4e3)))}},IM=401;function NM(i,e){let t=i.sample(IM).filter(({curvature:o})=>Number.isFinite(o)),n=e?` ${e}`:"",r=t.reduce((o,l)=>Math.abs(l.curvature)>Math.abs(o.curvature)?l:o,t[0]??i.at(.5)),s=i.bends(r.curvature)?`greatest curvature ${He(r.curvature)}${e?` 1/${e}`:""} at t = ${He(r.t,3)}`:"straight",a=i.flat?" · positive turns left":"";return`Length ${He(i.length,5)}${n} · ${s}${a}${e?"":" · no unit"}`}var gh=class{element;name;dirty=T("span",{class:"dirty",title:"Not saved"});undo;redo;compare;constructor(e,t,n,r,s,a){this.name=T("input",{class:"name","aria-label":"Name of the model",spellcheck:"false",maxlength:200}),nl(this.name,()=>{this.name.value=e.state.model.name}),this.name.addEventListener("change",()=>{let c=this.name.value.trim();if(!c)return void(this.name.value=e.state.model.name);let{model:h}=e.state,d=h.patches.length===1?[{...h.patches[0],name:c}]:h.patches;e.edit({...h,name:c,patches:d})}),this.undo=Qe(xt(Mt.undo),"Undo (Ctrl Z)",()=>e.undo(),"button square"),this.redo=Qe(xt(Mt.redo),"Redo (Ctrl Shift Z)",()=>e.redo(),"button square");let o=()=>["Presets",...Zo.map(c=>({label:c.name,hint:c.patches[0].kind.replaceAll("_"," "),act:()=>{t.start(c)}})),"Starters",...Object.entries(st).filter(([,c])=>c.construction).map(([c,{title:h}])=>({label:Rt(c),hint:h,act:()=>{t.start(Ko(c))}}))];this.compare=gn("Compare",[{value:"off",label:"One",title:"The model alone"},{value:"before",label:"Before | now",title:"As last saved or opened, beside the model now"},{value:"sets",label:"Four sets",title:"The four sets of shape parameters of the thesis, on one scale"},{value:"kept",label:"Kept",title:"The model beside those you kept"}],c=>c==="kept"&&!e.state.kept.length?Du(e):e.set({compare:c}));let l=Qe("Keep","Keep the model as it is now, to compare with",()=>Du(e),"button quiet");this.element=T("header",{class:"bar"},a?null:T("span",{class:"brand",title:"quintrig"},LM(),T("span",{},"quintrig")),Qe(xt(Mt.side),"Construction and control points",s,"button square drawer"),this.name,this.dirty,T("div",{class:"group"},ya(T("span",{},"Models",xt(Mt.down)),"Models: presets and starters",o),ya(T("span",{},xt(Mt.open),T("span",{class:"word"},"Open"),xt(Mt.down)),"Open a model",()=>t.openItems()),ya(T("span",{},xt(Mt.save),T("span",{class:"word"},"Save"),xt(Mt.down)),"Save the model",()=>t.saveItems())),T("div",{class:"group tight"},this.undo,this.redo),T("div",{class:"group tight"},this.compare.element,l),T("span",{class:"spacer"}),T("div",{class:"group tight last"},Qe(xt(Mt.picture),"Save a picture",()=>{t.picture()},"button square"),ya(xt(Mt.export),"Export",()=>t.exportItems(),"button square",()=>t.lookAtFormats()),Qe(xt(Mt.sun),"Light or dark",n,"button square theme"),Qe(xt(Mt.help),"Keys and pointer (?)",r,"button square")))}refresh(e){Fr(this.name)||(this.name.value=e.model.name),this.name.style.setProperty("--letters",String(Math.min(30,Math.max(6,this.name.value.length)))),this.dirty.hidden=e.model===e.saved,this.undo.disabled=!e.canUndo,this.redo.disabled=!e.canRedo,this.compare.update(e.compare)}};function LM(){let i=xt("M2 11c3-6 9-1 12-7M2 11c2 3 5 3 6.5 2.2M14 4c.3 3-1.500 7.200-5.500 9.200M5.500 7.700c1 2.500 3 4 5.600 3.700M9.500 6.600c.7 1.900 1.900 3 3.400 3.100");return i.classList.add("mark-icon"),i}function Kg(i,e,t,n,r,s,a){let o=i.getContext("2d"),{width:l,height:c}=i,h=Math.max(11,Math.min(l,c)/48);o.fillStyle=o.strokeStyle=a?"#e8edf3":"#1c232c",o.textBaseline="middle",o.font=`600 ${h}px Helvetica, Arial, sans-serif`;let d=r.length?Math.max(...r.map(E=>E.x+E.width)):1;if(s.forEach((E,w)=>{let y=r[w];y&&E&&o.fillText(E,y.x/d*l+h,y.y/d*l+1.4*h)}),!e.legend)return i;let u=r[0]?.pieces[t.patch],p=u?.surface,f=p?`normal ${cs(p)} Su × Sv`:u?.curve.length?t.settings.comb?"curvature comb":"curve":"no surface";o.font=`${.85*h}px Helvetica, Arial, sans-serif`,o.fillText(`${t.model.name} · ${f}${t.model.unit?` · lengths in ${t.model.unit}`:""}`,h,c-1.2*h);let b=lt[t.settings.quantity];if(!b||!r[0]?.pieces.some(E=>E.surface))return i;let m=di(b,t.model.unit),g=`${Rt(b.name)}${b.colour==="classes"?"":` ${b.symbol}`}${m?` (${m})`:""}`,v=l-h,M=o.measureText(g).width;if(o.textAlign="right",o.fillText(g,v,1.4*h),o.textAlign="left",n){let E=2.6*h,w=Math.min(14*h,c*.5),y=v-Math.max(4.6*h,.3*M),A=mr(b);A.forEach((D,R)=>{o.fillStyle=On(D),o.fillRect(y,E+w*(1-(R+1)/A.length),h,w/A.length+.6)}),o.fillStyle=a?"#e8edf3":"#1c232c";for(let D=0;D<5;D++)o.fillText(He(n.low+(n.high-n.low)*D/4,3),y+1.4*h,E+w*(1-D/4));return i}let x=gr(b.key);return b.classes.slice(1).forEach((E,w)=>{let y=(2.9+1.4*w)*h;o.fillStyle=On(x[w+1]),o.fillRect(v-h,y-.5*h,h,h),o.fillStyle=a?"#e8edf3":"#1c232c",o.textAlign="right",o.fillText(E,v-1.5*h,y),o.textAlign="left"}),i}var{sameColour:rp,noise:DM}=Ue.limits,bh=48,yh=new Float32Array(0),jg=new WeakMap;function zM(i,e){let t=jg.get(i);if(t?.version===i.version)return t;let{values:n,repeated:r,covered:s}=i,a=new Float32Array(n.length),o=0,l=0,c=0,h=0;for(let u=0;u<n.length;u++){if(!s[u])continue;let p=n[u];p-p===0?(a[o++]=p,l+=p):r[u]||(h++,p===p&&c++)}let d={version:i.version,sorted:a.subarray(0,o).sort(),sum:l,missing:h,infinite:c,scale:OM(i,e)};return jg.set(i,d),d}function e1(i,e,t){let n=i.map(b=>zM(b,e)),r=n.map(b=>b.sorted).filter(b=>b.length),s=b=>n.reduce((m,g)=>m+b(g),0),a=s(b=>b.sorted.length),o=Math.max(...n.map(b=>b.scale)),l=Math.min(...r.map(b=>b[0])),c=Math.max(...r.map(b=>b.at(-1))),[h,d]=FM(r,a,l,c,e,t,o);d>h||([h,d]=[h-.5*(Math.abs(h)||1),h+.5*(Math.abs(h)||1)]);let u=Array.from({length:bh+1},(b,m)=>vh(r,h+(d-h)*m/bh,m===bh)),p=u.slice(1).map((b,m)=>b-u[m]),f=a?1/a:0;return{low:h,high:d,below:u[0]*f,above:(a-u[bh])*f,least:l,most:c,mean:a?s(b=>b.sum)/a:NaN,finite:a,missing:s(b=>b.missing),infinite:s(b=>b.infinite),histogram:p,noise:DM*o}}function FM(i,e,t,n,r,s,a){if(s.range==="fixed")return[s.low,s.high];if(r.key==="shape_index")return[-1,1];if(!e)return r.colour==="diverging"?[-1,1]:[0,1];let o=s.range==="robust",l=s.percentile/100,c=b=>Math.round(b*(e-1));if(r.colour==="diverging"){let b=Math.max(-t,n),m=b;return o&&(m=sp(Qg(0,b,c(1-l),g=>vh(i,g,!0)-vh(i,-g)),b)),(m<=rp*a||m===0)&&(m=a>0?a:1),[-m,m]}let h=b=>Qg(t,n,c(b),m=>vh(i,m,!0)),d=o?h(l):t,u=o?h(1-l):n,p=.5*(d+u);if(o&&(d=p-sp(p-d,p-t),u=p+sp(u-p,n-p)),d>=0&&d<=.4*u&&(d=0),u>d&&u-d>=Math.max(.02*Math.abs(p),rp*a))return[d,u];let f=Math.abs(p)>rp*a?.5*Math.abs(p):a||1;return[p-f,p+f]}function vh(i,e,t=!1){let n=0;for(let r of i){let s=0,a=r.length;for(;s<a;){let o=s+a>>1,l=r[o];l<e||t&&l===e?s=o+1:a=o}n+=s}return n}function Qg(i,e,t,n){if(n(i)>t)return i;for(;;){let r=Math.fround(.5*i+.5*e);if(r<=i||r>=e)return e;n(r)>t?e=r:i=r}}var sp=(i,e)=>e<=1.5*i?e:i;function OM(i,e){let{size:t,planes:n,stride:r,count:s}=i.grid;if(e.power===0||!(t>0))return 1;if(e.power>0)return t**e.power;yh.length<s&&(yh=new Float32Array(s));let a=0;for(let o=0;o<s;o+=7){let l=n[ze.curvedness*r+o];i.covered[o]&&l<1/0&&(yh[a++]=l)}return Math.max(a?UM(yh.subarray(0,a),.98):0,1/t)**-e.power}function UM(i,e){let t=Math.round(e*(i.length-1)),n=0,r=i.length-1;for(;n<r;){let s=i[n+r>>1],a=n,o=r;for(;a<=o;){for(;i[a]<s;)a++;for(;i[o]>s;)o--;if(a<=o){let l=i[a];i[a++]=i[o],i[o--]=l}}if(t<=o)r=o;else if(t>=a)n=a;else break}return i[t]}var xh={iso:[-55,26],top:[-90,90],side:[-90,0],back:[0,0],front:[180,0],bottom:[-90,-90]},t1=14*Math.PI/180,ap=Math.PI/180;function kM(i,e){let t=i*ap,n=e*ap;return{right:new k(-Math.sin(t),Math.cos(t),0),up:new k(-Math.sin(n)*Math.cos(t),-Math.sin(n)*Math.sin(t),Math.cos(n)),towards:new k(Math.cos(n)*Math.cos(t),Math.cos(n)*Math.sin(t),Math.sin(n))}}var co=class{azimuth=xh.iso[0];elevation=xh.iso[1];span=1.1;target=new k;chosen="perspective";straight=!1;moved=!1;perspective=new Xt(2*t1/ap,1,.01,100);orthographic=new Vs;goal=null;from={azimuth:0,elevation:0,span:1,target:new k};get projection(){return this.straight?"orthographic":this.chosen}camera(e){let t=this.projection==="perspective"?this.perspective:this.orthographic,n=this.span/Math.min(1,e),r=n/Math.tan(t1),{right:s,up:a,towards:o}=this.axes();return t.position.copy(this.target).addScaledVector(o,r),t.matrixWorld.copy(new pt().makeBasis(s,a,o)).setPosition(t.position),t.matrixWorld.decompose(t.position,t.quaternion,t.scale),t instanceof Xt?(t.aspect=e,t.near=Math.max(r-6,.02*r),t.far=r+12):(t.left=-n*e,t.right=n*e,t.top=n,t.bottom=-n,t.near=r-12,t.far=r+12),t.updateProjectionMatrix(),t.updateMatrixWorld(!0),t}axes(){return kM(this.azimuth,this.elevation)}turn(e,t){this.goal=null,this.moved=!0,this.straight=!1,this.azimuth-=e*.35,this.elevation=Math.max(-90,Math.min(90,this.elevation+t*.35))}pan(e,t,n=1){this.goal=null,this.moved=!0;let{right:r,up:s}=this.axes(),a=2*this.span/Math.min(1,n);this.target.addScaledVector(r,-e*a).addScaledVector(s,t*a)}zoom(e,t=0,n=0,r=1){this.goal=null;let s=this.span;this.span=Math.max(1e-4,Math.min(20,this.span*e));let a=s/this.span-1;this.pan(-t*a,-n*a,r)}go(e,t,n,r,s){if(this.moved=!1,s){this.azimuth=e,this.elevation=t,this.span=n,this.target.copy(r);return}let a=(e-this.azimuth)%360;a>180&&(a-=360),a<-180&&(a+=360),this.from={azimuth:this.azimuth,elevation:this.elevation,span:this.span,target:this.target.clone()},this.goal={azimuth:this.azimuth+a,elevation:t,span:n,target:r.clone(),start:performance.now()}}step(e){if(!this.goal)return!1;let t=Math.min(1,Math.max(0,(e-this.goal.start)/260)),n=1-(1-t)**3,r=(s,a)=>s+(a-s)*n;return this.azimuth=r(this.from.azimuth,this.goal.azimuth),this.elevation=r(this.from.elevation,this.goal.elevation),this.span=r(this.from.span,this.goal.span),this.target.lerpVectors(this.from.target,this.goal.target,n),t>=1&&(this.goal=null),t<1}};var n1=`
out vec3 place;
out vec3 way;
out vec2 parameters;
void main() {
  place = position;
  way = normal;
  parameters = uv;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`,i1=`
precision highp float;
precision highp sampler2D;
in vec3 place;
in vec3 way;
in vec2 parameters;
layout(location = 0) out vec4 pixel;

uniform int mode;            // 0 plain, 1 real quantity, 2 classes
uniform sampler2D field;     // one number a grid point; 1e38 where there is none
uniform sampler2D colours;   // the colour map, or one colour a class
uniform vec2 range;
uniform float contour;       // distance between contour lines of the quantity; 0: none
uniform vec2 cells;          // grid points in u and v
uniform vec3 front;
uniform vec3 back;
uniform vec3 undefinedColour;
uniform int stripes;         // 0 none, 1 zebra, 2 isophotes, 3 reflection lines, 4 highlight lines
uniform float density;
uniform vec3 light;
uniform float curves;        // iso-curves across each parameter; 0: none
uniform vec4 cut;            // plane: cut.xyz . x > cut.w is cut away
uniform bool clipped;
uniform bool wire;
uniform float shade;         // strength of the light
uniform vec3 towards;        // direction to the eye, orthographic
uniform float faded;
uniform sampler2D face;      // what the loops of a trimmed face leave, over the window that they span
uniform bool trimmed;

const float MISSING = 1e37;

float at(ivec2 i) { return texelFetch(field, ivec2(i.y, i.x), 0).r; }

float line(float x, float width) {
  float slope = max(fwidth(x), 1e-6);
  float away = abs(fract(x - 0.5) - 0.5) / slope;
  return (1.0 - smoothstep(width - 0.5, width + 0.5, away)) * clamp(1.2 - slope * 2.0, 0.0, 1.0);
}

float band(float x) {
  float slope = max(fwidth(x), 1e-6);
  float wave = abs(fract(x) - 0.5) - 0.25;
  return mix(smoothstep(-slope, slope, wave), 0.5, smoothstep(0.35, 0.8, slope));
}

void main() {
  if (clipped && dot(cut.xyz, place) > cut.w) discard;
  if (trimmed && texture(face, parameters).r < 0.5) discard;
  vec3 eye = isOrthographic ? towards : normalize(cameraPosition - place);
  vec3 flatWay = cross(dFdx(place), dFdy(place));
  vec3 normal = dot(way, way) > 0.2 ? normalize(way) : (dot(flatWay, flatWay) > 0.0 ? normalize(flatWay) : eye);
  bool outside = dot(normal, eye) >= 0.0;
  vec3 colour = outside ? front : back;

  if (mode == 1) {
    vec2 x = parameters * (cells - 1.0);
    ivec2 i = ivec2(clamp(floor(x), vec2(0.0), cells - 2.0));
    vec2 f = x - vec2(i);
    float a = at(i), b = at(i + ivec2(1, 0)), c = at(i + ivec2(0, 1)), d = at(i + ivec2(1, 1));
    if (max(max(abs(a), abs(b)), max(abs(c), abs(d))) > MISSING) {
      colour = undefinedColour;
    } else {
      float value = mix(mix(a, b, f.x), mix(c, d, f.x), f.y);
      float share = clamp((value - range.x) / (range.y - range.x), 0.0, 1.0);
      colour = texture(colours, vec2(share * 255.0 / 256.0 + 0.5 / 256.0, 0.5)).rgb;
      if (contour > 0.0) colour = mix(colour, vec3(0.08), 0.55 * line(value / contour, 0.6));
    }
  } else if (mode == 2) {
    float code = at(ivec2(clamp(floor(parameters * (cells - 1.0) + 0.5), vec2(0.0), cells - 1.0)));
    colour = texelFetch(colours, ivec2(int(code + 0.5), 0), 0).rgb;
  }

  if (stripes > 0) {
    vec3 n = outside ? normal : -normal;
    vec3 side = normalize(abs(light.z) < 0.95 ? cross(light, vec3(0.0, 0.0, 1.0)) : cross(light, vec3(0.0, 1.0, 0.0)));
    float x = 0.0;
    float seen = 1.0;
    if (stripes == 1) {
      x = acos(clamp(dot(reflect(-eye, n), light), -1.0, 1.0)) / 3.14159265 * density;
    } else if (stripes == 2) {
      x = acos(clamp(dot(n, light), -1.0, 1.0)) / 3.14159265 * density;
    } else {
      // A ceiling of parallel tube lights, three scene lengths off along the light's direction, at equal angles seen from
      // the middle: as many as are asked for from side to side, and none so close to another that they blur to grey.
      vec3 ray = stripes == 3 ? reflect(-eye, n) : n;
      float rise = dot(ray, light);
      vec3 hit = place + ray * ((3.0 - dot(place, light)) / max(rise, 1e-4));
      x = atan(dot(hit, side), 3.0) / 3.14159265 * density;
      seen = smoothstep(0.02, 0.12, rise);
    }
    float dark = band(x) * seen;
    colour = mode == 0 ? mix(vec3(0.96), vec3(0.1), dark) : mix(colour, colour * 0.28, dark);
  }

  float lit = abs(dot(normal, normalize(eye + 0.35 * light)));
  colour *= mix(1.0, 0.62 + 0.42 * lit, shade);
  if (mode == 0 && stripes == 0) colour += 0.10 * pow(lit, 24.0);

  float grid = 0.0;
  if (curves > 0.0) grid = max(line(parameters.x * curves, wire ? 0.75 : 0.5), line(parameters.y * curves, wire ? 0.75 : 0.5));
  if (wire) {
    if (grid < 0.15) discard;
    pixel = vec4(colour * 0.9, 1.0);
  } else {
    pixel = vec4(mix(colour, vec3(0.05, 0.07, 0.1), grid * 0.34), 1.0);
  }
  pixel.rgb = mix(pixel.rgb, vec3(0.5), faded);
}`;var BM=1e38,r1=new Map,_h=class{grid=new ys;material;mesh;values=new Float32Array(0);version=0;covered=new Uint8Array(0);repeated=new Uint8Array(0);places=0;singular=0;box=[];trim;counted=null;buffers=new Map;current=null;constructor(){this.material=new Jt({glslVersion:Ui,vertexShader:n1,fragmentShader:i1,side:Fn,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1,uniforms:{mode:{value:0},field:{value:null},colours:{value:null},range:{value:new $e(-1,1)},contour:{value:0},cells:{value:new $e(2,2)},front:{value:new k},back:{value:new k},undefinedColour:{value:new k},stripes:{value:0},density:{value:20},light:{value:new k(0,0,1)},curves:{value:0},cut:{value:new ht},clipped:{value:!1},wire:{value:!1},shade:{value:1},towards:{value:new k(0,0,1)},faded:{value:0},face:{value:null},trimmed:{value:!1}}}),this.mesh=new Yt(void 0,this.material),this.mesh.frustumCulled=!1}update(e,t,n,r){let s=this.current=this.prepare(t),{grid:a}=this;a.evaluate(e,t,t),this.cut(e,t);let{planes:o,stride:l,count:c}=a;this.singular=this.places=0,this.repeated.length!==c&&(this.repeated=new Uint8Array(c));let h=[1/0,1/0,1/0],d=[-1/0,-1/0,-1/0],u=s.position,p=(b,m)=>u[3*b]===u[3*m]&&u[3*b+1]===u[3*m+1]&&u[3*b+2]===u[3*m+2];this.repeated.fill(0);for(let b=0;b<c;b++){for(let v=0;v<3;v++){s.position[3*b+v]=(o[(ze.point+v)*l+b]-r.centre[v])*r.scale;let M=o[(ze.normal+v)*l+b];s.normal[3*b+v]=M===M?M:0;let x=u[3*b+v];x<h[v]&&(h[v]=x),x>d[v]&&(d[v]=x)}if(!this.covered[b])continue;let m=b%t>0&&p(b,b-1)||b>=t&&p(b,b-t);if(this.repeated[b]=m?1:0,m)continue;this.places++;let g=o[ze.gaussian*l+b];g!==g&&this.singular++}this.box.splice(0,6,...h,...d),s.geometry.attributes.position.needsUpdate=!0,s.geometry.attributes.normal.needsUpdate=!0,this.mesh.geometry=s.geometry,this.mesh.visible=!0,this.material.uniforms.cells.value.set(t,t),this.paint(n)}cut(e,t){if(this.trim===e.trim&&this.covered.length===t*t)return;this.covered=Go(e,this.grid.u,this.grid.v);let n=this.material.uniforms;this.trim!==e.trim&&(n.face.value?.dispose(),n.face.value=e.trim?.length?qM(e):null,n.trimmed.value=n.face.value!==null),this.trim=e.trim}paint(e){let t=this.current;if(this.version++,!t)return;let n=this.material.uniforms,r=lt[e];if(n.mode.value=r?r.colour==="classes"?2:1:0,this.values=r?t.values:new Float32Array(0),r){this.grid.quantity(e,t.values,ms);let s=t.texture.image.data;for(let a=0;a<s.length;a++){let o=t.values[a];s[a]=o-o===0?o:BM}t.texture.needsUpdate=!0,n.field.value=t.texture,n.colours.value=VM(e)}}clear(){this.current=null,this.mesh.visible=!1,this.box.length=0}get counts(){if(this.counted?.version===this.version)return this.counted.counts;let e=[];for(let t=0;t<this.values.length;t++)this.covered[t]&&!this.repeated[t]&&(e[this.values[t]]=(e[this.values[t]]??0)+1);return this.counted={version:this.version,counts:e},e}get position(){return this.current?.position??new Float32Array(0)}get side(){return this.current?this.grid.nu:0}dispose(){for(let e of this.buffers.values())e.geometry.dispose(),e.texture.dispose();this.material.uniforms.face.value?.dispose(),this.material.dispose()}prepare(e){let t=this.buffers.get(e);if(t)return t;if(this.buffers.size>5){let h=this.buffers.keys().next().value;this.buffers.get(h).geometry.dispose(),this.buffers.get(h).texture.dispose(),this.buffers.delete(h)}let n=new cn,r=new Float32Array(3*e*e),s=new Float32Array(3*e*e),a=new Float32Array(2*e*e);for(let h=0,d=0;h<e;h++)for(let u=0;u<e;u++,d+=2)a.set([h/(e-1),u/(e-1)],d);let o=new Uint32Array(6*(e-1)*(e-1));for(let h=0,d=0;h<e-1;h++)for(let u=0;u<e-1;u++){let p=h*e+u;o[d++]=p,o[d++]=p+e,o[d++]=p+e+1,o[d++]=p,o[d++]=p+e+1,o[d++]=p+1}n.setIndex(new At(o,1)),n.setAttribute("position",new At(r,3).setUsage(Ys)),n.setAttribute("normal",new At(s,3).setUsage(Ys)),n.setAttribute("uv",new At(a,2));let l=new Hr(new Float32Array(e*e),e,e,Ja,Mn),c={geometry:n,position:r,normal:s,values:new Float32Array(e*e),texture:l};return this.buffers.set(e,c),c}},ho=1024;function qM(i){let e=document.createElement("canvas"),[t,n,r,s]=Ji(i);e.width=e.height=ho;let a=e.getContext("2d");a.fillRect(0,0,ho,ho),a.fillStyle="#ffffff",a.beginPath();for(let l of i.trim)l.forEach(([c,h],d)=>{let u=[ho*(c-t)/(r-t),ho*(1-(h-n)/(s-n))];d?a.lineTo(...u):a.moveTo(...u)}),a.closePath();a.fill("evenodd");let o=new ka(e);return o.minFilter=o.magFilter=Ft,o.generateMipmaps=!1,o}var s1=([i,e,t])=>new k(i/255,e/255,t/255);function VM(i){let e=lt[i],t=e.colour==="classes"?i:e.colour,n=r1.get(t);if(!n){let r=e.colour==="classes"?gr(i):mr(e);n=new Hr(Xg(r),r.length,1,wn,tn),n.magFilter=n.minFilter=e.colour==="classes"?Et:Ft,n.needsUpdate=!0,r1.set(t,n)}return n}var op=class{mesh=new _h;overlays=new rh;patch=null;surface=null;curve=[];side=0;frame=null;quantity="";lines="";net=""},Sh=class{scene=new Da;pieces=[];x=0;y=0;width=1;height=1;resizePieces(e){for(;this.pieces.length>e;){let t=this.pieces.pop();this.scene.remove(t.mesh.mesh,t.overlays.group),t.mesh.dispose(),t.overlays.dispose()}for(;this.pieces.length<e;){let t=new op;this.pieces.push(t),this.scene.add(t.mesh.mesh,t.overlays.group)}}};function a1(i,e,t){let n=-1/0,r=1/0;for(let s=0;s<3;s++){let a=(i[s]-1e-5-e[s])/t[s],o=(i[s+3]+1e-5-e[s])/t[s];n=Math.max(n,Math.min(a,o)||n),r=Math.min(r,Math.max(a,o)||r)}return n<=r}function o1(i,e,t,n,r){let s=1/0,a=0,o=0,[l,c,h]=t,[d,u,p]=n;for(let b=0;b<e-1;b++)for(let m=0;m<e-1;m++){let g=3*(b*e+m);for(let v=0;v<2;v++){let M=v===0?g+3*e:g+3*e+3,x=v===0?g+3*e+3:g+3,E=i[g],w=i[g+1],y=i[g+2],A=i[M]-E,D=i[M+1]-w,R=i[M+2]-y,N=i[x]-E,F=i[x+1]-w,V=i[x+2]-y,P=u*V-p*F,G=p*N-d*V,W=d*F-u*N,O=A*P+D*G+R*W;if(O===0)continue;let Q=l-E,H=c-w,J=h-y,te=(Q*P+H*G+J*W)/O;if(te<-1e-9||te>1+1e-9)continue;let ve=H*R-J*D,Ee=J*A-Q*R,X=Q*D-H*A,re=(d*ve+u*Ee+p*X)/O;if(re<-1e-9||te+re>1+1e-9)continue;let me=(N*ve+F*Ee+V*X)/O;if(me>=s)continue;let Me=(b+(v===0?te+re:te))/(e-1),pe=(m+(v===0?re:te+re))/(e-1);r(l+me*d,c+me*u,h+me*p,Me,pe)&&([s,a,o]=[me,Me,pe])}}if(s===1/0)return null;let f=b=>Math.min(1,Math.max(0,b));return{u:f(a),v:f(o),distance:s}}function l1(){let i=document.createElement("canvas").getContext("webgl2"),e=i?.getExtension("WEBGL_debug_renderer_info"),t=e?String(i.getParameter(e.UNMASKED_RENDERER_WEBGL)):"";return i?.getExtension("WEBGL_lose_context")?.loseContext(),/swiftshader|llvmpipe|softpipe|software|basic render/i.test(t)}var HM=64;function c1(i,e,t,n,r,s){let a=i.getContext("2d");a.setTransform(n,0,0,n,0,0),a.clearRect(0,0,i.width,i.height);let o=lt[r],l=o?o.colour==="classes"?gr(r):mr(o):[],c=p=>o?p-p!==0?es:o.colour==="classes"||!s?l[p]??es:l[Math.round(255*Math.min(1,Math.max(0,(p-s.low)/(s.high-s.low))))]:js,{right:h,up:d,towards:u}=t.axes();for(let p of e){let f=t.span/Math.min(1,p.width/p.height),b=p.height/(2*f),m=[];for(let{mesh:g}of p.pieces){let v=g.side,M=g.position,x=Math.max(1,Math.ceil((v-1)/HM)),E=y=>{let A=[M[3*y]-t.target.x,M[3*y+1]-t.target.y,M[3*y+2]-t.target.z],D=R=>A[0]*R.x+A[1]*R.y+A[2]*R.z;return[p.x+p.width/2+b*D(h),p.y+p.height/2-b*D(d),D(u)]},w=Array.from({length:Math.ceil((v-1)/x)},(y,A)=>A*x);for(let y of w)for(let A of w){let D=Math.min(v-1,y+x),R=Math.min(v-1,A+x),[N,F,V,P]=[E(y*v+A),E(D*v+A),E(D*v+R),E(y*v+R)],G=(y+D>>1)*v+(A+R>>1);if(!g.covered[G])continue;let W=g.grid.planes,O=g.grid.stride,Q=Math.abs(W[3*O+G]*u.x+W[4*O+G]*u.y+W[5*O+G]*u.z);m.push({depth:N[2]+F[2]+V[2]+P[2],corners:[N[0],N[1],F[0],F[1],V[0],V[1],P[0],P[1]],colour:c(g.values[G]??NaN),lit:Q||.5})}}a.save(),a.beginPath(),a.rect(p.x,p.y,p.width,p.height),a.clip();for(let g of m.sort((v,M)=>v.depth-M.depth)){let v=.68+.32*g.lit;a.fillStyle=a.strokeStyle=On(g.colour.map(M=>Math.round(M*v))),a.beginPath(),a.moveTo(g.corners[0],g.corners[1]);for(let M=2;M<8;M+=2)a.lineTo(g.corners[M],g.corners[M+1]);a.closePath(),a.fill(),a.stroke()}for(let{overlays:g}of p.pieces)GM(a,g,(v,M,x)=>{let E=[v-t.target.x,M-t.target.y,x-t.target.z],w=y=>E[0]*y.x+E[1]*y.y+E[2]*y.z;return[p.x+p.width/2+b*w(h),p.y+p.height/2-b*w(d)]});a.restore()}}function GM(i,e,t){let{lines:n,points:r}=e.drawn;for(let{ends:s,colour:a,width:o,opacity:l}of n){i.strokeStyle=a,i.lineWidth=o,i.globalAlpha=l,i.beginPath();for(let c=0;c<s.length;c+=6)i.moveTo(...t(s[c],s[c+1],s[c+2])),i.lineTo(...t(s[c+3],s[c+4],s[c+5]));i.stroke()}i.globalAlpha=1,i.lineWidth=1.5,i.strokeStyle="#ffffff";for(let{places:s,tints:a}of r)for(let o=0;3*o<s.length;o++)i.fillStyle=On([0,1,2].map(l=>Math.round(255*a[4*o+l]))),i.beginPath(),i.arc(...t(s[3*o],s[3*o+1],s[3*o+2]),a[4*o+3]>1.5?6:4,0,7),i.fill(),i.stroke()}var WM=6,Mh=class{constructor(e){this.canvas=e;this.software=l1();let t=e.getContext("webgl2",{antialias:!this.software,alpha:!0,powerPreference:"high-performance"});this.renderer=t&&new Kc({canvas:e,context:t}),this.renderer?.setClearColor(0,0),this.renderer&&(this.renderer.autoClear=!1)}canvas;orbit=new co;cells=[];renderer;range=null;quantity="none";width=1;height=1;ratio=1;margin=0;covered=0;software;detail=1;get works(){return this.renderer!==null}resize(e,t,n){this.width=Math.max(1,e),this.height=Math.max(1,t),this.ratio=n,this.renderer?(this.renderer.setPixelRatio(this.pixels),this.renderer.setSize(this.width,this.height,!1)):(this.canvas.width=this.width*n,this.canvas.height=this.height*n),this.arrange()}economy(e){let t=this.software?e?.6:1.5:1;t!==this.detail&&(this.detail=t,this.resize(this.width,this.height,this.ratio))}get pixels(){return this.ratio*this.detail}layout(e,t=0){for(this.margin=t;this.cells.length>e;)this.cells.pop().resizePieces(0);for(;this.cells.length<e;)this.cells.push(new Sh);this.arrange()}arrange(){let e=this.cells.length,t=e>4?3:e>1?2:1,n=Math.ceil(e/t),r=e>1?Math.max(.6*this.width,this.width-this.margin):this.width,s=e>1?this.height-50:this.height;this.cells.forEach((a,o)=>{a.width=r/t,a.height=s/n,a.x=o%t*a.width,a.y=Math.floor(o/t)*a.height;for(let l of a.pieces)l.overlays.resize(a.width*this.pixels,a.height*this.pixels,this.pixels)})}style(e,t,n,r,s){let a=$M(e);this.range=t,this.quantity=e.quantity;let o=Kr(e,r);for(let l of this.cells)l.pieces.forEach((c,h)=>{let d=c.mesh.material.uniforms;lp(d.front.value,ah),lp(d.back.value,js),lp(d.undefinedColour.value,es),t&&d.range.value.set(t.low,t.high),d.contour.value=t&&e.contours?(t.high-t.low)/10:0,d.stripes.value=["none","zebra","isophotes","reflection","highlight"].indexOf(e.stripes),d.density.value=e.density,d.light.value.copy(a),d.curves.value=e.wireframe?30:e.curves?10:0,d.cut.value.set(...o),d.clipped.value=e.section&&e.clip,d.wire.value=e.wireframe,d.shade.value=e.stripes==="none"?1:.6,d.faded.value=(l.pieces.length>1&&h!==s,0),c.overlays.theme(n),c.overlays.resize(l.width*this.pixels,l.height*this.pixels,this.pixels)});this.orbit.chosen=this.works?e.projection:"orthographic"}draw(){let{renderer:e}=this;if(!e)return c1(this.canvas,this.cells,this.orbit,this.ratio,this.quantity,this.range);e.setScissorTest(!1),e.setViewport(0,0,this.width,this.height),e.clear(),e.setScissorTest(!0);let t=this.orbit.axes().towards;for(let n of this.cells){let r=this.height-n.y-n.height;e.setViewport(n.x,r,n.width,n.height),e.setScissor(n.x,r,n.width,n.height);for(let s of n.pieces)s.mesh.material.uniforms.towards.value.copy(t);e.render(n.scene,this.orbit.camera(n.width/n.height))}}zoomAt(e,t,n){let r=this.cells[Math.max(0,this.cellAt(t,n))];this.orbit.zoom(e,(t-r.x)/r.height-.5*r.width/r.height,(n-r.y)/r.height-.5,r.width/r.height)}pan(e,t){let{width:n,height:r}=this.cells[0];this.orbit.pan(e/r,t/r,n/r)}cellAt(e,t){return this.cells.findIndex(n=>e>=n.x&&e<n.x+n.width&&t>=n.y&&t<n.y+n.height)}ray(e,t,n){let r=this.cells[e],s=this.orbit.camera(r.width/r.height),a=(t-r.x)/r.width*2-1,o=1-(n-r.y)/r.height*2,l=new k(a,o,-1).unproject(s),h=new k(a,o,1).unproject(s).sub(l).normalize();return{origin:[l.x,l.y,l.z],direction:[h.x,h.y,h.z]}}project(e,t){let n=this.cells[e],r=new k(t[0],t[1],t[2]).project(this.orbit.camera(n.width/n.height));return{x:n.x+(r.x+1)*.5*n.width,y:n.y+(1-r.y)*.5*n.height,depth:r.z}}pick(e,t,n,r){let s=this.cellAt(e,t);if(s<0)return null;let{origin:a,direction:o}=this.ray(s,e,t),[l,c,h,d]=Kr(n,r),u=n.section&&n.clip,p=null;return this.cells[s].pieces.forEach((f,b)=>{let m=f.mesh.side,{surface:g}=f;if(!g||m<2||!a1(f.mesh.box,a,o))return;let[v,M,x,E]=Ji(g),w=(N,F)=>[v+(x-v)*N,M+(E-M)*F],y=(N,F,V,P,G)=>(!u||l*N+c*F+h*V<=d)&&gs(g,...w(P,G)),A=o1(f.mesh.position,m,a,o,y);if(!A||p&&A.distance>=p.distance)return;let[D,R]=w(A.u,A.v);p={u:D,v:R,distance:A.distance,cell:s,piece:b}}),p}pickCurve(e,t,n,r){let s=this.cellAt(e,t),a=null,o=r;for(let[l,{curve:c}]of s<0?[]:this.cells[s].pieces.entries()){let h=c.map(({point:d})=>this.project(s,qt(n,d)));for(let d=0;d+1<h.length;d++){let u=h[d],p=h[d+1],f=p.x-u.x,b=p.y-u.y,m=Math.min(1,Math.max(0,((e-u.x)*f+(t-u.y)*b)/(f*f+b*b||1))),g=Math.hypot(u.x+m*f-e,u.y+m*b-t);g<o&&([o,a]=[g,{cell:s,piece:l,u:c[d].t+m*(c[d+1].t-c[d].t),v:0}])}}return a}hides(e,t,n,r){let s=this.project(e,t),a=this.pick(s.x,s.y,n,r);if(!a)return!1;let{origin:o}=this.ray(e,s.x,s.y);return a.distance<Math.hypot(...t.map((l,c)=>l-o[c]))-.03}view(e,t,n,r){this.orbit.straight=e!=="iso",this.fit(t,n,r,xh[e])}fit(e,t,n,[r,s]=[this.orbit.azimuth,this.orbit.elevation]){let a=this.cells[0];if(!a)return;let o=new co;o.azimuth=r,o.elevation=s,o.chosen=this.orbit.projection;let{right:l,up:c}=o.axes(),h=a.width/a.height,d=this.cells.length>1,u=a.width<300?10:24,p=!d&&n>.3*a.width,f=1-2*(d||p?u:n+u)/a.width,b=-1+2*(d?u:62+Math.min(this.covered,.5*a.height))/a.height,m=-1+2*u/a.width,g=1-2*(p?Math.min(.3*a.height,150):d?u+22:u)/a.height,v=new k;for(let M=0;M<6;M++){let x=o.camera(h),[E,w,y,A]=[1/0,-1/0,1/0,-1/0],D=(N,F,V)=>{v.set(N,F,V).project(x),E=Math.min(E,v.x),w=Math.max(w,v.x),y=Math.min(y,v.y),A=Math.max(A,v.y)};for(let{pieces:N}of this.cells)for(let{mesh:F,overlays:V}of N){let P=F.position,G=3*Math.max(1,Math.floor(F.side/24));for(let W=0;W+2<P.length;W+=G)F.covered[W/3]&&XM(e,P[W],P[W+1],P[W+2])&&D(P[W],P[W+1],P[W+2]);for(let[W,O,Q]of[...V.netPoints,...V.curvePoints])Math.hypot(W,O,Q)<WM&&D(W,O,Q)}if(!(w>=E))break;let R=o.span/Math.min(1,h);o.target.addScaledVector(l,R*h*(.5*(E+w)-.5*(m+f))).addScaledVector(c,R*(.5*(y+A)-.5*(b+g))),o.span=Math.min(20,Math.max(.02,o.span*Math.max((w-E)/(f-m),(A-y)/(g-b))))}this.orbit.go(r,s,o.span,o.target,t)}async picture(e,t,n){let r={width:this.width,height:this.height,ratio:this.ratio,detail:this.detail};this.detail=this.software&&Math.max(e,t)<=4096?2:1,this.renderer?.setClearColor(n?new Ge().setStyle(n,"srgb-linear"):0,n?1:0),this.resize(e,t,1),this.draw();let s=document.createElement("canvas");return s.width=e,s.height=t,s.getContext("2d").drawImage(this.canvas,0,0,e,t),this.renderer?.setClearColor(0,0),this.detail=r.detail,this.resize(r.width,r.height,r.ratio),this.draw(),s}finish(){let e=this.renderer?.getContext();e?.readPixels(0,0,1,1,e.RGBA,e.UNSIGNED_BYTE,new Uint8Array(4))}dispose(){this.layout(0),this.renderer?.dispose()}};function $M(i){let e=i.lightAzimuth*Math.PI/180,t=i.lightElevation*Math.PI/180;return new k(Math.cos(t)*Math.cos(e),Math.cos(t)*Math.sin(e),Math.sin(t))}var XM=({half:[i,e,t]},n,r,s)=>Math.abs(n)<=i+.04&&Math.abs(r)<=e+.04&&Math.abs(s)<=t+.04;function lp(i,e){i.copy(s1(e))}var h1="quintrig:draft:",YM=3,wh=class{constructor(e){this.place=e;let t=Math.random().toString(36).slice(2,10);this.key=`${h1}${e}:${t}`,navigator.locks?.request(this.key,()=>new Promise(()=>{})).catch(()=>{})}place;key;offers=[];watch(e,t){let n=0,r=()=>this.keep(e.state);e.subscribe((s,a)=>{s.opened!==a.opened&&this.offer(e,t,s.source),!(s.model===a.model&&s.saved===a.saved&&s.source===a.source)&&(clearTimeout(n),s.model===s.saved?r():n=window.setTimeout(r,400))}),window.addEventListener("pagehide",r),this.offer(e,t)}async offer(e,t,n){for(let o of this.offers.splice(0))o();let{opened:r}=e.state,s=await this.left();if(e.state.opened!==r)return;let a=n===void 0?s:s.filter(o=>n&&o.source?.name===n.name);this.offers=a.slice(0,YM).map(o=>{let l=new Date(o.when).toLocaleString([],{dateStyle:"medium",timeStyle:"short"}),c=o.source?` (${o.source.name})`:"";return t.offer(`Unsaved work on “${o.model.name}”${c} from ${l} was kept.`,"Restore it",()=>{e.resume(o),this.keep(e.state)&&cp(o.key)},"Discard",()=>cp(o.key))})}keep({model:e,saved:t,source:n}){try{return e===t?localStorage.removeItem(this.key):localStorage.setItem(this.key,JSON.stringify({when:Date.now(),model:on(e),saved:on(t),source:n,library:ef()})),!0}catch{return!1}}async left(){let e=new Set((await navigator.locks?.query().catch(()=>null))?.held?.map(n=>n.name)??[]),t=[];for(let n of JM())if(!(!n.startsWith(`${h1}${this.place}:`)||n===this.key||e.has(n)))try{let{when:r,model:s,saved:a,source:o,library:l}=JSON.parse(localStorage.getItem(n));Ar(l??[]);let c=vt(s);t.push({key:n,when:r,model:c,saved:a?vt(a):{...c},source:o??null})}catch{cp(n)}return t.sort((n,r)=>r.when-n.when)}};function cp(i){localStorage.removeItem(i)}function JM(){try{return Object.keys(localStorage)}catch{return[]}}var ZM=16*2**20,KM=15e3,Ah=class{constructor(e,t,n,r,s,a){this.store=e;this.host=t;this.root=n;this.draw=r;this.size=s;this.ends=a;this.look()}store;host;root;draw;size;ends;known=[];formats=[];asked="";lost=!1;async look(){try{this.known=await this.host.list()}catch{this.known=[]}}async lookAtFormats(){let{state:e}=this.store,t=Ve(e).name,n=`${t}
${Wn(e.model)}`;if(n===this.asked)return!1;this.asked=n;try{this.formats=await this.host.formats(e.model,t)}catch{this.asked=""}return!0}openItems(){let e=this.known.map(t=>({label:t,act:()=>{this.load(t)}}));return[{label:"From this computer …",hint:"or drop a file on the picture",act:()=>this.choose()},...e.length?["In the folder",...e]:[]]}saveItems(){let{model:e,source:t}=this.store.state;return[...this.host.kind==="live"?[{label:t?`Save ${t.name}`:"Save …",hint:"Ctrl S",act:()=>{this.save()}},{label:"Save as …",act:()=>{this.saveAs()}}]:[],{label:"Download TOML",act:()=>$n(`${Xn(e.name)}.toml`,Wn(e))},{label:"Download JSON",act:()=>$n(`${Xn(e.name)}.json`,`${JSON.stringify(on(e),null,1)}
`,"application/json")}]}exportItems(){return this.host.kind!=="live"?[{label:"Exports need the live studio",hint:"quintrig view MODEL",disabled:!0,act:()=>{}}]:this.formats.length?[...new Set(this.formats.map(t=>t.family))].flatMap(t=>[t,...this.formats.filter(n=>n.family===t).map(n=>({label:n.label,hint:n.suffix,...n.reason?{disabled:!0,reason:n.reason}:{},act:()=>{this.guard(()=>this.export(n))}}))]):[{label:"Asking what this model can be written as …",disabled:!0,act:()=>{}}]}async export(e){let{model:t,settings:n}=this.store.state,r=Ve(this.store.state).name,s=this.ends(),a=lt[n.quantity],o=a?`${a.name}${s?`, ${He(s[0])} to ${He(s[1])} ${Ho(a,t.unit)}`:""}`.trim():"none",l=e.takes?await qm(this.root(),e.label,t.unit,e.takes==="tolerance"?"":o):{tolerance:null};if(!l)return;this.store.set({message:{kind:"note",text:`Writing ${e.label} …`,lines:[]}});let c={model:t,patch:r,colour:a?n.quantity:"",low:s?.[0]??null,high:s?.[1]??null,...l},{name:h,notes:d}=await this.host.export(c,e);this.store.set({message:{kind:"note",text:`Exported ${h}`,lines:d}})}async start(e){await this.leave()&&this.store.open(e,null)}async load(e){await this.guard(async()=>{let{model:t,source:n}=await this.host.load(e);await this.leave()&&this.store.open(t,n)})}choose(){let e=T("input",{type:"file",accept:".toml,.json"});e.addEventListener("change",()=>{let t=e.files?.[0];t&&this.take(t)}),e.click()}async take(e){await this.guard(async()=>{if(e.size>ZM)throw new Error(`${e.name}: expected at most 16 MB, found ${Math.round(e.size/2**20)} MB; is this a model?`);let t=await this.host.read(e.name,await e.text());await this.leave()&&this.store.open(t,null)})}receive(e){e.addEventListener("dragover",t=>{t.preventDefault(),e.classList.add("receiving")}),e.addEventListener("dragleave",()=>e.classList.remove("receiving")),e.addEventListener("drop",t=>{t.preventDefault(),e.classList.remove("receiving");let n=t.dataTransfer?.files[0];n&&this.take(n)})}async save(){let{source:e}=this.store.state;e?await this.write(e.name,e.tag):await this.saveAs()}async saveAs(){let e=this.host.kind==="live"?await Bm(this.root(),"Save as",`${Xn(this.store.state.model.name)}.toml`):this.store.state.model.name;e&&await this.write(e,"")}async picture(){let[e,t]=this.size(),n=await Vm(this.root(),2*e,2*t);if(!n)return;(await this.draw(n)).toBlob(s=>s&&$n(`${Xn(this.store.state.model.name)}.png`,s),"image/png")}async write(e,t){let{model:n,opened:r}=this.store.state;try{let s=await this.host.save(e,n,t);this.store.written(r,n,s),this.store.set({message:{kind:"note",text:s?`Saved ${s.name}`:"Downloaded"}}),this.look()}catch(s){if(!(s instanceof ma))return this.fail(s);let a=await Zn(this.root(),"The file is another one now",[T("p",{},s.message)],[["other","Save under another name"],["over","Overwrite it"],["cancel","Cancel"]]);a==="over"&&await this.write(e,null),a==="other"&&await this.saveAs()}}async leave(){let{model:e,saved:t}=this.store.state;return e===t?!0:await Zn(this.root(),"Leave this model?",[T("p",{},`The changes to “${e.name}” are not saved.`)],[["stay","Go on working"],["leave","Leave them"]])==="leave"}async guard(e){try{await e()}catch(t){this.fail(t)}}watch(){let e=()=>{this.connected()};window.addEventListener("focus",e),setInterval(()=>document.visibilityState==="visible"&&e(),KM)}async connected(){try{await this.host.list(),this.lost&&this.store.set({message:{kind:"note",text:"Connected to the studio's server again"}}),this.lost&&this.look(),this.lost=!1}catch(e){e instanceof Nr&&!this.lost&&this.fail(e)}}fail(e){let{message:t}=e;if(!(e instanceof Nr))return this.store.set({message:{kind:"error",text:t}});this.lost=!0;let{source:n}=this.store.state;this.store.set({message:{kind:"error",text:t,lines:[`To reconnect: ${e.stopped?`run “quintrig view ${n?.name??"MODEL"}” in a terminal, `:""}open the address that quintrig view printed in this browser, then try again here.`,"Or download the model, and open it in the new tab."],actions:[{label:"Download the model",act:()=>this.download()},{label:"Try again",act:()=>{this.again()}}]}})}async again(){this.store.set({message:null}),await this.guard(async()=>{await this.host.list()}),await this.connected()}download(){let{model:e,source:t}=this.store.state;$n(t?.name.replace(/\.\w+$/,".toml")??`${Xn(e.name)}.toml`,Wn(e))}};var jM={1:"iso",2:"top",3:"side",4:"back",5:"front",6:"bottom"},QM={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]},ew="input:not([type=checkbox], [type=range], [type=radio]), select, textarea, [contenteditable]",tw="input[type=range], input[type=radio], [role=radio], .knob";function u1(i,e){let{store:t,stage:n}=e,{settings:r}=t.state,s=i.composedPath()[0];if(!(s instanceof HTMLElement))return!1;if(i.ctrlKey||i.metaKey){let l=i.key.toLowerCase();if(l==="s")e.files.save();else if(l==="o")e.files.choose();else{if(Fr(s))return!1;if(l==="z"&&i.shiftKey)t.redo();else if(l==="z")t.undo();else if(l==="y")t.redo();else return!1}return!0}if(i.altKey||s.matches(ew))return!1;let a=jM[i.key],o=QM[i.key];if(o&&s.matches(tw))return!1;if(a)e.view(a);else if(o)nw(o,i.shiftKey,e);else if(i.key==="+"||i.key==="=")n.orbit.zoom(.85);else if(i.key==="-")n.orbit.zoom(1/.85);else switch(i.key.length===1?i.key.toLowerCase():i.key){case"p":{let l=n.orbit.projection==="perspective"?"orthographic":"perspective";n.orbit.straight=!1,t.setting({projection:l});break}case"f":e.fit();break;case"n":t.setting({net:!r.net});break;case"i":t.setting({curves:!r.curves});break;case"w":t.setting({wireframe:!r.wireframe});break;case"z":t.setting({stripes:r.stripes==="zebra"?"none":"zebra"});break;case"c":{let l=["off","before","sets","kept"];t.set({compare:l[(l.indexOf(t.state.compare)+1)%l.length]});break}case"[":case"]":iw(t,i.key==="]"?1:-1);break;case"Escape":t.set({selected:null,message:null});break;case"?":e.help();break;case"Enter":{if(!s.matches("canvas"))return!1;let l=n.cells[0],c=n.pick(l.x+l.width/2,l.y+l.height/2,r,e.frame());c&&t.set({pins:[...t.state.pins,{patch:c.piece,u:Math.round(c.u*1e4)/1e4,v:Math.round(c.v*1e4)/1e4}]});break}default:return!1}return e.redraw(),!0}function nw([i,e],t,n){let{store:r,stage:s}=n;if(!r.state.selected){t?s.orbit.pan(-.03*i,.03*e):s.orbit.turn(-12*i,-12*e);return}let a=s.orbit.axes(),o=i?a.right:a.up,l=i||e,c=[o.x,o.y,o.z],h=c.map(Math.abs).indexOf(Math.max(...c.map(Math.abs))),d=r.state.settings.snapStep*(t?10:1)*l*Math.sign(c[h]);Jg(r,[0,1,2].map(u=>u===h?d:0)),r.settle()}function iw(i,e){let t=Ve(i.state),n=mn(t).filter(s=>!s.mirrored);if(!n.length)return;let r=n.findIndex(s=>s.id===i.state.selected);i.set({selected:n[(r+e+n.length)%n.length].id})}function d1(i,e){let{planes:t,stride:n,count:r,nu:s,nv:a}=e.grid,o=0,l=-1;for(let p=0;p<r;p++){let f=Math.abs(t[ze.mean*n+p])+t[ze.halfDifference*n+p];f>o&&f<1/0&&e.covered[p]&&(o=f,l=p)}if(l<0||!(o*e.grid.size>1e-9))return null;let c=e.grid.u[Math.floor(l/a)],h=e.grid.v[l%a],d=[],u=p=>Math.min(1,Math.max(0,p));for(let p=.5/(s-1);p>1e-6;p*=.5){let f=[-1,0,1].map(v=>v*p),b=f.map(v=>u(c+v)),m=f.map(v=>u(h+v)),g=Yn(i,b,m,!1,["k1","k2","point"]);for(let v=0;v<9;v++){if(!gs(i,b[Math.floor(v/3)],m[v%3]))continue;let M=Math.max(Math.abs(g.k1[v]),Math.abs(g.k2[v]));(M>=o||v===4&&!d.length)&&(o=Math.max(o,M),c=b[Math.floor(v/3)],h=m[v%3],d=Array.from(g.point.subarray(3*v,3*v+3)))}}return{u:c,v:h,point:d,radius:1/o}}var rw=9,sw=20,aw=40,Eh=36,ow=361,lw=[1,.7,.5,.35,.25],Th=class{constructor(e,t){this.stage=e;this.fail=t}stage;fail;cost=0;side=0;coarse=75;drawable=1/0;tooth=0;get meshes(){return this.stage.cells.flatMap(e=>e.pieces.filter(t=>t.surface).map(t=>t.mesh))}evaluate(e,{settings:t,moving:n},r){this.side=this.points(t,n,e.length);let s=performance.now(),a=0;e.forEach(({model:l},c)=>{let h=this.stage.cells[c];h.resizePieces(l.patches.length),l.patches.forEach((d,u)=>a+=this.piece(h.pieces[u],d,t,r))});let o=performance.now()-s;return a&&this.pace(o,a,t.resolution),o}waited(e){e>aw?this.drawable=Math.max(Eh,.75*this.side):e<sw&&(this.drawable*=1.06)}decorate(e,t,n){let r=t.settings.combs==="off"?0:Gg(this.meshes,t.settings,n),s=this.stage.cells.flatMap(a=>a.pieces.map(o=>o.curve)).filter(a=>a.length);this.tooth=t.settings.comb&&s.length?Wg(s,t.settings.combScale,n):0,e.forEach(({editable:a},o)=>this.overlay(this.stage.cells[o],t,n,a,r))}sharpest(){return this.stage.cells.flatMap(({pieces:e},t)=>{let r=e.map(s=>s.surface?d1(s.surface,s.mesh):null).filter(s=>s!==null).sort((s,a)=>s.radius-a.radius)[0];return r?[{cell:t,at:r}]:[]})}piece(e,t,n,r){let{side:s}=this,a=e.patch===t&&e.side===s&&e.frame===r;if(a&&e.quantity!==n.quantity&&e.mesh.paint(n.quantity),e.quantity=n.quantity,a)return 0;try{if(nt(t))return this.curve(e,t,r);e.patch!==t&&(e.surface=Nn(t)),e.curve.length&&e.overlays.curve(e.curve=[],r,0)}catch(o){return this.fail(o.message),0}return e.patch=t,e.side=s,e.frame=r,e.lines=e.net="",e.mesh.update(e.surface,s,n.quantity,r),s*s}curve(e,t,n){return e.curve=St(t).sample(ow),Object.assign(e,{surface:null,patch:t,side:this.side,frame:n,lines:"",net:""}),e.mesh.clear(),e.overlays.edge([],n),0}overlay(e,t,n,r,s){e.pieces.forEach((a,o)=>{if(!a.surface&&!a.curve.length||!a.patch)return;let l=t.settings.net,c=l&&r&&o===t.patch,h=a.surface?cw(t.settings,s):`curve ${this.tooth}`;a.lines!==h&&!a.surface?a.overlays.curve(a.curve,n,this.tooth):a.lines!==h&&a.overlays.update(a.mesh,t.settings,n,s),a.lines=h;let d=`${l} ${c} ${c?t.selected:""} ${t.moving}`;if(a.net!==d){if(a.net=d,!a.surface)return a.overlays.net(l?Sm(a.patch):[],c?mn(a.patch):[],t.selected,n);a.overlays.net(l?Mm(a.patch,a.surface):[],c?Su(a.patch,a.surface):[],t.selected,n),a.overlays.edge(t.moving?[]:hw(a.patch,a.surface),n)}})}points(e,t,n){if(t){let r=Math.min(this.coarse,this.drawable),s=lw.map(a=>Math.max(Eh,Math.round(a*e.resolution)));return Math.min(e.resolution,s.find(a=>a<=r)??Eh)}return lt[e.quantity]?.colour==="classes"&&n===1?2*e.resolution:e.resolution}pace(e,t,n){this.cost=e;let r=e/t,s=this.stage.cells.reduce((o,l)=>o+l.pieces.length,0),a=Math.sqrt(rw/r/Math.max(1,s));this.coarse=a>=n?n:Math.max(Eh,Math.min(n,Math.round(a)))}},cw=(i,e)=>JSON.stringify([e,i.directions,i.normals,i.combs,i.zeroK,i.zeroH,i.section,i.section&&[i.sectionAzimuth,i.sectionTilt,i.sectionAt]]),p1=new WeakMap;function hw(i,e){if(i.kind!=="developable")return[];let t=p1.get(e);if(t)return t;let n=Co(e).map(({u:r,v:s})=>{let{point:a}=Yn(e,r,s,!0,["point"]);return r.map((o,l)=>Array.from(a.subarray(3*l,3*l+3)))});return p1.set(e,n),n}var Ch=class{constructor(e,t){this.stage=e;this.redraw=t}stage;redraw;down=new Map;busy=!1;touch(e,t){return this.down.set(e,t),this.busy||=this.down.size>1,this.busy}move(e,t){if(!this.busy||!this.down.has(e))return!1;let n=this.span();this.down.set(e,t);let r=this.span();return n&&r&&(this.stage.zoomAt(n.apart/r.apart,n.middle.x,n.middle.y),this.stage.pan(r.middle.x-n.middle.x,r.middle.y-n.middle.y),this.redraw()),!0}lift(e){let t=this.down.delete(e)&&this.busy;return this.down.size||(this.busy=!1),t}span(){let[e,t]=[...this.down.values()];return!e||!t?null:{apart:Math.max(8,Math.hypot(e.x-t.x,e.y-t.y)),middle:{x:.5*(e.x+t.x),y:.5*(e.y+t.y)}}}};var uo=11,uw=24;function f1(i,e){let{store:t,stage:n}=e,r=null,s=!1,a=new Ch(n,()=>e.redraw()),o=v=>{let M=i.getBoundingClientRect();return{x:v.clientX-M.left,y:v.clientY-M.top}},l=()=>mn(Ve(t.state)),c=(v,M,x)=>{let E=n.cellAt(v,M),w=t.state.settings.net&&l().find(A=>A.id===t.state.selected);if(!w||w.along||E!==Qo(t.state,n.cells.length))return null;let y=zm(el(n,E,qt(e.frame(),w.position),h(w)),v,M,x);return y&&{handle:w,axes:y.axes}},h=v=>v.free.map((M,x)=>M&&!t.state.settings.locks[x]),d=(v,M,x)=>{let E=n.cellAt(v,M),{settings:w}=t.state;if(E<0||!w.section)return null;let y=jr(w,e.frame()),A=D=>{let R=n.project(E,y[D]);return Math.hypot(R.x-v,R.y-M)};return A("tilt")<x?"tilt":A("move")<x?"move":null},u=(v,M,x)=>{let E=n.cellAt(v,M);if(E<0||!t.state.settings.net||!e.editable(E))return null;let w=null,y=x;for(let A of l()){let D=n.project(E,qt(e.frame(),A.position)),R=Math.hypot(D.x-v,D.y-M)-(A.id===t.state.selected?2:0);R<y&&(y=R,w=A)}return w};i.addEventListener("pointerdown",v=>{let{x:M,y:x}=o(v),E=v.pointerType==="touch",w=v.button!==0||v.shiftKey,y=E?uw:uo;if(pw(i,v.pointerId),i.focus({preventScroll:!0,focusVisible:!1}),v.preventDefault(),E&&a.touch(v.pointerId,{x:M,y:x}))return r=null,t.settle();let A=w?null:d(M,x,y),D=w||A?null:u(M,x,y),R=w||A||D?null:c(M,x,.6*y),N=D??R?.handle??null,F=n.cellAt(M,x);r={kind:w?"pan":A?"section":N?"move":"turn",cell:F,handle:N,grip:A,axes:R?.axes??null,settings:t.state.settings,from:F<0?null:n.ray(F,M,x),x:M,y:x,far:0},N&&t.set({selected:N.id,hover:null})}),i.addEventListener("pointermove",v=>{let{x:M,y:x}=o(v);if(a.move(v.pointerId,{x:M,y:x}))return;if(!r){if(i.classList.toggle("grab",u(M,x,uo)!==null||d(M,x,uo)!==null||c(M,x,.6*uo)!==null),s||v.pointerType==="touch")return;s=!0,requestAnimationFrame(()=>{s=!1,r||b(M,x)});return}let E=M-r.x,w=x-r.y;r.far+=Math.abs(E)+Math.abs(w),r.kind==="turn"?n.orbit.turn(E,w):r.kind==="pan"?n.pan(E,w):r.kind==="section"?m(r,M,x):r.far>2&&g(r,M,x,v.altKey),r.x=M,r.y=x,(r.kind==="turn"||r.kind==="pan")&&e.redraw()});let p=v=>{if(a.lift(v.pointerId)||!r)return;let M=r;if(r=null,t.settle(),v.type==="pointercancel"||M.far>4||M.kind!=="turn"||v.button!==0)return;let x=f(M.x,M.y);if(x){let E=x.piece===t.state.patch?t.state.selected:null;t.set({hover:null,patch:x.piece,selected:E,pins:[...t.state.pins,{patch:x.piece,u:Rh(x.u),v:Rh(x.v)}]})}else t.set({selected:null})};i.addEventListener("pointerup",p),i.addEventListener("pointercancel",p),i.addEventListener("pointerleave",()=>{!r&&t.state.hover&&t.set({hover:null})}),i.addEventListener("contextmenu",v=>v.preventDefault()),i.addEventListener("dblclick",()=>{e.fit()}),i.addEventListener("wheel",v=>{if(!e.ownsWheel()&&!v.ctrlKey)return;v.preventDefault();let{x:M,y:x}=o(v);n.zoomAt(Math.exp(Math.max(-60,Math.min(60,v.deltaY*(v.deltaMode?16:1)))*.0022),M,x),e.redraw()},{passive:!1});function f(v,M){return n.pickCurve(v,M,e.frame(),uo)??n.pick(v,M,t.state.settings,e.frame())}function b(v,M){let x=f(v,M);x?t.set({hover:{patch:x.piece,u:Rh(x.u),v:Rh(x.v),x:v,y:M,cell:x.cell}}):t.state.hover&&t.set({hover:null})}function m({grip:v,settings:M,from:x,cell:E},w,y){let A=e.frame(),D=jr(M,A)[v],R=n.ray(E,w,y),N=v==="move"?Wo(D,Ks(M),x,R):um(Math.hypot(...D),R,D);t.setting(Ug(v,N,M,A))}function g({handle:v,from:M,cell:x,axes:E},w,y,A){if(!v||!M||!l().some(J=>J.id===v.id))return;let{settings:D}=t.state,R=e.frame(),N=qt(R,v.position),F=n.ray(x,w,y),{towards:V}=n.orbit.axes(),P=E?[0,1,2].map(J=>E.includes(J)):h(v),G=[V.x,V.y,V.z],W=v.along?{line:v.along}:dm(P,A?G:v.plane,G),O=Lm(R,pm(W,N,M,F)),Q=D.snap?D.snapStep:10**Math.floor(Math.log10(Au(n,x,N)/R.scale)),H=v.along?dw(v.along,O,Q):fm(W,v.position,O,Q,D.snap);t.editPatch(Xo(Ve(t.state),v,H),`drag ${v.id}`)}}function dw(i,e,t){let n=s=>s.reduce((a,o,l)=>a+o*i[l],0),r=(-n(e)-Math.round(-n(e)/t)*t)/n(i);return e.map((s,a)=>s+r*i[a])}var Rh=i=>Math.round(i*1e4)/1e4,m1=()=>matchMedia("(prefers-reduced-motion: reduce)").matches;function pw(i,e){try{i.setPointerCapture(e)}catch{}}function g1(i,e){let t=Ve(i);if(e&&hs(e).size===0)return"A single point: it has no size, no tangent plane and no curvature";let n=pn(t),r=wi(t).find((l,c)=>!as(l,n[c])),s=t.unchecked_basis===!0?of(Vn(t))[0]:void 0;if(s)return`The functions of the basis ${s.name} do not sum to 1 (off by ${He(s.offSum.by,3)} ${s.offSum.where}): the ${nt(t)?"curve":"surface"} moves with the origin`;if(r)return`Shape parameters outside ${os(r).replaceAll("-","−")}: the convex-hull property is lost`;if(t.trim?.length)return"A trimmed face: meshes and CAD files take the whole of its surface";if(t.kind!=="developable"||i.moving||!e)return"";let a=Co(e);return a.length?`The edge of regression (magenta) lies inside the strip for u = ${a.map(({u:l})=>`${l[0].toFixed(3)} to ${l.at(-1).toFixed(3)}`).join(", ")}: the surface is singular there`:""}var b1=160,ts=class{constructor(e,t,n){this.container=e;this.host=t;let r={...Em(),...n.quantity?{quantity:n.quantity}:{}};this.store=new Jo({model:n.model,saved:n.model,source:n.source,patch:0,selected:null,settings:r,compare:"off",kept:[],pins:[],hover:null,canUndo:!1,canRedo:!1,moving:!1,message:null,opened:1});let{store:s}=this;this.stage=new Mh(this.canvas),this.painter=new Th(this.stage,l=>this.status.warn(l)),this.files=new Ah(s,t,()=>this.root,l=>this.picture(l),()=>[this.centre.clientWidth,this.centre.clientHeight],()=>this.range&&[this.range.low,this.range.high]),this.bar=new gh(s,this.files,()=>this.switchTheme(),()=>{Iu(this.root)},()=>this.root.classList.toggle("with-left"),t.kind!=="live"),this.model=new fh(s),this.inspector=new sh(s),this.probe=new sl(s,()=>this.plan()),this.status=new mh(s),this.hud=new al(s,this.stage,{fit:()=>this.fit(),view:l=>this.view(l)}),this.centre.append(this.hud.element,this.legend.element),this.root=T("div",{class:`studio ${t.kind}`},this.bar.element,this.model.element,T("main",{class:"centre"},this.status.banner,this.centre,this.probe.element),this.inspector.element,this.status.element),e.append(this.root),this.drafts=new wh(t.place),f1(this.canvas,{store:s,stage:this.stage,frame:()=>this.frame,fit:()=>this.fit(),editable:l=>jo(s.state)[l]?.editable??!1,redraw:()=>this.plan(),ownsWheel:()=>t.kind==="live"||this.canvas.matches(":focus")}),(t.kind==="live"?document:this.root).addEventListener("keydown",l=>{!(l instanceof KeyboardEvent)||this.root.querySelector("dialog[open]")||u1(l,{store:s,stage:this.stage,files:this.files,frame:()=>this.frame,fit:()=>this.fit(),view:c=>this.view(c),redraw:()=>this.plan(),help:()=>{Iu(this.root)}})&&l.preventDefault()}),this.files.receive(this.root),this.canvas.addEventListener("webglcontextrestored",()=>this.plan(!0)),new ResizeObserver(()=>{this.resize(),this.hurry()}).observe(this.centre),new ResizeObserver(()=>{this.stage.covered=Math.max(0,this.probe.element.offsetHeight-(this.root.querySelector(".centre").clientHeight-this.centre.clientHeight)),this.centre.style.setProperty("--covered",`${this.stage.covered}px`)}).observe(this.probe.element),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>this.plan(!0)),s.subscribe((l,c)=>this.changed(l,c,n)),this.stage.works||this.status.warn("This browser has no WebGL: you see still pictures. Everything else works."),this.resize(),this.plan(!0),t.kind!=="notebook"&&this.drafts.watch(s,this.status),t.kind==="live"&&this.files.watch()}container;host;store;root;stage;canvas=T("canvas",{class:"view",tabindex:0,role:"application","aria-label":"The surface. Arrow keys turn it; ? lists all keys."});centre=T("div",{class:"picture"},this.canvas);legend=new lh;hud;bar;inspector;model;probe;status;files;drafts;frame=Im;range=null;sharp=[];painter;surfaces=0;planned=0;shownAt=0;settling=0;dark=!1;stale=!0;refit=!0;fitAfter=!1;fresh=!0;flat=!1;from=null;changed(e,t,n){e.model!==t.model&&(n.onModel?.(e.model),(e.model.patches.some((s,a)=>s.kind!==t.model.patches[a]?.kind)||e.model.patches.length!==t.model.patches.length)&&(this.refit=this.fresh=!0)),e.opened!==t.opened&&(this.refit=this.fresh=!0);let r=t.compare!==e.compare;e.hover!==t.hover&&e.model===t.model&&e.settings===t.settings&&this.hud.refresh(e,this.frame,this.sharp),(e.model!==t.model||e.settings!==t.settings||e.patch!==t.patch||r||e.kept!==t.kept||e.saved!==t.saved||e.moving!==t.moving||e.selected!==t.selected)&&this.plan(!0),(e.message!==t.message||e.pins!==t.pins)&&this.plan()}plan(e=!1){if(this.stale||=e,this.planned)return;let t=performance.now();this.planned=requestAnimationFrame(n=>{this.planned=0,this.store.state.moving&&this.painter.waited(performance.now()-t),this.show(n)})}hurry(){this.planned&&(cancelAnimationFrame(this.planned),this.planned=0,this.show(performance.now()))}show(e){let t=this.store.state.moving||e-this.shownAt<b1;this.shownAt=e,this.stage.economy(t),clearTimeout(this.settling),t&&this.stage.software&&(this.settling=window.setTimeout(()=>this.plan(),b1+40));let n=this.stage.orbit.step(e),r=performance.now();this.surfaces=0,this.stale&&(this.stale=!1,this.work());let s=performance.now();this.stage.draw(),this.hud.refresh(this.store.state,this.frame,this.sharp),this.root.dispatchEvent(new CustomEvent("drawn",{detail:{start:r,surfaces:this.surfaces,evaluated:s-r,drawn:performance.now()-s}})),n&&this.plan()}work(){let{state:e}=this.store,{settings:t}=e;this.dark=t.theme==="dark"||t.theme==="auto"&&this.darkAround(),this.root.dataset.theme=this.dark?"dark":"light";let n=jo(this.store.state);this.stage.cells.length!==n.length&&(this.fitAfter=!0),this.stage.layout(n.length,this.margin()),this.refit&&this.reframe(n),this.surfaces=this.painter.evaluate(n,e,this.frame);let{meshes:r}=this.painter,s=lt[t.quantity];this.range=s&&r.length&&s.colour!=="classes"?e1(r,s,t):null;let a=Ve(e);e.model.patches.every(nt)?this.legend.element.hidden=!0:s?this.range?this.legend.real(s.key,this.range,e.model.unit,this.dark):this.legend.classes(s.key,r.map(l=>l.counts)):this.legend.plain(t.stripes!=="none"),this.stage.style(t,this.range,this.dark,this.frame,e.patch),this.painter.decorate(n,e,this.frame),this.fitAfter&&this.from?this.stage.view(this.from,this.frame,!0,this.margin()):this.fitAfter&&this.stage.fit(this.frame,!0,this.margin()),this.from=null,this.fitAfter=!1,this.sharp=t.minRadius&&!e.moving?this.painter.sharpest():[],this.bar.refresh(e),this.inspector.refresh(e,this.dark),this.model.refresh(e),this.hud.labels(n.map(l=>l.label),e);let o=this.stage.cells[0]?.pieces[e.patch]?.surface??null;this.status.refresh(e,{side:this.painter.side,cost:this.painter.cost,singular:r.reduce((l,c)=>l+c.singular,0),points:r.reduce((l,c)=>l+c.places,0),sharp:this.sharp[0]?.at??null,surface:o,curve:nt(a)?St(a):null,warning:g1(e,o)})}reframe(e){this.refit=!1;let t=Pm(e);if(!t)return;this.frame=Nm(t.low,t.high);let n=e.every(({model:r})=>r.patches.every(s=>nt(s)&&St(s).flat));this.fresh&&(n||this.flat)&&(this.from=n?"top":"iso"),[this.fresh,this.flat]=[!1,n],this.inspector.sectionBox(t),this.store.setting({sectionAt:0,snapStep:10**Math.round(Math.log10(Math.max(2/this.frame.scale,1e-30)/100))}),this.fitAfter=!0}margin(){return this.legend.element.offsetWidth+10}view(e){this.stage.view(e,this.frame,m1(),this.margin()),this.plan()}fit(){this.refit=!0,this.plan(!0)}resize(){let{clientWidth:e,clientHeight:t}=this.centre;!e||!t||(this.stage.resize(e,t,Math.min(2,devicePixelRatio||1)),this.fitAfter||=!this.stage.orbit.moved,this.plan(!0))}darkAround(){return this.host.kind==="notebook"&&document.body.dataset.jpThemeLight?document.body.dataset.jpThemeLight==="false":matchMedia("(prefers-color-scheme: dark)").matches&&(this.host.kind==="live"||getComputedStyle(document.documentElement).colorScheme.includes("dark"))}switchTheme(){this.store.setting({theme:this.dark?"light":"dark"})}async picture(e){let t=getComputedStyle(this.root),n=e.background==="white"?"#ffffff":e.background==="theme"?t.getPropertyValue("--ground-flat").trim():null,r=await this.stage.picture(e.width,e.height,n),{state:s}=this.store;return Kg(r,e,s,this.range,this.stage.cells,jo(this.store.state).map(a=>a.label),this.dark&&e.background==="theme")}locate(e){let{state:t}=this.store,n=t.model.patches[t.patch],r=jr(t.settings,this.frame),s=mn(n).find(l=>l.id===e);if(!s&&e!=="move"&&e!=="tilt")return null;let a=this.stage.project(0,s?qt(this.frame,s.position):r[e]),o=this.canvas.getBoundingClientRect();return{x:o.left+a.x,y:o.top+a.y}}receive(e){this.store.open(e,null)}dispose(){cancelAnimationFrame(this.planned),clearTimeout(this.settling),this.stage.dispose(),this.container.replaceChildren()}};function Ph(i){let{model:e,saved:t}=i.state;if(e.patches.every(Ir))return;let n={...e,patches:e.patches.map(r=>Ir(r)?r:{...r})};i.set({model:n,saved:t===e?n:t})}var y1=`/* One sheet for the whole studio, inside a shadow root. Lengths in px; colours as variables, one set a theme. */
:host { all: initial; display: block; height: 100%; contain: content; }
.place { height: 100%; container-type: inline-size; }
* { box-sizing: border-box; }
[hidden] { display: none !important; }

.studio {
  --accent: #0f6e84; --accent-soft: #d9edf1; --accent-ink: #ffffff;
  --ink: #1b222b; --ink-2: #55606e; --ink-3: #626d7a;
  --panel: #fbfbfa; --line: #dfe2e4; --line-2: #c3c9ce; --field: #ffffff; --hover: #eef1f2;
  --ground: radial-gradient(120% 90% at 50% 32%, #ffffff 0%, #f2f4f5 58%, #e3e7ea 100%); --ground-flat: #f4f6f7;
  --glass: rgb(255 255 255 / 82%); --shadow: 0 1px 2px rgb(20 30 40 / 8%), 0 6px 24px rgb(20 30 40 / 10%);
  --warn: #8a4b00; --warn-soft: #fdf0dc; --error: #a51d2d; --error-soft: #fbe5e7;
  --x: #b3261e; --y: #1b7f3b; --z: #2456b8;
  display: grid; --bar: 46px; grid-template: "bar bar bar" 46px "left centre right" minmax(0, 1fr) "status status status" 26px / 236px minmax(0, 1fr) 296px;
  height: 100%; color: var(--ink); background: var(--panel);
  font: 12.5px/1.45 Inter, "Segoe UI", "Helvetica Neue", Arial, system-ui, sans-serif; font-variant-numeric: tabular-nums;
  -webkit-font-smoothing: antialiased; position: relative; overflow: hidden; accent-color: var(--accent);
}
.studio[data-theme="dark"] {
  --accent: #4fb8cf; --accent-soft: #17414c; --accent-ink: #06222a;
  --ink: #e6eaee; --ink-2: #a9b3be; --ink-3: #95a0ac;
  --panel: #1a1f25; --line: #2c333b; --line-2: #46505b; --field: #12161b; --hover: #262d35;
  --ground: radial-gradient(120% 90% at 50% 32%, #333c46 0%, #222931 55%, #161b20 100%); --ground-flat: #262d35;
  --glass: rgb(26 31 37 / 82%); --shadow: 0 1px 2px rgb(0 0 0 / 40%), 0 8px 28px rgb(0 0 0 / 35%);
  --warn: #ffc474; --warn-soft: #3d2c12; --error: #ff9aa5; --error-soft: #43191f;
  --x: #ff8a80; --y: #7ddf9b; --z: #8fb4ff;
  color-scheme: dark;
}
.studio :focus-visible { outline: 2px solid var(--accent); outline-offset: 1px; }
.studio.receiving::after { content: "Drop a model file (.toml or .json)"; position: absolute; inset: 8px; display: grid; place-items: center; font-size: 18px; border: 2px dashed var(--accent); border-radius: 10px; background: var(--glass); z-index: 30; }
button, input, select { font: inherit; color: inherit; }
.spacer { flex: 1; }
.hint { margin: 0; color: var(--ink-3); font-size: 11.5px; }
.caption { color: var(--ink-2); }
.icon { width: 16px; height: 16px; fill: none; stroke: currentcolor; stroke-width: 1.4; stroke-linecap: round; stroke-linejoin: round; flex: none; }
.math { font-family: "STIX Two Text", "Cambria Math", Cambria, "Liberation Serif", "Times New Roman", serif; font-size: 1.12em; white-space: nowrap; }
.math .roman { font-style: normal; }
.math sub, .math sup { font-size: 0.68em; line-height: 0; font-style: normal; }
.unit { color: var(--ink-3); font-size: 0.88em; margin-left: 0.35em; font-weight: 400; }

/* Bar */
.bar { grid-area: bar; display: flex; align-items: center; gap: 8px; padding: 0 10px 0 12px; border-bottom: 1px solid var(--line); background: var(--panel); z-index: 6; min-width: 0; }
.brand { display: flex; align-items: center; gap: 7px; font-weight: 650; letter-spacing: -0.01em; font-size: 14px; padding-right: 10px; margin-right: 2px; border-right: 1px solid var(--line); height: 22px; }
.mark-icon { width: 20px; height: 20px; color: var(--accent); stroke-width: 1.2; }
.name { border: 1px solid transparent; background: none; font-weight: 600; padding: 4px 6px; border-radius: 6px; width: calc(var(--letters) * 1.02ch + 18px); text-overflow: ellipsis; }
@supports (field-sizing: content) { .name { field-sizing: content; width: auto; min-width: 60px; max-width: 260px; } }
.name:hover { border-color: var(--line-2); }
.name:focus { background: var(--field); border-color: var(--accent); outline: none; }
.dirty { width: 8px; height: 8px; border-radius: 50%; background: #e08a1e; margin-left: -6px; flex: none; }
.button.drawer { display: none; }
.group { display: flex; align-items: center; gap: 4px; }
.group.tight { gap: 2px; }
.button { display: inline-flex; align-items: center; justify-content: center; gap: 6px; height: 28px; padding: 0 9px; border: 1px solid transparent; border-radius: 6px; background: none; cursor: pointer; white-space: nowrap; }
.button > span { display: inline-flex; align-items: center; gap: 5px; }
.button .icon:last-child:not(:first-child) { width: 12px; height: 12px; opacity: 0.7; }
.button:hover:not(:disabled), .menu-item:hover:not(:disabled) { background: var(--hover); }
.button:disabled { opacity: 0.35; cursor: default; }
.button.square { width: 30px; padding: 0; }
.button.quiet { color: var(--accent); }
.button.primary { background: var(--accent); color: var(--accent-ink); font-weight: 600; }
.button.primary:hover { filter: brightness(1.08); background: var(--accent); }
.tiny { border: 0; background: none; padding: 2px; border-radius: 4px; cursor: pointer; display: inline-flex; color: var(--ink-3); }
.tiny:hover { background: var(--hover); color: var(--ink); }
.tiny .icon { width: 12px; height: 12px; }
.menu-box { position: relative; }
.menu { position: absolute; top: 32px; left: 0; min-width: 220px; max-width: 340px; max-height: min(70vh, 520px); overflow: auto; padding: 5px; background: var(--panel); border: 1px solid var(--line); border-radius: 9px; box-shadow: var(--shadow); z-index: 20; }
.menu.to-left { left: auto; right: 0; }
.menu-title { padding: 7px 9px 3px; font-size: 11px; color: var(--ink-3); font-weight: 600; }
.menu-item { display: flex; width: 100%; justify-content: space-between; gap: 16px; align-items: baseline; padding: 5px 9px; border: 0; background: none; border-radius: 5px; text-align: left; cursor: pointer; }
.menu-item small { color: var(--ink-3); text-align: right; }
.menu-item span { white-space: nowrap; }
.menu-item .reason { max-width: 190px; }
.menu-item:disabled { color: var(--ink-3); cursor: default; }
.segmented { display: inline-flex; background: var(--hover); border-radius: 7px; padding: 2px; max-width: 100%; }
.segment { border: 0; background: none; height: 24px; padding: 0 9px; border-radius: 5px; cursor: pointer; color: var(--ink-2); white-space: nowrap; flex: 1 1 auto; }
.right .segment { padding: 0 6px; }
.right .segmented { flex-wrap: wrap; }
.segment:hover { color: var(--ink); }
.segment[aria-checked="true"] { background: var(--field); color: var(--ink); box-shadow: 0 1px 2px rgb(0 0 0 / 16%); font-weight: 550; }

/* Panels */
.panel { overflow: hidden auto; background: var(--panel); scrollbar-width: thin; scrollbar-color: var(--line-2) transparent; }
.left { grid-area: left; border-right: 1px solid var(--line); }
.right { grid-area: right; border-left: 1px solid var(--line); }
.panel > .stack { padding: 10px 12px 12px; }
.stack { display: flex; flex-direction: column; gap: 8px; min-width: 0; }
.section { border-top: 1px solid var(--line); }
.right .section:first-child, .left .section:first-child { border-top: 0; }
.section > summary { list-style: none; cursor: pointer; padding: 9px 12px 7px; font-weight: 620; display: flex; align-items: center; justify-content: space-between; }
.section > summary::-webkit-details-marker { display: none; }
.section > summary::after { content: ""; width: 6px; height: 6px; border: solid var(--ink-3); border-width: 0 1.4px 1.4px 0; transform: rotate(45deg) translate(-2px, -2px); transition: transform 120ms; }
.section:not([open]) > summary::after { transform: rotate(-45deg); }
.section-body { padding: 0 12px 12px; display: flex; flex-direction: column; gap: 8px; }
.row { display: flex; align-items: center; justify-content: space-between; gap: 8px; }
.row > select { width: 140px; }
.row.basis { flex-direction: column; align-items: stretch; gap: 4px; }
.row.basis > select { width: 100%; }
select { height: 28px; border: 1px solid var(--line-2); border-radius: 6px; background: var(--field); padding: 0 6px; width: 100%; min-width: 0; }
.number, dialog input[type="text"] { height: 26px; border: 1px solid var(--line-2); border-radius: 6px; background: var(--field); padding: 0 6px; width: 100%; min-width: 0; text-align: right; appearance: textfield; }
.number::-webkit-inner-spin-button { display: none; }
.number.wrong { border-color: var(--error); background: var(--error-soft); }
.number:disabled { opacity: 0.4; }
.field { display: flex; align-items: center; gap: 7px; min-width: 0; }
.field > span:empty { display: none; }
.shape .field > span { flex: 1; }
.shape .field .number { width: 96px; }
.pair { display: grid; grid-template-columns: 1fr 1fr; gap: 10px; }
.subtitle { color: var(--ink-3); font-size: 11.5px; margin-top: 2px; }
.shape { display: flex; flex-direction: column; gap: 6px; }
.toggle { display: flex; align-items: center; gap: 7px; cursor: pointer; min-height: 24px; }
.toggle > span:nth-child(2) { flex: 1; white-space: nowrap; }
.switch { appearance: none; width: 26px; height: 15px; margin: 0; border-radius: 8px; background: var(--line-2); position: relative; cursor: pointer; flex: none; transition: background 120ms; }
.switch::after { content: ""; position: absolute; inset: 2px auto 2px 2px; width: 11px; border-radius: 50%; background: #fff; transition: transform 120ms; box-shadow: 0 1px 1px rgb(0 0 0 / 25%); }
.switch:checked { background: var(--accent); }
.switch:checked::after { transform: translateX(11px); }
.switches { display: grid; grid-template-columns: 1fr 1fr; gap: 2px 12px; }
.keys { display: inline-flex; gap: 3px; }
.key { width: 12px; height: 3px; border-radius: 2px; }

.slider { display: grid; grid-template-columns: 26px minmax(0, 1fr) 62px; align-items: center; gap: 8px; }
.slider > .symbol { font-size: 14px; white-space: nowrap; }
.slider > .symbol:not(:has(.math)) { font-size: 12px; color: var(--ink-2); }
.slider:not(:has(.symbol .math)) { grid-template-columns: 38px minmax(0, 1fr) 62px; }
.range { position: relative; height: 30px; }
.range input { position: absolute; inset: 0 0 10px; width: 100%; margin: 0; background: none; appearance: none; cursor: pointer; height: 20px; }
.track { position: absolute; left: 0; right: 0; top: 8px; height: 4px; border-radius: 2px; background: linear-gradient(to right, var(--accent) var(--share, 0%), var(--line-2) var(--share, 0%)); opacity: 0.85; }
.range input::-webkit-slider-thumb { appearance: none; width: 14px; height: 14px; border-radius: 50%; background: var(--field); border: 2px solid var(--accent); box-shadow: 0 1px 3px rgb(0 0 0 / 22%); }
.range input::-moz-range-thumb { width: 11px; height: 11px; border-radius: 50%; background: var(--field); border: 2px solid var(--accent); }
.range input:focus-visible { outline: none; }
.range input:focus-visible::-webkit-slider-thumb { outline: 2px solid var(--accent); outline-offset: 2px; }
.range input:focus-visible::-moz-range-thumb { outline: 2px solid var(--accent); outline-offset: 2px; }
.marks { position: absolute; left: 7px; right: 7px; top: 16px; height: 13px; pointer-events: none; }
.mark { position: absolute; transform: translateX(-50%); font-size: 9.5px; color: var(--ink-3); line-height: 1; padding-top: 4px; }
.mark::before { content: ""; position: absolute; top: 0; left: 50%; width: 1px; height: 3px; background: var(--line-2); }
.chips { display: flex; flex-wrap: wrap; gap: 4px; }
.chip { border: 1px solid var(--line-2); background: var(--field); border-radius: 12px; height: 23px; padding: 0 8px; font-size: 11.5px; cursor: pointer; color: var(--ink-2); }
.chip:hover { border-color: var(--accent); color: var(--ink); }
.chip[aria-pressed="true"] { background: var(--accent-soft); border-color: var(--accent); color: var(--ink); }
.light { display: grid; grid-template-columns: 58px minmax(0, 1fr); gap: 10px; align-items: center; }
.light .stack { gap: 2px; }
.light-ball { width: 58px; height: 58px; border-radius: 50%; position: relative; cursor: crosshair; touch-action: none; background: radial-gradient(circle at 50% 50%, var(--field), var(--hover)); border: 1px solid var(--line-2); }
.light-ball span { position: absolute; width: 12px; height: 12px; margin: -6px; border-radius: 50%; background: #ffb300; border: 2px solid #fff; box-shadow: 0 0 6px rgb(255 170 0 / 70%); }
.light-ball span.under { background: #94836a; box-shadow: none; }

/* Left panel */
.patches { display: flex; flex-direction: column; gap: 1px; padding: 8px; border-bottom: 1px solid var(--line); max-height: 168px; overflow: auto; }
.patch { display: flex; justify-content: space-between; gap: 8px; border: 0; background: none; border-radius: 6px; padding: 5px 8px; text-align: left; cursor: pointer; }
.patch span { overflow: hidden; text-overflow: ellipsis; white-space: nowrap; }
.patch small { color: var(--ink-3); }
.patch:hover { background: var(--hover); }
.patch[aria-selected="true"] { background: var(--accent-soft); font-weight: 600; }
.points { display: flex; flex-direction: column; gap: 8px; min-height: 104px; }
.points > .segmented { display: flex; }
.net { display: grid; grid-template-columns: repeat(var(--columns), minmax(0, 1fr)); gap: 3px; padding: 7px; background: var(--hover); border-radius: 8px; }
.knob { height: 20px; border: 0; border-radius: 5px; background: none; cursor: pointer; position: relative; padding: 0; font-size: 11px; color: var(--ink-2); }
.knob:empty::after { content: ""; position: absolute; left: 50%; top: 50%; width: 7px; height: 7px; margin: -3.5px; border-radius: 50%; background: var(--ink-3); opacity: 0.75; }
.knob:hover { background: var(--field); }
.knob[aria-pressed="true"] { background: #d9620a; color: #fff; }
.knob[aria-pressed="true"]:empty::after { background: #fff; opacity: 1; }
.coordinates { display: grid; gap: 5px; }
.coordinates .field i { width: 14px; display: inline-block; text-align: center; }
.drag-tools { display: flex; flex-direction: column; gap: 4px; border-top: 1px solid var(--line); padding-top: 8px; }
.locks { display: flex; align-items: center; gap: 10px; }
.locks .caption { min-width: 34px; }
.locks .toggle { gap: 4px; }
.snap { display: flex; align-items: center; gap: 8px; }
.snap .field { flex: 1; }

/* Picture */
.centre { grid-area: centre; display: flex; flex-direction: column; min-width: 0; min-height: 0; position: relative; }
.picture { position: relative; flex: 1; min-height: 0; background: var(--ground); overflow: hidden; }
.view { position: absolute; inset: 0; width: 100%; height: 100%; display: block; touch-action: none; cursor: default; }
.embedded .view, .notebook .view { touch-action: pan-y; }
.view:focus-visible { outline-offset: -2px; }
.view.grab { cursor: grab; }
.hud { position: absolute; inset: 0; pointer-events: none; }
.hud > * { pointer-events: none; }
.view-tools { position: absolute; left: 10px; bottom: calc(10px + var(--covered, 0px)); display: flex; gap: 1px; align-items: center; background: var(--glass); backdrop-filter: blur(6px); border-radius: 9px; padding: 3px; box-shadow: var(--shadow); pointer-events: auto !important; }
.view-tools .button { height: 26px; padding: 0 8px; }
.view-tools .square { width: 28px; }
.view-tools .segmented { margin-left: 4px; }
.view-tools .segment { height: 22px; }
.triad { position: absolute; left: 12px; bottom: calc(52px + var(--covered, 0px)); width: 62px; height: 62px; overflow: visible; }
.gizmo { position: absolute; inset: 0; width: 100%; height: 100%; }
.gizmo polygon { stroke-width: 3; stroke-linecap: round; stroke-linejoin: round; fill: none; }
.gizmo .square { stroke-width: 1; fill-opacity: 0.28; }
.gizmo .square.axis-x { fill: var(--x); } .gizmo .square.axis-y { fill: var(--y); } .gizmo .square.axis-z { fill: var(--z); }
.triad line { stroke-width: 2; stroke-linecap: round; }
.triad text { font: italic 12px "STIX Two Text", Cambria, "Liberation Serif", serif; text-anchor: middle; dominant-baseline: central; fill: var(--ink-2); }
.axis-x { stroke: var(--x); } .axis-y { stroke: var(--y); } .axis-z { stroke: var(--z); }
.cell { position: absolute; border: 0 solid var(--line); }
.cell:nth-child(n + 2) { border-left-width: 1px; }
.cell:nth-child(n + 3) { border-top-width: 1px; }
.cell:nth-child(3) { border-left-width: 0; }
.cell-label { position: absolute; left: 12px; top: 10px; background: var(--glass); border-radius: 6px; padding: 2px 8px; font-weight: 600; }
.kept { position: absolute; left: 12px; top: 36px; max-width: calc(100% - 24px); pointer-events: auto; font-size: 11px; }
.kept-tools { display: flex; gap: 2px; flex-wrap: wrap; }
.kept .button { height: 22px; padding: 0 6px; background: var(--glass); font-size: 11px; }
.differs { margin-top: 3px; padding: 2px 6px; border-radius: 6px; background: var(--glass); width: fit-content; max-width: 100%; overflow-wrap: anywhere; }
.pin, .sharpest { position: absolute; left: 0; top: 0; width: 0; height: 0; }
.pin b { position: absolute; transform: translate(-50%, -100%) translateY(-5px); min-width: 18px; height: 18px; padding: 0 4px; border-radius: 9px; background: var(--ink); color: var(--panel); font-size: 11px; line-height: 18px; text-align: center; }
.pin::after { content: ""; position: absolute; left: -3px; top: -3px; width: 6px; height: 6px; border-radius: 50%; background: var(--ink); box-shadow: 0 0 0 1.5px var(--panel); }
.sharpest::after { content: ""; position: absolute; left: -7px; top: -7px; width: 14px; height: 14px; border-radius: 50%; border: 2px solid #d0006f; box-shadow: 0 0 0 1px #fff; }
.sharpest.behind::after { border-style: dashed; box-shadow: none; }
.behind { opacity: 0.6; }
.sharpest b { position: absolute; left: 12px; top: -11px; white-space: nowrap; background: #b00060; color: #fff; padding: 1px 7px; border-radius: 9px; font-size: 11.5px; font-weight: 600; }
.sharpest sub { font-size: 0.75em; line-height: 0; }
.tip { position: absolute; left: 0; top: 0; background: var(--glass); backdrop-filter: blur(8px); border-radius: 8px; box-shadow: var(--shadow); padding: 7px 10px; font-size: 12px; max-width: 260px; z-index: 3; }
.tip-title { font-weight: 600; }
.tip-point { color: var(--ink-2); margin-bottom: 3px; }
.tip-words { color: var(--ink-2); margin-top: 3px; padding-top: 3px; border-top: 1px solid var(--line); }
.tip-words:empty { display: none; }
.tip table { border-collapse: collapse; }
.tip th { text-align: left; font-weight: 400; color: var(--ink-2); padding: 0 14px 0 0; }
.tip td { text-align: right; }

.legend { position: absolute; right: 10px; top: 10px; margin: 0; padding: 9px 11px 8px; background: var(--glass); backdrop-filter: blur(6px); border-radius: 10px; box-shadow: var(--shadow); max-width: 200px; font-size: 12px; pointer-events: none; }
.legend-title { font-weight: 600; margin-bottom: 7px; line-height: 1.3; }
.legend-symbol { display: block; font-weight: 400; }
.scale { display: flex; height: 148px; margin: 4px 0 8px; }
canvas.colours { width: 14px; height: 100%; border: 0; border-radius: 3px; }
.histogram { width: 32px; height: 100%; margin-right: 2px; }
.ticks { position: relative; flex: 1; min-width: 46px; margin-left: 8px; }
.facts { display: grid; grid-template-columns: max-content max-content; gap: 0 10px; margin: 0; }
.facts dd { margin: 0; text-align: right; color: var(--ink); }
.tick { position: absolute; transform: translateY(50%); white-space: nowrap; line-height: 1; }
.tick::before { content: ""; position: absolute; left: -7px; top: 50%; width: 4px; height: 1px; background: var(--ink-3); }
.legend figcaption { color: var(--ink-2); font-size: 11.5px; }
.missing { display: flex; align-items: center; gap: 6px; }
.types { list-style: none; margin: 0; padding: 0; display: grid; gap: 3px; }
.types li { display: grid; grid-template-columns: 13px minmax(0, 1fr) auto; gap: 8px; align-items: center; }
.types .absent { opacity: 0.72; color: var(--ink-3); }
.types .share { color: var(--ink-2); padding-left: 8px; }
.swatch { width: 13px; height: 13px; border-radius: 3px; display: inline-block; box-shadow: inset 0 0 0 1px rgb(0 0 0 / 14%); }

/* Banners, probe, status, dialogs */
.banners { position: absolute; z-index: 5; top: 10px; left: 12px; display: flex; flex-direction: column; gap: 6px; align-items: flex-start; width: max-content; max-width: min(620px, calc(100% - 180px)); }
.banner { display: flex; align-items: center; gap: 10px; background: var(--panel); border: 1px solid var(--line); border-left: 3px solid var(--accent); border-radius: 8px; padding: 7px 8px 7px 12px; box-shadow: var(--shadow); overflow-wrap: anywhere; }
.banner.error { border-left-color: var(--error); background: var(--error-soft); color: var(--ink); }
.banner .primary { height: 26px; }
.banner ul { margin: 3px 0 1px; padding: 0; list-style: none; color: var(--ink-2); font-size: 12px; max-height: 40vh; overflow: auto; }
.banner:has(ul) { align-items: flex-start; }
/* The picture ends at the probe's closed bar; unfolded it lies over the picture, so that a pin does not move it. */
.probe { position: absolute; inset: auto 0 0; z-index: 3; border-top: 1px solid var(--line); background: var(--panel); max-height: 42%; overflow: auto; }
.picture { margin-bottom: 31px; }
.view-tools { flex-wrap: wrap; max-width: calc(100% - 20px); }
.probe > summary { cursor: pointer; display: flex; align-items: center; gap: 7px; padding: 6px 12px; font-weight: 620; position: sticky; top: 0; left: 0; background: var(--panel); z-index: 2; list-style: none; }
.probe > summary .hint { font-weight: 400; }
.badge:empty { display: none; }
.badge { background: var(--accent); color: var(--accent-ink); border-radius: 9px; padding: 0 6px; font-size: 11px; }
.probe-tools { display: flex; align-items: center; gap: 10px; padding: 0 12px 7px; position: sticky; left: 0; }
.probe-tools .field .number { width: 68px; }
.probe-body { overflow-x: auto; padding: 0 12px 8px; }
.probe table { border-collapse: collapse; white-space: nowrap; }
.probe th { text-align: right; font-weight: 500; color: var(--ink-2); padding: 3px 10px 3px 0; border-bottom: 1px solid var(--line); }
.probe td { text-align: right; padding: 3px 10px 3px 0; border-bottom: 1px solid var(--line); }
.probe td.word { text-align: left; }
.pin-number { display: inline-block; min-width: 17px; height: 17px; line-height: 17px; border-radius: 9px; background: var(--ink); color: var(--panel); text-align: center; font-size: 11px; font-weight: 600; }
.status { grid-area: status; display: flex; align-items: center; gap: 14px; padding: 0 12px; border-top: 1px solid var(--line); font-size: 11.5px; color: var(--ink-2); white-space: nowrap; overflow: hidden; }
.status sub { font-size: 0.75em; line-height: 0; font-style: italic; }
.status .warning { color: var(--warn); overflow: hidden; text-overflow: ellipsis; }
.status .quiet { color: var(--ink-3); }
dialog { border: 1px solid var(--line); border-radius: 12px; padding: 0; background: var(--panel); color: var(--ink); box-shadow: var(--shadow); width: min(460px, 90vw); font: inherit; }
dialog::backdrop { background: rgb(15 20 26 / 38%); }
dialog form { padding: 16px 18px 14px; display: flex; flex-direction: column; gap: 12px; }
dialog h2 { margin: 0; font-size: 15px; font-weight: 650; }
dialog p { margin: 0; overflow-wrap: anywhere; }
.dialog-body { display: flex; flex-direction: column; gap: 10px; max-height: 66vh; overflow: auto; padding: 3px; margin: -3px; }
.dialog-buttons { display: flex; flex-direction: row-reverse; gap: 8px; }
.dialog-buttons .button { border-color: var(--line-2); }
dialog input[type="text"] { text-align: left; height: 30px; }
.field.wide { flex-direction: column; align-items: stretch; gap: 3px; }
.keys-list { display: grid; grid-template-columns: max-content 1fr; gap: 2px 14px; margin: 0; }
.keys-list dt { font-weight: 600; }
.keys-list dd { margin: 0; color: var(--ink-2); }

/* A report page and a notebook have less room. */
@container (width < 1180px) { .segment { padding: 0 6px; } .studio { grid-template-columns: 208px minmax(0, 1fr) 280px; } }
@container (width < 1100px) {
  .studio:is(.embedded, .notebook) { grid-template: "bar bar" 46px "centre right" minmax(0, 1fr) "status status" 26px / minmax(0, 1fr) 280px; }
  .embedded .left, .notebook .left { display: none; }
  .embedded .button.drawer, .notebook .button.drawer { display: inline-flex; }
}
@container (width < 960px) {
  .studio { grid-template: "bar bar" 46px "centre right" minmax(0, 1fr) "status status" 26px / minmax(0, 1fr) 272px; }
  .left, .bar .quiet { display: none; }
  .bar { gap: 4px; padding: 0 6px; }
  .bar .segment { padding: 0 5px; }
  .button.drawer { display: inline-flex; }
  .brand > span, .bar .word { display: none; }
}
/* The left panel over the picture, where there is no room for it beside. */
@container (width < 1100px) {
  .with-left .left { display: block !important; position: absolute; z-index: 8; left: 0; top: var(--bar); bottom: 26px; width: min(280px, 82%); box-shadow: var(--shadow); }
  .with-left .drawer { background: var(--accent-soft); }
}
@container (width < 640px) {
  .studio, .studio:is(.embedded, .notebook) { --bar: 80px; grid-template: "bar" var(--bar) "centre" minmax(260px, 1fr) "right" minmax(170px, 30%) "status" 26px / minmax(0, 1fr); }
  .bar { flex-wrap: wrap; align-content: center; row-gap: 4px; }
  .bar .menu-box .icon:last-child:not(:first-child), .bar > .spacer { display: none; }
  .brand { padding-right: 4px; border: 0; margin: 0; }
  .bar .name { flex: 1; max-width: none; }
  .bar .last { margin-left: auto; }
  .bar .segmented { overflow: auto hidden; }
  .bar .button { padding: 0 6px; }
  .bar .button.square { width: 28px; padding: 0; }
  .menu { position: fixed; left: 8px; right: 8px; top: calc(var(--bar) - 2px); max-width: none; }
  .menu.to-left { left: 8px; right: 8px; }
  .right { border-left: 0; border-top: 1px solid var(--line); }
  .legend { padding: 7px 9px; font-size: 11px; }
  .legend figcaption, .histogram { display: none; }
  .legend .scale { height: 88px; margin: 4px 0 6px; }
  .types { gap: 1px; }
  .view-tools .button { padding: 0 6px; }
  .probe { max-height: 30%; }
  .banners { max-width: calc(100% - 24px); }
  .status { gap: 8px; padding: 0 8px; overflow-x: auto; }
}
@media (prefers-reduced-motion: reduce) { * { transition: none !important; } }
.hint.error { color: var(--error); }
.model-text textarea {
  width: 100%; resize: vertical; padding: 6px 8px; border: 1px solid var(--line); border-radius: 6px; background: var(--field, var(--ground-flat)); color: var(--ink);
  font: 11.5px/1.45 ui-monospace, "DejaVu Sans Mono", monospace; white-space: pre-wrap; overflow-wrap: anywhere; tab-size: 4;
}
.model-text .hint.error { overflow-wrap: anywhere; }
`;function po(i){let e=i.shadowRoot??i.attachShadow({mode:"open"}),t=new CSSStyleSheet;t.replaceSync(y1),e.adoptedStyleSheets=[t];let n=document.createElement("div");return n.className="place",e.replaceChildren(n),n}function fo(i,e){return Object.assign(i,{studio:e}).studio}var mw=60,hp=240,v1=4e3;function gw(i){let e=new Map;return(t,n)=>{e.size||setTimeout(()=>{for(let[r,s]of e)i.set(r,s());e.clear(),i.save_changes()},mw),e.set(t,n)}}function bw(i,e){let t=null;return e("msg:custom",n=>{let{built:r}=n??{};r&&t?.(r)}),n=>new Promise(r=>{t=r,i.send?.({build:n})})}function x1({model:i,el:e}){let t=gw(i),n=[],r=(g,v)=>{n.push([g,v]),i.on(g,v)},s=(g,v)=>r(`change:${g}`,v),a=i.get("brought")??{};Cr(a),ua(a.built??[]);let o=null,l=Io(bw(i,r),()=>o&&Ph(o.store)),c=g=>JSON.stringify(on(g)),h=()=>String(i.get("quantity")),d="",u=fo(e,new ts(po(e),new fs("notebook","notebook"),{model:vt(i.get("model")),source:null,quantity:h(),onModel(g){let v=c(g);v!==d&&(d=v,t("model",()=>JSON.parse(d)))}}));o=u;let{store:p}=u;d=c(p.state.model),s("model",()=>{let g=vt(i.get("model")),v=c(g);v!==d&&(d=v,p.edit(g))}),p.subscribe(({settings:{quantity:g}},v)=>{g!==v.settings.quantity&&g!==h()&&t("quantity",()=>p.state.settings.quantity)}),s("quantity",()=>{let g=h(),{settings:v}=p.state;g!==v.quantity&&(g==="none"||lt[g])&&p.setting({quantity:g,range:v.range==="fixed"?"robust":v.range})}),Object.assign(e.style,{resize:"vertical",overflow:"hidden",minHeight:`${hp}px`,maxHeight:`${v1}px`});let f=()=>Math.min(v1,Math.max(hp,Math.round(parseFloat(e.style.height)||hp))),b=()=>{e.style.height=`${Number(i.get("height"))}px`};b(),s("height",b);let m=new ResizeObserver(()=>{f()!==i.get("height")&&t("height",f)});return m.observe(e),()=>{for(let[g,v]of n)i.off(g,v);l(),m.disconnect(),u.dispose()}}function yw(i,e){Cr(e.installed??{});let t=new fs("embedded",e.place??location.pathname);return fo(i,new ts(po(i),t,{model:vt(e.model),source:null,...e.quantity?{quantity:e.quantity}:{}}))}async function vw(i,e){Cr(JSON.parse(document.getElementById("quintrig-installed")?.textContent??"{}"));let t=new ko(e),n=null;Io(h=>t.build(h),()=>n&&Ph(n.store)),location.search&&history.replaceState(null,"",location.pathname);let r=await Gf(t),s=await fetch("api/model"),{model:a,source:o}=r??(s.ok?fu(await s.json()):{model:Zo[0],source:null}),l=n=new ts(po(i),t,{model:a,source:o});if(!r&&!s.ok&&s.status!==404){let{error:h}=await s.json().catch(()=>({}));l.store.set({message:{kind:"error",text:h??`the server answered ${s.status}`}})}let c=()=>{let{model:h,saved:d}=l.store.state;document.title=`${h===d?"":"● "}${h.name} – quintrig`};return l.store.subscribe(c),Hf(t,l.store),c(),fo(i,l)}var mL={render:x1};if(typeof document<"u"){let i=document.querySelector("[data-quintrig]");i?.dataset.quintrig==="live"&&vw(i,i.dataset.place??"").catch(e=>i.textContent=String(e));for(let e of document.querySelectorAll("[data-quintrig=embedded]")){let t=document.getElementById(e.dataset.model??"")?.textContent??"null";yw(e,JSON.parse(t))}}export{tu as BUILDERS,Pf as FAMILIES,dn as Formulas,st as KINDS,qn as LIBRARY,ci as QUANTITIES,lt as QUANTITY,Yn as analyse,Bo as besl,Nn as build,ip as converted,St as curveOf,mL as default,yw as embed,Eo as entry,$h as family,vt as fromDict,ps as fromToml,ca as functionsOf,Cr as install,vw as live,qh as parse,mu as pointType,gu as shapeClass,wi as shapeParameters,on as toDict};
