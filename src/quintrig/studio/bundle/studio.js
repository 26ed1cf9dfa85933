/* quintrig studio; sources sha256 9a0283c17aebdabb0a0839bd0c3c8b6b0684ffc8eb05cf01946679b088d5e888; the licences of the packages in it follow */
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
var Be={version:"0.1.0",schema:1,units:["um","mm","cm","m","km","in","ft"],shapeRange:[-4,1],shapeSets:{"4":[[1,1,1,1],[1,1,-3,-3],[1,-3,1,-3],[1,0,-2,-3]],"2":[[1,1],[0,-4],[-2,0],[-2,-4]]},quantities:[{key:"point",symbol:"S(u, v)",latex:"\\mathbf{S}(u,v)",name:"point",meaning:"position",source:"thesis eq. 3.1",power:1,parity:"even",colour:"vector",partner:"",components:3,classes:[]},{key:"normal",symbol:"n",latex:"\\mathbf{n}",name:"unit normal",meaning:"S_u × S_v, normalised",source:"do Carmo 1976, §2.5-3.3",power:0,parity:"odd",colour:"vector",partner:"",components:3,classes:[]},{key:"E",symbol:"E",latex:"E",name:"first form E",meaning:"S_u · S_u",source:"do Carmo 1976, §2.5-3.3",power:2,parity:"even",colour:"sequential",partner:"",components:1,classes:[]},{key:"F",symbol:"F",latex:"F",name:"first form F",meaning:"S_u · S_v",source:"do Carmo 1976, §2.5-3.3",power:2,parity:"even",colour:"diverging",partner:"",components:1,classes:[]},{key:"G",symbol:"G",latex:"G",name:"first form G",meaning:"S_v · S_v",source:"do Carmo 1976, §2.5-3.3",power:2,parity:"even",colour:"sequential",partner:"",components:1,classes:[]},{key:"L",symbol:"L",latex:"L",name:"second form L",meaning:"S_uu · n",source:"do Carmo 1976, §2.5-3.3",power:1,parity:"odd",colour:"diverging",partner:"",components:1,classes:[]},{key:"M",symbol:"M",latex:"M",name:"second form M",meaning:"S_uv · n",source:"do Carmo 1976, §2.5-3.3",power:1,parity:"odd",colour:"diverging",partner:"",components:1,classes:[]},{key:"N",symbol:"N",latex:"N",name:"second form N",meaning:"S_vv · n",source:"do Carmo 1976, §2.5-3.3",power:1,parity:"odd",colour:"diverging",partner:"",components:1,classes:[]},{key:"gaussian",symbol:"K",latex:"K",name:"Gaussian curvature",meaning:"dome or bowl (+), developable (0), saddle (-)",source:"do Carmo 1976, §2.5-3.3",power:-2,parity:"even",colour:"diverging",partner:"",components:1,classes:[]},{key:"mean",symbol:"H",latex:"H",name:"mean curvature",meaning:"bends towards the normal (+) or away from it (-)",source:"do Carmo 1976, §2.5-3.3",power:-1,parity:"odd",colour:"diverging",partner:"",components:1,classes:[]},{key:"k1",symbol:"κ1",latex:"\\kappa_1",name:"larger principal curvature",meaning:"the most that the surface bends towards the normal: H + R, R = (κ1 - κ2)/2",source:"do Carmo 1976, §2.5-3.3",power:-1,parity:"swap",colour:"diverging",partner:"k2",components:1,classes:[]},{key:"k2",symbol:"κ2",latex:"\\kappa_2",name:"smaller principal curvature",meaning:"the least that it bends towards the normal, or the most away from it: H - R, R = (κ1 - κ2)/2",source:"do Carmo 1976, §2.5-3.3",power:-1,parity:"swap",colour:"diverging",partner:"k1",components:1,classes:[]},{key:"direction1",symbol:"d1",latex:"\\mathbf{d}_1",name:"direction of κ1",meaning:"unit tangent, NaN at umbilics",source:"do Carmo 1976, §2.5-3.3",power:0,parity:"swap",colour:"vector",partner:"direction2",components:3,classes:[]},{key:"direction2",symbol:"d2",latex:"\\mathbf{d}_2",name:"direction of κ2",meaning:"unit tangent, NaN at umbilics",source:"do Carmo 1976, §2.5-3.3",power:0,parity:"swap",colour:"vector",partner:"direction1",components:3,classes:[]},{key:"shape_index",symbol:"S",latex:"S",name:"shape index",meaning:"cup -1, rut -1/2, saddle 0, ridge +1/2, cap +1 (n towards the viewer)",source:"Koenderink and van Doorn 1992",power:0,parity:"odd",colour:"diverging",partner:"",components:1,classes:[]},{key:"curvedness",symbol:"C",latex:"C",name:"curvedness",meaning:"how strongly it bends, whatever the shape",source:"Koenderink and van Doorn 1992",power:-1,parity:"even",colour:"sequential",partner:"",components:1,classes:[]},{key:"beta0",symbol:"β0",latex:"\\beta_0",name:"squared slope",meaning:"square of the slope, in the metric of the horizontal plane (the definition for a height field)",source:"Fujita and Ohsaki 2009; Iri et al. 2001",power:0,parity:"even",colour:"sequential",partner:"",components:1,classes:[]},{key:"beta1",symbol:"β1",latex:"\\beta_1",name:"Laplacian of the height",meaning:"bowl-like (+) or roof-like (-), in the metric of the horizontal plane (the definition for a height field)",source:"Fujita and Ohsaki 2009; Iri et al. 2001",power:-1,parity:"even",colour:"diverging",partner:"",components:1,classes:[]},{key:"beta2",symbol:"β2",latex:"\\beta_2",name:"Hessian determinant",meaning:"dome or bowl (+), developable (0), saddle (-), in the metric of the horizontal plane (the definition for a height field)",source:"Fujita and Ohsaki 2009; Iri et al. 2001",power:-2,parity:"even",colour:"diverging",partner:"",components:1,classes:[]},{key:"gamma1",symbol:"γ1",latex:"\\gamma_1",name:"bending along steepest descent",meaning:"slope eases (+) or steepens (-) downhill; weighted by slope², in the metric of the horizontal plane (the definition for a height field)",source:"Fujita and Ohsaki 2009; Iri et al. 2001",power:-1,parity:"even",colour:"diverging",partner:"",components:1,classes:[]},{key:"gamma2",symbol:"γ2",latex:"\\gamma_2",name:"twist of steepest descent",meaning:"0 on crest and trough lines; weighted by slope², in the metric of the horizontal plane (the definition for a height field)",source:"Fujita and Ohsaki 2009; Iri et al. 2001",power:-1,parity:"even",colour:"diverging",partner:"",components:1,classes:[]},{key:"gamma3",symbol:"γ3",latex:"\\gamma_3",name:"bending along the contour",meaning:"hollow (+) or spur (-): rises or falls to both sides along the contour; weighted by slope², in the metric of the horizontal plane (the definition for a height field)",source:"Fujita and Ohsaki 2009; Iri et al. 2001",power:-1,parity:"even",colour:"diverging",partner:"",components:1,classes:[]},{key:"beta0_surface",symbol:"β0ˢ",latex:"\\beta_0^{S}",name:"squared slope",meaning:"square of the slope, in the metric of the surface",source:"Fujita and Ohsaki 2009; Iri et al. 2001",power:0,parity:"even",colour:"sequential",partner:"",components:1,classes:[]},{key:"beta1_surface",symbol:"β1ˢ",latex:"\\beta_1^{S}",name:"Laplacian of the height",meaning:"bowl-like (+) or roof-like (-), in the metric of the surface",source:"Fujita and Ohsaki 2009; Iri et al. 2001",power:-1,parity:"even",colour:"diverging",partner:"",components:1,classes:[]},{key:"beta2_surface",symbol:"β2ˢ",latex:"\\beta_2^{S}",name:"Hessian determinant",meaning:"dome or bowl (+), developable (0), saddle (-), in the metric of the surface",source:"Fujita and Ohsaki 2009; Iri et al. 2001",power:-2,parity:"even",colour:"diverging",partner:"",components:1,classes:[]},{key:"gamma1_surface",symbol:"γ1ˢ",latex:"\\gamma_1^{S}",name:"bending along steepest descent",meaning:"slope eases (+) or steepens (-) downhill; weighted by slope², in the metric of the surface",source:"Fujita and Ohsaki 2009; Iri et al. 2001",power:-1,parity:"even",colour:"diverging",partner:"",components:1,classes:[]},{key:"gamma2_surface",symbol:"γ2ˢ",latex:"\\gamma_2^{S}",name:"twist of steepest descent",meaning:"0 on crest and trough lines; weighted by slope², in the metric of the surface",source:"Fujita and Ohsaki 2009; Iri et al. 2001",power:-1,parity:"even",colour:"diverging",partner:"",components:1,classes:[]},{key:"gamma3_surface",symbol:"γ3ˢ",latex:"\\gamma_3^{S}",name:"bending along the contour",meaning:"hollow (+) or spur (-): rises or falls to both sides along the contour; weighted by slope², in the metric of the surface",source:"Fujita and Ohsaki 2009; Iri et al. 2001",power:-1,parity:"even",colour:"diverging",partner:"",components:1,classes:[]},{key:"point_type",symbol:"point type",latex:"\\mathrm{type}",name:"point type",meaning:"signs of κ1 and κ2",source:"thesis table 3.1",power:0,parity:"even",colour:"classes",partner:"",components:1,classes:["undefined","elliptic","hyperbolic","parabolic","planar","umbilic"]},{key:"hk_type",symbol:"HK type",latex:"HK",name:"HK type",meaning:"signs of K and H, n towards the viewer",source:"Besl and Jain 1986; thesis table 3.2",power:0,parity:"mirror",colour:"classes",partner:"",components:1,classes:["undefined","peak","ridge","saddle ridge","impossible","flat","minimal","pit","valley","saddle valley"]},{key:"shape_class",symbol:"shape class",latex:"S\\,\\mathrm{class}",name:"shape class",meaning:"nine ranges of the shape index",source:"Koenderink and van Doorn 1992; thesis table 3.3",power:0,parity:"mirror",colour:"classes",partner:"",components:1,classes:["undefined","spherical cup","trough","rut","saddle rut","saddle","saddle ridge","ridge","dome","spherical cap","planar"]},{key:"invariant_type",symbol:"invariant type",latex:"\\beta\\,\\mathrm{type}",name:"invariant type",meaning:"signs of β1 and β2, seen from above",source:"Fujita and Ohsaki 2009; thesis table 3.4",power:0,parity:"even",colour:"classes",partner:"",components:1,classes:["undefined","dome","roof","saddle roof","impossible","level or tilted plane","balanced saddle","bowl","trough","saddle trough"]}],limits:{relative:1e-6,flat:1e-6,noise:1e-12,sameColour:1e-9,rounding:14210854715202004e-30,singular:9094947017729282e-28,stepsForSize:17,farOff:1e6,samePoint:7105427357601002e-30,vertical:1e-9,largest:1e50,largestPolygon:64},shapeBreaks:[.125,.375,.625,.875],families:["trigonometric","bernstein","bspline","circular","hyperbolic","powers","joined","formulas","chebyshev"],library:[{name:"trigonometric",title:"Quintic trigonometric Bézier",counts:"6 control points",sizes:[6],usual:6,formulas:{"6":{functions:["a^4*(1-alpha+alpha*a)","s*a^3*(4+alpha-alpha*s)","a^2*b*(8*s+3*c+9)","b^2*a*(8*c+3*s+9)","c*b^3*(4+zeta-zeta*c)","b^4*(1-zeta+zeta*b)"],parameters:[["alpha",-4,1,0,!1,!1],["zeta",-4,1,0,!1,!1]]}}},{name:"quadratic",title:"Quadratic trigonometric Bézier",counts:"3 control points",sizes:[3],usual:3,formulas:{"3":{functions:["a*(1-alpha+alpha*a)","2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b","b*(1-zeta+zeta*b)"],parameters:[["alpha",-1,1,0,!1,!1],["zeta",-1,1,0,!1,!1]]}}},{name:"cubic",title:"Cubic trigonometric Bézier",counts:"4 control points",sizes:[4],usual:4,formulas:{"4":{functions:["a^2*(1-alpha+alpha*a)","s*a*(2+alpha-alpha*s)","c*b*(2+zeta-zeta*c)","b^2*(1-zeta+zeta*b)"],parameters:[["alpha",-2,1,0,!1,!1],["zeta",-2,1,0,!1,!1]]}}},{name:"quartic",title:"Quartic trigonometric Bézier",counts:"5 control points",sizes:[5],usual:5,formulas:{"5":{functions:["a^3*(1-alpha+alpha*a)","s*a^2*(3+alpha-alpha*s)","2*a*b*(2+s+c)","c*b^2*(3+zeta-zeta*c)","b^3*(1-zeta+zeta*b)"],parameters:[["alpha",-3,1,0,!1,!1],["zeta",-3,1,0,!1,!1]]}}},{name:"quintic",title:"Quintic trigonometric Bézier",counts:"6 control points",sizes:[6],usual:6,formulas:{"6":{functions:["a^4*(1-alpha+alpha*a)","s*a^3*(4+alpha-alpha*s)","a^2*b*(8*s+3*c+9)","b^2*a*(8*c+3*s+9)","c*b^3*(4+zeta-zeta*c)","b^4*(1-zeta+zeta*b)"],parameters:[["alpha",-4,1,0,!1,!1],["zeta",-4,1,0,!1,!1]]}}},{name:"generalised_trigonometric",title:"Generalised trigonometric Bézier",counts:"3 or more control points",sizes:[3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24,25,26,27,28,29,30,31,32,33,34,35,36,37,38,39,40,41,42,43,44,45,46,47,48,49,50,51,52,53,54,55,56,57,58,59,60,61,62,63,64],usual:6,formulas:{"3":{functions:["1*1*1*(a*(1-alpha+alpha*a))","1*1*1*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)","1*1*1*(b*(1-zeta+zeta*b))"],parameters:[["alpha",-1,1,0,!1,!1],["zeta",-1,1,0,!1,!1]]},"4":{functions:["1*r*1*(a*(1-alpha+alpha*a))","1*1*t*(a*(1-alpha+alpha*a))+1*r*1*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)","1*1*t*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1*r*1*(b*(1-zeta+zeta*b))","1*1*t*(b*(1-zeta+zeta*b))"],parameters:[["alpha",-1,1,0,!1,!1],["zeta",-1,1,0,!1,!1]]},"5":{functions:["1*r^2*1*(a*(1-alpha+alpha*a))","2*r*t*(a*(1-alpha+alpha*a))+1*r^2*1*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)","1*1*t^2*(a*(1-alpha+alpha*a))+2*r*t*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1*r^2*1*(b*(1-zeta+zeta*b))","1*1*t^2*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+2*r*t*(b*(1-zeta+zeta*b))","1*1*t^2*(b*(1-zeta+zeta*b))"],parameters:[["alpha",-1,1,0,!1,!1],["zeta",-1,1,0,!1,!1]]},"6":{functions:["1*r^3*1*(a*(1-alpha+alpha*a))","3*r^2*t*(a*(1-alpha+alpha*a))+1*r^3*1*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)","3*r*t^2*(a*(1-alpha+alpha*a))+3*r^2*t*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1*r^3*1*(b*(1-zeta+zeta*b))","1*1*t^3*(a*(1-alpha+alpha*a))+3*r*t^2*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+3*r^2*t*(b*(1-zeta+zeta*b))","1*1*t^3*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+3*r*t^2*(b*(1-zeta+zeta*b))","1*1*t^3*(b*(1-zeta+zeta*b))"],parameters:[["alpha",-1,1,0,!1,!1],["zeta",-1,1,0,!1,!1]]},"7":{functions:["1*r^4*1*(a*(1-alpha+alpha*a))","4*r^3*t*(a*(1-alpha+alpha*a))+1*r^4*1*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)","6*r^2*t^2*(a*(1-alpha+alpha*a))+4*r^3*t*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1*r^4*1*(b*(1-zeta+zeta*b))","4*r*t^3*(a*(1-alpha+alpha*a))+6*r^2*t^2*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+4*r^3*t*(b*(1-zeta+zeta*b))","1*1*t^4*(a*(1-alpha+alpha*a))+4*r*t^3*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+6*r^2*t^2*(b*(1-zeta+zeta*b))","1*1*t^4*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+4*r*t^3*(b*(1-zeta+zeta*b))","1*1*t^4*(b*(1-zeta+zeta*b))"],parameters:[["alpha",-1,1,0,!1,!1],["zeta",-1,1,0,!1,!1]]},"8":{functions:["1*r^5*1*(a*(1-alpha+alpha*a))","5*r^4*t*(a*(1-alpha+alpha*a))+1*r^5*1*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)","10*r^3*t^2*(a*(1-alpha+alpha*a))+5*r^4*t*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1*r^5*1*(b*(1-zeta+zeta*b))","10*r^2*t^3*(a*(1-alpha+alpha*a))+10*r^3*t^2*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+5*r^4*t*(b*(1-zeta+zeta*b))","5*r*t^4*(a*(1-alpha+alpha*a))+10*r^2*t^3*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+10*r^3*t^2*(b*(1-zeta+zeta*b))","1*1*t^5*(a*(1-alpha+alpha*a))+5*r*t^4*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+10*r^2*t^3*(b*(1-zeta+zeta*b))","1*1*t^5*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+5*r*t^4*(b*(1-zeta+zeta*b))","1*1*t^5*(b*(1-zeta+zeta*b))"],parameters:[["alpha",-1,1,0,!1,!1],["zeta",-1,1,0,!1,!1]]},"9":{functions:["1*r^6*1*(a*(1-alpha+alpha*a))","6*r^5*t*(a*(1-alpha+alpha*a))+1*r^6*1*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)","15*r^4*t^2*(a*(1-alpha+alpha*a))+6*r^5*t*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1*r^6*1*(b*(1-zeta+zeta*b))","20*r^3*t^3*(a*(1-alpha+alpha*a))+15*r^4*t^2*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+6*r^5*t*(b*(1-zeta+zeta*b))","15*r^2*t^4*(a*(1-alpha+alpha*a))+20*r^3*t^3*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+15*r^4*t^2*(b*(1-zeta+zeta*b))","6*r*t^5*(a*(1-alpha+alpha*a))+15*r^2*t^4*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+20*r^3*t^3*(b*(1-zeta+zeta*b))","1*1*t^6*(a*(1-alpha+alpha*a))+6*r*t^5*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+15*r^2*t^4*(b*(1-zeta+zeta*b))","1*1*t^6*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+6*r*t^5*(b*(1-zeta+zeta*b))","1*1*t^6*(b*(1-zeta+zeta*b))"],parameters:[["alpha",-1,1,0,!1,!1],["zeta",-1,1,0,!1,!1]]},"10":{functions:["1*r^7*1*(a*(1-alpha+alpha*a))","7*r^6*t*(a*(1-alpha+alpha*a))+1*r^7*1*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)","21*r^5*t^2*(a*(1-alpha+alpha*a))+7*r^6*t*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1*r^7*1*(b*(1-zeta+zeta*b))","35*r^4*t^3*(a*(1-alpha+alpha*a))+21*r^5*t^2*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+7*r^6*t*(b*(1-zeta+zeta*b))","35*r^3*t^4*(a*(1-alpha+alpha*a))+35*r^4*t^3*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+21*r^5*t^2*(b*(1-zeta+zeta*b))","21*r^2*t^5*(a*(1-alpha+alpha*a))+35*r^3*t^4*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+35*r^4*t^3*(b*(1-zeta+zeta*b))","7*r*t^6*(a*(1-alpha+alpha*a))+21*r^2*t^5*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+35*r^3*t^4*(b*(1-zeta+zeta*b))","1*1*t^7*(a*(1-alpha+alpha*a))+7*r*t^6*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+21*r^2*t^5*(b*(1-zeta+zeta*b))","1*1*t^7*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+7*r*t^6*(b*(1-zeta+zeta*b))","1*1*t^7*(b*(1-zeta+zeta*b))"],parameters:[["alpha",-1,1,0,!1,!1],["zeta",-1,1,0,!1,!1]]},"11":{functions:["1*r^8*1*(a*(1-alpha+alpha*a))","8*r^7*t*(a*(1-alpha+alpha*a))+1*r^8*1*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)","28*r^6*t^2*(a*(1-alpha+alpha*a))+8*r^7*t*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1*r^8*1*(b*(1-zeta+zeta*b))","56*r^5*t^3*(a*(1-alpha+alpha*a))+28*r^6*t^2*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+8*r^7*t*(b*(1-zeta+zeta*b))","70*r^4*t^4*(a*(1-alpha+alpha*a))+56*r^5*t^3*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+28*r^6*t^2*(b*(1-zeta+zeta*b))","56*r^3*t^5*(a*(1-alpha+alpha*a))+70*r^4*t^4*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+56*r^5*t^3*(b*(1-zeta+zeta*b))","28*r^2*t^6*(a*(1-alpha+alpha*a))+56*r^3*t^5*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+70*r^4*t^4*(b*(1-zeta+zeta*b))","8*r*t^7*(a*(1-alpha+alpha*a))+28*r^2*t^6*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+56*r^3*t^5*(b*(1-zeta+zeta*b))","1*1*t^8*(a*(1-alpha+alpha*a))+8*r*t^7*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+28*r^2*t^6*(b*(1-zeta+zeta*b))","1*1*t^8*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+8*r*t^7*(b*(1-zeta+zeta*b))","1*1*t^8*(b*(1-zeta+zeta*b))"],parameters:[["alpha",-1,1,0,!1,!1],["zeta",-1,1,0,!1,!1]]},"12":{functions:["1*r^9*1*(a*(1-alpha+alpha*a))","9*r^8*t*(a*(1-alpha+alpha*a))+1*r^9*1*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)","36*r^7*t^2*(a*(1-alpha+alpha*a))+9*r^8*t*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1*r^9*1*(b*(1-zeta+zeta*b))","84*r^6*t^3*(a*(1-alpha+alpha*a))+36*r^7*t^2*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+9*r^8*t*(b*(1-zeta+zeta*b))","126*r^5*t^4*(a*(1-alpha+alpha*a))+84*r^6*t^3*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+36*r^7*t^2*(b*(1-zeta+zeta*b))","126*r^4*t^5*(a*(1-alpha+alpha*a))+126*r^5*t^4*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+84*r^6*t^3*(b*(1-zeta+zeta*b))","84*r^3*t^6*(a*(1-alpha+alpha*a))+126*r^4*t^5*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+126*r^5*t^4*(b*(1-zeta+zeta*b))","36*r^2*t^7*(a*(1-alpha+alpha*a))+84*r^3*t^6*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+126*r^4*t^5*(b*(1-zeta+zeta*b))","9*r*t^8*(a*(1-alpha+alpha*a))+36*r^2*t^7*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+84*r^3*t^6*(b*(1-zeta+zeta*b))","1*1*t^9*(a*(1-alpha+alpha*a))+9*r*t^8*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+36*r^2*t^7*(b*(1-zeta+zeta*b))","1*1*t^9*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+9*r*t^8*(b*(1-zeta+zeta*b))","1*1*t^9*(b*(1-zeta+zeta*b))"],parameters:[["alpha",-1,1,0,!1,!1],["zeta",-1,1,0,!1,!1]]},"13":{functions:["1*r^10*1*(a*(1-alpha+alpha*a))","10*r^9*t*(a*(1-alpha+alpha*a))+1*r^10*1*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)","45*r^8*t^2*(a*(1-alpha+alpha*a))+10*r^9*t*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1*r^10*1*(b*(1-zeta+zeta*b))","120*r^7*t^3*(a*(1-alpha+alpha*a))+45*r^8*t^2*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+10*r^9*t*(b*(1-zeta+zeta*b))","210*r^6*t^4*(a*(1-alpha+alpha*a))+120*r^7*t^3*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+45*r^8*t^2*(b*(1-zeta+zeta*b))","252*r^5*t^5*(a*(1-alpha+alpha*a))+210*r^6*t^4*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+120*r^7*t^3*(b*(1-zeta+zeta*b))","210*r^4*t^6*(a*(1-alpha+alpha*a))+252*r^5*t^5*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+210*r^6*t^4*(b*(1-zeta+zeta*b))","120*r^3*t^7*(a*(1-alpha+alpha*a))+210*r^4*t^6*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+252*r^5*t^5*(b*(1-zeta+zeta*b))","45*r^2*t^8*(a*(1-alpha+alpha*a))+120*r^3*t^7*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+210*r^4*t^6*(b*(1-zeta+zeta*b))","10*r*t^9*(a*(1-alpha+alpha*a))+45*r^2*t^8*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+120*r^3*t^7*(b*(1-zeta+zeta*b))","1*1*t^10*(a*(1-alpha+alpha*a))+10*r*t^9*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+45*r^2*t^8*(b*(1-zeta+zeta*b))","1*1*t^10*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+10*r*t^9*(b*(1-zeta+zeta*b))","1*1*t^10*(b*(1-zeta+zeta*b))"],parameters:[["alpha",-1,1,0,!1,!1],["zeta",-1,1,0,!1,!1]]},"14":{functions:["1*r^11*1*(a*(1-alpha+alpha*a))","11*r^10*t*(a*(1-alpha+alpha*a))+1*r^11*1*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)","55*r^9*t^2*(a*(1-alpha+alpha*a))+11*r^10*t*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1*r^11*1*(b*(1-zeta+zeta*b))","165*r^8*t^3*(a*(1-alpha+alpha*a))+55*r^9*t^2*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+11*r^10*t*(b*(1-zeta+zeta*b))","330*r^7*t^4*(a*(1-alpha+alpha*a))+165*r^8*t^3*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+55*r^9*t^2*(b*(1-zeta+zeta*b))","462*r^6*t^5*(a*(1-alpha+alpha*a))+330*r^7*t^4*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+165*r^8*t^3*(b*(1-zeta+zeta*b))","462*r^5*t^6*(a*(1-alpha+alpha*a))+462*r^6*t^5*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+330*r^7*t^4*(b*(1-zeta+zeta*b))","330*r^4*t^7*(a*(1-alpha+alpha*a))+462*r^5*t^6*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+462*r^6*t^5*(b*(1-zeta+zeta*b))","165*r^3*t^8*(a*(1-alpha+alpha*a))+330*r^4*t^7*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+462*r^5*t^6*(b*(1-zeta+zeta*b))","55*r^2*t^9*(a*(1-alpha+alpha*a))+165*r^3*t^8*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+330*r^4*t^7*(b*(1-zeta+zeta*b))","11*r*t^10*(a*(1-alpha+alpha*a))+55*r^2*t^9*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+165*r^3*t^8*(b*(1-zeta+zeta*b))","1*1*t^11*(a*(1-alpha+alpha*a))+11*r*t^10*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+55*r^2*t^9*(b*(1-zeta+zeta*b))","1*1*t^11*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+11*r*t^10*(b*(1-zeta+zeta*b))","1*1*t^11*(b*(1-zeta+zeta*b))"],parameters:[["alpha",-1,1,0,!1,!1],["zeta",-1,1,0,!1,!1]]},"15":{functions:["1*r^12*1*(a*(1-alpha+alpha*a))","12*r^11*t*(a*(1-alpha+alpha*a))+1*r^12*1*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)","66*r^10*t^2*(a*(1-alpha+alpha*a))+12*r^11*t*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1*r^12*1*(b*(1-zeta+zeta*b))","220*r^9*t^3*(a*(1-alpha+alpha*a))+66*r^10*t^2*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+12*r^11*t*(b*(1-zeta+zeta*b))","495*r^8*t^4*(a*(1-alpha+alpha*a))+220*r^9*t^3*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+66*r^10*t^2*(b*(1-zeta+zeta*b))","792*r^7*t^5*(a*(1-alpha+alpha*a))+495*r^8*t^4*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+220*r^9*t^3*(b*(1-zeta+zeta*b))","924*r^6*t^6*(a*(1-alpha+alpha*a))+792*r^7*t^5*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+495*r^8*t^4*(b*(1-zeta+zeta*b))","792*r^5*t^7*(a*(1-alpha+alpha*a))+924*r^6*t^6*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+792*r^7*t^5*(b*(1-zeta+zeta*b))","495*r^4*t^8*(a*(1-alpha+alpha*a))+792*r^5*t^7*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+924*r^6*t^6*(b*(1-zeta+zeta*b))","220*r^3*t^9*(a*(1-alpha+alpha*a))+495*r^4*t^8*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+792*r^5*t^7*(b*(1-zeta+zeta*b))","66*r^2*t^10*(a*(1-alpha+alpha*a))+220*r^3*t^9*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+495*r^4*t^8*(b*(1-zeta+zeta*b))","12*r*t^11*(a*(1-alpha+alpha*a))+66*r^2*t^10*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+220*r^3*t^9*(b*(1-zeta+zeta*b))","1*1*t^12*(a*(1-alpha+alpha*a))+12*r*t^11*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+66*r^2*t^10*(b*(1-zeta+zeta*b))","1*1*t^12*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+12*r*t^11*(b*(1-zeta+zeta*b))","1*1*t^12*(b*(1-zeta+zeta*b))"],parameters:[["alpha",-1,1,0,!1,!1],["zeta",-1,1,0,!1,!1]]},"16":{functions:["1*r^13*1*(a*(1-alpha+alpha*a))","13*r^12*t*(a*(1-alpha+alpha*a))+1*r^13*1*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)","78*r^11*t^2*(a*(1-alpha+alpha*a))+13*r^12*t*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1*r^13*1*(b*(1-zeta+zeta*b))","286*r^10*t^3*(a*(1-alpha+alpha*a))+78*r^11*t^2*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+13*r^12*t*(b*(1-zeta+zeta*b))","715*r^9*t^4*(a*(1-alpha+alpha*a))+286*r^10*t^3*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+78*r^11*t^2*(b*(1-zeta+zeta*b))","1287*r^8*t^5*(a*(1-alpha+alpha*a))+715*r^9*t^4*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+286*r^10*t^3*(b*(1-zeta+zeta*b))","1716*r^7*t^6*(a*(1-alpha+alpha*a))+1287*r^8*t^5*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+715*r^9*t^4*(b*(1-zeta+zeta*b))","1716*r^6*t^7*(a*(1-alpha+alpha*a))+1716*r^7*t^6*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1287*r^8*t^5*(b*(1-zeta+zeta*b))","1287*r^5*t^8*(a*(1-alpha+alpha*a))+1716*r^6*t^7*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1716*r^7*t^6*(b*(1-zeta+zeta*b))","715*r^4*t^9*(a*(1-alpha+alpha*a))+1287*r^5*t^8*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1716*r^6*t^7*(b*(1-zeta+zeta*b))","286*r^3*t^10*(a*(1-alpha+alpha*a))+715*r^4*t^9*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1287*r^5*t^8*(b*(1-zeta+zeta*b))","78*r^2*t^11*(a*(1-alpha+alpha*a))+286*r^3*t^10*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+715*r^4*t^9*(b*(1-zeta+zeta*b))","13*r*t^12*(a*(1-alpha+alpha*a))+78*r^2*t^11*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+286*r^3*t^10*(b*(1-zeta+zeta*b))","1*1*t^13*(a*(1-alpha+alpha*a))+13*r*t^12*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+78*r^2*t^11*(b*(1-zeta+zeta*b))","1*1*t^13*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+13*r*t^12*(b*(1-zeta+zeta*b))","1*1*t^13*(b*(1-zeta+zeta*b))"],parameters:[["alpha",-1,1,0,!1,!1],["zeta",-1,1,0,!1,!1]]}}},{name:"generalised_trigonometric_squares",title:"Generalised trigonometric Bézier, with cos² and sin² for 1 - t and t",counts:"3 to 34 control points",sizes:[3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24,25,26,27,28,29,30,31,32,33,34],usual:6,formulas:{"3":{functions:["1*1*1*(a*(1-alpha+alpha*a))","1*1*1*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)","1*1*1*(b*(1-zeta+zeta*b))"],parameters:[["alpha",-1,1,0,!1,!1],["zeta",-1,1,0,!1,!1]]},"4":{functions:["1*c^2*1*(a*(1-alpha+alpha*a))","1*1*s^2*(a*(1-alpha+alpha*a))+1*c^2*1*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)","1*1*s^2*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1*c^2*1*(b*(1-zeta+zeta*b))","1*1*s^2*(b*(1-zeta+zeta*b))"],parameters:[["alpha",-1,1,0,!1,!1],["zeta",-1,1,0,!1,!1]]},"5":{functions:["1*c^4*1*(a*(1-alpha+alpha*a))","2*c^2*s^2*(a*(1-alpha+alpha*a))+1*c^4*1*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)","1*1*s^4*(a*(1-alpha+alpha*a))+2*c^2*s^2*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1*c^4*1*(b*(1-zeta+zeta*b))","1*1*s^4*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+2*c^2*s^2*(b*(1-zeta+zeta*b))","1*1*s^4*(b*(1-zeta+zeta*b))"],parameters:[["alpha",-1,1,0,!1,!1],["zeta",-1,1,0,!1,!1]]},"6":{functions:["1*c^6*1*(a*(1-alpha+alpha*a))","3*c^4*s^2*(a*(1-alpha+alpha*a))+1*c^6*1*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)","3*c^2*s^4*(a*(1-alpha+alpha*a))+3*c^4*s^2*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1*c^6*1*(b*(1-zeta+zeta*b))","1*1*s^6*(a*(1-alpha+alpha*a))+3*c^2*s^4*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+3*c^4*s^2*(b*(1-zeta+zeta*b))","1*1*s^6*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+3*c^2*s^4*(b*(1-zeta+zeta*b))","1*1*s^6*(b*(1-zeta+zeta*b))"],parameters:[["alpha",-1,1,0,!1,!1],["zeta",-1,1,0,!1,!1]]},"7":{functions:["1*c^8*1*(a*(1-alpha+alpha*a))","4*c^6*s^2*(a*(1-alpha+alpha*a))+1*c^8*1*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)","6*c^4*s^4*(a*(1-alpha+alpha*a))+4*c^6*s^2*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1*c^8*1*(b*(1-zeta+zeta*b))","4*c^2*s^6*(a*(1-alpha+alpha*a))+6*c^4*s^4*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+4*c^6*s^2*(b*(1-zeta+zeta*b))","1*1*s^8*(a*(1-alpha+alpha*a))+4*c^2*s^6*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+6*c^4*s^4*(b*(1-zeta+zeta*b))","1*1*s^8*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+4*c^2*s^6*(b*(1-zeta+zeta*b))","1*1*s^8*(b*(1-zeta+zeta*b))"],parameters:[["alpha",-1,1,0,!1,!1],["zeta",-1,1,0,!1,!1]]},"8":{functions:["1*c^10*1*(a*(1-alpha+alpha*a))","5*c^8*s^2*(a*(1-alpha+alpha*a))+1*c^10*1*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)","10*c^6*s^4*(a*(1-alpha+alpha*a))+5*c^8*s^2*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1*c^10*1*(b*(1-zeta+zeta*b))","10*c^4*s^6*(a*(1-alpha+alpha*a))+10*c^6*s^4*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+5*c^8*s^2*(b*(1-zeta+zeta*b))","5*c^2*s^8*(a*(1-alpha+alpha*a))+10*c^4*s^6*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+10*c^6*s^4*(b*(1-zeta+zeta*b))","1*1*s^10*(a*(1-alpha+alpha*a))+5*c^2*s^8*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+10*c^4*s^6*(b*(1-zeta+zeta*b))","1*1*s^10*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+5*c^2*s^8*(b*(1-zeta+zeta*b))","1*1*s^10*(b*(1-zeta+zeta*b))"],parameters:[["alpha",-1,1,0,!1,!1],["zeta",-1,1,0,!1,!1]]},"9":{functions:["1*c^12*1*(a*(1-alpha+alpha*a))","6*c^10*s^2*(a*(1-alpha+alpha*a))+1*c^12*1*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)","15*c^8*s^4*(a*(1-alpha+alpha*a))+6*c^10*s^2*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1*c^12*1*(b*(1-zeta+zeta*b))","20*c^6*s^6*(a*(1-alpha+alpha*a))+15*c^8*s^4*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+6*c^10*s^2*(b*(1-zeta+zeta*b))","15*c^4*s^8*(a*(1-alpha+alpha*a))+20*c^6*s^6*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+15*c^8*s^4*(b*(1-zeta+zeta*b))","6*c^2*s^10*(a*(1-alpha+alpha*a))+15*c^4*s^8*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+20*c^6*s^6*(b*(1-zeta+zeta*b))","1*1*s^12*(a*(1-alpha+alpha*a))+6*c^2*s^10*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+15*c^4*s^8*(b*(1-zeta+zeta*b))","1*1*s^12*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+6*c^2*s^10*(b*(1-zeta+zeta*b))","1*1*s^12*(b*(1-zeta+zeta*b))"],parameters:[["alpha",-1,1,0,!1,!1],["zeta",-1,1,0,!1,!1]]},"10":{functions:["1*c^14*1*(a*(1-alpha+alpha*a))","7*c^12*s^2*(a*(1-alpha+alpha*a))+1*c^14*1*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)","21*c^10*s^4*(a*(1-alpha+alpha*a))+7*c^12*s^2*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1*c^14*1*(b*(1-zeta+zeta*b))","35*c^8*s^6*(a*(1-alpha+alpha*a))+21*c^10*s^4*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+7*c^12*s^2*(b*(1-zeta+zeta*b))","35*c^6*s^8*(a*(1-alpha+alpha*a))+35*c^8*s^6*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+21*c^10*s^4*(b*(1-zeta+zeta*b))","21*c^4*s^10*(a*(1-alpha+alpha*a))+35*c^6*s^8*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+35*c^8*s^6*(b*(1-zeta+zeta*b))","7*c^2*s^12*(a*(1-alpha+alpha*a))+21*c^4*s^10*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+35*c^6*s^8*(b*(1-zeta+zeta*b))","1*1*s^14*(a*(1-alpha+alpha*a))+7*c^2*s^12*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+21*c^4*s^10*(b*(1-zeta+zeta*b))","1*1*s^14*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+7*c^2*s^12*(b*(1-zeta+zeta*b))","1*1*s^14*(b*(1-zeta+zeta*b))"],parameters:[["alpha",-1,1,0,!1,!1],["zeta",-1,1,0,!1,!1]]},"11":{functions:["1*c^16*1*(a*(1-alpha+alpha*a))","8*c^14*s^2*(a*(1-alpha+alpha*a))+1*c^16*1*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)","28*c^12*s^4*(a*(1-alpha+alpha*a))+8*c^14*s^2*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1*c^16*1*(b*(1-zeta+zeta*b))","56*c^10*s^6*(a*(1-alpha+alpha*a))+28*c^12*s^4*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+8*c^14*s^2*(b*(1-zeta+zeta*b))","70*c^8*s^8*(a*(1-alpha+alpha*a))+56*c^10*s^6*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+28*c^12*s^4*(b*(1-zeta+zeta*b))","56*c^6*s^10*(a*(1-alpha+alpha*a))+70*c^8*s^8*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+56*c^10*s^6*(b*(1-zeta+zeta*b))","28*c^4*s^12*(a*(1-alpha+alpha*a))+56*c^6*s^10*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+70*c^8*s^8*(b*(1-zeta+zeta*b))","8*c^2*s^14*(a*(1-alpha+alpha*a))+28*c^4*s^12*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+56*c^6*s^10*(b*(1-zeta+zeta*b))","1*1*s^16*(a*(1-alpha+alpha*a))+8*c^2*s^14*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+28*c^4*s^12*(b*(1-zeta+zeta*b))","1*1*s^16*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+8*c^2*s^14*(b*(1-zeta+zeta*b))","1*1*s^16*(b*(1-zeta+zeta*b))"],parameters:[["alpha",-1,1,0,!1,!1],["zeta",-1,1,0,!1,!1]]},"12":{functions:["1*c^18*1*(a*(1-alpha+alpha*a))","9*c^16*s^2*(a*(1-alpha+alpha*a))+1*c^18*1*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)","36*c^14*s^4*(a*(1-alpha+alpha*a))+9*c^16*s^2*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1*c^18*1*(b*(1-zeta+zeta*b))","84*c^12*s^6*(a*(1-alpha+alpha*a))+36*c^14*s^4*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+9*c^16*s^2*(b*(1-zeta+zeta*b))","126*c^10*s^8*(a*(1-alpha+alpha*a))+84*c^12*s^6*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+36*c^14*s^4*(b*(1-zeta+zeta*b))","126*c^8*s^10*(a*(1-alpha+alpha*a))+126*c^10*s^8*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+84*c^12*s^6*(b*(1-zeta+zeta*b))","84*c^6*s^12*(a*(1-alpha+alpha*a))+126*c^8*s^10*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+126*c^10*s^8*(b*(1-zeta+zeta*b))","36*c^4*s^14*(a*(1-alpha+alpha*a))+84*c^6*s^12*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+126*c^8*s^10*(b*(1-zeta+zeta*b))","9*c^2*s^16*(a*(1-alpha+alpha*a))+36*c^4*s^14*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+84*c^6*s^12*(b*(1-zeta+zeta*b))","1*1*s^18*(a*(1-alpha+alpha*a))+9*c^2*s^16*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+36*c^4*s^14*(b*(1-zeta+zeta*b))","1*1*s^18*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+9*c^2*s^16*(b*(1-zeta+zeta*b))","1*1*s^18*(b*(1-zeta+zeta*b))"],parameters:[["alpha",-1,1,0,!1,!1],["zeta",-1,1,0,!1,!1]]},"13":{functions:["1*c^20*1*(a*(1-alpha+alpha*a))","10*c^18*s^2*(a*(1-alpha+alpha*a))+1*c^20*1*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)","45*c^16*s^4*(a*(1-alpha+alpha*a))+10*c^18*s^2*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1*c^20*1*(b*(1-zeta+zeta*b))","120*c^14*s^6*(a*(1-alpha+alpha*a))+45*c^16*s^4*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+10*c^18*s^2*(b*(1-zeta+zeta*b))","210*c^12*s^8*(a*(1-alpha+alpha*a))+120*c^14*s^6*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+45*c^16*s^4*(b*(1-zeta+zeta*b))","252*c^10*s^10*(a*(1-alpha+alpha*a))+210*c^12*s^8*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+120*c^14*s^6*(b*(1-zeta+zeta*b))","210*c^8*s^12*(a*(1-alpha+alpha*a))+252*c^10*s^10*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+210*c^12*s^8*(b*(1-zeta+zeta*b))","120*c^6*s^14*(a*(1-alpha+alpha*a))+210*c^8*s^12*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+252*c^10*s^10*(b*(1-zeta+zeta*b))","45*c^4*s^16*(a*(1-alpha+alpha*a))+120*c^6*s^14*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+210*c^8*s^12*(b*(1-zeta+zeta*b))","10*c^2*s^18*(a*(1-alpha+alpha*a))+45*c^4*s^16*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+120*c^6*s^14*(b*(1-zeta+zeta*b))","1*1*s^20*(a*(1-alpha+alpha*a))+10*c^2*s^18*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+45*c^4*s^16*(b*(1-zeta+zeta*b))","1*1*s^20*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+10*c^2*s^18*(b*(1-zeta+zeta*b))","1*1*s^20*(b*(1-zeta+zeta*b))"],parameters:[["alpha",-1,1,0,!1,!1],["zeta",-1,1,0,!1,!1]]},"14":{functions:["1*c^22*1*(a*(1-alpha+alpha*a))","11*c^20*s^2*(a*(1-alpha+alpha*a))+1*c^22*1*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)","55*c^18*s^4*(a*(1-alpha+alpha*a))+11*c^20*s^2*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1*c^22*1*(b*(1-zeta+zeta*b))","165*c^16*s^6*(a*(1-alpha+alpha*a))+55*c^18*s^4*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+11*c^20*s^2*(b*(1-zeta+zeta*b))","330*c^14*s^8*(a*(1-alpha+alpha*a))+165*c^16*s^6*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+55*c^18*s^4*(b*(1-zeta+zeta*b))","462*c^12*s^10*(a*(1-alpha+alpha*a))+330*c^14*s^8*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+165*c^16*s^6*(b*(1-zeta+zeta*b))","462*c^10*s^12*(a*(1-alpha+alpha*a))+462*c^12*s^10*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+330*c^14*s^8*(b*(1-zeta+zeta*b))","330*c^8*s^14*(a*(1-alpha+alpha*a))+462*c^10*s^12*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+462*c^12*s^10*(b*(1-zeta+zeta*b))","165*c^6*s^16*(a*(1-alpha+alpha*a))+330*c^8*s^14*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+462*c^10*s^12*(b*(1-zeta+zeta*b))","55*c^4*s^18*(a*(1-alpha+alpha*a))+165*c^6*s^16*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+330*c^8*s^14*(b*(1-zeta+zeta*b))","11*c^2*s^20*(a*(1-alpha+alpha*a))+55*c^4*s^18*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+165*c^6*s^16*(b*(1-zeta+zeta*b))","1*1*s^22*(a*(1-alpha+alpha*a))+11*c^2*s^20*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+55*c^4*s^18*(b*(1-zeta+zeta*b))","1*1*s^22*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+11*c^2*s^20*(b*(1-zeta+zeta*b))","1*1*s^22*(b*(1-zeta+zeta*b))"],parameters:[["alpha",-1,1,0,!1,!1],["zeta",-1,1,0,!1,!1]]},"15":{functions:["1*c^24*1*(a*(1-alpha+alpha*a))","12*c^22*s^2*(a*(1-alpha+alpha*a))+1*c^24*1*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)","66*c^20*s^4*(a*(1-alpha+alpha*a))+12*c^22*s^2*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1*c^24*1*(b*(1-zeta+zeta*b))","220*c^18*s^6*(a*(1-alpha+alpha*a))+66*c^20*s^4*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+12*c^22*s^2*(b*(1-zeta+zeta*b))","495*c^16*s^8*(a*(1-alpha+alpha*a))+220*c^18*s^6*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+66*c^20*s^4*(b*(1-zeta+zeta*b))","792*c^14*s^10*(a*(1-alpha+alpha*a))+495*c^16*s^8*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+220*c^18*s^6*(b*(1-zeta+zeta*b))","924*c^12*s^12*(a*(1-alpha+alpha*a))+792*c^14*s^10*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+495*c^16*s^8*(b*(1-zeta+zeta*b))","792*c^10*s^14*(a*(1-alpha+alpha*a))+924*c^12*s^12*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+792*c^14*s^10*(b*(1-zeta+zeta*b))","495*c^8*s^16*(a*(1-alpha+alpha*a))+792*c^10*s^14*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+924*c^12*s^12*(b*(1-zeta+zeta*b))","220*c^6*s^18*(a*(1-alpha+alpha*a))+495*c^8*s^16*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+792*c^10*s^14*(b*(1-zeta+zeta*b))","66*c^4*s^20*(a*(1-alpha+alpha*a))+220*c^6*s^18*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+495*c^8*s^16*(b*(1-zeta+zeta*b))","12*c^2*s^22*(a*(1-alpha+alpha*a))+66*c^4*s^20*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+220*c^6*s^18*(b*(1-zeta+zeta*b))","1*1*s^24*(a*(1-alpha+alpha*a))+12*c^2*s^22*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+66*c^4*s^20*(b*(1-zeta+zeta*b))","1*1*s^24*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+12*c^2*s^22*(b*(1-zeta+zeta*b))","1*1*s^24*(b*(1-zeta+zeta*b))"],parameters:[["alpha",-1,1,0,!1,!1],["zeta",-1,1,0,!1,!1]]},"16":{functions:["1*c^26*1*(a*(1-alpha+alpha*a))","13*c^24*s^2*(a*(1-alpha+alpha*a))+1*c^26*1*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)","78*c^22*s^4*(a*(1-alpha+alpha*a))+13*c^24*s^2*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1*c^26*1*(b*(1-zeta+zeta*b))","286*c^20*s^6*(a*(1-alpha+alpha*a))+78*c^22*s^4*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+13*c^24*s^2*(b*(1-zeta+zeta*b))","715*c^18*s^8*(a*(1-alpha+alpha*a))+286*c^20*s^6*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+78*c^22*s^4*(b*(1-zeta+zeta*b))","1287*c^16*s^10*(a*(1-alpha+alpha*a))+715*c^18*s^8*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+286*c^20*s^6*(b*(1-zeta+zeta*b))","1716*c^14*s^12*(a*(1-alpha+alpha*a))+1287*c^16*s^10*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+715*c^18*s^8*(b*(1-zeta+zeta*b))","1716*c^12*s^14*(a*(1-alpha+alpha*a))+1716*c^14*s^12*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1287*c^16*s^10*(b*(1-zeta+zeta*b))","1287*c^10*s^16*(a*(1-alpha+alpha*a))+1716*c^12*s^14*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1716*c^14*s^12*(b*(1-zeta+zeta*b))","715*c^8*s^18*(a*(1-alpha+alpha*a))+1287*c^10*s^16*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1716*c^12*s^14*(b*(1-zeta+zeta*b))","286*c^6*s^20*(a*(1-alpha+alpha*a))+715*c^8*s^18*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+1287*c^10*s^16*(b*(1-zeta+zeta*b))","78*c^4*s^22*(a*(1-alpha+alpha*a))+286*c^6*s^20*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+715*c^8*s^18*(b*(1-zeta+zeta*b))","13*c^2*s^24*(a*(1-alpha+alpha*a))+78*c^4*s^22*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+286*c^6*s^20*(b*(1-zeta+zeta*b))","1*1*s^26*(a*(1-alpha+alpha*a))+13*c^2*s^24*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+78*c^4*s^22*(b*(1-zeta+zeta*b))","1*1*s^26*(2*sqrt(2)*sin(pi*t/4)*sin(pi*r/4)+alpha*s*a+zeta*c*b)+13*c^2*s^24*(b*(1-zeta+zeta*b))","1*1*s^26*(b*(1-zeta+zeta*b))"],parameters:[["alpha",-1,1,0,!1,!1],["zeta",-1,1,0,!1,!1]]}}},{name:"sg_bezier",title:"Shape-adjustable generalised Bézier",counts:"3 to 7 control points",sizes:[3,4,5,6,7],usual:4,formulas:{"3":{functions:["r^2*(r+(1-lam1)*t)","t*r*((2+lam1)*r+(2+lam2)*t)","t^2*(t+(1-lam2)*r)"],parameters:[["lam1",-2,1,0,!1,!1],["lam2",-2,1,0,!1,!1]]},"4":{functions:["r^3*(r+(1-lam1)*t)","t*r^2*((3+lam1)*r+(3-lam2)*t)","t^2*r*((3+lam2)*r+(3+lam3)*t)","t^3*(t+(1-lam3)*r)"],parameters:[["lam1",-3,1,0,!1,!1],["lam2",-3,3,0,!1,!1],["lam3",-3,1,0,!1,!1]]},"5":{functions:["r^4*(r+(1-lam1)*t)","t*r^3*((4+lam1)*r+(4-lam2)*t)","t^2*r^2*((6+lam2)*r+(6+lam3)*t)","t^3*r*((4-lam3)*r+(4+lam4)*t)","t^4*(t+(1-lam4)*r)"],parameters:[["lam1",-4,1,0,!1,!1],["lam2",-6,4,0,!1,!1],["lam3",-6,4,0,!1,!1],["lam4",-4,1,0,!1,!1]]},"6":{functions:["r^5*(r+(1-lam1)*t)","t*r^4*((5+lam1)*r+(5-lam2)*t)","t^2*r^3*((10+lam2)*r+(10-lam3)*t)","t^3*r^2*((10+lam3)*r+(10+lam4)*t)","t^4*r*((5-lam4)*r+(5+lam5)*t)","t^5*(t+(1-lam5)*r)"],parameters:[["lam1",-5,1,0,!1,!1],["lam2",-10,5,0,!1,!1],["lam3",-10,10,0,!1,!1],["lam4",-10,5,0,!1,!1],["lam5",-5,1,0,!1,!1]]},"7":{functions:["r^6*(r+(1-lam1)*t)","t*r^5*((6+lam1)*r+(6-lam2)*t)","t^2*r^4*((15+lam2)*r+(15-lam3)*t)","t^3*r^3*((20+lam3)*r+(20+lam4)*t)","t^4*r^2*((15-lam4)*r+(15+lam5)*t)","t^5*r*((6-lam5)*r+(6+lam6)*t)","t^6*(t+(1-lam6)*r)"],parameters:[["lam1",-6,1,0,!1,!1],["lam2",-15,6,0,!1,!1],["lam3",-20,15,0,!1,!1],["lam4",-20,15,0,!1,!1],["lam5",-15,6,0,!1,!1],["lam6",-6,1,0,!1,!1]]}}},{name:"lambda_bezier",title:"λ-Bézier",counts:"3 or more control points",sizes:[3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24,25,26,27,28,29,30,31,32,33,34,35,36,37,38,39,40,41,42,43,44,45,46,47,48,49,50,51,52,53,54,55,56,57,58,59,60,61,62,63,64],usual:4,formulas:{"3":{functions:["r^2*(r+(1-lam)*t)","t*r*((2+(1/1)*lam)*r+(2-(-1/1)*lam)*t)","t^2*(t+(1-lam)*r)"],parameters:[["lam",-1,1,0,!1,!1]]},"4":{functions:["r^3*(r+(1-lam)*t)","t*r^2*((3+(1/1)*lam)*r+(3-(0/1)*lam)*t)","t^2*r*((3+(0/1)*lam)*r+(3-(-1/1)*lam)*t)","t^3*(t+(1-lam)*r)"],parameters:[["lam",-1,1,0,!1,!1]]},"5":{functions:["r^4*(r+(1-lam)*t)","t*r^3*((4+(1/1)*lam)*r+(4-(2/3)*lam)*t)","t^2*r^2*((6+(2/3)*lam)*r+(6-(-2/3)*lam)*t)","t^3*r*((4+(-2/3)*lam)*r+(4-(-1/1)*lam)*t)","t^4*(t+(1-lam)*r)"],parameters:[["lam",-1,1,0,!1,!1]]},"6":{functions:["r^5*(r+(1-lam)*t)","t*r^4*((5+(1/1)*lam)*r+(5-(5/4)*lam)*t)","t^2*r^3*((10+(5/4)*lam)*r+(10-(0/1)*lam)*t)","t^3*r^2*((10+(0/1)*lam)*r+(10-(-5/4)*lam)*t)","t^4*r*((5+(-5/4)*lam)*r+(5-(-1/1)*lam)*t)","t^5*(t+(1-lam)*r)"],parameters:[["lam",-1,1,0,!1,!1]]},"7":{functions:["r^6*(r+(1-lam)*t)","t*r^5*((6+(1/1)*lam)*r+(6-(9/5)*lam)*t)","t^2*r^4*((15+(9/5)*lam)*r+(15-(1/1)*lam)*t)","t^3*r^3*((20+(1/1)*lam)*r+(20-(-1/1)*lam)*t)","t^4*r^2*((15+(-1/1)*lam)*r+(15-(-9/5)*lam)*t)","t^5*r*((6+(-9/5)*lam)*r+(6-(-1/1)*lam)*t)","t^6*(t+(1-lam)*r)"],parameters:[["lam",-1,1,0,!1,!1]]},"8":{functions:["r^7*(r+(1-lam)*t)","t*r^6*((7+(1/1)*lam)*r+(7-(7/3)*lam)*t)","t^2*r^5*((21+(7/3)*lam)*r+(21-(7/3)*lam)*t)","t^3*r^4*((35+(7/3)*lam)*r+(35-(0/1)*lam)*t)","t^4*r^3*((35+(0/1)*lam)*r+(35-(-7/3)*lam)*t)","t^5*r^2*((21+(-7/3)*lam)*r+(21-(-7/3)*lam)*t)","t^6*r*((7+(-7/3)*lam)*r+(7-(-1/1)*lam)*t)","t^7*(t+(1-lam)*r)"],parameters:[["lam",-1,1,0,!1,!1]]},"9":{functions:["r^8*(r+(1-lam)*t)","t*r^7*((8+(1/1)*lam)*r+(8-(20/7)*lam)*t)","t^2*r^6*((28+(20/7)*lam)*r+(28-(4/1)*lam)*t)","t^3*r^5*((56+(4/1)*lam)*r+(56-(2/1)*lam)*t)","t^4*r^4*((70+(2/1)*lam)*r+(70-(-2/1)*lam)*t)","t^5*r^3*((56+(-2/1)*lam)*r+(56-(-4/1)*lam)*t)","t^6*r^2*((28+(-4/1)*lam)*r+(28-(-20/7)*lam)*t)","t^7*r*((8+(-20/7)*lam)*r+(8-(-1/1)*lam)*t)","t^8*(t+(1-lam)*r)"],parameters:[["lam",-1,1,0,!1,!1]]},"10":{functions:["r^9*(r+(1-lam)*t)","t*r^8*((9+(1/1)*lam)*r+(9-(27/8)*lam)*t)","t^2*r^7*((36+(27/8)*lam)*r+(36-(6/1)*lam)*t)","t^3*r^6*((84+(6/1)*lam)*r+(84-(21/4)*lam)*t)","t^4*r^5*((126+(21/4)*lam)*r+(126-(0/1)*lam)*t)","t^5*r^4*((126+(0/1)*lam)*r+(126-(-21/4)*lam)*t)","t^6*r^3*((84+(-21/4)*lam)*r+(84-(-6/1)*lam)*t)","t^7*r^2*((36+(-6/1)*lam)*r+(36-(-27/8)*lam)*t)","t^8*r*((9+(-27/8)*lam)*r+(9-(-1/1)*lam)*t)","t^9*(t+(1-lam)*r)"],parameters:[["lam",-1,1,0,!1,!1]]},"11":{functions:["r^10*(r+(1-lam)*t)","t*r^9*((10+(1/1)*lam)*r+(10-(35/9)*lam)*t)","t^2*r^8*((45+(35/9)*lam)*r+(45-(25/3)*lam)*t)","t^3*r^7*((120+(25/3)*lam)*r+(120-(10/1)*lam)*t)","t^4*r^6*((210+(10/1)*lam)*r+(210-(14/3)*lam)*t)","t^5*r^5*((252+(14/3)*lam)*r+(252-(-14/3)*lam)*t)","t^6*r^4*((210+(-14/3)*lam)*r+(210-(-10/1)*lam)*t)","t^7*r^3*((120+(-10/1)*lam)*r+(120-(-25/3)*lam)*t)","t^8*r^2*((45+(-25/3)*lam)*r+(45-(-35/9)*lam)*t)","t^9*r*((10+(-35/9)*lam)*r+(10-(-1/1)*lam)*t)","t^10*(t+(1-lam)*r)"],parameters:[["lam",-1,1,0,!1,!1]]},"12":{functions:["r^11*(r+(1-lam)*t)","t*r^10*((11+(1/1)*lam)*r+(11-(22/5)*lam)*t)","t^2*r^9*((55+(22/5)*lam)*r+(55-(11/1)*lam)*t)","t^3*r^8*((165+(11/1)*lam)*r+(165-(33/2)*lam)*t)","t^4*r^7*((330+(33/2)*lam)*r+(330-(66/5)*lam)*t)","t^5*r^6*((462+(66/5)*lam)*r+(462-(0/1)*lam)*t)","t^6*r^5*((462+(0/1)*lam)*r+(462-(-66/5)*lam)*t)","t^7*r^4*((330+(-66/5)*lam)*r+(330-(-33/2)*lam)*t)","t^8*r^3*((165+(-33/2)*lam)*r+(165-(-11/1)*lam)*t)","t^9*r^2*((55+(-11/1)*lam)*r+(55-(-22/5)*lam)*t)","t^10*r*((11+(-22/5)*lam)*r+(11-(-1/1)*lam)*t)","t^11*(t+(1-lam)*r)"],parameters:[["lam",-1,1,0,!1,!1]]},"13":{functions:["r^12*(r+(1-lam)*t)","t*r^11*((12+(1/1)*lam)*r+(12-(54/11)*lam)*t)","t^2*r^10*((66+(54/11)*lam)*r+(66-(14/1)*lam)*t)","t^3*r^9*((220+(14/1)*lam)*r+(220-(25/1)*lam)*t)","t^4*r^8*((495+(25/1)*lam)*r+(495-(27/1)*lam)*t)","t^5*r^7*((792+(27/1)*lam)*r+(792-(12/1)*lam)*t)","t^6*r^6*((924+(12/1)*lam)*r+(924-(-12/1)*lam)*t)","t^7*r^5*((792+(-12/1)*lam)*r+(792-(-27/1)*lam)*t)","t^8*r^4*((495+(-27/1)*lam)*r+(495-(-25/1)*lam)*t)","t^9*r^3*((220+(-25/1)*lam)*r+(220-(-14/1)*lam)*t)","t^10*r^2*((66+(-14/1)*lam)*r+(66-(-54/11)*lam)*t)","t^11*r*((12+(-54/11)*lam)*r+(12-(-1/1)*lam)*t)","t^12*(t+(1-lam)*r)"],parameters:[["lam",-1,1,0,!1,!1]]},"14":{functions:["r^13*(r+(1-lam)*t)","t*r^12*((13+(1/1)*lam)*r+(13-(65/12)*lam)*t)","t^2*r^11*((78+(65/12)*lam)*r+(78-(52/3)*lam)*t)","t^3*r^10*((286+(52/3)*lam)*r+(286-(143/4)*lam)*t)","t^4*r^9*((715+(143/4)*lam)*r+(715-(143/3)*lam)*t)","t^5*r^8*((1287+(143/3)*lam)*r+(1287-(143/4)*lam)*t)","t^6*r^7*((1716+(143/4)*lam)*r+(1716-(0/1)*lam)*t)","t^7*r^6*((1716+(0/1)*lam)*r+(1716-(-143/4)*lam)*t)","t^8*r^5*((1287+(-143/4)*lam)*r+(1287-(-143/3)*lam)*t)","t^9*r^4*((715+(-143/3)*lam)*r+(715-(-143/4)*lam)*t)","t^10*r^3*((286+(-143/4)*lam)*r+(286-(-52/3)*lam)*t)","t^11*r^2*((78+(-52/3)*lam)*r+(78-(-65/12)*lam)*t)","t^12*r*((13+(-65/12)*lam)*r+(13-(-1/1)*lam)*t)","t^13*(t+(1-lam)*r)"],parameters:[["lam",-1,1,0,!1,!1]]},"15":{functions:["r^14*(r+(1-lam)*t)","t*r^13*((14+(1/1)*lam)*r+(14-(77/13)*lam)*t)","t^2*r^12*((91+(77/13)*lam)*r+(91-(21/1)*lam)*t)","t^3*r^11*((364+(21/1)*lam)*r+(364-(49/1)*lam)*t)","t^4*r^10*((1001+(49/1)*lam)*r+(1001-(77/1)*lam)*t)","t^5*r^9*((2002+(77/1)*lam)*r+(2002-(77/1)*lam)*t)","t^6*r^8*((3003+(77/1)*lam)*r+(3003-(33/1)*lam)*t)","t^7*r^7*((3432+(33/1)*lam)*r+(3432-(-33/1)*lam)*t)","t^8*r^6*((3003+(-33/1)*lam)*r+(3003-(-77/1)*lam)*t)","t^9*r^5*((2002+(-77/1)*lam)*r+(2002-(-77/1)*lam)*t)","t^10*r^4*((1001+(-77/1)*lam)*r+(1001-(-49/1)*lam)*t)","t^11*r^3*((364+(-49/1)*lam)*r+(364-(-21/1)*lam)*t)","t^12*r^2*((91+(-21/1)*lam)*r+(91-(-77/13)*lam)*t)","t^13*r*((14+(-77/13)*lam)*r+(14-(-1/1)*lam)*t)","t^14*(t+(1-lam)*r)"],parameters:[["lam",-1,1,0,!1,!1]]},"16":{functions:["r^15*(r+(1-lam)*t)","t*r^14*((15+(1/1)*lam)*r+(15-(45/7)*lam)*t)","t^2*r^13*((105+(45/7)*lam)*r+(105-(25/1)*lam)*t)","t^3*r^12*((455+(25/1)*lam)*r+(455-(65/1)*lam)*t)","t^4*r^11*((1365+(65/1)*lam)*r+(1365-(117/1)*lam)*t)","t^5*r^10*((3003+(117/1)*lam)*r+(3003-(143/1)*lam)*t)","t^6*r^9*((5005+(143/1)*lam)*r+(5005-(715/7)*lam)*t)","t^7*r^8*((6435+(715/7)*lam)*r+(6435-(0/1)*lam)*t)","t^8*r^7*((6435+(0/1)*lam)*r+(6435-(-715/7)*lam)*t)","t^9*r^6*((5005+(-715/7)*lam)*r+(5005-(-143/1)*lam)*t)","t^10*r^5*((3003+(-143/1)*lam)*r+(3003-(-117/1)*lam)*t)","t^11*r^4*((1365+(-117/1)*lam)*r+(1365-(-65/1)*lam)*t)","t^12*r^3*((455+(-65/1)*lam)*r+(455-(-25/1)*lam)*t)","t^13*r^2*((105+(-25/1)*lam)*r+(105-(-45/7)*lam)*t)","t^14*r*((15+(-45/7)*lam)*r+(15-(-1/1)*lam)*t)","t^15*(t+(1-lam)*r)"],parameters:[["lam",-1,1,0,!1,!1]]}}},{name:"alpha_bernstein",title:"α-Bernstein",counts:"3 or more control points",sizes:[3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24,25,26,27,28,29,30,31,32,33,34,35,36,37,38,39,40,41,42,43,44,45,46,47,48,49,50,51,52,53,54,55,56,57,58,59,60,61,62,63,64],usual:4,formulas:{"3":{functions:["alpha*1*1*r^2+(1-alpha)*1*1*r","alpha*2*t*r","alpha*1*t^2*1+(1-alpha)*1*t*1"],parameters:[["alpha",0,1,1,!1,!1]]},"4":{functions:["alpha*1*1*r^3+(1-alpha)*1*1*r^2","alpha*3*t*r^2+(1-alpha)*1*t*r","alpha*3*t^2*r+(1-alpha)*1*t*r","alpha*1*t^3*1+(1-alpha)*1*t^2*1"],parameters:[["alpha",0,1,1,!1,!1]]},"5":{functions:["alpha*1*1*r^4+(1-alpha)*1*1*r^3","alpha*4*t*r^3+(1-alpha)*2*t*r^2","alpha*6*t^2*r^2+(1-alpha)*1*t^2*r+(1-alpha)*1*t*r^2","alpha*4*t^3*r+(1-alpha)*2*t^2*r","alpha*1*t^4*1+(1-alpha)*1*t^3*1"],parameters:[["alpha",0,1,1,!1,!1]]},"6":{functions:["alpha*1*1*r^5+(1-alpha)*1*1*r^4","alpha*5*t*r^4+(1-alpha)*3*t*r^3","alpha*10*t^2*r^3+(1-alpha)*3*t^2*r^2+(1-alpha)*1*t*r^3","alpha*10*t^3*r^2+(1-alpha)*1*t^3*r+(1-alpha)*3*t^2*r^2","alpha*5*t^4*r+(1-alpha)*3*t^3*r","alpha*1*t^5*1+(1-alpha)*1*t^4*1"],parameters:[["alpha",0,1,1,!1,!1]]},"7":{functions:["alpha*1*1*r^6+(1-alpha)*1*1*r^5","alpha*6*t*r^5+(1-alpha)*4*t*r^4","alpha*15*t^2*r^4+(1-alpha)*6*t^2*r^3+(1-alpha)*1*t*r^4","alpha*20*t^3*r^3+(1-alpha)*4*t^3*r^2+(1-alpha)*4*t^2*r^3","alpha*15*t^4*r^2+(1-alpha)*1*t^4*r+(1-alpha)*6*t^3*r^2","alpha*6*t^5*r+(1-alpha)*4*t^4*r","alpha*1*t^6*1+(1-alpha)*1*t^5*1"],parameters:[["alpha",0,1,1,!1,!1]]},"8":{functions:["alpha*1*1*r^7+(1-alpha)*1*1*r^6","alpha*7*t*r^6+(1-alpha)*5*t*r^5","alpha*21*t^2*r^5+(1-alpha)*10*t^2*r^4+(1-alpha)*1*t*r^5","alpha*35*t^3*r^4+(1-alpha)*10*t^3*r^3+(1-alpha)*5*t^2*r^4","alpha*35*t^4*r^3+(1-alpha)*5*t^4*r^2+(1-alpha)*10*t^3*r^3","alpha*21*t^5*r^2+(1-alpha)*1*t^5*r+(1-alpha)*10*t^4*r^2","alpha*7*t^6*r+(1-alpha)*5*t^5*r","alpha*1*t^7*1+(1-alpha)*1*t^6*1"],parameters:[["alpha",0,1,1,!1,!1]]},"9":{functions:["alpha*1*1*r^8+(1-alpha)*1*1*r^7","alpha*8*t*r^7+(1-alpha)*6*t*r^6","alpha*28*t^2*r^6+(1-alpha)*15*t^2*r^5+(1-alpha)*1*t*r^6","alpha*56*t^3*r^5+(1-alpha)*20*t^3*r^4+(1-alpha)*6*t^2*r^5","alpha*70*t^4*r^4+(1-alpha)*15*t^4*r^3+(1-alpha)*15*t^3*r^4","alpha*56*t^5*r^3+(1-alpha)*6*t^5*r^2+(1-alpha)*20*t^4*r^3","alpha*28*t^6*r^2+(1-alpha)*1*t^6*r+(1-alpha)*15*t^5*r^2","alpha*8*t^7*r+(1-alpha)*6*t^6*r","alpha*1*t^8*1+(1-alpha)*1*t^7*1"],parameters:[["alpha",0,1,1,!1,!1]]},"10":{functions:["alpha*1*1*r^9+(1-alpha)*1*1*r^8","alpha*9*t*r^8+(1-alpha)*7*t*r^7","alpha*36*t^2*r^7+(1-alpha)*21*t^2*r^6+(1-alpha)*1*t*r^7","alpha*84*t^3*r^6+(1-alpha)*35*t^3*r^5+(1-alpha)*7*t^2*r^6","alpha*126*t^4*r^5+(1-alpha)*35*t^4*r^4+(1-alpha)*21*t^3*r^5","alpha*126*t^5*r^4+(1-alpha)*21*t^5*r^3+(1-alpha)*35*t^4*r^4","alpha*84*t^6*r^3+(1-alpha)*7*t^6*r^2+(1-alpha)*35*t^5*r^3","alpha*36*t^7*r^2+(1-alpha)*1*t^7*r+(1-alpha)*21*t^6*r^2","alpha*9*t^8*r+(1-alpha)*7*t^7*r","alpha*1*t^9*1+(1-alpha)*1*t^8*1"],parameters:[["alpha",0,1,1,!1,!1]]},"11":{functions:["alpha*1*1*r^10+(1-alpha)*1*1*r^9","alpha*10*t*r^9+(1-alpha)*8*t*r^8","alpha*45*t^2*r^8+(1-alpha)*28*t^2*r^7+(1-alpha)*1*t*r^8","alpha*120*t^3*r^7+(1-alpha)*56*t^3*r^6+(1-alpha)*8*t^2*r^7","alpha*210*t^4*r^6+(1-alpha)*70*t^4*r^5+(1-alpha)*28*t^3*r^6","alpha*252*t^5*r^5+(1-alpha)*56*t^5*r^4+(1-alpha)*56*t^4*r^5","alpha*210*t^6*r^4+(1-alpha)*28*t^6*r^3+(1-alpha)*70*t^5*r^4","alpha*120*t^7*r^3+(1-alpha)*8*t^7*r^2+(1-alpha)*56*t^6*r^3","alpha*45*t^8*r^2+(1-alpha)*1*t^8*r+(1-alpha)*28*t^7*r^2","alpha*10*t^9*r+(1-alpha)*8*t^8*r","alpha*1*t^10*1+(1-alpha)*1*t^9*1"],parameters:[["alpha",0,1,1,!1,!1]]},"12":{functions:["alpha*1*1*r^11+(1-alpha)*1*1*r^10","alpha*11*t*r^10+(1-alpha)*9*t*r^9","alpha*55*t^2*r^9+(1-alpha)*36*t^2*r^8+(1-alpha)*1*t*r^9","alpha*165*t^3*r^8+(1-alpha)*84*t^3*r^7+(1-alpha)*9*t^2*r^8","alpha*330*t^4*r^7+(1-alpha)*126*t^4*r^6+(1-alpha)*36*t^3*r^7","alpha*462*t^5*r^6+(1-alpha)*126*t^5*r^5+(1-alpha)*84*t^4*r^6","alpha*462*t^6*r^5+(1-alpha)*84*t^6*r^4+(1-alpha)*126*t^5*r^5","alpha*330*t^7*r^4+(1-alpha)*36*t^7*r^3+(1-alpha)*126*t^6*r^4","alpha*165*t^8*r^3+(1-alpha)*9*t^8*r^2+(1-alpha)*84*t^7*r^3","alpha*55*t^9*r^2+(1-alpha)*1*t^9*r+(1-alpha)*36*t^8*r^2","alpha*11*t^10*r+(1-alpha)*9*t^9*r","alpha*1*t^11*1+(1-alpha)*1*t^10*1"],parameters:[["alpha",0,1,1,!1,!1]]},"13":{functions:["alpha*1*1*r^12+(1-alpha)*1*1*r^11","alpha*12*t*r^11+(1-alpha)*10*t*r^10","alpha*66*t^2*r^10+(1-alpha)*45*t^2*r^9+(1-alpha)*1*t*r^10","alpha*220*t^3*r^9+(1-alpha)*120*t^3*r^8+(1-alpha)*10*t^2*r^9","alpha*495*t^4*r^8+(1-alpha)*210*t^4*r^7+(1-alpha)*45*t^3*r^8","alpha*792*t^5*r^7+(1-alpha)*252*t^5*r^6+(1-alpha)*120*t^4*r^7","alpha*924*t^6*r^6+(1-alpha)*210*t^6*r^5+(1-alpha)*210*t^5*r^6","alpha*792*t^7*r^5+(1-alpha)*120*t^7*r^4+(1-alpha)*252*t^6*r^5","alpha*495*t^8*r^4+(1-alpha)*45*t^8*r^3+(1-alpha)*210*t^7*r^4","alpha*220*t^9*r^3+(1-alpha)*10*t^9*r^2+(1-alpha)*120*t^8*r^3","alpha*66*t^10*r^2+(1-alpha)*1*t^10*r+(1-alpha)*45*t^9*r^2","alpha*12*t^11*r+(1-alpha)*10*t^10*r","alpha*1*t^12*1+(1-alpha)*1*t^11*1"],parameters:[["alpha",0,1,1,!1,!1]]},"14":{functions:["alpha*1*1*r^13+(1-alpha)*1*1*r^12","alpha*13*t*r^12+(1-alpha)*11*t*r^11","alpha*78*t^2*r^11+(1-alpha)*55*t^2*r^10+(1-alpha)*1*t*r^11","alpha*286*t^3*r^10+(1-alpha)*165*t^3*r^9+(1-alpha)*11*t^2*r^10","alpha*715*t^4*r^9+(1-alpha)*330*t^4*r^8+(1-alpha)*55*t^3*r^9","alpha*1287*t^5*r^8+(1-alpha)*462*t^5*r^7+(1-alpha)*165*t^4*r^8","alpha*1716*t^6*r^7+(1-alpha)*462*t^6*r^6+(1-alpha)*330*t^5*r^7","alpha*1716*t^7*r^6+(1-alpha)*330*t^7*r^5+(1-alpha)*462*t^6*r^6","alpha*1287*t^8*r^5+(1-alpha)*165*t^8*r^4+(1-alpha)*462*t^7*r^5","alpha*715*t^9*r^4+(1-alpha)*55*t^9*r^3+(1-alpha)*330*t^8*r^4","alpha*286*t^10*r^3+(1-alpha)*11*t^10*r^2+(1-alpha)*165*t^9*r^3","alpha*78*t^11*r^2+(1-alpha)*1*t^11*r+(1-alpha)*55*t^10*r^2","alpha*13*t^12*r+(1-alpha)*11*t^11*r","alpha*1*t^13*1+(1-alpha)*1*t^12*1"],parameters:[["alpha",0,1,1,!1,!1]]},"15":{functions:["alpha*1*1*r^14+(1-alpha)*1*1*r^13","alpha*14*t*r^13+(1-alpha)*12*t*r^12","alpha*91*t^2*r^12+(1-alpha)*66*t^2*r^11+(1-alpha)*1*t*r^12","alpha*364*t^3*r^11+(1-alpha)*220*t^3*r^10+(1-alpha)*12*t^2*r^11","alpha*1001*t^4*r^10+(1-alpha)*495*t^4*r^9+(1-alpha)*66*t^3*r^10","alpha*2002*t^5*r^9+(1-alpha)*792*t^5*r^8+(1-alpha)*220*t^4*r^9","alpha*3003*t^6*r^8+(1-alpha)*924*t^6*r^7+(1-alpha)*495*t^5*r^8","alpha*3432*t^7*r^7+(1-alpha)*792*t^7*r^6+(1-alpha)*792*t^6*r^7","alpha*3003*t^8*r^6+(1-alpha)*495*t^8*r^5+(1-alpha)*924*t^7*r^6","alpha*2002*t^9*r^5+(1-alpha)*220*t^9*r^4+(1-alpha)*792*t^8*r^5","alpha*1001*t^10*r^4+(1-alpha)*66*t^10*r^3+(1-alpha)*495*t^9*r^4","alpha*364*t^11*r^3+(1-alpha)*12*t^11*r^2+(1-alpha)*220*t^10*r^3","alpha*91*t^12*r^2+(1-alpha)*1*t^12*r+(1-alpha)*66*t^11*r^2","alpha*14*t^13*r+(1-alpha)*12*t^12*r","alpha*1*t^14*1+(1-alpha)*1*t^13*1"],parameters:[["alpha",0,1,1,!1,!1]]},"16":{functions:["alpha*1*1*r^15+(1-alpha)*1*1*r^14","alpha*15*t*r^14+(1-alpha)*13*t*r^13","alpha*105*t^2*r^13+(1-alpha)*78*t^2*r^12+(1-alpha)*1*t*r^13","alpha*455*t^3*r^12+(1-alpha)*286*t^3*r^11+(1-alpha)*13*t^2*r^12","alpha*1365*t^4*r^11+(1-alpha)*715*t^4*r^10+(1-alpha)*78*t^3*r^11","alpha*3003*t^5*r^10+(1-alpha)*1287*t^5*r^9+(1-alpha)*286*t^4*r^10","alpha*5005*t^6*r^9+(1-alpha)*1716*t^6*r^8+(1-alpha)*715*t^5*r^9","alpha*6435*t^7*r^8+(1-alpha)*1716*t^7*r^7+(1-alpha)*1287*t^6*r^8","alpha*6435*t^8*r^7+(1-alpha)*1287*t^8*r^6+(1-alpha)*1716*t^7*r^7","alpha*5005*t^9*r^6+(1-alpha)*715*t^9*r^5+(1-alpha)*1716*t^8*r^6","alpha*3003*t^10*r^5+(1-alpha)*286*t^10*r^4+(1-alpha)*1287*t^9*r^5","alpha*1365*t^11*r^4+(1-alpha)*78*t^11*r^3+(1-alpha)*715*t^10*r^4","alpha*455*t^12*r^3+(1-alpha)*13*t^12*r^2+(1-alpha)*286*t^11*r^3","alpha*105*t^13*r^2+(1-alpha)*1*t^13*r+(1-alpha)*78*t^12*r^2","alpha*15*t^14*r+(1-alpha)*13*t^13*r","alpha*1*t^15*1+(1-alpha)*1*t^14*1"],parameters:[["alpha",0,1,1,!1,!1]]}}},{name:"ali_cubic",title:"Ali's cubic",counts:"4 control points",sizes:[4],usual:4,formulas:{"4":{functions:["r^2*(1+(2-p)*t)","p*t*r^2","q*t^2*r","t^2*(1+(2-q)*r)"],parameters:[["p",0,3,3,!1,!1],["q",0,3,3,!1,!1]]}}},{name:"q_bernstein",title:"q-Bernstein",counts:"2 to 11 control points",sizes:[2,3,4,5,6,7,8,9,10,11],usual:4,formulas:{"2":{functions:["(1*1)*1*(r+(1-q^0)*t)","(1*1)*t"],parameters:[["q",0,1,1,!0,!1]]},"3":{functions:["(1*1)*1*(r+(1-q^0)*t)*(r+(1-q^1)*t)","(1*1+1*q)*t*(r+(1-q^0)*t)","(1*1)*t^2"],parameters:[["q",0,1,1,!0,!1]]},"4":{functions:["(1*1)*1*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)","(1*1+1*q+1*q^2)*t*(r+(1-q^0)*t)*(r+(1-q^1)*t)","(1*1+1*q+1*q^2)*t^2*(r+(1-q^0)*t)","(1*1)*t^3"],parameters:[["q",0,1,1,!0,!1]]},"5":{functions:["(1*1)*1*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)*(r+(1-q^3)*t)","(1*1+1*q+1*q^2+1*q^3)*t*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)","(1*1+1*q+2*q^2+1*q^3+1*q^4)*t^2*(r+(1-q^0)*t)*(r+(1-q^1)*t)","(1*1+1*q+1*q^2+1*q^3)*t^3*(r+(1-q^0)*t)","(1*1)*t^4"],parameters:[["q",0,1,1,!0,!1]]},"6":{functions:["(1*1)*1*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)*(r+(1-q^3)*t)*(r+(1-q^4)*t)","(1*1+1*q+1*q^2+1*q^3+1*q^4)*t*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)*(r+(1-q^3)*t)","(1*1+1*q+2*q^2+2*q^3+2*q^4+1*q^5+1*q^6)*t^2*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)","(1*1+1*q+2*q^2+2*q^3+2*q^4+1*q^5+1*q^6)*t^3*(r+(1-q^0)*t)*(r+(1-q^1)*t)","(1*1+1*q+1*q^2+1*q^3+1*q^4)*t^4*(r+(1-q^0)*t)","(1*1)*t^5"],parameters:[["q",0,1,1,!0,!1]]},"7":{functions:["(1*1)*1*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)*(r+(1-q^3)*t)*(r+(1-q^4)*t)*(r+(1-q^5)*t)","(1*1+1*q+1*q^2+1*q^3+1*q^4+1*q^5)*t*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)*(r+(1-q^3)*t)*(r+(1-q^4)*t)","(1*1+1*q+2*q^2+2*q^3+3*q^4+2*q^5+2*q^6+1*q^7+1*q^8)*t^2*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)*(r+(1-q^3)*t)","(1*1+1*q+2*q^2+3*q^3+3*q^4+3*q^5+3*q^6+2*q^7+1*q^8+1*q^9)*t^3*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)","(1*1+1*q+2*q^2+2*q^3+3*q^4+2*q^5+2*q^6+1*q^7+1*q^8)*t^4*(r+(1-q^0)*t)*(r+(1-q^1)*t)","(1*1+1*q+1*q^2+1*q^3+1*q^4+1*q^5)*t^5*(r+(1-q^0)*t)","(1*1)*t^6"],parameters:[["q",0,1,1,!0,!1]]},"8":{functions:["(1*1)*1*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)*(r+(1-q^3)*t)*(r+(1-q^4)*t)*(r+(1-q^5)*t)*(r+(1-q^6)*t)","(1*1+1*q+1*q^2+1*q^3+1*q^4+1*q^5+1*q^6)*t*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)*(r+(1-q^3)*t)*(r+(1-q^4)*t)*(r+(1-q^5)*t)","(1*1+1*q+2*q^2+2*q^3+3*q^4+3*q^5+3*q^6+2*q^7+2*q^8+1*q^9+1*q^10)*t^2*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)*(r+(1-q^3)*t)*(r+(1-q^4)*t)","(1*1+1*q+2*q^2+3*q^3+4*q^4+4*q^5+5*q^6+4*q^7+4*q^8+3*q^9+2*q^10+1*q^11+1*q^12)*t^3*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)*(r+(1-q^3)*t)","(1*1+1*q+2*q^2+3*q^3+4*q^4+4*q^5+5*q^6+4*q^7+4*q^8+3*q^9+2*q^10+1*q^11+1*q^12)*t^4*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)","(1*1+1*q+2*q^2+2*q^3+3*q^4+3*q^5+3*q^6+2*q^7+2*q^8+1*q^9+1*q^10)*t^5*(r+(1-q^0)*t)*(r+(1-q^1)*t)","(1*1+1*q+1*q^2+1*q^3+1*q^4+1*q^5+1*q^6)*t^6*(r+(1-q^0)*t)","(1*1)*t^7"],parameters:[["q",0,1,1,!0,!1]]},"9":{functions:["(1*1)*1*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)*(r+(1-q^3)*t)*(r+(1-q^4)*t)*(r+(1-q^5)*t)*(r+(1-q^6)*t)*(r+(1-q^7)*t)","(1*1+1*q+1*q^2+1*q^3+1*q^4+1*q^5+1*q^6+1*q^7)*t*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)*(r+(1-q^3)*t)*(r+(1-q^4)*t)*(r+(1-q^5)*t)*(r+(1-q^6)*t)","(1*1+1*q+2*q^2+2*q^3+3*q^4+3*q^5+4*q^6+3*q^7+3*q^8+2*q^9+2*q^10+1*q^11+1*q^12)*t^2*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)*(r+(1-q^3)*t)*(r+(1-q^4)*t)*(r+(1-q^5)*t)","(1*1+1*q+2*q^2+3*q^3+4*q^4+5*q^5+6*q^6+6*q^7+6*q^8+6*q^9+5*q^10+4*q^11+3*q^12+2*q^13+1*q^14+1*q^15)*t^3*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)*(r+(1-q^3)*t)*(r+(1-q^4)*t)","(1*1+1*q+2*q^2+3*q^3+5*q^4+5*q^5+7*q^6+7*q^7+8*q^8+7*q^9+7*q^10+5*q^11+5*q^12+3*q^13+2*q^14+1*q^15+1*q^16)*t^4*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)*(r+(1-q^3)*t)","(1*1+1*q+2*q^2+3*q^3+4*q^4+5*q^5+6*q^6+6*q^7+6*q^8+6*q^9+5*q^10+4*q^11+3*q^12+2*q^13+1*q^14+1*q^15)*t^5*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)","(1*1+1*q+2*q^2+2*q^3+3*q^4+3*q^5+4*q^6+3*q^7+3*q^8+2*q^9+2*q^10+1*q^11+1*q^12)*t^6*(r+(1-q^0)*t)*(r+(1-q^1)*t)","(1*1+1*q+1*q^2+1*q^3+1*q^4+1*q^5+1*q^6+1*q^7)*t^7*(r+(1-q^0)*t)","(1*1)*t^8"],parameters:[["q",0,1,1,!0,!1]]},"10":{functions:["(1*1)*1*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)*(r+(1-q^3)*t)*(r+(1-q^4)*t)*(r+(1-q^5)*t)*(r+(1-q^6)*t)*(r+(1-q^7)*t)*(r+(1-q^8)*t)","(1*1+1*q+1*q^2+1*q^3+1*q^4+1*q^5+1*q^6+1*q^7+1*q^8)*t*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)*(r+(1-q^3)*t)*(r+(1-q^4)*t)*(r+(1-q^5)*t)*(r+(1-q^6)*t)*(r+(1-q^7)*t)","(1*1+1*q+2*q^2+2*q^3+3*q^4+3*q^5+4*q^6+4*q^7+4*q^8+3*q^9+3*q^10+2*q^11+2*q^12+1*q^13+1*q^14)*t^2*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)*(r+(1-q^3)*t)*(r+(1-q^4)*t)*(r+(1-q^5)*t)*(r+(1-q^6)*t)","(1*1+1*q+2*q^2+3*q^3+4*q^4+5*q^5+7*q^6+7*q^7+8*q^8+8*q^9+8*q^10+7*q^11+7*q^12+5*q^13+4*q^14+3*q^15+2*q^16+1*q^17+1*q^18)*t^3*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)*(r+(1-q^3)*t)*(r+(1-q^4)*t)*(r+(1-q^5)*t)","(1*1+1*q+2*q^2+3*q^3+5*q^4+6*q^5+8*q^6+9*q^7+11*q^8+11*q^9+12*q^10+11*q^11+11*q^12+9*q^13+8*q^14+6*q^15+5*q^16+3*q^17+2*q^18+1*q^19+1*q^20)*t^4*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)*(r+(1-q^3)*t)*(r+(1-q^4)*t)","(1*1+1*q+2*q^2+3*q^3+5*q^4+6*q^5+8*q^6+9*q^7+11*q^8+11*q^9+12*q^10+11*q^11+11*q^12+9*q^13+8*q^14+6*q^15+5*q^16+3*q^17+2*q^18+1*q^19+1*q^20)*t^5*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)*(r+(1-q^3)*t)","(1*1+1*q+2*q^2+3*q^3+4*q^4+5*q^5+7*q^6+7*q^7+8*q^8+8*q^9+8*q^10+7*q^11+7*q^12+5*q^13+4*q^14+3*q^15+2*q^16+1*q^17+1*q^18)*t^6*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)","(1*1+1*q+2*q^2+2*q^3+3*q^4+3*q^5+4*q^6+4*q^7+4*q^8+3*q^9+3*q^10+2*q^11+2*q^12+1*q^13+1*q^14)*t^7*(r+(1-q^0)*t)*(r+(1-q^1)*t)","(1*1+1*q+1*q^2+1*q^3+1*q^4+1*q^5+1*q^6+1*q^7+1*q^8)*t^8*(r+(1-q^0)*t)","(1*1)*t^9"],parameters:[["q",0,1,1,!0,!1]]},"11":{functions:["(1*1)*1*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)*(r+(1-q^3)*t)*(r+(1-q^4)*t)*(r+(1-q^5)*t)*(r+(1-q^6)*t)*(r+(1-q^7)*t)*(r+(1-q^8)*t)*(r+(1-q^9)*t)","(1*1+1*q+1*q^2+1*q^3+1*q^4+1*q^5+1*q^6+1*q^7+1*q^8+1*q^9)*t*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)*(r+(1-q^3)*t)*(r+(1-q^4)*t)*(r+(1-q^5)*t)*(r+(1-q^6)*t)*(r+(1-q^7)*t)*(r+(1-q^8)*t)","(1*1+1*q+2*q^2+2*q^3+3*q^4+3*q^5+4*q^6+4*q^7+5*q^8+4*q^9+4*q^10+3*q^11+3*q^12+2*q^13+2*q^14+1*q^15+1*q^16)*t^2*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)*(r+(1-q^3)*t)*(r+(1-q^4)*t)*(r+(1-q^5)*t)*(r+(1-q^6)*t)*(r+(1-q^7)*t)","(1*1+1*q+2*q^2+3*q^3+4*q^4+5*q^5+7*q^6+8*q^7+9*q^8+10*q^9+10*q^10+10*q^11+10*q^12+9*q^13+8*q^14+7*q^15+5*q^16+4*q^17+3*q^18+2*q^19+1*q^20+1*q^21)*t^3*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)*(r+(1-q^3)*t)*(r+(1-q^4)*t)*(r+(1-q^5)*t)*(r+(1-q^6)*t)","(1*1+1*q+2*q^2+3*q^3+5*q^4+6*q^5+9*q^6+10*q^7+13*q^8+14*q^9+16*q^10+16*q^11+18*q^12+16*q^13+16*q^14+14*q^15+13*q^16+10*q^17+9*q^18+6*q^19+5*q^20+3*q^21+2*q^22+1*q^23+1*q^24)*t^4*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)*(r+(1-q^3)*t)*(r+(1-q^4)*t)*(r+(1-q^5)*t)","(1*1+1*q+2*q^2+3*q^3+5*q^4+7*q^5+9*q^6+11*q^7+14*q^8+16*q^9+18*q^10+19*q^11+20*q^12+20*q^13+19*q^14+18*q^15+16*q^16+14*q^17+11*q^18+9*q^19+7*q^20+5*q^21+3*q^22+2*q^23+1*q^24+1*q^25)*t^5*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)*(r+(1-q^3)*t)*(r+(1-q^4)*t)","(1*1+1*q+2*q^2+3*q^3+5*q^4+6*q^5+9*q^6+10*q^7+13*q^8+14*q^9+16*q^10+16*q^11+18*q^12+16*q^13+16*q^14+14*q^15+13*q^16+10*q^17+9*q^18+6*q^19+5*q^20+3*q^21+2*q^22+1*q^23+1*q^24)*t^6*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)*(r+(1-q^3)*t)","(1*1+1*q+2*q^2+3*q^3+4*q^4+5*q^5+7*q^6+8*q^7+9*q^8+10*q^9+10*q^10+10*q^11+10*q^12+9*q^13+8*q^14+7*q^15+5*q^16+4*q^17+3*q^18+2*q^19+1*q^20+1*q^21)*t^7*(r+(1-q^0)*t)*(r+(1-q^1)*t)*(r+(1-q^2)*t)","(1*1+1*q+2*q^2+2*q^3+3*q^4+3*q^5+4*q^6+4*q^7+5*q^8+4*q^9+4*q^10+3*q^11+3*q^12+2*q^13+2*q^14+1*q^15+1*q^16)*t^8*(r+(1-q^0)*t)*(r+(1-q^1)*t)","(1*1+1*q+1*q^2+1*q^3+1*q^4+1*q^5+1*q^6+1*q^7+1*q^8+1*q^9)*t^9*(r+(1-q^0)*t)","(1*1)*t^10"],parameters:[["q",0,1,1,!0,!1]]}}},{name:"normalised_trigonometric",title:"Normalised trigonometric B-basis",counts:"3, 5, 7, 9 or 11 control points",sizes:[3,5,7,9,11],usual:5,formulas:{"3":{functions:["(1*1)*sin(beta*r/2)^2*1/sin(beta/2)^2","(1*(2*cos(beta/2)))*sin(beta*r/2)*sin(beta*t/2)/sin(beta/2)^2","(1*1)*1*sin(beta*t/2)^2/sin(beta/2)^2"],parameters:[["beta",0,3.141592653589793,1.5707963267948966,!0,!0]]},"5":{functions:["(1*1)*sin(beta*r/2)^4*1/sin(beta/2)^4","(2*(2*cos(beta/2)))*sin(beta*r/2)^3*sin(beta*t/2)/sin(beta/2)^4","(1*(2*cos(beta/2))^2+2*1)*sin(beta*r/2)^2*sin(beta*t/2)^2/sin(beta/2)^4","(2*(2*cos(beta/2)))*sin(beta*r/2)*sin(beta*t/2)^3/sin(beta/2)^4","(1*1)*1*sin(beta*t/2)^4/sin(beta/2)^4"],parameters:[["beta",0,3.141592653589793,1.5707963267948966,!0,!0]]},"7":{functions:["(1*1)*sin(beta*r/2)^6*1/sin(beta/2)^6","(3*(2*cos(beta/2)))*sin(beta*r/2)^5*sin(beta*t/2)/sin(beta/2)^6","(3*(2*cos(beta/2))^2+3*1)*sin(beta*r/2)^4*sin(beta*t/2)^2/sin(beta/2)^6","(1*(2*cos(beta/2))^3+6*(2*cos(beta/2)))*sin(beta*r/2)^3*sin(beta*t/2)^3/sin(beta/2)^6","(3*(2*cos(beta/2))^2+3*1)*sin(beta*r/2)^2*sin(beta*t/2)^4/sin(beta/2)^6","(3*(2*cos(beta/2)))*sin(beta*r/2)*sin(beta*t/2)^5/sin(beta/2)^6","(1*1)*1*sin(beta*t/2)^6/sin(beta/2)^6"],parameters:[["beta",0,3.141592653589793,1.5707963267948966,!0,!0]]},"9":{functions:["(1*1)*sin(beta*r/2)^8*1/sin(beta/2)^8","(4*(2*cos(beta/2)))*sin(beta*r/2)^7*sin(beta*t/2)/sin(beta/2)^8","(6*(2*cos(beta/2))^2+4*1)*sin(beta*r/2)^6*sin(beta*t/2)^2/sin(beta/2)^8","(4*(2*cos(beta/2))^3+12*(2*cos(beta/2)))*sin(beta*r/2)^5*sin(beta*t/2)^3/sin(beta/2)^8","(1*(2*cos(beta/2))^4+12*(2*cos(beta/2))^2+6*1)*sin(beta*r/2)^4*sin(beta*t/2)^4/sin(beta/2)^8","(4*(2*cos(beta/2))^3+12*(2*cos(beta/2)))*sin(beta*r/2)^3*sin(beta*t/2)^5/sin(beta/2)^8","(6*(2*cos(beta/2))^2+4*1)*sin(beta*r/2)^2*sin(beta*t/2)^6/sin(beta/2)^8","(4*(2*cos(beta/2)))*sin(beta*r/2)*sin(beta*t/2)^7/sin(beta/2)^8","(1*1)*1*sin(beta*t/2)^8/sin(beta/2)^8"],parameters:[["beta",0,3.141592653589793,1.5707963267948966,!0,!0]]},"11":{functions:["(1*1)*sin(beta*r/2)^10*1/sin(beta/2)^10","(5*(2*cos(beta/2)))*sin(beta*r/2)^9*sin(beta*t/2)/sin(beta/2)^10","(10*(2*cos(beta/2))^2+5*1)*sin(beta*r/2)^8*sin(beta*t/2)^2/sin(beta/2)^10","(10*(2*cos(beta/2))^3+20*(2*cos(beta/2)))*sin(beta*r/2)^7*sin(beta*t/2)^3/sin(beta/2)^10","(5*(2*cos(beta/2))^4+30*(2*cos(beta/2))^2+10*1)*sin(beta*r/2)^6*sin(beta*t/2)^4/sin(beta/2)^10","(1*(2*cos(beta/2))^5+20*(2*cos(beta/2))^3+30*(2*cos(beta/2)))*sin(beta*r/2)^5*sin(beta*t/2)^5/sin(beta/2)^10","(5*(2*cos(beta/2))^4+30*(2*cos(beta/2))^2+10*1)*sin(beta*r/2)^4*sin(beta*t/2)^6/sin(beta/2)^10","(10*(2*cos(beta/2))^3+20*(2*cos(beta/2)))*sin(beta*r/2)^3*sin(beta*t/2)^7/sin(beta/2)^10","(10*(2*cos(beta/2))^2+5*1)*sin(beta*r/2)^2*sin(beta*t/2)^8/sin(beta/2)^10","(5*(2*cos(beta/2)))*sin(beta*r/2)*sin(beta*t/2)^9/sin(beta/2)^10","(1*1)*1*sin(beta*t/2)^10/sin(beta/2)^10"],parameters:[["beta",0,3.141592653589793,1.5707963267948966,!0,!0]]}}},{name:"c_bezier",title:"C-Bézier",counts:"4 control points",sizes:[4],usual:4,formulas:{"4":{functions:["(phi*r-sin(phi*r))/(phi-sin(phi))","sin(phi/2)^3/(phi/2*(1-cos(phi/2))-(phi/2-sin(phi/2)))*((1-cos(phi*r))/(1-cos(phi))-(phi*r-sin(phi*r))/(phi-sin(phi)))","sin(phi/2)^3/(phi/2*(1-cos(phi/2))-(phi/2-sin(phi/2)))*((1-cos(phi*t))/(1-cos(phi))-(phi*t-sin(phi*t))/(phi-sin(phi)))","(phi*t-sin(phi*t))/(phi-sin(phi))"],parameters:[["phi",0,3.141592653589793,1.5707963267948966,!0,!1]]}}},{name:"h_bezier",title:"H-Bézier",counts:"4 control points",sizes:[4],usual:4,formulas:{"4":{functions:["(sinh(phi*r)-phi*r)/(sinh(phi)-phi)","sinh(phi/2)^3/(phi/2*(cosh(phi/2)-1)-(sinh(phi/2)-phi/2))*((cosh(phi*r)-1)/(cosh(phi)-1)-(sinh(phi*r)-phi*r)/(sinh(phi)-phi))","sinh(phi/2)^3/(phi/2*(cosh(phi/2)-1)-(sinh(phi/2)-phi/2))*((cosh(phi*t)-1)/(cosh(phi)-1)-(sinh(phi*t)-phi*t)/(sinh(phi)-phi))","(sinh(phi*t)-phi*t)/(sinh(phi)-phi)"],parameters:[["phi",0,8,1,!0,!1]]}}},{name:"bernstein",title:"Bernstein polynomials, classical Bézier",counts:"2 or more control points",sizes:[2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24,25,26,27,28,29,30,31,32,33,34,35,36,37,38,39,40,41,42,43,44,45,46,47,48,49,50,51,52,53,54,55,56,57,58,59,60,61,62,63,64],usual:4,formulas:{}}],basisKeys:["functions","parameters","source","claims"],words:{point_type:["","lies on one side of the tangent plane, like an egg","crosses the tangent plane, like a saddle","bends in one direction only, like a cylinder","is flat to second order, like a plane","bends alike in all directions, like a sphere"],hk_type:["","bulges towards the normal in all directions","bulges towards the normal in one direction, straight in the other","saddle that mostly bulges towards the normal","cannot occur, since H² >= K","plane","saddle, equally bent both ways","hollow in all directions","hollow in one direction, straight in the other","saddle that is mostly hollow"],shape_class:["","hollow of a sphere, S = -1","hollow, more bent one way","gutter, S = -1/2","gutter with a sagging axis","symmetric saddle, S = 0","crest with a sagging axis","crest, S = +1/2","bulge, more bent one way","bulge of a sphere, S = +1","plane, κ1 = κ2 = 0"]},kinds:{tensor:{title:"Tensor-product surface",construction:!0,surface:!0,shapeNames:["alpha1","zeta1","alpha2","zeta2"],fields:{flip:{description:"Turn the normal to the other side",required:!1,default:!1,type:"boolean"},shape:{description:"Shape parameters of the basis, those in u, then those in v; for the quintic basis (α1, ζ1, α2, ζ2), or (α, ζ) for a developable, each in [-4, 1]",required:!1,default:[0,0,0,0],type:"shape"},basis:{description:"Basis, by name, or two for u and v, such as ['cubic', 'quintic']; 'bernstein' gives the classical surface on the same points",required:!1,default:"trigonometric",type:"basis"},bases:{description:"Bases of your own by name: [bases.NAME] with functions = [...] and parameters = { NAME = [low, high] }, or the name of a file of [basis.NAME] tables beside the model",required:!1,default:{},type:"raw"},unchecked_shape:{description:"Allow shape parameters outside their range, [-4, 1] for the quintic basis; the convex-hull property is then lost",required:!1,default:!1,type:"boolean"},unchecked_basis:{description:"Allow a basis whose functions do not sum to 1; the surface moves with the origin",required:!1,default:!1,type:"boolean"},points:{description:"6 x 6 control points [x, y, z]; points[i][j] with i along u, j along v",required:!0,type:"points",counts:[6,6],dimension:3}}},symmetric:{title:"Tensor-product surface that is its own mirror image",construction:!0,surface:!0,shapeNames:["alpha1","zeta1","alpha2","zeta2"],fields:{flip:{description:"Turn the normal to the other side",required:!1,default:!1,type:"boolean"},shape:{description:"Shape parameters of the basis, those in u, then those in v; for the quintic basis (α1, ζ1, α2, ζ2), or (α, ζ) for a developable, each in [-4, 1]",required:!1,default:[0,0,0,0],type:"shape"},basis:{description:"Basis, by name, or two for u and v, such as ['cubic', 'quintic']; 'bernstein' gives the classical surface on the same points",required:!1,default:"trigonometric",type:"basis"},bases:{description:"Bases of your own by name: [bases.NAME] with functions = [...] and parameters = { NAME = [low, high] }, or the name of a file of [basis.NAME] tables beside the model",required:!1,default:{},type:"raw"},unchecked_shape:{description:"Allow shape parameters outside their range, [-4, 1] for the quintic basis; the convex-hull property is then lost",required:!1,default:!1,type:"boolean"},unchecked_basis:{description:"Allow a basis whose functions do not sum to 1; the surface moves with the origin",required:!1,default:!1,type:"boolean"},points:{description:"3 x 6 control points, half of the net; the other three rows are mirrored",required:!0,type:"points",counts:[3,6],dimension:3},mirror:{description:"Mirror plane [a, b, c, d]: a x + b y + c z + d = 0",required:!0,type:"plane"}}},swept:{title:"Translational sweep of a section along a trajectory",construction:!0,surface:!0,shapeNames:["alpha1","zeta1","alpha2","zeta2"],fields:{flip:{description:"Turn the normal to the other side",required:!1,default:!1,type:"boolean"},shape:{description:"Shape parameters of the basis, those in u, then those in v; for the quintic basis (α1, ζ1, α2, ζ2), or (α, ζ) for a developable, each in [-4, 1]",required:!1,default:[0,0,0,0],type:"shape"},basis:{description:"Basis, by name, or two for u and v, such as ['cubic', 'quintic']; 'bernstein' gives the classical surface on the same points",required:!1,default:"trigonometric",type:"basis"},bases:{description:"Bases of your own by name: [bases.NAME] with functions = [...] and parameters = { NAME = [low, high] }, or the name of a file of [basis.NAME] tables beside the model",required:!1,default:{},type:"raw"},unchecked_shape:{description:"Allow shape parameters outside their range, [-4, 1] for the quintic basis; the convex-hull property is then lost",required:!1,default:!1,type:"boolean"},unchecked_basis:{description:"Allow a basis whose functions do not sum to 1; the surface moves with the origin",required:!1,default:!1,type:"boolean"},section:{description:"6 points [x, y, z] of the section curve, along u",required:!0,type:"points",counts:[6],dimension:3},trajectory:{description:"6 points [x, y, z] of the trajectory curve, along v",required:!0,type:"points",counts:[6],dimension:3}}},swung:{title:"Profile swung along a plane trajectory",construction:!0,surface:!0,shapeNames:["alpha1","zeta1","alpha2","zeta2"],fields:{flip:{description:"Turn the normal to the other side",required:!1,default:!1,type:"boolean"},shape:{description:"Shape parameters of the basis, those in u, then those in v; for the quintic basis (α1, ζ1, α2, ζ2), or (α, ζ) for a developable, each in [-4, 1]",required:!1,default:[0,0,0,0],type:"shape"},basis:{description:"Basis, by name, or two for u and v, such as ['cubic', 'quintic']; 'bernstein' gives the classical surface on the same points",required:!1,default:"trigonometric",type:"basis"},bases:{description:"Bases of your own by name: [bases.NAME] with functions = [...] and parameters = { NAME = [low, high] }, or the name of a file of [basis.NAME] tables beside the model",required:!1,default:{},type:"raw"},unchecked_shape:{description:"Allow shape parameters outside their range, [-4, 1] for the quintic basis; the convex-hull property is then lost",required:!1,default:!1,type:"boolean"},unchecked_basis:{description:"Allow a basis whose functions do not sum to 1; the surface moves with the origin",required:!1,default:!1,type:"boolean"},profile:{description:"6 pairs [r, z] of the profile curve, along u",required:!0,type:"points",counts:[6],dimension:2},trajectory:{description:"6 pairs [x, y] of the trajectory curve, along v",required:!0,type:"points",counts:[6],dimension:2},scale:{description:"Scale factor λ of the trajectory",required:!1,default:1,type:"number"}}},ruled:{title:"Straight lines between two curves",construction:!0,surface:!0,shapeNames:["alpha1","zeta1","alpha2","zeta2"],fields:{flip:{description:"Turn the normal to the other side",required:!1,default:!1,type:"boolean"},shape:{description:"Shape parameters of the basis, those in u, then those in v; for the quintic basis (α1, ζ1, α2, ζ2), or (α, ζ) for a developable, each in [-4, 1]",required:!1,default:[0,0,0,0],type:"shape"},basis:{description:"Basis, by name, or two for u and v, such as ['cubic', 'quintic']; 'bernstein' gives the classical surface on the same points",required:!1,default:"trigonometric",type:"basis"},bases:{description:"Bases of your own by name: [bases.NAME] with functions = [...] and parameters = { NAME = [low, high] }, or the name of a file of [basis.NAME] tables beside the model",required:!1,default:{},type:"raw"},unchecked_shape:{description:"Allow shape parameters outside their range, [-4, 1] for the quintic basis; the convex-hull property is then lost",required:!1,default:!1,type:"boolean"},unchecked_basis:{description:"Allow a basis whose functions do not sum to 1; the surface moves with the origin",required:!1,default:!1,type:"boolean"},first:{description:"6 points [x, y, z] of the curve at v = 0, with (α1, ζ1)",required:!0,type:"points",counts:[6],dimension:3},second:{description:"6 points [x, y, z] of the curve at v = 1, with (α2, ζ2)",required:!0,type:"points",counts:[6],dimension:3}}},developable:{title:"Strip enveloped by a family of planes",construction:!0,surface:!0,shapeNames:["alpha","zeta"],fields:{flip:{description:"Turn the normal to the other side",required:!1,default:!1,type:"boolean"},shape:{description:"Shape parameters of the basis, those in u, then those in v; for the quintic basis (α1, ζ1, α2, ζ2), or (α, ζ) for a developable, each in [-4, 1]",required:!1,default:[0,0],type:"shape"},basis:{description:"Basis, by name, or two for u and v, such as ['cubic', 'quintic']; 'bernstein' gives the classical surface on the same points",required:!1,default:"trigonometric",type:"basis"},bases:{description:"Bases of your own by name: [bases.NAME] with functions = [...] and parameters = { NAME = [low, high] }, or the name of a file of [basis.NAME] tables beside the model",required:!1,default:{},type:"raw"},unchecked_shape:{description:"Allow shape parameters outside their range, [-4, 1] for the quintic basis; the convex-hull property is then lost",required:!1,default:!1,type:"boolean"},unchecked_basis:{description:"Allow a basis whose functions do not sum to 1; the surface moves with the origin",required:!1,default:!1,type:"boolean"},planes:{description:"6 control planes [a, b, c, d]: a x + b y + c z + d = 0",required:!0,type:"points",counts:[6],dimension:4},bounds:{description:"2 planes [a, b, c, d] that cut the rulings at v = 0 and v = 1",required:!0,type:"points",counts:[2],dimension:4}}},nurbs:{title:"Rational B-spline surface (NURBS), such as a face read from a CAD file",construction:!1,surface:!0,shapeNames:[],fields:{flip:{description:"Turn the normal to the other side",required:!1,default:!1,type:"boolean"},degrees:{description:"Degrees (p, q) in u and v",required:!0,type:"raw"},knots:{description:"Full knot vectors in u and v: control points + degree + 1 numbers each; u, v in [0, 1] span them",required:!0,type:"raw"},points:{description:"Control points [x, y, z]; points[i][j] with i along u, j along v",required:!0,type:"raw"},weights:{description:"Weights of the control points, all 1 when left out",required:!1,default:null,type:"raw"},trim:{description:"Closed loops of [u, v] that bound the face on its surface",required:!1,default:[],type:"raw"}}},sphere:{title:"Sphere",construction:!1,surface:!0,shapeNames:[],fields:{flip:{description:"Turn the normal to the other side",required:!1,default:!1,type:"boolean"},radius:{description:"Radius",required:!1,default:1,type:"positive"}}},ellipsoid:{title:"Ellipsoid x²/a² + y²/b² + z²/c² = 1",construction:!1,surface:!0,shapeNames:[],fields:{flip:{description:"Turn the normal to the other side",required:!1,default:!1,type:"boolean"},a:{description:"Half axis along x",required:!1,default:3,type:"positive"},b:{description:"Half axis along y",required:!1,default:2,type:"positive"},c:{description:"Half axis along z",required:!1,default:1,type:"positive"}}},cylinder:{title:"Circular cylinder",construction:!1,surface:!0,shapeNames:[],fields:{flip:{description:"Turn the normal to the other side",required:!1,default:!1,type:"boolean"},radius:{description:"Radius",required:!1,default:1,type:"positive"},height:{description:"Height along z",required:!1,default:2,type:"positive"}}},cone:{title:"Cone with its apex up",construction:!1,surface:!0,shapeNames:[],fields:{flip:{description:"Turn the normal to the other side",required:!1,default:!1,type:"boolean"},radius:{description:"Radius of the base",required:!1,default:1,type:"positive"},height:{description:"Height along z",required:!1,default:2,type:"positive"}}},torus:{title:"Torus",construction:!1,surface:!0,shapeNames:[],fields:{flip:{description:"Turn the normal to the other side",required:!1,default:!1,type:"boolean"},major:{description:"Radius of the circle of centres",required:!1,default:3,type:"positive"},minor:{description:"Radius of the tube",required:!1,default:1,type:"positive"}}},catenoid:{title:"Catenoid, a minimal surface",construction:!1,surface:!0,shapeNames:[],fields:{flip:{description:"Turn the normal to the other side",required:!1,default:!1,type:"boolean"},waist:{description:"Radius of the waist",required:!1,default:1,type:"positive"},height:{description:"Height along z",required:!1,default:2,type:"positive"}}},helicoid:{title:"One turn of a helicoid, a minimal surface",construction:!1,surface:!0,shapeNames:[],fields:{flip:{description:"Turn the normal to the other side",required:!1,default:!1,type:"boolean"},radius:{description:"Half length of the rulings",required:!1,default:1,type:"positive"},pitch:{description:"Rise in one turn",required:!1,default:2,type:"number"}}},hyperbolic_paraboloid:{title:"z = x y",construction:!1,surface:!0,shapeNames:[],fields:{flip:{description:"Turn the normal to the other side",required:!1,default:!1,type:"boolean"},size:{description:"Half side of the square of parameters",required:!1,default:1,type:"positive"}}},monkey_saddle:{title:"z = x³ - 3 x y²",construction:!1,surface:!0,shapeNames:[],fields:{flip:{description:"Turn the normal to the other side",required:!1,default:!1,type:"boolean"},size:{description:"Half side of the square of parameters",required:!1,default:1,type:"positive"}}},enneper:{title:"Enneper's minimal surface",construction:!1,surface:!0,shapeNames:[],fields:{flip:{description:"Turn the normal to the other side",required:!1,default:!1,type:"boolean"},size:{description:"Half side of the square of parameters",required:!1,default:1,type:"positive"}}},curve:{title:"Curve",construction:!0,surface:!1,shapeNames:["alpha","zeta"],fields:{flip:{description:"Run from the other end",required:!1,default:!1,type:"boolean"},shape:{description:"Shape parameters of the basis, those in u, then those in v; for the quintic basis (α1, ζ1, α2, ζ2), or (α, ζ) for a developable, each in [-4, 1]",required:!1,default:[0,0],type:"shape"},basis:{description:"Basis, by name, or two for u and v, such as ['cubic', 'quintic']; 'bernstein' gives the classical surface on the same points",required:!1,default:"trigonometric",type:"basis"},bases:{description:"Bases of your own by name: [bases.NAME] with functions = [...] and parameters = { NAME = [low, high] }, or the name of a file of [basis.NAME] tables beside the model",required:!1,default:{},type:"raw"},unchecked_shape:{description:"Allow shape parameters outside their range, [-4, 1] for the quintic basis; the convex-hull property is then lost",required:!1,default:!1,type:"boolean"},unchecked_basis:{description:"Allow a basis whose functions do not sum to 1; the surface moves with the origin",required:!1,default:!1,type:"boolean"},points:{description:"6 control points, all [x, y] or all [x, y, z]",required:!0,type:"points",counts:[0],dimension:0},close:{description:"End in the first control point, which is then not given again as the last",required:!1,default:!1,type:"boolean"}}}},palette:{undefined:"#7d7d7d",front:"#9dc3e0",back:"#e8c793",series:["#0072b2","#d55e00","#009e73","#cc79a7","#e69f00","#56b4e9","#000000","#a6761d"],classes:{point_type:["#7d7d7d","#d9541e","#5fd99a","#f5a623","#f2f0ea","#7f1d0f"],hk_type:["#7d7d7d","#d9541e","#f5a623","#fbe26a","#000000","#f2f0ea","#5fd99a","#2166ac","#56a0d3","#a6d8f0"],shape_class:["#7d7d7d","#08306b","#2166ac","#56a0d3","#a6d8f0","#5fd99a","#fbe26a","#f5a623","#d9541e","#7f1d0f","#f2f0ea"],invariant_type:["#7d7d7d","#d9541e","#f5a623","#fbe26a","#000000","#f2f0ea","#5fd99a","#2166ac","#56a0d3","#a6d8f0"]},diverging:["#12406f","#194e80","#215c91","#286aa2","#2f78b3","#4387bc","#5796c5","#6ca5cd","#80b4d6","#92bfdc","#a5cae1","#b7d5e7","#cadfec","#d5e5ed","#e0eaee","#ebefee","#f6f3ee","#f7ebe2","#f7e3d6","#f8dbca","#f8d2be","#f4c4ac","#f1b59a","#eda789","#e99878","#e18369","#d96f5b","#d05a4c","#c7473e","#b53938","#a32b32","#921e2b","#821226"],sequential:["#f3f1d8","#ebeed0","#e3eac8","#dbe7c0","#d3e3b8","#cbe0b0","#c0dcac","#b4d6a9","#a7d1a5","#9acca2","#8ec79f","#82c29d","#76bb9c","#6bb59c","#60ae9b","#55a89b","#4aa29a","#459b98","#409497","#3a8d95","#358694","#307f92","#2f7890","#2e708d","#2d698b","#2d6288","#2c5b85","#2c5481","#2d4c7b","#2d4575","#2d3d6f","#2e3668","#2e2f63"]},presets:[{schema:1,name:"Car boot lid",unit:"mm",kind:"swept",shape:[1,1,0,0],section:[[0,0,30],[240,0,-14],[590,0,36],[606,0,-2],[505,0,-190],[560,0,-390]],trajectory:[[-150,-700,-90],[-55,-610,-24],[0,-260,0],[0,260,0],[-55,610,-24],[-150,700,-90]]},{schema:1,name:"Classical quintic swung vase",unit:"cm",kind:"swung",flip:!0,basis:"bernstein",profile:[[1,0],[3,1],[4,3],[3,5],[2,7],[2,8]],trajectory:[[1,0],[1,.6],[.7,1],[0,1.2],[-.6,1.1],[-1,.9]],scale:1.5},{schema:1,name:"Cylinder",unit:"mm",kind:"cylinder",radius:10,height:40},{schema:1,name:"Developable vault",unit:"m",kind:"developable",shape:[1,1],planes:[[-1,.22,1,-11],[-.8,.1,1,-9],[-.35,-.04,1,-6],[.35,-.1,1,-6],[.8,-.04,1,-9],[1,.04,1,-11]],bounds:[[0,1,0,0],[0,1,0,-10]]},{schema:1,name:"Saddle roof from a CSV net",unit:"m",kind:"tensor",shape:[0,0,0,0],points:[[[0,0,3],[0,2,4.92],[0,4,5.88],[0,6,5.88],[0,8,4.92],[0,10,3]],[[2,0,1.08],[2,2,3],[2,4,3.96],[2,6,3.96],[2,8,3],[2,10,1.08]],[[4,0,.12],[4,2,2.04],[4,4,3],[4,6,3],[4,8,2.04],[4,10,.12]],[[6,0,.12],[6,2,2.04],[6,4,3],[6,6,3],[6,8,2.04],[6,10,.12]],[[8,0,1.08],[8,2,3],[8,4,3.96],[8,6,3.96],[8,8,3],[8,10,1.08]],[[10,0,3],[10,2,4.92],[10,4,5.88],[10,6,5.88],[10,8,4.92],[10,10,3]]]},{schema:1,name:"Rear of a car",unit:"mm",patch:[{name:"rear window",kind:"swept",shape:[1,1,0,0],section:[[-720,0,470],[-600,0,452],[-430,0,390],[-300,0,290],[-150,0,160],[0,0,30]],trajectory:[[-150,-700,-90],[-55,-610,-24],[0,-260,0],[0,260,0],[-55,610,-24],[-150,700,-90]]},{name:"boot lid",kind:"swept",shape:[1,1,0,0],section:[[0,0,30],[240,0,-14],[590,0,36],[606,0,-2],[505,0,-190],[560,0,-390]],trajectory:[[-150,-700,-90],[-55,-610,-24],[0,-260,0],[0,260,0],[-55,610,-24],[-150,700,-90]]}]},{schema:1,name:"Ruled roof",unit:"m",kind:"ruled",shape:[1,1,1,1],first:[[0,0,0],[1,2,4],[3,3,5],[5,3,5],[7,2,4],[8,0,0]],second:[[0,10,2],[1,9,0],[3,8,-2],[5,8,3],[7,9,5],[8,10,1]]},{schema:1,name:"Sphere",unit:"mm",kind:"sphere",radius:20},{schema:1,name:"Swept canopy",unit:"m",kind:"swept",shape:[1,1,1,1],section:[[0,0,0],[2,0,1],[4,0,3],[6,0,3],[8,0,1],[10,0,0]],trajectory:[[0,0,0],[0,1,3],[0,3,5],[0,5,5],[0,7,3],[0,8,0]]},{schema:1,name:"Swung vase",unit:"cm",kind:"swung",flip:!0,shape:[1,1,1,1],profile:[[1,0],[3,1],[4,3],[3,5],[2,7],[2,8]],trajectory:[[1,0],[1,.6],[.7,1],[0,1.2],[-.6,1.1],[-1,.9]],scale:1.5},{schema:1,name:"Symmetric shell",unit:"m",kind:"symmetric",shape:[1,1,1,1],points:[[[0,0,0],[0,2,2],[0,4,3],[0,6,3],[0,8,2],[0,10,0]],[[2,0,1.5],[2,2,3],[2,4,4.5],[2,6,4.5],[2,8,3],[2,10,1.5]],[[4,0,3],[4,2,3.5],[4,4,5],[4,6,5],[4,8,3.5],[4,10,3]]],mirror:[1,0,0,-5]},{schema:1,name:"Thesis net of section 2.5.2",kind:"tensor",flip:!0,shape:[1,1,1,1],points:[[[0,0,0],[0,0,10],[4,0,10],[6,0,10],[10,0,10],[10,0,0]],[[0,2,0],[0,2,10],[4,2,10],[6,2,10],[10,2,10],[10,2,0]],[[0,4,0],[0,4,10],[4,4,10],[6,4,10],[10,4,10],[10,4,0]],[[0,6,0],[0,6,10],[4,6,10],[6,6,10],[10,6,10],[10,6,0]],[[0,8,0],[0,8,10],[4,8,10],[6,8,10],[10,8,10],[10,8,0]],[[0,10,0],[0,10,10],[4,10,10],[6,10,10],[10,10,10],[10,10,0]]]},{schema:1,name:"Wavy surface",unit:"cm",kind:"tensor",shape:[1,1,1,1],points:[[[0,0,0],[0,2,1],[0,4,2],[0,6,2],[0,8,1],[0,10,0]],[[2,0,1],[2,2,3],[2,4,5],[2,6,4],[2,8,2],[2,10,1]],[[4,0,2],[4,2,5],[4,4,8],[4,6,7],[4,8,4],[4,10,2]],[[6,0,2],[6,2,4],[6,4,7],[6,6,6],[6,8,3],[6,10,1]],[[8,0,1],[8,2,2],[8,4,4],[8,6,3],[8,8,1],[8,10,-1]],[[10,0,0],[10,2,1],[10,4,2],[10,6,1],[10,8,-1],[10,10,-3]]]}],starters:{tensor:{schema:1,name:"My tensor surface",unit:"mm",kind:"tensor",points:[[[0,0,0],[0,20,0],[0,40,0],[0,60,0],[0,80,0],[0,100,0]],[[20,0,0],[20,20,5],[20,40,15],[20,60,16],[20,80,7],[20,100,2]],[[40,0,0],[40,20,15],[40,40,40],[40,60,44],[40,80,19],[40,100,4]],[[60,0,0],[60,20,16],[60,40,44],[60,60,49],[60,80,21],[60,100,5]],[[80,0,0],[80,20,7],[80,40,19],[80,60,21],[80,80,9],[80,100,2]],[[100,0,0],[100,20,2],[100,40,4],[100,60,5],[100,80,2],[100,100,0]]],shape:[0,0,0,0]},symmetric:{schema:1,name:"My symmetric surface",unit:"mm",kind:"symmetric",points:[[[0,0,0],[0,20,8],[0,40,23],[0,60,25],[0,80,11],[0,100,2]],[[20,0,10],[20,20,18],[20,40,33],[20,60,35],[20,80,21],[20,100,12]],[[40,0,30],[40,20,38],[40,40,53],[40,60,55],[40,80,41],[40,100,32]]],mirror:[1,0,0,-50],shape:[0,0,0,0]},swept:{schema:1,name:"My swept surface",unit:"mm",kind:"swept",section:[[0,0,0],[20,0,10],[40,0,30],[60,0,30],[80,0,10],[100,0,0]],trajectory:[[0,0,0],[0,20,11],[0,40,30],[0,60,34],[0,80,14],[0,100,3]],shape:[0,0,0,0]},swung:{schema:1,name:"My swung surface",unit:"mm",kind:"swung",profile:[[20,0],[60,10],[80,40],[50,70],[30,100],[40,120]],trajectory:[[1,0],[1,.6],[.7,1],[-.7,1],[-1,.6],[-1,0]],shape:[0,0,0,0],flip:!0,scale:1},ruled:{schema:1,name:"My ruled surface",unit:"mm",kind:"ruled",first:[[0,0,0],[20,0,10],[40,0,30],[60,0,30],[80,0,10],[100,0,0]],second:[[0,100,0],[20,100,5],[40,100,13],[60,100,14],[80,100,6],[100,100,1]],shape:[0,0,0,0]},developable:{schema:1,name:"My developable surface",unit:"mm",kind:"developable",planes:[[-1,.2,1,-110],[-.8,.1,1,-90],[-.35,-.05,1,-60],[.35,-.05,1,-60],[.8,.1,1,-90],[1,.2,1,-110]],bounds:[[0,1,0,0],[0,1,0,-100]],shape:[0,0]},nurbs:{schema:1,name:"My nurbs",unit:"mm",kind:"nurbs",degrees:[2,2],knots:[[0,0,0,1,1,1],[0,0,0,1,1,1]],points:[[[0,0,0],[0,50,50],[0,100,0]],[[50,0,30],[50,50,80],[50,100,30]],[[100,0,0],[100,50,50],[100,100,0]]],weights:[[1,.7,1],[1,.7,1],[1,.7,1]]},sphere:{schema:1,name:"My sphere",unit:"mm",kind:"sphere",radius:20},ellipsoid:{schema:1,name:"My ellipsoid",unit:"mm",kind:"ellipsoid",a:30,b:20,c:10},cylinder:{schema:1,name:"My cylinder",unit:"mm",kind:"cylinder",radius:10,height:40},cone:{schema:1,name:"My cone",unit:"mm",kind:"cone",radius:10,height:20},torus:{schema:1,name:"My torus",unit:"mm",kind:"torus",major:30,minor:10},catenoid:{schema:1,name:"My catenoid",unit:"mm",kind:"catenoid",waist:10,height:20},helicoid:{schema:1,name:"My helicoid",unit:"mm",kind:"helicoid",radius:10,pitch:20},hyperbolic_paraboloid:{schema:1,name:"My hyperbolic paraboloid",unit:"mm",kind:"hyperbolic_paraboloid"},monkey_saddle:{schema:1,name:"My monkey saddle",unit:"mm",kind:"monkey_saddle"},enneper:{schema:1,name:"My enneper",unit:"mm",kind:"enneper"},curve:{schema:1,name:"My curve",unit:"mm",kind:"curve",points:[[0,0],[10,40],[40,50],[60,-10],[90,0],[100,30]],shape:[0,0]}}};var qt=()=>new Float64Array(3);function Vt(n,e,t){let i=n[0],r=n[1],s=n[2],a=e[0],o=e[1],l=e[2];return t[0]=i*a,t[1]=i*o+r*a,t[2]=i*l+r*o+s*a,t}function Hn(n,e,t,i,r,s){return s[0]=n*e[0]+t*i[0]+r,s[1]=n*e[1]+t*i[1],s[2]=n*e[2]+t*i[2],s}function $p(n,e,t){let i=e[0],r=e[1],s=e[2],a=n[0]/i,o=(n[1]-a*r)/i,l=(n[2]-(a*s+o*r))/i;return t[0]=a,t[1]=o,t[2]=l,t}function ha(n,e,t){t[0].fill(0),t[0][0]=1;for(let i=1;i<=e;i++)Vt(t[i-1],n,t[i])}var Mi=n=>Array.from({length:n},qt);var Xp=.5*Math.PI,wi=class{constructor(e,t){this.start=e;this.end=t}start;end;size=2;derivatives(e,t,i){let r=this.end-this.start,s=Xp*r;for(let a=0;a<t;a++){ua(this.start+r*e[a]);let o=wr,l=Ar;i[2*a]=l,i[2*a+1]=o,i[2*(t+a)]=s*-o,i[2*(t+a)+1]=s*l,i[2*(2*t+a)]=s*s*-l,i[2*(2*t+a)+1]=s*s*-o}}},os=class{constructor(e,t){this.start=e;this.end=t}start;end;size=2;derivatives(e,t,i){let r=this.end-this.start;for(let s=0;s<t;s++){let a=this.start+r*e[s],o=Math.cosh(a),l=Math.sinh(a);for(let c=0,h=1;c<3;c++,h*=r)i[2*(c*t+s)]=h*(c===1?l:o),i[2*(c*t+s)+1]=h*(c===1?o:l)}}},dn=class{constructor(e,t,i){this.start=e;this.end=t;this.degree=i;this.size=i+1}start;end;degree;size;derivatives(e,t,i){let r=qt(),s=Mi(this.size),a=this.size;r[1]=this.end-this.start;for(let o=0;o<t;o++){r[0]=this.start+(this.end-this.start)*e[o],ha(r,this.degree,s);for(let l=0;l<a;l++)jh(s[l],i,t,o,a,l)}}},Gn=class{constructor(e){this.parts=e;this.size=e.reduce((t,i)=>t+i.size,0)}parts;size;scratch=new Float64Array(0);derivatives(e,t,i){let r=0;for(let s of this.parts){let a=s.size;this.scratch.length<3*t*a&&(this.scratch=new Float64Array(3*t*a)),s.derivatives(e,t,this.scratch);for(let o=0;o<3*t;o++)for(let l=0;l<a;l++)i[o*this.size+r+l]=this.scratch[o*a+l];r+=a}}};function jh(n,e,t,i,r,s){e[i*r+s]=n[0],e[(t+i)*r+s]=n[1],e[(2*t+i)*r+s]=2*n[2]}var wr=0,Ar=1;function ua(n){let e=mb(n),t=Xp*(n-e),i=Math.sin(t),r=Math.cos(t),s=(e%4+4)%4;wr=(s===0?i:s===1?r:s===2?-i:-r)+0,Ar=(s===0?r:s===1?-i:s===2?-r:i)+0}function mb(n){let e=Math.floor(n);return n-e!==.5?Math.round(n):e%2===0?e:e+1}var Gi=qt(),Wi=qt(),$i=qt(),Xi=qt(),Ai=qt(),Zh=qt(),Kh=qt(),Ro=qt(),da=qt(),oi=qt(),ls=Mi(5),Yp=Mi(5);Ai[0]=1;var ci=[!1,!1],pn=class{constructor(e,t,i=ci){this.alpha=e;this.zeta=t;this.still=i}alpha;zeta;still;size=6;derivatives(e,t,i){let{alpha:r,zeta:s}=this;for(let a=0;a<t;a++){let[o,l]=this.still;if(this.slopes(e[a],!1,!1,ls),o||l){this.slopes(e[a],o,l,Yp);let b=(o?Gi[0]:1)*(l?Wi[0]:1);for(let m=0;m<5;m++)ls[m][1]=b*Yp[m][1]}let c=Gi[0],h=Wi[0],d=$i[0],u=Xi[0],p=e[a]<.5,f=6*a;i[f]=d**4*(p?1-r*c:1-r+r*d),i[f+1]=c*d**3*(p?4+r-r*c:4+r*d),i[f+2]=d**2*u*(8*c+3*h+9),i[f+3]=u**2*d*(8*h+3*c+9),i[f+4]=h*u**3*(p?4+s*u:4+s-s*h),i[f+5]=u**4*(p?1-s+s*u:1-s*h);for(let b=0;b<2;b++){let m=6*((b+1)*t+a);i[m]=-ls[0][b];for(let g=1;g<5;g++)i[m+g]=ls[g-1][b]-ls[g][b];i[m+5]=ls[4][b]}}}slopes(e,t,i,r){ua(e),jp(wr,Ar,Gi),jp(Ar,-wr,Wi),Hn(-1,Gi,0,Gi,0,$i),Hn(-1,Wi,0,Wi,0,Xi),$i[0]=2*Math.sin(.25*Math.PI*(1-e))**2,Xi[0]=2*Math.sin(.25*Math.PI*e)**2;let s=e<.5,a=t?Ai:Gi,o=i?Ai:Wi;Vt(a,o,Ro),Vt($i,$i,Zh),Vt(Xi,Xi,Kh),Jp(this.alpha,Gi,$i,s,t,da),Vt(o,Vt(Vt(Zh,$i,oi),da,oi),r[0]),Vt(Zh,Ro,r[1]),Hn(12,r[1],0,Ai,0,r[1]),$p(Ai,Hn(1,Gi,1,Wi,1,oi),oi),Hn(4,oi,32,Ai,0,oi),Vt(Vt($i,Xi,da),Vt(Ro,oi,oi),r[2]),Vt(Kh,Ro,r[3]),Hn(12,r[3],0,Ai,0,r[3]),Jp(this.zeta,Wi,Xi,!s,i,da),Vt(a,Vt(Vt(Kh,Xi,oi),da,oi),r[4]);for(let l=0;l<5;l++)Hn(.5*Math.PI,r[l],0,Ai,0,r[l])}},li=class{constructor(e){this.degree=e;this.size=e+1}degree;size;derivatives(e,t,i){let r=qt(),s=qt(),a=gb(this.degree);r[1]=1,s[1]=-1;for(let o=0;o<t;o++)r[0]=e[o],s[0]=1-e[o],a(r,s,i,t,o)}};function Zp(n,e,t){let i=(r,s)=>t[r].every((a,o)=>a.every((l,c)=>l===t[s][o][c]));return[n===-4||i(0,1),e===-4||i(t.length-1,t.length-2)]}function Qh(n,e){let t=1;for(let i=1;i<=e;i++)t=t*(n-e+i)/i;return t}function Jp(n,e,t,i,r,s){if(r)return void Hn(-5*n,Ai,0,e,0,s);Hn(-5*n,e,0,e,0,s),s[0]=i?4+n-5*n*e[0]:4-4*n+5*n*t[0]}function jp(n,e,t){let i=.5*Math.PI;t[0]=n,t[1]=i*e,t[2]=i*i*-n/2}function gb(n){let e=Mi(n+1),t=Mi(n+1),i=qt(),r=e.map((s,a)=>Qh(n,a));return(s,a,o,l,c)=>{ha(s,n,e),ha(a,n,t);for(let h=0;h<=n;h++)Vt(e[h],t[n-h],i),Hn(r[h],i,0,i,0,i),jh(i,o,l,c,n+1,h)}}var Io=["t","r","s","c","a","b"],tu=["sin","cos","sinh","cosh","sqrt","exp"],nf=[...Io,"pi",...tu],Kp=4e3,Qp=40,eu=64,ef=200,Po=/\s*(?:(?<number>(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?)|(?<name>[\p{L}_][\p{L}\p{N}_]*)|(?<sign>\*\*|.))/suy,tf={s:"a",c:"b",t:"r",a:"s",b:"c",r:"t"};function ru(n,e=[]){if(typeof n!="string")throw new Error(`expected a formula in quotation marks, found ${JSON.stringify(n)}`.slice(0,200));if(n.length>Kp)throw new Error(`expected at most ${Kp} characters, found ${n.length}; shorten the formula`);return new nu(n,e).whole()}function rf(n){return n.is==="binary"?[n.left,n.right]:n.is==="power"?[n.base]:n.is==="call"?[n.argument]:[]}var nu=class{constructor(e,t){this.text=e;this.parameters=t;this.advance()}text;parameters;place=0;depth=0;kind="";token="";start=0;whole(){let[e]=this.sum();return this.kind&&this.fail("expected an operator + - * / ^ or the end",this.kind==="sign"?this.remedy():"write 2*t for a product"),e}advance(){Po.lastIndex=this.place;let e=Po.exec(this.text)?.groups,t=Object.entries(e??{}).find(([,i])=>i!==void 0&&i.trim()!=="");[this.kind,this.token]=t??["",""],this.start=t?Po.lastIndex-this.token.length:this.text.trimEnd().length,t&&(this.place=Po.lastIndex)}fail(e,t=""){let i=this.kind?on(this.token.slice(0,40)):"the end of the formula";throw new Error(`character ${this.start+1}: ${e}, found ${i}${t?`; ${t}`:""}`)}sign(e){return this.kind==="sign"&&this.token.length===1&&e.includes(this.token)}sum(){return this.chain("+-",()=>this.product())}product(){return this.chain("*/",()=>this.factor())}chain(e,t){let[i,r]=t();for(;this.sign(e);){let s=this.token;this.advance();let[a,o]=t();[i,r]=[bb(s,i,a),this.higher(r,o)]}return[i,r]}factor(){if(this.sign("-")){this.deeper(),this.advance();let[i,r]=this.factor();this.depth--;let s={is:"number",value:i.is==="number"?-i.value:-1};return[i.is==="number"?s:{is:"binary",sign:"*",left:s,right:i},this.higher(r)]}let[e,t]=this.atom();return this.token==="**"&&this.fail("expected an operator + - * / ^","write ^ for a power"),this.sign("^")&&(this.advance(),[e,t]=[{is:"power",base:e,exponent:this.exponent()},this.higher(t)],(this.sign("^")||this.token==="**")&&this.fail("expected one power only","set parentheses: (x^2)^3")),[e,t]}exponent(){(this.kind!=="number"||!/^\d+$/.test(this.token))&&this.fail(`expected a whole power from 0 to ${eu}`,"write products, quotients or sqrt for others");let e=Number(this.token);return(this.token.length>4||e>eu)&&this.fail(`expected a power of at most ${eu}`,"lower it"),this.advance(),e}atom(){if(this.kind==="number"){let e=Number(this.token);return e>1e100&&this.fail("expected a number of at most 1e100"),this.advance(),[{is:"number",value:e},1]}return this.kind==="name"?this.named():this.sign("(")?this.bracket():this.fail("expected a number, a name or '('",this.remedy())}named(){let e=this.token;if(tu.includes(e)){this.advance(),this.token!=="("&&this.fail(`expected '(' after ${e}`,`write ${e}(...)`);let[i,r]=this.bracket();return[{is:"call",name:e,argument:i},this.higher(r)]}let t=[...Io,"pi",...this.parameters];if(!t.includes(e)){let i=/^\s*\(/.test(this.text.slice(this.place)),r=i?tu:t,s=No(e,r),a=s?`did you mean ${on(s)}?`:i?"":"list it under parameters";this.fail(`expected ${i?"a function":"a name"}, one of ${r.join(", ")}`,a)}return this.advance(),this.sign("(")&&this.fail("expected an operator + - * / ^","write t*(...) for a product"),[{is:"name",name:e},1]}bracket(){this.deeper(),this.advance();let e=this.sum();return this.token!==")"&&this.fail("expected ')'",this.remedy()),this.advance(),this.depth--,e}deeper(){++this.depth>Qp&&this.fail(`expected at most ${Qp} levels of nesting`,"simplify the formula")}higher(...e){let t=Math.max(...e)+1;return t>ef&&this.fail(`expected at most ${ef} terms or factors in a row`,"simplify the formula"),t}remedy(){return[".","[","{","_","'",'"',";",":","@","=","!","`"].includes(this.token)?"a formula holds numbers, names, + - * / ^ and parentheses only":this.token===","?"write one argument only":""}};function bb(n,e,t){let i=(a,o)=>JSON.stringify(a)===JSON.stringify(o),r=a=>a.is==="number"&&a.value===1,s=(a,o)=>({is:"call",name:a,argument:o});if(n==="-"&&r(e)){if(t.is==="name"&&tf[t.name])return{is:"name",name:tf[t.name]};if(t.is==="call"&&t.name==="cos")return s("versin",t.argument)}if(n==="-"&&t.is==="call"&&t.name==="sin"&&i(t.argument,e))return s("sinrest",e);if(n==="-"&&e.is==="call"){if(e.name==="cosh"&&r(t))return s("coshless",e.argument);if(e.name==="sinh"&&i(e.argument,t))return s("sinhrest",t)}return{is:"binary",sign:n,left:e,right:t}}function on(n){let e=n.includes("'")&&!n.includes('"')?'"':"'";return e+n.replaceAll("\\","\\\\").replaceAll(`
`,"\\n").replaceAll(e,`\\${e}`)+e}function No(n,e){return e.map(i=>[2*iu(i,n)/(i.length+n.length),i]).filter(([i])=>i>=.6).sort(([i,r],[s,a])=>s-i||(r<a?1:-1))[0]?.[1]??""}function iu(n,e){for(let t=Math.min(n.length,e.length);t>0;t--)for(let i=0;i+t<=n.length;i++){let r=e.indexOf(n.slice(i,i+t));if(r>=0)return t+iu(n.slice(0,i),e.slice(0,r))+iu(n.slice(i+t),e.slice(r+t))}return 0}function sf(n,e,t){for(let i=0;i<t.length;i++){let r=0;for(let s=0;s<=i;s++)r+=n[s]*e[i-s];t[i]=r}}function af(n,e,t){for(let i=0;i<t.length;i++){let r=n[i];for(let s=0;s<i;s++)r-=t[s]*e[i-s];t[i]=r/e[0]}}function of(n,e){e[0]=Math.sqrt(n[0]);for(let t=1;t<e.length;t++){let i=n[t];for(let r=1;r<t;r++)i-=e[r]*e[t-r];e[t]=i/(2*e[0])}}function Lo(n,e,t,i,r){let s=0;for(let a=1;a<=r;a++)s+=a*n[a]*e[r-a];i[r]=t*s/r}function lf(n,e){e[0]=Math.exp(n[0]);for(let t=1;t<e.length;t++)Lo(n,e,1,e,t)}var cs=new Float64Array(0),pa=new Float64Array(0),fa=new Float64Array(0);function Yi(n,e){cs.length!==n.length&&([cs,pa,fa]=[n.slice(),n.slice(),n.slice()]);let t=n[0],i=e?1:-1;cs[0]=e?Math.sinh(t):Math.sin(t),pa[0]=e?Math.cosh(t):Math.cos(t),fa[0]=2*(e?Math.sinh(.5*t):Math.sin(.5*t))**2;for(let r=1;r<n.length;r++)Lo(n,pa,1,cs,r),Lo(n,cs,1,fa,r),pa[r]=i*fa[r];return{sine:cs,cosine:pa,versine:fa}}function su(n,e,t){let i=n[0],r=e?i*i:-i*i,s=0;for(let l=10;l>1;l--)s=(1+s)*r/(2*l*(2*l+1));let a=e?Math.sinh(i)-i:i-Math.sin(i),{versine:o}=Yi(n,e);t[0]=Math.abs(i)<1.5?i**3*(1+s)/6:a;for(let l=1;l<t.length;l++)Lo(n,o,1,t,l)}var cf={sin:(n,e)=>e.set(Yi(n,!1).sine),cos:(n,e)=>e.set(Yi(n,!1).cosine),versin:(n,e)=>e.set(Yi(n,!1).versine),sinrest:(n,e)=>su(n,!1,e),sinh:(n,e)=>e.set(Yi(n,!0).sine),cosh:(n,e)=>e.set(Yi(n,!0).cosine),coshless:(n,e)=>e.set(Yi(n,!0).versine),sinhrest:(n,e)=>su(n,!0,e),sqrt:of,exp:lf};function yb(n,e){let t=new Float64Array(1);return cf[n](Float64Array.of(e),t),t[0]}var Er=class{constructor(e,t){this.values=t;this.roots=e.map(i=>this.placed(this.node(i)))}values;operations=[];places=new Map;found=new Map;roots;registers=[];at(e,t){this.registers[0]?.length!==t+1&&(this.registers=this.operations.map(()=>new Float64Array(t+1)));let{registers:i}=this;ua(e);let r=wr,s=Ar;return this.operations.forEach(({name:a,x:o,y:l,value:c},h)=>{let d=i[h],u=i[o],p=i[l];switch(a){case"t":case"r":d.fill(0),d[0]=a==="t"?e:1-e,t&&(d[1]=a==="t"?1:-1);break;case"s":return Do(r,s,d);case"c":return Do(s,-r,d);case"a":return Do(-r,-s,d,2*Math.sin(.25*Math.PI*(1-e))**2);case"b":return Do(-s,r,d,2*Math.sin(.25*Math.PI*e)**2);case"number":d.fill(0),d[0]=c;break;case"add":for(let f=0;f<=t;f++)d[f]=u[f]+p[f];break;case"subtract":for(let f=0;f<=t;f++)d[f]=u[f]-p[f];break;case"multiply":return sf(u,p,d);case"divide":return af(u,p,d);case"scale":for(let f=0;f<=t;f++)d[f]=c*u[f];break;case"shift":d.set(u),d[0]+=c;break;default:return cf[a](u,d)}}),this.roots.map(a=>i[a])}put(e,t=0,i=0,r=0){let s=`${e} ${t} ${i} ${Object.is(r,-0)?"-0":r}`,a=this.places.get(s);return a!==void 0?{at:a}:(this.places.set(s,this.operations.length),{at:this.operations.push({name:e,x:t,y:i,value:r})-1})}placed(e){return("at"in e?e:this.put("number",0,0,e.number)).at}node(e){let t=this.found.get(e);if(t)return t;let i=this.made(e);return this.found.set(e,i),i}made(e){switch(e.is){case"number":return{number:e.value};case"name":return Io.includes(e.name)?this.put(e.name):{number:e.name==="pi"?Math.PI:this.values[e.name]};case"power":return this.power(this.node(e.base),e.exponent);case"binary":return this.binary(e.sign,this.node(e.left),this.node(e.right));case"call":{let t=this.node(e.argument);return"number"in t?{number:yb(e.name,t.number)}:this.put(e.name,t.at)}}}binary(e,t,i){if("number"in t&&"number"in i){let[r,s]=[t.number,i.number];return{number:e==="+"?r+s:e==="-"?r-s:e==="*"?r*s:r/s}}if("number"in i){let r=i.number,s=this.placed(t);return e==="*"||e==="/"?this.put("scale",s,0,e==="*"?r:1/r):this.put("shift",s,0,e==="+"?r:-r)}return e==="/"?this.put("divide",this.placed(t),i.at):"number"in t?e==="*"?this.put("scale",i.at,0,t.number):this.put("shift",e==="-"?this.placed(this.put("scale",i.at,0,-1)):i.at,0,t.number):this.put(e==="+"?"add":e==="-"?"subtract":"multiply",t.at,i.at)}power(e,t){if("number"in e)return{number:e.number**t};let i=null,r=e;for(let s=t;s;s>>=1)s&1&&(i=i?this.binary("*",i,r):r),s>1&&(r=this.binary("*",r,r));return i??{number:1}}};function Do(n,e,t,i=n){let r=.5*Math.PI;for(let s=0,a=1;s<t.length;s++)t[s]=a*(s%4===0?n:s%4===1?e:s%4===2?-n:-e),a*=r/(s+1);t[0]=i}var hf=64,vb=7,uf=.001,df=1e-9,pf=1e12,ma=64,hi=Array.from({length:ma+1},(n,e)=>.5-.5*Math.cos(Math.PI*e/ma));function mf(n,e){let t=bf(e);n.forEach((r,s)=>{for(let[a,o,l]of vf(r)){let c=xb(a,o,t,e);if(c)throw new Error(`functions[${s}]: ${l} ${c}; rewrite it, or narrow the range of the parameters`)}});let i=t.map(r=>au(n,e,r));n.forEach((r,s)=>i.forEach((a,o)=>a.forEach((l,c)=>{if(Math.abs(l[s])<=pf)return;let h=hs(e,t[o],hi[c]);throw new Error(`functions[${s}]: expected values of size at most ${pf.toExponential()}, found none such ${h}; rewrite it, or narrow the range`)})))}function gf(n,e){let t=-1,i="";for(let r of bf(e))au(n,e,r).forEach((s,a)=>{let o=Math.abs(s.reduce((l,c)=>l+c,0)-1)/Math.max(1,...s.map(Math.abs));o>t&&([t,i]=[o,hs(e,r,hi[a])])});return{by:t,where:i}}function bf(n){let e=n.length,t=Array.from({length:e},(s,a)=>a),i=2**e<=hf?Array.from({length:2**e},(s,a)=>t.map(o=>a>>e-1-o&1)):Array.from({length:hf},(s,a)=>t.map(o=>a<2?a:ff(a,o)<.5?0:1)),r=e?Array.from({length:vb},(s,a)=>t.map(o=>ff(a+1,o))):[];return[...i,t.map(()=>.5),...r].map(s=>n.map(({low:a,high:o,open:l},c)=>{let h=a+uf*(o-a)*Number(l[0]),d=o-uf*(o-a)*Number(l[1]);return h+(d-h)*s[c]}))}var ff=(n,e)=>((n+1)*.754877666+(e+1)*(n+3)*.569840291)%1,yf=(n,e)=>Object.fromEntries(n.map(({name:t},i)=>[t,e[i]]));function au(n,e,t){let i=new Er(n,yf(e,t));return hi.map(r=>i.at(r,0).map(s=>s[0]))}function*vf(n){for(let e of rf(n))yield*vf(e);n.is==="binary"&&n.sign==="/"&&(yield[n.right,!1,"divides by zero"]),n.is==="call"&&n.name==="sqrt"&&(yield[n.argument,!0,"takes the root of a number that is not positive"])}function xb(n,e,t,i){let r=t.map(u=>au([n],i,u).map(p=>p[0]));if(!r.every(u=>u.every(Number.isFinite)))return"";for(let[u,p]of r.entries()){let f=Math.max(...p.map(Math.abs)),b=p.findIndex(m=>Math.abs(m)<=df*f||e&&m<0);if(b>=0)return hs(i,t[u],hi[b])}let s=r.map(u=>u.map(Math.sign)),a=[-1,1].every(u=>s.some(p=>p.includes(u)));for(let[u,p]of a?s.entries():[]){let f=p.findIndex((b,m)=>m+1<p.length&&p[m+1]!==b);if(f>=0)return hs(i,t[u],.5*(hi[f]+hi[f+1]),"near")}let o=u=>Math.min(...e?u:u.map(Math.abs)),l=r.map(o),c=l.indexOf(Math.min(...l)),h=r[c],d=h.findIndex(u=>(e?u:Math.abs(u))===l[c]);return a?hs(i,t[c],hi[d],"near"):_b(n,t[c],d,df*Math.max(...h.map(Math.abs)),i)}function _b(n,e,t,i,r){let s=hi[Math.max(t-1,0)],a=hi[Math.min(t+1,ma)],o=new Er([n],yf(r,e));for(let l=0;l<4;l++){let c=hi.map((u,p)=>s+(a-s)*p/ma),h=c.map(u=>Math.abs(o.at(u,0)[0][0])),d=h.indexOf(Math.min(...h));if(h[d]<=i)return hs(r,e,c[d],"near");[s,a]=[c[Math.max(d-1,0)],c[Math.min(d+1,ma)]]}return""}function hs(n,e,t,i="at"){let r=s=>String(Number(s.toPrecision(4)));return[`${i} t = ${r(t)}`,...n.map(({name:s},a)=>`${s} = ${r(e[a])}`)].join(", ")}var xf=64,_f=24;function zo(n,e,t,i){if(!/^[A-Za-z_]\w*$/.test(n))throw new Error(`parameters: expected a name of letters, digits and _, found ${on(n.slice(0,60))}`);if(n.length>30||nf.includes(n))throw new Error(`parameters: ${on(n.slice(0,40))} is ${n.length>30?"longer than 30 letters":"taken by the grammar"}; choose another name`);if(!(e<t))throw new Error(`parameters.${n}: expected a range [low, high] with low < high, found [${Fo(e)}, ${Fo(t)}]`);return{name:n,low:e,high:t,start:i??(e<=0&&t>=0?0:.5*(e+t)),open:[!1,!1]}}var us=({low:n,high:e,open:t},i)=>(t[0]?i>n:i>=n)&&(t[1]?i<e:i<=e),ds=({low:n,high:e,open:t})=>`${t[0]?"(":"["}${Fo(n)}, ${Fo(e)}${t[1]?")":"]"}`,Fo=n=>String(Number(n.toPrecision(6))),Tr=class{constructor(e,t,i,r=!1){this.name=e;this.functions=t;this.parameters=i;let s=i.map(o=>o.name),a=t.length;if(a<2||a>xf)throw new Error(`functions: expected 2 to ${xf} formulas, found ${a}`);if(s.length>_f)throw new Error(`parameters: expected at most ${_f}, found ${s.length}`);this.trees=t.map((o,l)=>{try{return ru(o,s)}catch(c){throw new Error(`functions[${l}]: ${c.message}`)}}),r||mf(this.trees,i)}name;functions;parameters;trees;off=null;get size(){return this.functions.length}get offSum(){return this.off??=gf(this.trees,this.parameters)}get partition(){return this.offSum.by<=1e-12}},fn=class{constructor(e,t){this.basis=e;this.size=e.size,this.tape=new Er(e.trees,Object.fromEntries(e.parameters.map(({name:i},r)=>[i,t[r]])))}basis;size;tape;get partition(){return this.basis.partition}series(e,t){return this.tape.at(e,t)}derivatives(e,t,i){let r=this.size;for(let s=0;s<t;s++)this.series(e[s],2).forEach((a,o)=>{i[s*r+o]=a[0],i[(t+s)*r+o]=a[1],i[(2*t+s)*r+o]=2*a[2]})}slopes(e,t,i,r){let s=this.series(e,3),a=s.length-1,o=this.basis.partition;for(let l=0;l<3;l++)if(o)if(e<.5)for(let c=a-1,h=0;c>=0;c--)r[c][l]=h+=(l+1)*s[c+1][l+1];else for(let c=0,h=0;c<a;c++)r[c][l]=h-=(l+1)*s[c][l+1];else for(let c=0;c<=a;c++)r[c][l]=(l+1)*s[c][l+1]}};var Sf=64,wf={},Oo={},Wn=wf;function Sb(n){let e=new Map,{name:t,title:i,counts:r,sizes:s,formulas:a}=n,o=l=>s.includes(l)&&(l in a||t==="bernstein");return{name:t,title:i,counts:r,sizes:s,has:o,basis(l){let c=e.get(l);if(c)return c;if(!o(l))throw new Error(`points: a page from disk holds no formulas of the ${t} basis for ${l} points; open the model with: quintrig view MODEL`);let{functions:h,parameters:d}=a[l]??Mb(l),u=new Tr(t,h,d.map(([p,f,b,m,g,y])=>({name:p,low:f,high:b,start:m,open:[g,y]})),!0);return e.set(l,u),u}}}var Mb=n=>({functions:Array.from({length:n},(e,t)=>`${Qh(n-1,t)}*t^${t}*r^${n-1-t}`),parameters:[]});function Rr(n){for(let e of n){let t=Oo[e.name],i=t?{...t,formulas:{...t.formulas,...e.formulas}}:e;Oo[e.name]=i,wf[e.name]=Sb(i)}}Rr(Be.library);var wb={...Oo},Af=()=>Object.values(Oo).filter(n=>n!==wb[n.name]),Mf=new WeakMap;function Pr(n){if(n===void 0)return{};if(typeof n=="string")throw new Error(`bases: a page from disk reads no file ${on(n)}; put its tables into the model as [bases.NAME], or use: quintrig view MODEL`);if(!lu(n))throw new Error(`bases: expected [bases.NAME] tables, found ${Cr(n)}`);let e=Mf.get(n);if(e)return e;let t=Object.keys(n).length;if(t>Sf)throw new Error(`bases: expected at most ${Sf} bases, found ${t}`);let i=Object.fromEntries(Object.entries(n).map(([r,s])=>{try{return[r,Ab(Tb(r,s))]}catch(a){throw new Error(`bases.${r.slice(0,60)}: ${a.message}`)}}));return Mf.set(n,i),i}var Ab=n=>{let{name:e,size:t}=n;return{name:e,title:e,counts:`${t} control points`,sizes:[t],has:i=>i===t,basis:()=>n}},ou=Be.basisKeys,Eb=Be.library.map(({name:n})=>n);function Tb(n,e){if(Eb.includes(n))throw new Error(`${on(n)} is the name of a basis that quintrig brings; choose another name`);if(!/^[A-Za-z_]\w{0,59}$/.test(n))throw new Error(`expected a name of letters, digits and _, found ${on(n.slice(0,60))}`);if(!lu(e))throw new Error(`expected a table with functions = [...] and parameters = {...}, found ${Cr(e)}`);let t=Object.keys(e).find(o=>!ou.includes(o));if(t!==void 0){let o=No(t,ou);throw new Error(`unknown key ${on(t)}${o?`; did you mean ${on(o)}?`:""}; the keys are ${ou.join(", ")}`)}let{functions:i,parameters:r={},source:s=""}=e;if(!Array.isArray(i))throw new Error(`functions: expected a list of formulas, such as ["1-t", "t"], found ${Cr(i)}`);if(!lu(r))throw new Error(`parameters: expected a table such as { lam = [-1, 1] }, found ${Cr(r)}`);if(typeof s!="string"||s.length>400)throw new Error(`source: expected a text of at most 400 letters, found ${Cr(s)}`);let a=Object.entries(r).map(([o,l])=>{let c=`parameters.${o.slice(0,40)}`;if(!Array.isArray(l)||l.length<2||l.length>3)throw new Error(`${c}: expected its range [low, high], such as [-1, 1], found ${Cr(l)}`);let h=l.find(d=>typeof d!="number"||!Number.isFinite(d));if(h!==void 0)throw new Error(`parameters.${o}: expected a finite number, found ${Cr(h)}`);return zo(o,...l)});return new Tr(n,i,a)}function ko(n,e={}){let t={...Wn,...e};if(Object.hasOwn(t,n))return t[n];let i=No(n,Object.keys(t));throw new Error(`basis: expected one of ${Object.keys(t).join(", ")}, found ${on(n)}${i?`; did you mean ${on(i)}?`:""}`)}function cu(n,e,t,i=ci){return e===6&&(n===Wn.trigonometric||n===Wn.quintic)?new pn(t[0],t[1],i):n===Wn.bernstein?new li(e-1):new fn(n.basis(e),t)}var lu=n=>typeof n=="object"&&n!==null&&!Array.isArray(n),Cr=n=>(n===void 0?"none":typeof n=="string"?on(n):JSON.stringify(n)??String(n)).slice(0,60);var Ze=class extends Error{},Ir=Be.shapeRange,Ef={...Be.kinds},Tf={...Be.starters},it=Ef,hu=Tf;function Nr(n){Rr(n.library??[]);for(let[e,t]of Object.entries(n.kinds??{}))Ef[e]??=t;for(let[e,t]of Object.entries(n.starters??{}))Tf[e]??=t}function Ae(n,e){return n[e]??it[n.kind]?.fields[e]?.default}function $n(n){let e=Ae(n,"basis");if(e===void 0)return[];let t=Pr(Ae(n,"bases")),i=l=>Ae(n,l)??[],r=Cb(n),s=i(r[0]),a=(s[0]??[]).length,o=n.kind==="symmetric"?[["points",uu(ko([e].flat()[0],t),s.length)],["points[0]",a]]:n.kind==="curve"?[["points",s.length+ +(Ae(n,"close")===!0)]]:n.kind==="developable"?[["planes",s.length]]:it[n.kind].fields[r[0]].counts.length===2?[[r[0],s.length],[`${r[0]}[0]`,a]]:[[r[0],s.length],[r.at(-1),i(r.at(-1)).length]];if(Array.isArray(e)&&e.length!==o.length)throw new Error(`basis: expected one basis, or ${o.length}, found ${e.length}`);return o.map(([l,c],h)=>{let d=ko(Array.isArray(e)?e[h]:e,t);if(!d.sizes.includes(c)){let u=n.kind==="curve"&&Ae(n,"close")===!0?"; close = true adds the first once more, as the last":"";throw new Error(`${l}: expected ${l==="planes"?d.counts.replace("points","planes"):d.counts} for the ${d.name} basis, found ${c}${u}`)}return{entry:d,points:c,place:l}})}var Cb=n=>Object.entries(it[n.kind].fields).flatMap(([e,t])=>t.type==="points"?[e]:[]);function uu(n,e){let t=[2*e,2*e-1].find(r=>n.sizes.includes(r));if(t!==void 0)return t;let i=[...new Set(n.sizes.map(r=>r+1>>1))].sort((r,s)=>r-s);throw new Error(`points: expected ${i.length<4?i.join(" or "):`${i[0]} to ${i.at(-1)}`} rows, half of the net, found ${e}`)}var Lr=n=>Rf(n,"trigonometric","quintic"),Ji=n=>Rf(n,"bernstein");function Rf(n,...e){let t=Ae(n,"basis");return t!==void 0&&[t].flat().every(i=>e.includes(i))}var Cf=new WeakMap;function Ei(n){let e=Cf.get(n);if(!e){try{e=Ae(n,"basis")===void 0?Rb(n):Pf($n(n))}catch{e=[]}Cf.set(n,e)}return e}var Rb=n=>(it[n.kind]?.fields.shape?it[n.kind].shapeNames:[]).map(e=>({name:e,label:e,low:Ir[0],high:Ir[1],start:0,open:[!1,!1],of:0}));function Pf(n){let e=(t,i)=>n.length<2?t:/\d$/.test(t)?`${t}_${i+1}`:`${t}${i+1}`;return n.flatMap(({entry:t,points:i},r)=>t.basis(i).parameters.map(s=>({...s,label:e(s.name,r),of:r})))}function mn(n){if(!it[n.kind]?.fields.shape)return[];let e=n.shape??[];return e.length?e:Ji(n)||!it[n.kind].fields.basis?Ae(n,"shape")??[]:Ei(n).map(t=>t.start)}function du(n,e){let t=Pf(e),i=n.shape??[];if(i.length===0)return e.map(({entry:r,points:s})=>r.basis(s).parameters.map(a=>a.start));if(e.every(r=>r.entry===Wn.bernstein)){if(i.length!==2*e.length)throw new Error(`shape: expected none or ${2*e.length} numbers, which do not act in the bernstein basis, found ${i.length}`);return e.map(()=>[])}if(i.length!==t.length){let r=t.length?` (${t.map(s=>s.label).join(", ")})`:", as the basis has no shape parameters";throw new Error(`shape: expected ${t.length} numbers${r}, found ${i.length}`)}if(n.unchecked_shape!==!0){let r=i.findIndex((s,a)=>!us(t[a],s));if(r>=0)throw new Error(`shape[${r}] (${t[r].label}) = ${i[r]} is outside ${ds(t[r])}, the range of this basis; choose a value in the range, or set unchecked_shape = true and lose what the range warrants, such as the convex-hull property`)}return e.map((r,s)=>i.filter((a,o)=>t[o].of===s))}function Pb(n,e){if(n.unchecked_basis!==!0)for(let t of e.map(({entry:i,points:r})=>i.basis(r))){if(t.partition)continue;let{by:i,where:r}=t.offSum;throw new Error(`basis: the functions of '${t.name}' do not sum to 1 (off by ${Number(i.toPrecision(3))} ${r}); correct the formulas, or set unchecked_basis = true and have a surface that moves with the origin`)}}var If=n=>n.map(({entry:e,points:t})=>e.basis(t)).filter(e=>!e.partition);function Uo(n){let e=$n(n),t=du(n,e);return Pb(n,e),e.map(({entry:i,points:r},s)=>{let a=t[s],o=i===Wn.trigonometric||i===Wn.quintic,l=()=>new fn(i.basis(r),a);return{partition:i.basis(r).partition,formulas:l,dual:()=>o?new pn(a[0],a[1]):l(),functions:(c=ci)=>cu(i,r,a,c),still:c=>o?Zp(a[0],a[1],c):ci}})}function Nn(n,e=3){let t=new Array(e).fill(1/0),i=new Array(e).fill(-1/0);for(let o of n)if(o.every(Number.isFinite))for(let l=0;l<e;l++)t[l]=Math.min(t[l],o[l]),i[l]=Math.max(i[l],o[l]);let r=Math.max(...t.map((o,l)=>i[l]-o));if(!Number.isFinite(r))return t.map(()=>0);let s=t.map((o,l)=>.5*o+.5*i[l]),a=2**(Math.floor(Math.log2(r))+3);return r>0&&a>0&&Number.isFinite(a)?s.map(o=>Math.round(o/a)*a+0):s}var Xn=(n,e)=>n.map((t,i)=>t-e[i]);function ps(n,e){if(e.every(r=>r===0))return[...n];let t=n[3],i=0;for(let r=0;r<3;r++){let s=n[r]*e[r],[a,o]=Nf(n[r]),[l,c]=Nf(e[r]),h=o*c-(s-a*l-o*l-a*c),d=t+s,u=d-t;i+=t-(d-u)+(s-u)+h,t=d}return[n[0],n[1],n[2],t+i]}function Nf(n){let e=134217729*n,t=e-(e-n);return[t,n-t]}var Wt=class{constructor(e,t){this.points=e;this.functions=t;this.size=e.m,this.dimension=e.dimension}points;functions;size;dimension;scratch=new Float64Array(0);derivatives(e,t,i){let r=this.functions.size,s=this.size*this.dimension,a=this.points.values;this.scratch.length<3*t*r&&(this.scratch=new Float64Array(3*t*r));let o=this.scratch;this.functions.derivatives(e,t,o);for(let l=0;l<3*t;l++)for(let c=0;c<s;c++){let h=0;for(let d=0;d<r;d++)h+=o[l*r+d]*a[d*s+c];i[l*s+c]=h}}},fs=n=>n.flip?"against":"along",{stepsForSize:Ln,farOff:Ib,samePoint:Nb}=Be.limits,Lf=Float64Array.from({length:Ln},(n,e)=>e/(Ln-1)),ui=new Float64Array(3*Ln*Ln),ga=new Float64Array(Ln*Ln);function di(n){let{rows:e,blend:t,origin:i=[0,0,0]}=n,r=e.size,s=e.dimension,a=new Float64Array(3*Ln*r*s),o=new Float64Array(3*Ln*r);e.derivatives(Lf,Ln,a),t.derivatives(Lf,Ln,o);let l=0,c=[0,0,0,1];for(let y=0;y<Ln;y++)for(let _=0;_<Ln;_++){for(let E=0;E<s;E++){c[E]=0;for(let w=0;w<r;w++)c[E]+=a[(y*r+w)*s+E]*o[_*r+w]}let x=s===4?c[3]:1;for(let E=0;E<3;E++)ui[3*l+E]=c[E]/x;Number.isFinite(ui[3*l]+ui[3*l+1]+ui[3*l+2])&&l++}let h=[1/0,1/0,1/0],d=[-1/0,-1/0,-1/0],[u,p,f]=[0,1,2].map(y=>{for(let _=0;_<l;_++)ga[_]=ui[3*_+y];return Df(ga.subarray(0,l))});for(let y=0;y<l;y++)ga[y]=Math.max(Math.abs(ui[3*y]-u),Math.abs(ui[3*y+1]-p),Math.abs(ui[3*y+2]-f));let b=Ib*Df(ga.slice(0,l))||1/0;for(let y=0;y<l;y++)if(!(ga[y]>b))for(let _=0;_<3;_++)h[_]=Math.min(h[_],ui[3*y+_]),d[_]=Math.max(d[_],ui[3*y+_]);let m=l?Math.sqrt(h.reduce((y,_,x)=>y+(d[x]-_)**2,0)):0;for(let y=0;y<3;y++)h[y]+=i[y],d[y]+=i[y];let g=Math.max(...h.map(Math.abs),...d.map(Math.abs));return{low:h,high:d,size:m>Nb*g?m:0}}function Df(n){n.sort();let e=n.length>>1;return n.length%2?n[e]:.5*(n[e-1]+n[e])}function $t(n){let e=n.length,t=n[0].length,i=n[0][0].length,r=new Float64Array(e*t*i);return n.forEach((s,a)=>s.forEach((o,l)=>r.set(o,(a*t+l)*i))),{values:r,n:e,m:t,dimension:i}}function pu(n,e,t){let i=Nn(n.flat());return fu(n.map(r=>r.map(s=>Xn(s,i))),i,e,t,$t(n))}function fu(n,e,t,i,r){let s=()=>n.map(c=>c.map(h=>h.map((d,u)=>d+e[u])));r??=$t(s()),t.every(c=>c.partition)||([n,e]=[s(),[0,0,0]]);let a=n[0].map((c,h)=>n.map(d=>d[h])),o=t[0].functions(t[0].still(n)),l=t[1].functions(t[1].still(a));return{rows:new Wt($t(n),o),blend:l,flip:i,net:r,origin:e}}function Ff(n,e,t,i,r){let s=Nn(n.flat()),a=ps(e,s),o=n.map(c=>c.map(h=>Xn(h,s))),l=o.map(c=>c.map(h=>ms(h,a))).reverse();if(t){let c=Math.max(...l[0].flatMap((h,d)=>h.map((u,p)=>Math.abs(u-o.at(-1)[d][p]))));if(c>1e-9*Math.max(...o.flat(2).map(Math.abs)))throw new Error(`points[${n.length-1}]: expected points on the mirror plane, as this basis has a middle row, found them ${Number((.5*c).toPrecision(3))} away`);l.shift()}return fu([...o,...l],s,i,r)}function zf(n,e,t,i){let[r,s]=[Nn(n),Nn(e)],a=n.map(h=>Xn(h,r)),o=e.map(h=>Xn(h,s)),l=(h,d)=>h.map(u=>d.map(p=>u.map((f,b)=>f+p[b]))),c=r.map((h,d)=>h+s[d]);return fu(l(a,o),c,t,i,$t(l(n,e)))}function Of(n,e,t,i,r){return pu(n.map(([s,a])=>e.map(([o,l])=>[t*s*o,t*s*l,a])),i,r)}function kf(n,e,t,i){let r=[0,0,0],[s,a]=t,o=s.partition&&a.partition?Nn([...n,...e]):r,l=$t([...n.map(f=>[Xn(f,o),r]),...e.map(f=>[r,Xn(f,o)])]),c=s.still(n.map(f=>[f])),h=a.still(e.map(f=>[f])),d=[c[0]&&h[0],c[1]&&h[1]],u=new Gn([s.functions(d),a.functions(d)]),p=n.length===e.length?$t(n.map((f,b)=>[f,e[b]])):null;return{rows:new Wt(l,u),blend:new li(1),flip:i,net:p,origin:o}}function ms(n,e){let[t,i,r,s]=e,a=(n[0]*t+n[1]*i+n[2]*r+s)/(t*t+i*i+r*r);return[n[0]-2*a*t,n[1]-2*a*i,n[2]-2*a*r]}var{noise:Uf,rounding:Lb}=Be.limits;function Bf(n,e,t,i,r){let s=Db(new gs(n,e,t,i)),a=l=>ps(l,s),o=new gs(n.map(a),e.map(a),t,i);if(!o.meets())throw new Error("planes: the control planes envelop no strip that the bounding planes cut (they are equal, parallel, or all contain one line that a bounding plane contains too); change the planes or the bounds");return{rows:o,blend:new li(1),flip:r,net:null,origin:s}}function Db(n){let t=Float64Array.from({length:17},(l,c)=>c/16),i=new Float64Array(306);n.derivatives(t,17,i);let s=Array.from({length:34},(l,c)=>Array.from(i.subarray(3*c,3*c+3))).filter(l=>l.every(Number.isFinite)),a=[0,1,2].map(l=>s.map(c=>c[l]).sort((c,h)=>c-h)),o=l=>a.map(c=>c[Math.floor(l*(c.length-1))]);return s.length?Nn([o(.25),o(.75)]):[0,0,0]}var gs=class{constructor(e,t,i,r=!0){this.planes=e;this.bounds=t;this.functions=i;this.edges=r?e.slice(1).map((a,o)=>a.map((l,c)=>l-e[o][c])):e.map(a=>[...a]);let s=(a,o)=>i instanceof pn&&(i[a]===-4||o.every(l=>l===0));this.start=s("alpha",this.edges[0]),this.end=s("zeta",this.edges.at(-1)),this.hodograph=Mi(this.edges.length)}planes;bounds;functions;size=2;dimension=3;edges;start;end;scratch=new Float64Array(0);hodograph;derivatives(e,t,i){let r=3*this.functions.size*t;this.scratch.length<r&&(this.scratch=new Float64Array(r)),this.functions.derivatives(e,t,this.scratch);for(let s=0;s<t;s++){let{plane:a,slope:o}=this.dual(e[s],t,s);this.bounds.forEach((l,c)=>{Fb(a,o,l).forEach((h,d)=>{for(let u=0;u<3;u++)i[((d*t+s)*2+c)*3+u]=(d===2?2:1)*h[u]})})}}meets(){let t=Float64Array.from({length:33},(s,a)=>a/32);this.scratch=new Float64Array(3*this.functions.size*33),this.functions.derivatives(t,33,this.scratch);let i=this.bounds.map(()=>0),r=[0,0];for(let s=0;s<33;s++){let{plane:a,slope:o}=this.dual(t[s],33,s),[l,c]=[a[0].slice(0,3),o[0].slice(0,3)];Number.isNaN(c[0])||(r[0]=Math.max(r[0],Math.hypot(...l)),r[1]=Math.max(r[1],Math.hypot(...c)),this.bounds.forEach((h,d)=>i[d]=Math.max(i[d],Math.abs(Dn(ba(l,c),h)))))}return i.every((s,a)=>s>Uf*r[0]*r[1]*Math.hypot(...this.bounds[a].slice(0,3)))}dual(e,t,i){this.functions.slopes(e,this.start,this.end,this.hodograph);let r=[0,1,2],s=[0,1,2,3],{size:a}=this.functions,o=r.map(h=>s.map(d=>{let u=0;for(let p=0;p<a;p++)u+=this.scratch[a*(h*t+i)+p]*this.planes[p][d];return h===2?u/2:u})),l=r.map(h=>s.map(d=>this.hodograph.reduce((u,p,f)=>u+p[h]*this.edges[f][d],0))),c=s.map(h=>this.hodograph.reduce((d,u,p)=>d+Math.abs(u[0]*this.edges[p][h]),0));return s.every(h=>Math.abs(l[0][h])<=Lb*c[h])&&l[0].fill(NaN),{plane:o,slope:l}}};function Fb(n,e,t){let i=n.map(m=>ba(t,m)),[r,s,a]=e,o=n[0],l=Dn(r,i[0]),c=Dn(r,i[1])+Dn(s,i[0]),h=ba(r,t),d=ba(o,r),u=[0,1,2].map(m=>-(o[3]*h[m]+r[3]*i[0][m]+t[3]*d[m])/l),p=(-s[3]-Dn(s,u))/l,f=i[0].map(m=>p*m),b=(-2*a[3]-Dn(s,f)-2*Dn(a,u)-p*c)/l;return[u,f,i[0].map((m,g)=>.5*(p*i[1][g]+b*m))]}function Bo(n,e=257){let t=Float64Array.from({length:e},(h,d)=>d/(e-1)),i=new Float64Array(3*e*6);n.rows.derivatives(t,e,i);let r=Array.from(t,(h,d)=>zb(i,e,d)),s=r.map(([h,d])=>Math.max(Math.abs(h),Math.abs(d))),a=s.filter(h=>!Number.isNaN(h)).sort((h,d)=>h-d),o=Uf*(a[a.length>>1]??0),l=[],c=!1;return r.forEach(([h,d],u)=>{let p=h*d<=0&&s[u]>o;p&&!c&&l.push({u:[],v:[]}),p&&(l.at(-1).u.push(t[u]),l.at(-1).v.push(h/(h-d))),c=p}),l}function zb(n,e,t){let i=(c,h,d)=>n[((c*e+t)*2+h)*3+d],r=[0,1,2].map(c=>i(0,1,c)-i(0,0,c)),[s,a]=[0,1].map(c=>ba([i(1,c,0),i(1,c,1),i(1,c,2)],r)),o=Dn(s,s)>Dn(a,a)?s:a,l=Math.sqrt(Dn(o,o))||1;return[Dn(s,o)/l,Dn(a,o)/l]}var Dn=(n,e)=>n[0]*e[0]+n[1]*e[1]+n[2]*e[2],ba=(n,e)=>[n[1]*e[2]-n[2]*e[1],n[2]*e[0]-n[0]*e[2],n[0]*e[1]-n[1]*e[0]];var Dr=class{constructor(e,t){this.degree=t;this.size=e.length-t-1;let i=e[t],r=e[this.size];if(!(r>i))throw new Error(`knots: expected them to rise from ${i} over the domain, found them to end at ${r}`);this.knots=e.map(s=>s===r?1:(s-i)/(r-i))}degree;size;knots;derivatives(e,t,i){let{knots:r,degree:s,size:a}=this,o=Array.from({length:s+1},()=>new Float64Array(r.length-1));for(let l=0;l<t;l++){let c=s;for(;c<a-1&&r[c+1]<=e[l];)c++;o[0].fill(0),o[0][c]=1;for(let h=1;h<=s;h++){let d=o[h-1],u=p=>(e[l]-r[p])*qf(r[p+h]-r[p])*d[p];for(let p=0;p<r.length-1-h;p++)o[h][p]=u(p)+d[p+1]-u(p+1)}for(let h=0;h<3;h++){let d=h<=s?o[s-h]:new Float64Array(r.length-1);for(let u=s-h+1;h<=s&&u<=s;u++){let p=d,f=b=>u*qf(r[b+u]-r[b])*p[b];d=Float64Array.from({length:r.length-1-u},(b,m)=>f(m)-f(m+1))}for(let u=0;u<a;u++)i[(h*t+l)*a+u]=d[u]}}}},qf=n=>n>0?1/n:0;function Vf(n,e,t,i,r,s=[]){let a=$t(n),o=new Dr(i[0],t[0]),l=new Dr(i[1],t[1]);if(o.size!==a.n||l.size!==a.m)throw new Error(`knots: expected ${a.n+t[0]+1} and ${a.m+t[1]+1}, found ${i[0].length} and ${i[1].length}`);let c=Nn(n.flat()),h=n.map(p=>p.map(f=>Xn(f,c))),d=e?.[0]?.[0];if(!e||e.every(p=>p.every(f=>f===d)))return{rows:new Wt($t(h),o),blend:l,flip:r,net:a,origin:c,trim:s};let u=h.map((p,f)=>p.map((b,m)=>[...b.map(g=>g*e[f][m]),e[f][m]]));return{rows:new Wt($t(u),o),blend:l,flip:r,net:a,origin:c,trim:s}}var Hf=new dn(0,1,0),Gf=(n,e)=>mu(n,n,n,e);function mu(n,e,t,i){return ya(new wi(-1,1),[[n,e,0],[0,0,t]],!i)}function Wf(n,e,t){return ya(new dn(0,1,1),[[n,n,0],[0,0,e]],!t)}function $f(n,e,t){return ya(new dn(0,1,1),[[n,n,0],[-n,-n,e]],!t)}function Xf(n,e,t){return ya(new Gn([new wi(0,4),Hf]),[[e,e,0],[0,0,e],[n,n,0]],!t)}function Yf(n,e,t){let i=.5*e/n,r=new Gn([new os(-i,i),new dn(-i,i,1)]);return ya(r,[[n,n,0],[0,0,0],[0,0,0],[0,0,n]],!t)}function Jf(n,e,t){let i=$t([[[0,0,0],[0,0,0],[0,0,0],[0,0,e/(2*Math.PI)]],[[1,0,0],[0,1,0],[0,0,0],[0,0,0]]]),r=new Gn([new wi(0,4),new dn(0,2*Math.PI,1)]);return{rows:new Wt(i,new dn(-n,n,1)),blend:r,flip:t,net:null}}var jf=(n,e)=>gu(n,[[1,0,1,0,0],[0,1,0,1,0],[1,1,0,0,1]],e),Zf=(n,e)=>gu(n,[[1,0,1,0,0],[0,1,0,1,0],[3,0,0,0,1],[1,2,0,0,-3]],e);function Kf(n,e){let t=.3333333333333333,i=[[1,0,1,0,0],[3,0,-t,0,0],[1,2,1,0,0],[0,1,0,1,0],[0,3,0,-t,0],[2,1,0,1,0],[2,0,0,0,1],[0,2,0,0,-1]];return gu(n,i,e)}function ya(n,e,t){let i=$t(e.map(([r,s,a])=>[[r,0,0],[0,s,0],[0,0,a]]));return{rows:new Wt(i,n),blend:new Gn([new wi(0,4),Hf]),flip:t,net:null}}function gu(n,e,t){let i=Math.max(...e.map(a=>a[0]))+1,r=Math.max(...e.map(a=>a[1]))+1,s={values:new Float64Array(i*r*3),n:i,m:r,dimension:3};for(let[a,o,...l]of e)s.values.set(l,(a*r+o)*3);return{rows:new Wt(s,new dn(-n,n,i-1)),blend:new dn(-n,n,r-1),flip:t,net:null}}var bu=class{constructor(e){this.patch=e;this.flip=this.get("flip")}patch;flip;get bases(){return Uo(this.patch)}get odd(){return uu($n(this.patch)[0].entry,this.net("points").length)%2===1}get(e){return Ae(this.patch,e)}size(e){return this.get(e)}curve(e){return this.get(e)}net(e){return this.get(e)}strip(){let[e]=this.bases;return Bf(this.curve("planes"),this.curve("bounds"),e.dual(),e.partition,this.flip)}},yu={tensor:n=>pu(n.net("points"),n.bases,n.flip),symmetric:n=>Ff(n.net("points"),n.get("mirror"),n.odd,n.bases,n.flip),swept:n=>zf(n.curve("section"),n.curve("trajectory"),n.bases,n.flip),swung:n=>Of(n.curve("profile"),n.curve("trajectory"),n.size("scale"),n.bases,n.flip),ruled:n=>kf(n.curve("first"),n.curve("second"),n.bases,n.flip),developable:n=>n.strip(),nurbs:n=>Vf(n.net("points"),n.get("weights"),n.get("degrees"),n.curve("knots"),n.flip,n.net("trim")),sphere:n=>Gf(n.size("radius"),n.flip),ellipsoid:n=>mu(n.size("a"),n.size("b"),n.size("c"),n.flip),cylinder:n=>Wf(n.size("radius"),n.size("height"),n.flip),cone:n=>$f(n.size("radius"),n.size("height"),n.flip),torus:n=>Xf(n.size("major"),n.size("minor"),n.flip),catenoid:n=>Yf(n.size("waist"),n.size("height"),n.flip),helicoid:n=>Jf(n.size("radius"),n.size("pitch"),n.flip),hyperbolic_paraboloid:n=>jf(n.size("size"),n.flip),monkey_saddle:n=>Zf(n.size("size"),n.flip),enneper:n=>Kf(n.size("size"),n.flip)},Fr=n=>n.kind==="curve"||Object.hasOwn(yu,n.kind),Qf=n=>yu[n.kind](new bu(n));var qo=class{constructor(e,t){this.breaks=e;this.series=t;this.size=t[0][0][0].length}breaks;series;size;derivatives(e,t,i){let{breaks:r,series:s,size:a}=this;for(let o=0;o<t;o++){let l=0;for(;l<s.length-1&&r[l+1]<=e[o];)l++;let c=r[l],h=r[l+1],d=(e[o]-c-(h-e[o]))/(h-c);s[l].forEach((u,p)=>{for(let f=0;f<a;f++){let b=0,m=0;for(let g=u.length-1;g>0;g--)[b,m]=[2*d*b-m+u[g][f],b];i[(p*t+o)*a+f]=d*b-m+u[0][f]}})}}};var em={trigonometric:(n,e)=>new pn(n("alpha"),n("zeta"),e),bernstein:n=>new li(n("degree")),bspline:n=>new Dr(n("knots"),n("degree")),circular:n=>new wi(n("start"),n("end")),hyperbolic:n=>new os(n("start"),n("end")),powers:n=>new dn(n("start"),n("end"),n("degree")),joined:n=>new Gn(n("parts").map(va)),formulas:n=>new fn(new Tr("",n("functions"),n("names").map(e=>zo(e,-1,1)),!0),n("values")),chebyshev:n=>new qo(n("breaks"),n("series"))};function va(n){let e=em[n.family];if(!e)throw new Error(`functions: the page does not know ${n.family} functions`);return e(t=>n[t],n.still??ci)}var xa=class extends Ze{},kb=512,Ub=8,ji=new Map,tm=new Map,Vo=new Map,Zi=[],vu=!1;function Ho(n,e){let t={ask:n,arrived:e};return Zi.push(t),()=>{Zi.splice(Zi.indexOf(t),1)}}function _a(n){for(let{keys:e,surface:t,error:i}of n)xu(Su(e),t?qb(t):new Ze(i??"there is no surface"))}function nm(n){let e=Su(n),t=ji.get(e),i=`${n.kind} ${n.name}`;if(t instanceof Ze)throw t;if(t)return tm.set(i,t),t;if(!Zi.length)throw new Ze(`patch "${n.name}": ${im(n)}`);Vo.set(e,n),Bb();let r=tm.get(i);if(!r)throw new xa(`patch "${n.name}": is being built by Python`);return r}var _u=n=>Zi.length||ji.has(Su(n))?"":`patch "${n.name}": ${im(n)}`,im=({kind:n})=>`a ${n} is built by Python, which a page from disk lacks; change it with: quintrig view MODEL`;async function Bb(){if(!vu){for(vu=!0,await Promise.resolve();Vo.size&&Zi.length;){let n=[...Vo].slice(-Ub);Vo.clear();try{_a(await Zi.at(-1).ask(n.map(([,e])=>e)))}catch(e){for(let[t]of n)xu(t,new Ze(e.message))}for(let[e]of n)ji.has(e)||xu(e,new Ze("Python did not build this patch"));for(let{arrived:e}of Zi)e()}vu=!1}}function xu(n,e){ji.delete(n),ji.set(n,e),ji.size>kb&&ji.delete(ji.keys().next().value)}function Su(n){let e=Object.keys(it[n.kind]?.fields??{}).sort();return JSON.stringify([n.kind,...e.map(t=>Ae(n,t)??null)])}function qb({origin:n,flip:e,net:t,blend:i,...r}){return{rows:Vb(r,n),blend:va(i),flip:e,net:t&&$t(t),origin:n}}function Vb({points:n,planes:e,bounds:t,functions:i,dimension:r},s){let a=va(i);if(n)return new Wt($t(n),a);if(e&&t&&(a instanceof pn||a instanceof fn)){let o=c=>ps(c,s),l=a instanceof fn?a:new pn(a.alpha,a.zeta,ci);return new gs(e.map(o),t.map(o),l,!(a instanceof fn)||a.partition)}return{size:a.size/r,dimension:r,derivatives:(o,l,c)=>a.derivatives(o,l,c)}}var Hb=1e-13,Gb=1e-10,Go=400,Qe=n=>n.kind==="curve",Mu=class{constructor(e,t,i=!1){this.points=e;this.functions=t;this.backwards=i;this.flat=e[0].length===2;let r=e.map(s=>[s[0],s[1],s[2]??0]);this.origin=t.partition?Nn(r):[0,0,0],this.local=r.map(s=>Xn(s,this.origin)),this.polygon=this.local.slice(1).reduce((s,a,o)=>s+Math.hypot(...a.map((l,c)=>l-this.local[o][c])),0)}points;functions;backwards;flat;polygon;origin;local;derivatives(e){let t=this.functions.series(this.backwards?1-e:e,3),i=this.backwards?-1:1,r=(s,a)=>[0,1,2].map(o=>a*this.local.reduce((l,c,h)=>l+t[h][s]*c[o],0));return[r(0,1).map((s,a)=>s+this.origin[a]),r(1,i),r(2,2),r(3,6*i)]}at(e){let[t,i,r,s]=this.derivatives(e),a=Math.hypot(...i),o=!(a>Hb*this.polygon),l=$b(i,r),c=Math.hypot(...l),h=this.flat&&l[2]<0?-1:1,d=1e-13*a*Math.max(Math.hypot(...r),this.polygon),u=sm(i,r)/a**4;return{t:e,point:t,speed:a,curvature:o?NaN:h*c/a**3,torsion:o||c<=d?NaN:sm(l,s)/c**2,bend:r.map((p,f)=>o?NaN:p/a**2-i[f]*u)}}sample(e){return Array.from({length:e},(t,i)=>this.at(i/(e-1)))}get length(){let e=.5/Math.sqrt(3),t=Array.from({length:Go},(r,s)=>s),i=r=>Math.hypot(...this.derivatives(r)[1]);return t.reduce((r,s)=>r+i((s+.5-e)/Go)+i((s+.5+e)/Go),0)/(2*Go)}bends=e=>Math.abs(e)*this.polygon>Gb},rm=new WeakMap;function St(n){let e=rm.get(n);if(!e){try{e=Wb(n)}catch(t){e=new Ze(`patch "${n.name}": ${t.message}`)}rm.set(n,e)}if(e instanceof Ze)throw e;return e}function Wb(n){let e=Ae(n,"points");if(e.some(r=>r.length!==e[0].length))throw new Error("points: expected points all [x, y] or all [x, y, z]");let[t]=Uo(n),i=Ae(n,"flip")===!0;if(i&&!Lr(n)&&!Ji(n))throw new Error("flip: expected the quintic or the Bernstein basis, whose ends can be exchanged");return new Mu(Ae(n,"close")===!0?[...e,e[0]]:e,t.formulas(),i)}var sm=(n,e)=>n[0]*e[0]+n[1]*e[1]+n[2]*e[2],$b=(n,e)=>[n[1]*e[2]-n[2]*e[1],n[2]*e[0]-n[0]*e[2],n[0]*e[1]-n[1]*e[0]];var Wo=Be.units,{largest:cm,largestPolygon:am}=Be.limits;function vt(n){if(!lm(n))throw new Ze(`model: expected keys and values, got ${ln(n)}`);let{schema:e=Be.schema,name:t="",unit:i="",patch:r,join:s,built:a,library:o,...l}=n;if(a&&_a(a),o&&Rr(o),e!==Be.schema)throw new Ze(`schema: expected ${Be.schema}, got ${ln(e)}; this quintrig reads version 1`);if(i!==""&&!Wo.includes(i))throw new Ze(`unit: expected one of ${Wo.join(", ")}, got ${ln(i)}; leave it out for plain numbers`);if(typeof t!="string"||t.length>200)throw new Ze(`name: expected a short text, got ${ln(t)}`);if(r===void 0){let f=om({...l,name:t||String(l.kind??"surface")});return{name:t||f.name,unit:i,patches:[f]}}if(!Array.isArray(r)||!r.length)throw new Ze(`patch: expected one or more [[patch]] tables, got ${ln(r)}`);let{bases:c,...h}=l,d=Object.keys(h)[0];if(d)throw new Ze(`unknown key '${d}' beside [[patch]] tables; move it into a patch`);c!==void 0&&hm(()=>Pr(c));let u=r.map((f,b)=>{if(!lm(f))throw new Ze(`patch ${b+1}: expected a table of keys, got ${ln(f)}`);let m=c!==void 0&&it[String(f.kind)]?.fields.bases?{bases:c}:{};return om({...m,...f,name:f.name??`patch ${b+1}`})}),p=u.filter(Qe);if(new Set(p.map(f=>St(f).flat)).size>1)throw new Ze("points: expected curves all in the plane or all in space, found both in one model");if(s!==void 0&&!Array.isArray(s))throw new Ze(`join: expected one or more [[join]] tables, got ${ln(s)}`);return{name:t||u[0].name,unit:i,patches:u,...s?{join:s}:{}}}function cn(n){let e={schema:Be.schema,name:n.name};if(n.unit&&(e.unit=n.unit),n.patches.length===1){let{name:s,...a}=n.patches[0];return{...e,...a}}let t=[...new Set(n.patches.filter(s=>s.bases).map(s=>JSON.stringify(s.bases)))],i=t.length===1?{bases:JSON.parse(t[0])}:{},r=t.length===1?n.patches.map(({bases:s,...a})=>a):n.patches;return{...e,...i,patch:r,...n.join?{join:n.join}:{}}}function Xt(n){if(!Fr(n))return nm(n);try{return Qf(n)}catch(e){throw new Ze(`patch "${n.name}": ${e.message}`)}}function om(n){let e=`patch "${String(n.name)}"`,t=Object.hasOwn(it,String(n.kind)),i=it[String(n.kind)];if(!t||!i)throw new Ze(`${e}: kind: expected one of ${Object.keys(it).join(", ")}, got ${ln(n.kind)}`);let r=l=>{throw new Ze(`${e}: ${l}`)};for(let l of Object.keys(n))l!=="kind"&&l!=="name"&&!Object.hasOwn(i.fields,l)&&r(`unknown key '${l}'`);i.fields.bases&&hm(()=>Pr(n.bases),`${e}: `);let s=i.fields.basis!==void 0,a=i.surface&&(!s||["trigonometric","quintic",void 0].includes(n.basis));for(let[l,c]of Object.entries(i.fields)){let h=n[l];if(h===void 0){c.required&&r(`missing key '${l}': expected ${c.description}`);continue}c.type==="number"||c.type==="positive"?dm(h,l,r,c.type==="positive"):c.type==="boolean"&&typeof h!="boolean"?r(`${l}: expected true or false, got ${ln(h)}`):c.type==="choice"&&!c.choices.includes(h)?r(`${l}: expected one of ${c.choices.join(", ")}, got ${ln(h)}`):c.type==="plane"?$o(h,l,4,r):c.type==="basis"&&!Xb(h)?r(`${l}: expected the name of a basis, or two, got ${ln(h)}`):c.type==="shape"&&s?$o(h,l,null,r):c.type==="shape"?Yb(h,l,i.shapeNames,n.unchecked_shape===!0,r):c.type==="points"&&um(h,l,a?c.counts:c.counts.map(()=>0),c.dimension,r)}let o=n;try{Qe(o)?St(o):Xt(o)}catch(l){if(!(l instanceof xa))throw l}return o}function hm(n,e=""){try{n()}catch(t){throw new Ze(`${e}${t.message}`)}}var Xb=n=>[n].flat().every(e=>typeof e=="string"&&e!=="");function Yb(n,e,t,i,r){$o(n,e,t.length,r).forEach((s,a)=>{!i&&!(s>=Ir[0]&&s<=Ir[1])&&r(`shape[${a}] (${t[a]}) = ${s} is outside [${Ir.join(", ")}], where the basis is non-negative; choose a value in the range, or set unchecked_shape = true and lose the convex-hull property`)})}function um(n,e,t,i,r){if(!t.length)return void $o(n,e,i,r);if(!Array.isArray(n))return r(`${e}: expected a list, got ${ln(n)}`);let s=t[0],a=t.length===2;(s?n.length!==s:n.length<2||n.length>am)&&r(`${e}: expected ${s||`2 to ${am}`} ${a?"rows":"points"}, got ${n.length}`),n.forEach((o,l)=>um(o,`${e}[${l}]`,t.slice(1),i,r)),a&&n.some(o=>o.length!==n[0].length)&&r(`${e}: expected rows of equal length`)}function $o(n,e,t,i){return Array.isArray(n)?(t===null||(t===0?n.length===2||n.length===3:n.length===t)||i(`${e}: expected ${t===0?"2 or 3":t} numbers, got ${n.length}`),n.forEach((s,a)=>dm(s,`${e}[${a}]`,i,!1)),n):i(`${e}: expected a list, got ${ln(n)}`)}var Jb=cm.toExponential().replace("e+","e");function dm(n,e,t,i){typeof n!="number"&&t(`${e}: expected a number, got ${ln(n)}`),Number.isFinite(n)||t(`${e}: expected a finite number, got ${String(n)}`),Math.abs(n)>cm&&t(`${e}: expected a number of size at most ${Jb}, got ${String(n)}`),i&&!(n>0)&&t(`${e}: expected a number greater than 0, got ${String(n)}`)}var lm=n=>typeof n=="object"&&n!==null&&!Array.isArray(n);function ln(n){let e=n===void 0?"nothing":JSON.stringify(n)??String(n);return e.length<=60?e:`${e.slice(0,57)}...`}var wu="quintrig:here:";function pm(n,e){let t=()=>{let{source:i,saved:r}=e.state;try{sessionStorage.setItem(wu+n.place,JSON.stringify(i?{name:i.name}:{model:cn(r)}))}catch{sessionStorage.removeItem(wu+n.place)}};e.subscribe((i,r)=>{(i.opened!==r.opened||i.source!==r.source)&&t()})}async function fm(n){try{let e=JSON.parse(sessionStorage.getItem(wu+n.place)??"null");return e?e.name?await n.load(e.name):{model:vt(e.model),source:null}:null}catch{return null}}function jb(n,e){let t=n.slice(0,e).split(/\r?\n/);return[t.length,t.pop().length+1]}function Zb(n,e,t){let i=n.split(/\r?\n/),r="",s=(Math.log10(e+1)|0)+1;for(let a=e-1;a<=e+1;a++){let o=i[a-1];o&&(r+=a.toString().padEnd(s," "),r+=":  ",r+=o,r+=`
`,a===e&&(r+=" ".repeat(s+t+2),r+=`^
`))}return r}var Ne=class n extends Error{line;column;codeblock;constructor(e,t){let[i,r]=jb(t.toml,t.ptr),s=Zb(t.toml,i,r);super(`Invalid TOML document: ${e}

${s}`,t),this.line=i,this.column=r,this.codeblock=s}static x(e,t,i){throw new n(e,{toml:t.s,ptr:i??t.p})}};function Xo(n){let e=n.p,t=n.s.charCodeAt(n.p++),i=t,r=t===39,s=t===n.s.charCodeAt(n.p)&&t===n.s.charCodeAt(n.p+1);s&&((t=n.s.charCodeAt(n.p+=2))===10?n.p++:t===13&&n.s.charCodeAt(n.p+1)===10&&(n.p+=2));let a="",o=n.p,l=0;for(;n.p<n.s.length;n.p++)if(t=n.s.charCodeAt(n.p),s&&(t===10||t===13&&n.s.charCodeAt(n.p+1)===10))l=l&&3;else if(t<32&&t!==9||t===127)Ne.x("control characters are not allowed in strings",n);else if((!l||l===3)&&t===i&&(!s||n.s.charCodeAt(n.p+1)===i&&n.s.charCodeAt(n.p+2)===i)){if(s&&(n.s.charCodeAt(n.p+3)===i&&n.p++,n.s.charCodeAt(n.p+3)===i&&n.p++),!l){let c=n.s.slice(o,n.p);a=a?a+c:c}return n.p+=s?3:1,a}else if(!l)!r&&t===92&&(a+=n.s.slice(o,o=n.p),l=1);else if(l===1)if(t===120||t===117||t===85){let c=n.p++-1,h=0,d=t===120?2:t===117?4:8;for(let u=0;u<d;u++,n.p++){let p=n.s.charCodeAt(n.p),f=p>=48&&p<=57?p-48:p>=65&&p<=70?p-65+10:p>=97&&p<=102?p-97+10:-1;f<0&&Ne.x("invalid non-hex character in unicode escape",n),h=h<<4|f}(h<0||h>1114111||h>=55296&&h<=57343)&&Ne.x("invalid unicode escape",n,c),a+=String.fromCodePoint(h),o=n.p--,l=0}else s&&(t===32||t===9)?l=2:(t===98?a+="\b":t===116?a+="	":t===110?a+=`
`:t===102?a+="\f":t===114?a+="\r":t===101?a+="\x1B":t===34?a+='"':t===92?a+="\\":Ne.x("unrecognised escape sequence",n),o=n.p+1,l=0);else t!==32&&t!==9&&(l===2&&Ne.x("invalid escape: only line-ending whitespace may be escaped",n,o),l=!r&&t===92?1:0,o=n.p);Ne.x("unfinished string",n,e)}var Kb=/^(\d{4}-\d{2}-\d{2})?[Tt ]?(?:(\d{2}):\d{2}(?::\d{2}(?:\.\d+)?)?)?(Z|z|[-+]\d{2}:\d{2})?$/i,Sa=class n extends Date{#t=!1;#n=!1;#e=null;constructor(e,t,i){let r=!0,s=!0,a="Z",o;if(typeof e=="string")if(t)e:{if(t<3){if(+e.slice(11,13)>23){e="";break e}t===2?(a=null,e+="Z"):(o=e.charCodeAt(e.length-1))!==90&&o!==122&&(a=e.slice(e.length-6)),i&&(e=e.slice(0,10)+"T"+e.slice(11))}else t===4&&(e=+e.slice(0,2)>23?"":`0000-01-01T${e}Z`);r=t!==4,s=t!==3}else{let l=e.match(Kb);l?(l[1]||(r=!1,e=`0000-01-01T${e}`),s=!!l[2],s&&e[10]===" "&&(e=e.replace(" ","T")),l[2]&&+l[2]>23?e="":(a=l[3]||null,!a&&s&&(e+="Z"))):e=""}super(e),isNaN(this.getTime())||(this.#t=r,this.#n=s,this.#e=a)}isDateTime(){return this.#t&&this.#n}isLocal(){return!this.#t||!this.#n||!this.#e}isDate(){return this.#t&&!this.#n}isTime(){return this.#n&&!this.#t}isValid(){return this.#t||this.#n}toISOString(){let e=super.toISOString();if(this.isDate())return e.slice(0,10);if(this.isTime())return e.slice(11,23);if(this.#e===null)return e.slice(0,-1);if(this.#e==="Z"||this.#e==="z")return e;let t=+this.#e.slice(1,3)*60+ +this.#e.slice(4,6);return t=this.#e[0]==="-"?t:-t,new Date(this.getTime()-t*6e4).toISOString().slice(0,-1)+this.#e}static wrapAsOffsetDateTime(e,t="Z"){let i=new n(e);return i.#e=t,i}static wrapAsLocalDateTime(e){let t=new n(e);return t.#e=null,t}static wrapAsLocalDate(e){let t=new n(e);return t.#n=!1,t.#e=null,t}static wrapAsLocalTime(e){let t=new n(e);return t.#t=!1,t.#e=null,t}};function gn(n,e=10){return e===16?n>47&&n<58||n>64&&n<71||n>96&&n<103:n>47&&n<48+e}function Eu(n,e){return n===32||n===9||n===10||n===13||e&&(n===e||n===44)||n===35}function wa(n,e){let t=n.p,i=n.s.charCodeAt(n.p);if(i===91||i===123){n.d--||Ne.x("document contains excessively nested structures. aborting.",n);let r=i===91?bm(n):gm(n);return n.d++,r}return i===34||i===39?Xo(n):i===116?((n.s.charCodeAt(++n.p)!==114||n.s.charCodeAt(++n.p)!==117||n.s.charCodeAt(++n.p)!==101)&&Ne.x("invalid value",n,t),n.p++,!0):i===102?((n.s.charCodeAt(++n.p)!==97||n.s.charCodeAt(++n.p)!==108||n.s.charCodeAt(++n.p)!==115||n.s.charCodeAt(++n.p)!==101)&&Ne.x("invalid value",n,t),n.p++,!1):i===43||i===45?Yo(n,n.p,n.s.charCodeAt(++n.p),44-i,e):n.s.charCodeAt(n.p+4)===45&&n.s.charCodeAt(n.p+7)===45?Qb(n,i,e):n.s.charCodeAt(n.p+2)===58?ey(n,i,e):Yo(n,n.p,i,0,e)}function Yo(n,e,t,i,r){let s=t,a=0,o=!1;if(s===105)return(n.s.charCodeAt(++n.p)!==110||n.s.charCodeAt(++n.p)!==102)&&Ne.x("invalid value",n,e),n.p++,(i||1)/0;if(s===110)return(n.s.charCodeAt(++n.p)!==97||n.s.charCodeAt(++n.p)!==110)&&Ne.x("invalid value",n,e),n.p++,NaN;if(s===48){if(++n.p>=n.s.length||Eu(s=n.s.charCodeAt(n.p),r))return n.bi===!0?0n:0;if(!i){if(s===120)return Au(n,e,16,r);if(s===98)return Au(n,e,2,r);if(s===111)return Au(n,e,8,r)}s===46?a=2:s===101||s===69?a=4:Ne.x("illegal leading zero",n,e)}else gn(s)||Ne.x("invalid value",n,e);for(;++n.p<n.s.length&&(s=n.s.charCodeAt(n.p),!Eu(s,r));)a||(a=1),s===95?(a&1||Ne.x("illegal underscore",n),a+=11,o=!0):a===1&&s===46?a=2:(a===1||a===3)&&(s===101||s===69)?a=4:a===4&&(s===43||s===45)?a=6:gn(s)?a>9?a-=11:a&1||a++:Ne.x("illegal character in numeric literal",n);if(!a){let c=(t-48)*(i||1);return n.bi===!0?BigInt(c):c}a&1||Ne.x("unfinished numeric value",n,e);let l=n.s.slice(e,n.p);return o&&(l=l.replaceAll("_","")),a>1?parseFloat(l):mm(n,l,10,e)}function Au(n,e,t,i){let r,s=1;for(;++n.p<n.s.length&&(r=n.s.charCodeAt(n.p),!Eu(r,i));)r===95?(s&1&&Ne.x("illegal underscore",n),s=3):gn(r,t)?s&1&&s--:Ne.x("illegal character in numeric literal",n);s&1&&Ne.x("unfinished numeric value",n);let a=n.s.slice(e+2,n.p);return s&&(a=a.replaceAll("_","")),mm(n,a,t,e)}function mm(n,e,t,i){if(n.bi!==!0)e:{let r=parseInt(e,t);if(!Number.isSafeInteger(r)){if(n.bi)break e;Ne.x("integer value cannot be represented losslessly",n,i)}return r}return BigInt(t===10?e:(t===2?"0b":t===8?"0o":"0x")+e)}function Qb(n,e,t){let i=n.p++,r;if(!gn(e)||!gn(n.s.charCodeAt(n.p++))||!gn(n.s.charCodeAt(n.p++))||!gn(n.s.charCodeAt(n.p++)))return Yo(n,n.p=i,e,0,t);if(n.p+=5,gn(n.s.charCodeAt(n.p++))||Ne.x("invalid date-time: date part is malformed",n,i),n.p>=n.s.length||((e=n.s.charCodeAt(n.p))!==32||(r=!0,!gn(n.s.charCodeAt(n.p+1))))&&e!==84&&e!==116){let a=n.s.slice(i,n.p);return Ma(n,a,3,!1,i)}if(n.s.charCodeAt(n.p+=3)!==58&&Ne.x("invalid date-time: time part is malformed",n,i),n.s.charCodeAt(n.p+=3)===58&&(n.p+=3),n.s.charCodeAt(n.p)===46)for(;gn(n.s.charCodeAt(++n.p)););if(e=n.s.charCodeAt(n.p)){if(e===90||e===122){let a=n.s.slice(i,++n.p);return Ma(n,a,1,r,i,"[+00:00]")}if(e===43||e===45){let a=n.s.slice(i,n.p+=6);return Ma(n,a,1,r,i,!n.ld&&"["+n.s.slice(n.p-6,n.p)+"]")}}let s=n.s.slice(i,n.p);return Ma(n,s,2,r,i)}function ey(n,e,t){let i=n.p;if(!gn(e)||!gn(n.s.charCodeAt(++n.p)))return Yo(n,--n.p,e,0,t);if(n.s.charCodeAt(n.p+=4)===58&&(n.p+=3),n.s.charCodeAt(n.p)===46)for(;gn(n.s.charCodeAt(++n.p)););let r=n.s.slice(i,n.p);return Ma(n,r,4,!1,i)}function Ma(n,e,t,i,r,s){if(n.ld){let a=new Sa(e,t,i);return a.isValid()||Ne.x("invalid date",n,r),a}try{switch(s&&(e+=s),t){case 1:return Temporal.ZonedDateTime.from(e);case 2:return Temporal.PlainDateTime.from(e);case 3:return Temporal.PlainDate.from(e);case 4:return Temporal.PlainTime.from(e)}}catch(a){Ne.x(a instanceof Error?a.message:""+a,n,r)}}function ty(n){for(;n.p<n.s.length;n.p++){let e=n.s.charCodeAt(n.p);if(e===10)break;if(e===13&&n.s.charCodeAt(n.p+1)===10){n.p++;break}(e<32&&e!==9||e===127)&&Ne.x("control characters are not allowed in comments",n)}}function Yn(n,e,t){let i;for(;n.p<n.s.length;){for(;n.p<n.s.length&&((i=n.s.charCodeAt(n.p))===32||i===9||!e&&(i===10||i===13&&n.s.charCodeAt(n.p+1)===10));)n.p++;if(t||i!==35)break;ty(n)}}function Jo(n,e=61){let t,i=0,r=[],s,a=n.s.charCodeAt(t=n.p);do{if(a===e)return i||Ne.x("unexpected end of key",n),i===1&&r.push(n.s.slice(s,n.p)),n.p++,r;a===46?(i||Ne.x("illegal empty bare key",n),i===1&&r.push(n.s.slice(s,n.p)),i=0):!i&&(a===34||a===39)?(a===n.s.charCodeAt(n.p+1)&&a===n.s.charCodeAt(n.p+2)&&Ne.x("illegal quoted key: multiline strings are not allowed",n),r.push(Xo(n)),i=2,n.p--):a===32||a===9?i===1&&(r.push(n.s.slice(s,n.p)),i=2):i===2||a<48&&a!==45||a>57&&a<65||a>90&&a<97&&a!==95||a>122?Ne.x("illegal character in key",n):i||(i=1,s=n.p)}while(a=n.s.charCodeAt(++n.p));Ne.x("incomplete key-value: cannot find end of key",n,t)}function gm(n){let e=n.p++,t=Object.create(null),i=new Set,r;for(;n.p<n.s.length;){if(Yn(n),(r=n.s.charCodeAt(n.p))===125)return n.p++,t;let s,a=t,o=!1,l=n.p,c=Jo(n);for(let d=0;d<c.length;d++){d&&(a=o?a[s]:a[s]=Object.create(null)),s=c[d],(o=Object.hasOwn(a,s))&&(typeof a[s]!="object"||i.has(a[s]))&&Ne.x("trying to redefine an already defined value",n,l);let u=s==="__proto__";if(n.uk&&(u||s==="constructor")){a=n.uk!==1&&Ne.x("document contains an unsafe property",n,l);break}!o&&u&&Object.defineProperty(a,s,{enumerable:!0,configurable:!0,writable:!0})}o&&Ne.x("trying to redefine an already defined value",n,l),Yn(n,!0,!0);let h=wa(n,125);if(a&&typeof(a[s]=h)=="object"&&i.add(h),Yn(n),(r=n.s.charCodeAt(n.p++))===125)return t;r!==44&&Ne.x("expected comma or end of structure",n,n.p-1)}Ne.x("unfinished table",n,e)}function bm(n){let e=n.p++,t=[],i;for(;n.p<n.s.length;){if(Yn(n),(i=n.s.charCodeAt(n.p))===93)return n.p++,t;if(t.push(wa(n,93)),Yn(n),(i=n.s.charCodeAt(n.p++))===93)return t;i!==44&&Ne.x("expected comma or end of structure",n,n.p-1)}Ne.x("unfinished array",n,e)}function ym(n,e,t,i,r){let s=t,a=i,o,l=!1,c;for(let h=0;h<e.length;h++){if(h){if(s=l?s[o]:s[o]=Object.create(null),a=(c=a[o]).c,r===0&&(c.t===1||c.t===2))return null;if(c.t===2){let d=s.length-1;s=s[d],a=a[d].c}}if(o=e[h],(l=Object.hasOwn(s,o))&&a[o]?.t===0&&a[o]?.d)return null;if(!l){let d=o==="__proto__";if(n.uk&&(d||o==="constructor"))return!1;d&&(Object.defineProperty(s,o,{enumerable:!0,configurable:!0,writable:!0}),Object.defineProperty(a,o,{enumerable:!0,configurable:!0,writable:!0})),a[o]={t:h<e.length-1&&r===2?3:r,d:!1,i:0,c:Object.create(null)}}}if(c=a[o],c.t!==r&&!(r===1&&c.t===3)||(r===2&&(c.d||(c.d=!0,s[o]=[]),s[o].push(s=Object.create(null)),c.c[c.i++]=c={t:1,d:!1,i:0,c:Object.create(null)}),c.d))return null;if(c.d=!0,r===1)s=l?s[o]:s[o]=Object.create(null);else if(r===0&&l)return null;return[o,s,c.c]}function vm(n,e,t){(e===null||n.uk===2)&&Ne.x(e===null?"trying to redefine an already defined table or value":"document contains an unsafe property",n,t)}function Tu(n,e={}){let t={s:n,p:0,d:e.maxDepth??1e3,bi:e.integersAsBigInt??!1,ld:e.useLegacyDate??!0,uk:e.unsafeKeyBehaviour==="throw"?2:e.unsafeKeyBehaviour==="drop"?1:0},i=Object.create(null),r=Object.create(null),s,a=!1,o=i,l=r;for(n.charCodeAt(0)===65279&&t.p++,Yn(t);t.p<n.length;){if(n.charCodeAt(t.p)===91){let c=n.charCodeAt(++t.p)===91;s=t.p+=+c,a=!1;let h=Jo(t,93);c&&(n.charCodeAt(t.p)!==93&&Ne.x("expected end of table array declaration",t),t.p++);let d=ym(t,h,i,r,c?2:1);d?(l=d[2],o=d[1]):(vm(t,d,s),a=!0)}else{s=t.p;let c=Jo(t),h=ym(t,c,o,l,0);!h&&!a&&vm(t,h,s),Yn(t,!0,!0);let d=wa(t,void 0);h&&!a&&(h[1][h[0]]=d)}Yn(t,!0),t.p<n.length&&(s=n.charCodeAt(t.p))!==10&&(s!==13||n.charCodeAt(t.p+1)!==10)&&Ne.x("each key-value declaration must be followed by an end-of-line",t),Yn(t)}return i}var FE=!!"".isWellFormed;function _m(n){let e=[],t=!1,i=!1,r=0,s=o=>(o.lastIndex=r,o.exec(n)?.[0]??""),a=(o,l=r)=>{let c=n.slice(0,l).split(`
`);return{what:o,line:c.length,column:c.at(-1).length+1}};for(;r<n.length;){let o=n[r],l=e.at(-1)==="table";if(o==='"'||o==="'"){let c=s(ny),h=o==='"'?/^(?:[^\\]|\\[^ex])*?\\([ex])/.exec(c):null;if(h)return a(`unknown escape sequence \\${h[1]}`,r+h[0].length-2);r+=c.length||1,t=i=!1}else if(o==="#")r+=s(/[^\n]*/y).length;else if(o===`
`){if(l)return a("a line break in an inline table");e.length||(t=!1),r++}else if(o==="["||o==="{")e.push(o==="{"?"table":t?"list":"header"),t=e.at(-1)==="list",i=!1,r++;else if(o==="]"||o==="}"){if(i&&l)return a("a comma at the end of an inline table");e.pop(),t=i=!1,r++}else if(o===","||o==="=")t=o==="="||e.at(-1)==="list",i=o===",",r++;else if(/\s/.test(o))r++;else{let c=t?s(iy):"",h=c||s(/[^\s,=\]}#]+/y);if(c&&!ry(c))return a(`the date or time ${c} does not exist or lacks its seconds`);r+=h.length,t=i=!1}}return null}var ny=/"""(?:[^\\]|\\.)*?"{3,5}|'''.*?'{3,5}|"(?:[^"\\]|\\.)*"|'[^']*'/sy,iy=/\d{4}-\d\d-\d\d(?:[Tt ]\d[\d:.]*(?:[Zz]|[+-]\d\d:\d\d)?)?|\d\d:[\d:.]*/y,xm=/^([01]\d|2[0-3]):[0-5]\d:[0-5]\d(?:\.\d+)?(?:[Zz]|[+-]([01]\d|2[0-3]):[0-5]\d)?$/;function ry(n){if(n[2]===":")return xm.test(n);let[e,t,i]=n.slice(0,10).split("-").map(Number),r=new Date(0);return r.setUTCFullYear(e,t-1,i),e>0&&r.getUTCMonth()===t-1&&r.getUTCDate()===i&&(n.length===10||xm.test(n.slice(11)))}var sy=20,hn=n=>Ru(cn(n));function Ru(n){let e=[],t=o=>{for(let[l,c]of Object.entries(o))c!=null&&e.push(`${l} = ${jo(c)}`)},{patch:i,join:r,...s}=n,a=({bases:o,...l},c="")=>{t(l);for(let[h,d]of Object.entries(o??{}))e.push("",`[${c}bases.${Sm(h)}]`),t(d)};a(s);for(let[o,l]of Object.entries({patch:i,join:r}))for(let c of l??[])e.push("",`[[${o}]]`),a(c,`${o}.`);return`${e.join(`
`)}
`}var Sm=n=>/^[\w-]+$/.test(n)?n:JSON.stringify(n);function jo(n,e=""){return typeof n=="object"&&n!==null&&!Array.isArray(n)?`{ ${Object.entries(n).map(([i,r])=>`${Sm(i)} = ${jo(r)}`).join(", ")} }`:Array.isArray(n)?n.every(i=>!Array.isArray(i))&&!n.some(i=>typeof i=="string"&&i.length>12)?`[${n.map(i=>jo(i)).join(", ")}]`:`[
${n.map(i=>`${e}    ${jo(i,`${e}    `)},
`).join("")}${e}]`:typeof n=="string"?JSON.stringify(n):String(n)}function bs(n){try{let e=n.replace(/^\uFEFF/,""),{...t}=Tu(e,{integersAsBigInt:"asNeeded",maxDepth:sy}),i=_m(e);if(i)throw new Ze(`not valid TOML: ${i.what} (at line ${i.line}, column ${i.column})`);return Cu(t)}catch(e){if(!(e instanceof Ne))throw e;let[t]=e.message.replace(/^Invalid TOML document: /,"").split(`
`);throw new Ze(`not valid TOML: ${t} (at line ${e.line}, column ${e.column})`)}}function Cu(n){return typeof n=="bigint"?Number(n):Array.isArray(n)?n.map(Cu):typeof n!="object"||n===null||n instanceof Date?n:Object.fromEntries(Object.entries(n).map(([e,t])=>[e,Cu(t)]))}function T(n,e={},...t){let i=document.createElement(n);for(let[r,s]of Object.entries(e))if(r==="on")for(let[a,o]of Object.entries(s))i.addEventListener(a,o);else r==="class"?i.className=String(s):r.startsWith("aria-")&&typeof s=="boolean"?i.setAttribute(r,String(s)):s===!0?i.setAttribute(r,""):s!==!1&&s!==null&&s!==void 0&&i.setAttribute(r,String(s));return i.append(...t.filter(r=>r!=null&&r!==!1).map(r=>typeof r=="number"?String(r):r)),i}var Mm="http://www.w3.org/2000/svg";function xt(n){let e=document.createElementNS(Mm,"svg");e.setAttribute("viewBox","0 0 16 16"),e.setAttribute("class","icon"),e.setAttribute("aria-hidden","true");let t=document.createElementNS(Mm,"path");return t.setAttribute("d",n),e.append(t),e}var Mt={undo:"M3 6h7a3.5 3.5 0 0 1 0 7H6M3 6l3-3M3 6l3 3",redo:"M13 6H6a3.5 3.5 0 0 0 0 7h4M13 6l-3-3M13 6l-3 3",open:"M2 4.5h4l1.5 1.5H14v7H2zM2 8h12",save:"M3 3h8l2 2v8H3zM5.5 3v3.5h4V3M5 13V9h6v4",picture:"M2 4h3l1-1.5h4L11 4h3v9H2zM8 6.2a2.4 2.4 0 1 0 0 4.8 2.4 2.4 0 0 0 0-4.8z",export:"M8 10V2.5M5 5l3-3 3 3M3 9v4.5h10V9",sun:"M8 5.2a2.8 2.8 0 1 0 0 5.6 2.8 2.8 0 0 0 0-5.6zM8 1v1.6M8 13.4V15M1 8h1.6M13.4 8H15M3 3l1.2 1.2M11.8 11.8 13 13M13 3l-1.2 1.2M4.2 11.8 3 13",moon:"M13 9.5A5.5 5.5 0 1 1 6.5 3 4.4 4.4 0 0 0 13 9.5z",help:"M8 2a6 6 0 1 0 0 12A6 6 0 0 0 8 2zM6.2 6.2a1.9 1.9 0 1 1 2.6 1.8c-.6.3-.8.6-.8 1.2M8 11.2v.3",down:"M4.5 6.5 8 10l3.5-3.5",fit:"M2.5 6V2.5H6M10 2.5h3.5V6M13.5 10v3.5H10M6 13.5H2.5V10",pin:"M8 14V9.5M5 9.5h6L9.8 7V3.5H11v-1H5v1h1.2V7z",close:"M4 4l8 8M12 4l-8 8",flip:"M8 2v12M5 5 2 8l3 3M11 5l3 3-3 3",wire:"M2 12 6 3l8 2-3 9zM4 7.5l8.6 2M9.5 4 6.5 13",side:"M2.5 3h11v10h-11zM6 3v10"},Pu=n=>n.value.trim()===""?NaN:Number(n.value.replace(",","."));function Jn(n,e,t="text/plain"){let i=typeof e=="string"?new Blob([e],{type:t}):e,r=T("a",{href:URL.createObjectURL(i),download:n});r.click(),setTimeout(()=>URL.revokeObjectURL(r.href),1e4)}var jn=n=>n.normalize("NFKD").replace(/[^\w-]+/g,"_").replace(/^_+|_+$/g,"").toLowerCase()||"surface";var Aa=class extends Error{},zr=class extends Error{constructor(t){super(`${t?"The studio's server has stopped: it does not answer.":"The studio's server was started anew, and does not know this tab."} Your work is still here, and unsaved changes are kept in this browser.`);this.stopped=t}stopped},ys=class{constructor(e,t){this.kind=e;this.place=t}kind;place;list(){return Promise.resolve([])}load(e){return Promise.reject(new Ze(`${e}: a page from disk has no folder to open files from`))}read(e,t){return new Promise(i=>i(ay(e,t)))}save(e,t){return Jn(`${jn(e.replace(/\.(toml|json)$/i,""))}.toml`,hn(t)),Promise.resolve(null)}formats(){return Promise.resolve([])}export(){return Promise.reject(new Error("exports need the live studio: quintrig view MODEL"))}},vs=class{constructor(e){this.place=e}place;kind="live";async list(){return(await this.ask("GET","api/files")).files}async load(e){return Iu(await this.ask("GET",`api/files/${encodeURIComponent(e)}`))}async read(e,t){let i=await this.ask("POST","api/check",JSON.stringify({name:e,text:t}));return vt(i.model)}async save(e,t,i){let r=JSON.stringify({text:hn(t),tag:i});return await this.ask("PUT",`api/files/${encodeURIComponent(e)}`,r)}async formats(e,t){return(await this.ask("POST","api/formats",JSON.stringify({text:hn(e),patch:t}))).formats}async export({model:e,...t},{suffix:i}){let r=JSON.stringify({text:hn(e),suffix:i,...t}),{name:s,notes:a,content:o}=await this.ask("POST","api/export",r);return Jn(s,new Blob([Uint8Array.from(atob(o),l=>l.charCodeAt(0))])),{name:s,notes:a}}async targets(){return(await this.ask("GET","api/targets")).targets}async beside(e,{target:t,align:i,tolerance:r},s){let a=JSON.stringify({text:hn(e),target:t,align:i?"yes":"",tolerance:r,most:s}),{places:o,distances:l,...c}=await this.ask("POST","api/deviation",a);return{...c,places:wm(o),distances:wm(l)}}async lights(e,t,{demands:i,target:r}){return(await this.ask("POST","api/demands",JSON.stringify({text:hn(e),patch:t,demands:i,target:r}))).lights}async fairer(e,t,i){let r=await this.ask("POST","api/fair",JSON.stringify({text:hn(e),patch:t,only:i}));return{...r,model:vt(r.model)}}async build(e){return(await this.ask("POST","api/build",JSON.stringify({patches:JSON.stringify(e)}))).built}async ask(e,t,i){return(await this.send(e,t,i)).json()}async send(e,t,i){let r;try{r=await fetch(t,{method:e,body:i??null,...i?{headers:{"Content-Type":"application/json"}}:{}})}catch{throw new zr(!0)}if(r.ok)return r;let s=await r.json().catch(()=>null);if(r.status===403&&!s)throw new zr(!1);let a=s?.error??`the server answered ${r.status}`;throw r.status===409?new Aa(a):r.status===422?new Ze(a):new Error(a)}},wm=n=>new Float64Array(Uint8Array.from(atob(n),e=>e.charCodeAt(0)).buffer);function Iu(n){let{model:e,name:t,tag:i}=n;return{model:vt(e),source:t?{name:t,tag:i}:null}}function ay(n,e){try{if(/\.toml$/i.test(n))return vt(bs(e));if(!/\.json$/i.test(n))throw new Ze("expected a file ending in .toml or .json");let t;try{t=JSON.parse(e)}catch(i){throw new Ze(`not valid JSON: ${i.message}`)}return vt(t)}catch(t){throw new Ze(`${n}: ${t.message}`)}}var xs=Be.limits;function Zo(n,e,t,i,r){if(!(Math.abs(t)<1e300))return 0;if(t<=r)return 5;let s=Math.abs(n)<=i*t*t?0:n>0?1:-1;return 1+3*(1+(Math.abs(e)<=i*t?0:e>0?1:-1))+(1-s)}function Nu(n,e,t,i){if(n===0)return 0;if(n===5)return 4;let r=(n-1)%3;return r===0?e<=i*t?5:1:r===1?3:2}function Lu(n,e){if(e===0)return 0;if(e===5)return 10;let t=1;for(let i of Be.shapeBreaks)n>=-i&&t++,n>i&&t++;return t}function Am(n,e,t){let i=.5*(n-t);return Math.sqrt(i*i+e*e)}function Em(n,e,t,i){return t>i?-2/Math.PI*Math.atan2(n,e):NaN}var Or=1,kr=0;function Ko(n,e,t,i){let r=.5*(n-t),s=r>=0?i+r:e,a=r>=0?e:i-r,o=Math.sqrt(s*s+a*a);Or=s/o,kr=a/o}var oy=Be.limits.vertical;function Tm(n,e,t,i,r,s,a){a[0]=n*i*i+2*e*i*r+t*r*r,a[1]=s*((t-n)*i*r+e*(i*i-r*r)),a[2]=n*r*r-2*e*i*r+t*i*i}function Cm(n,e,t,i,r,s){let a=1/(Math.abs(r)>oy?r:0),o=a*a,l=o*a;s[0]=e*o,s[1]=(n[0]+2*t*r*r)*l,s[2]=i*o*o,s[3]=n[0]*l*o,s[4]=n[1]*o*o,s[5]=n[2]*l}function Rm(n,e,t,i,r,s){s[0]=e,s[1]=2*r*t,s[2]=r*r*i,s[3]=r*n[0],s[4]=Math.abs(r)*n[1],s[5]=r*n[2]}var pi=Be.quantities,lt=Object.fromEntries(pi.map(n=>[n.key,n])),Qo=(n,e)=>Be.words[n]?.[e]??"";function el(n,e){if(!e||n.power===0)return"";let t=e+["","","²","³"][Math.abs(n.power)];return n.power>0?t:`1/${t}`}function _s({trim:n=[]},e,t){return!n.length||Pm(n,e).filter(i=>i>t).length%2===1||cy(n,e,t)}function tl({trim:n=[]},e,t){let i=t.length,r=new Uint8Array(e.length*i).fill(n.length?0:1);if(!n.length)return r;for(let s=0;s<e.length;s++){let a=Pm(n,e[s]).sort((o,l)=>o-l);for(let o=0,l=0;o<i;o++){for(;l<a.length&&a[l]<=t[o];)l++;r[s*i+o]=l%2}}return r}function Ki({trim:n=[]}){if(!n.length)return[0,0,1,1];let e=[1,1],t=[0,0];for(let i of n.flat())for(let r of[0,1])e[r]=Math.min(e[r],i[r]),t[r]=Math.max(t[r],i[r]);return[e[0],e[1],t[0],t[1]]}function Pm(n,e){let t=[];for(let i of n){let[r,s]=i.at(-1);for(let a of i){let[o,l]=a;r>e!=o>e&&t.push(s+(e-r)/(o-r)*(l-s)),[r,s]=[o,l]}}return t}var ly=1e-9;function cy(n,e,t){return n.some(i=>i.some(([r,s],a)=>{let[o,l]=i.at(a-1),c=r-o,h=s-l,d=Math.hypot(c,h),u=(e-o)*c+(t-l)*h,p=(e-o)*h-(t-l)*c;return d>0&&Math.abs(p)<=ly*d&&u>=0&&u<=d*d}))}var hy=Be.limits.singular,Du=Be.limits.noise,Oe={a:0,b:1,c:2,normal:3,e1:6,e2:9,point:12,forms:15,mean:21,halfDifference:22,gaussian:23,curvedness:24},uy=25,Ms=class{nu=0;nv=0;count=0;size=0;sign=1;stride=0;planes=new Float64Array(0);low=[0,0,0];high=[0,0,0];u=new Float64Array(0);v=new Float64Array(0);rows=new Float64Array(0);blend=new Float64Array(0);origin=[0,0,0];partials=new Float64Array(18);evaluate(e,t,i){let[r,s,a,o]=Ki(e);this.u=Lm(t,r,a),this.v=Lm(i,s,o),this.evaluateAt(e,this.u,this.v,!0)}evaluateAt(e,t,i,r){let s=di(e);this.low=s.low,this.high=s.high,this.size=s.size,this.sign=e.flip?-1:1,this.nu=r?t.length:1,this.nv=i.length,this.count=this.nu*this.nv,this.origin=e.origin??[0,0,0];let a=e.rows.size,o=e.rows.dimension;this.rows.length<3*t.length*a*o&&(this.rows=new Float64Array(3*t.length*a*o)),this.blend.length<3*i.length*a&&(this.blend=new Float64Array(3*i.length*a)),this.stride<this.count&&(this.stride=this.count,this.planes=new Float64Array(uy*this.stride)),e.rows.derivatives(t,t.length,this.rows),e.blend.derivatives(i,i.length,this.blend);let l=this.size>0?hy*this.size*this.size:1/0;o===4?this.driveRational(a,t.length,i.length,r,l):this.drive(a,t.length,i.length,r,l)}quantity(e,t,i){fy(this,e,t,i)}drive(e,t,i,r,s){let{rows:a,blend:o,partials:l}=this,c=3*e*t,h=e*i;for(let d=0;d<this.count;d++){let u=r?d/i|0:d,p=r?d-u*i:d,f=0,b=0,m=0,g=0,y=0,_=0,x=0,E=0,w=0,v=0,A=0,L=0,R=0,N=0,z=0,H=0,P=0,W=0;for(let B=0,O=3*e*u,Q=e*p;B<e;B++,O+=3,Q++){let G=o[Q],Y=o[Q+h],ee=o[Q+2*h],ye=a[O],Ee=a[O+1],$=a[O+2],ne=a[O+c],he=a[O+c+1],xe=a[O+c+2];f+=ye*G,b+=Ee*G,m+=$*G,g+=ne*G,y+=he*G,_+=xe*G,x+=ye*Y,E+=Ee*Y,w+=$*Y,v+=a[O+2*c]*G,A+=a[O+2*c+1]*G,L+=a[O+2*c+2]*G,R+=ne*Y,N+=he*Y,z+=xe*Y,H+=ye*ee,P+=Ee*ee,W+=$*ee}l[0]=f,l[1]=b,l[2]=m,l[3]=g,l[4]=y,l[5]=_,l[6]=x,l[7]=E,l[8]=w,l[9]=v,l[10]=A,l[11]=L,l[12]=R,l[13]=N,l[14]=z,l[15]=H,l[16]=P,l[17]=W,this.reduce(d,s)}}driveRational(e,t,i,r,s){let{rows:a,blend:o,partials:l}=this,c=4*e*t,h=e*i,d=new Float64Array(24);for(let u=0;u<this.count;u++){let p=r?u/i|0:u,f=r?u-p*i:u;d.fill(0);for(let E=0,w=4*e*p,v=e*f;E<e;E++,w+=4,v++){let A=o[v],L=o[v+h],R=o[v+2*h];for(let N=0;N<4;N++){let z=a[w+N],H=a[w+c+N];d[N]+=z*A,d[4+N]+=H*A,d[8+N]+=z*L,d[12+N]+=a[w+2*c+N]*A,d[16+N]+=H*L,d[20+N]+=z*R}}let b=d[3],m=d[7],g=d[11],y=d[15],_=d[19],x=d[23];for(let E=0;E<3;E++){let w=d[E]/b,v=(d[4+E]-m*w)/b,A=(d[8+E]-g*w)/b;l[E]=w,l[3+E]=v,l[6+E]=A,l[9+E]=(d[12+E]-2*m*v-y*w)/b,l[12+E]=(d[16+E]-m*A-g*v-_*w)/b,l[15+E]=(d[20+E]-2*g*A-x*w)/b}this.reduce(u,s)}}reduce(e,t){let i=this.partials,r=i[0],s=i[1],a=i[2],o=i[3],l=i[4],c=i[5],h=i[6],d=i[7],u=i[8],p=i[9],f=i[10],b=i[11],m=i[12],g=i[13],y=i[14],_=i[15],x=i[16],E=i[17],w=this.planes,v=this.stride,A=this.sign,L=o*o+l*l+c*c,R=o*h+l*d+c*u,N=h*h+d*d+u*u,z=l*u-c*d,H=c*h-o*u,P=o*d-l*h,W=Math.sqrt(z*z+H*H+P*P),B=W>t?1/W:NaN,O=A*B,Q=z*O,G=H*O,Y=P*O,ee=p*Q+f*G+b*Y,ye=m*Q+g*G+y*Y,Ee=_*Q+x*G+E*Y,$=R/L,ne=ee/L,he=(ye-$*ee)*B,xe=(Ee-2*$*ye+$*$*ee)*(L*B)*B,ue=.5*(ne+xe),Fe=Am(ne,he,xe),ft=1/Math.sqrt(L),Pe=o*ft,tt=l*ft,rt=c*ft;w[e]=ne,w[v+e]=he,w[2*v+e]=xe,w[3*v+e]=Q,w[4*v+e]=G,w[5*v+e]=Y,w[6*v+e]=Pe,w[7*v+e]=tt,w[8*v+e]=rt,w[9*v+e]=A*(G*rt-Y*tt),w[10*v+e]=A*(Y*Pe-Q*rt),w[11*v+e]=A*(Q*tt-G*Pe),w[12*v+e]=r+this.origin[0],w[13*v+e]=s+this.origin[1],w[14*v+e]=a+this.origin[2],w[15*v+e]=L,w[16*v+e]=R,w[17*v+e]=N,w[18*v+e]=ee,w[19*v+e]=ye,w[20*v+e]=Ee,w[21*v+e]=ue,w[22*v+e]=Fe,w[23*v+e]=ne*xe-he*he,w[24*v+e]=Math.sqrt(ue*ue+Fe*Fe)}},dy=["E","F","G","L","M","N"],py=["beta0","beta1","beta2","gamma1","gamma2","gamma3"],Fu=new Float64Array(3),Ss=new Float64Array(6);function fy(n,e,t,i){let{planes:r,stride:s,count:a}=n,o=(f,b=1)=>{for(let m=0;m<b;m++)for(let g=0,y=(f+m)*s;g<a;g++,y++)t[b*g+m]=r[y]},l=n.size>0?1/n.size:1/0,c=i.flat*l,h=i.relative;switch(e){case"point":return o(Oe.point,3);case"normal":return o(Oe.normal,3);case"gaussian":return o(Oe.gaussian);case"mean":return o(Oe.mean);case"curvedness":return o(Oe.curvedness);case"k1":case"k2":{let f=e==="k1"?1:-1;for(let b=0;b<a;b++)t[b]=r[Oe.mean*s+b]+f*r[Oe.halfDifference*s+b];return}case"direction1":case"direction2":return my(n,e==="direction2",h,Du*l,t);case"shape_index":for(let f=0;f<a;f++)t[f]=Im(r,s,f,Du*l);return;case"hk_type":for(let f=0;f<a;f++)t[f]=zu(r,s,f,h,c);return;case"point_type":for(let f=0;f<a;f++){let b=zu(r,s,f,h,c);t[f]=Nu(b,r[Oe.halfDifference*s+f],r[Oe.curvedness*s+f],h)}return;case"shape_class":for(let f=0;f<a;f++)t[f]=Lu(Im(r,s,f,Du*l),zu(r,s,f,h,c));return;case"invariant_type":for(let f=0;f<a;f++){Nm(n,f,!0);let b=.5*Ss[1],m=2*b*b-Ss[2];t[f]=Zo(Ss[2],b,Math.sqrt(Math.max(m,0)),h,c)}return}let d=dy.indexOf(e);if(d>=0)return o(Oe.forms+d);let u=e.endsWith("_surface"),p=py.indexOf(u?e.slice(0,-8):e);if(p<0)throw new Error(`unknown quantity '${e}'; known are ${Object.keys(lt).join(", ")}`);for(let f=0;f<a;f++)Nm(n,f,!u),t[f]=Ss[p]}function zu(n,e,t,i,r){return Zo(n[Oe.gaussian*e+t],n[Oe.mean*e+t],n[Oe.curvedness*e+t],i,r)}function Im(n,e,t,i){return Em(n[Oe.mean*e+t],n[Oe.halfDifference*e+t],n[Oe.curvedness*e+t],i)}function Nm(n,e,t){let{planes:i,stride:r}=n,s=i[(Oe.e1+2)*r+e],a=i[(Oe.e2+2)*r+e],o=i[(Oe.normal+2)*r+e];Tm(i[e],i[r+e],i[2*r+e],s,a,n.sign,Fu);let l=s*s+a*a,c=i[Oe.mean*r+e],h=i[Oe.gaussian*r+e];t?Cm(Fu,l,c,h,o,Ss):Rm(Fu,l,c,h,o,Ss)}function my(n,e,t,i,r){let{planes:s,stride:a,count:o}=n;for(let l=0;l<o;l++){let c=s[Oe.halfDifference*a+l],h=s[Oe.curvedness*a+l],d=c>t*h&&h>i;Ko(s[l],s[a+l],s[2*a+l],c);for(let u=0;u<3;u++){let p=s[(Oe.e1+u)*a+l],f=s[(Oe.e2+u)*a+l],b=e?Or*f-kr*p:Or*p+kr*f;r[3*l+u]=d?b:NaN}}}var Lm=(n,e,t)=>Float64Array.from({length:n},(i,r)=>r===n-1?t:e+(t-e)*(r/(n-1)));function Zn(n,e,t,i=!1,r=pi.map(a=>a.key),s=xs){for(let o of[...Array.from(e),...Array.from(t)])if(!(o>=0&&o<=1))throw new Error(`parameter ${o} is outside the domain [0, 1]`);let a=new Ms;return a.evaluateAt(n,Float64Array.from(e),Float64Array.from(t),!i),Object.fromEntries(r.map(o=>{let l=new Float64Array(a.count*(lt[o]?.components??1));return a.quantity(o,l,s),[o,l]}))}function Fm(n,e,t,i){let r=Dm(n,e,t),s=Dm(n,e,i);return n.map((a,o)=>a+s[o]-r[o])}function nl(n,e,t,i){let r=Math.hypot(...e),s=e.map(l=>l/r),a=l=>{let c=n.map((u,p)=>u-l.origin[p]),h=Qi(s,l.direction),d=1-h*h;return d>1e-4?(h*Qi(c,l.direction)-Qi(c,s))/d:0},o=a(i)-a(t);return n.map((l,c)=>l+o*s[c])}function zm(n,{origin:e,direction:t},i){let r=Qi(e,t),s=r*r-Qi(e,e)+n*n,a=h=>e.map((d,u)=>d+h*t[u]);if(s<=0){let h=a(-r),d=Math.hypot(...h)||1;return h.map(u=>n*u/d)}let[o,l]=[a(-r-Math.sqrt(s)),a(-r+Math.sqrt(s))],c=h=>Math.hypot(...h.map((d,u)=>d-i[u]));return c(o)<=c(l)?o:l}function Dm(n,e,t){let i=Qi(e,n)-Qi(e,t.origin),r=Qi(e,t.direction),s=Math.abs(r)>1e-9?i/r:0;return t.origin.map((a,o)=>a+s*t.direction[o])}var Qi=(n,e)=>n[0]*e[0]+n[1]*e[1]+n[2]*e[2];var gy=.1,Ou=[[1,0,0],[0,1,0],[0,0,1]];function Om(n,e,t){let i=[0,1,2].filter(c=>n[c]);if(i.length===0)return null;if(i.length===1)return{line:Ou[i[0]]};let r=t.map(Math.abs),s=r.indexOf(Math.max(...r)),a=i.length===2?Ou[n.indexOf(!1)]:e??Ou[s];if(Math.abs(qm(a,t))>gy)return{normal:a};let o=Vm(a,t),l=Math.hypot(...o);return{line:o.map(c=>Math.abs(c)<1e-9*l?0:c/l)}}function km(n,e,t,i){return n===null?e:"line"in n?nl(e,n.line,t,i):Fm(e,n.normal,t,i)}function Um(n,e,t,i,r=!1){let s=u=>Math.round(u/i)*i;if(n===null)return[...e];if("line"in n){let u=n.line.map(Math.abs),p=u.indexOf(Math.max(...u)),f=n.line,b=(s(t[p])-e[p])/f[p];return e.map((m,g)=>g===p?s(t[g]):f[g]?m+b*f[g]:m)}let a=n.normal,o=a.map(Math.abs),l=o.indexOf(Math.max(...o)),c=[0,1,2].filter(u=>u!==l),h=[...e];for(let u of c)h[u]=s(t[u]);let d=c.reduce((u,p)=>u+a[p]*(h[p]-e[p]),0);return d!==0&&(h[l]=r?s(e[l]-d/a[l]):e[l]-d/a[l]),h}function Bm(n){let[e,...t]=n,i=t.map(c=>c.map((h,d)=>h-e[d])),r=Math.max(0,...i.map(c=>Math.hypot(...c))),s=i.find(c=>Math.hypot(...c)===r);if(!s||!(r>0))return;let a=i.map(c=>Vm(s,c)),o=Math.max(...a.map(c=>Math.hypot(...c))),l=a.find(c=>Math.hypot(...c)===o).map(c=>c/o);if(!(!(o>1e-9*r*r)||i.some(c=>Math.abs(qm(c,l))>1e-9*r)))return l.map(c=>Math.abs(c)<1e-12?0:c)}var qm=(n,e)=>n[0]*e[0]+n[1]*e[1]+n[2]*e[2],Vm=(n,e)=>[n[1]*e[2]-n[2]*e[1],n[2]*e[0]-n[0]*e[2],n[0]*e[1]-n[1]*e[0]];var Ur=[.11,.36,.66],Ea=[0,.47,.42],tr=[!0,!0,!0],$m=400,Hm=new WeakMap;function bn(n){let e=Hm.get(n);if(!e){try{e=Qe(n)?by(n):Uu(n,Xt(n))}catch{e=[]}Hm.set(n,e)}return e}function by(n){let e=Ae(n,"points"),t=e[0].length===2;return er("points",e.map(i=>[i[0],i[1],i[2]??0]),t?[!0,!0,!1]:tr,Ur).map((i,r)=>({...i,label:`point ${r}`}))}function Uu(n,e){let t=i=>Ae(n,i)??[];switch(n.kind){case"tensor":case"nurbs":return il(t("points"));case"symmetric":{let i=t("points"),r=Ae(n,"mirror"),s=il(i).map(a=>({...a,id:`${a.id}′`,label:`${a.label}′`,position:ms(a.position,r),mirrored:!0}));return[...il(i),...s]}case"swept":return[...er("section",t("section"),tr,Ur),...er("trajectory",t("trajectory"),tr,Ea)];case"ruled":return[...er("first",t("first"),tr,Ur),...er("second",t("second"),tr,Ea)];case"swung":return[...er("profile",t("profile").map(([i,r])=>[i,0,r]),[!0,!1,!0],Ur),...er("trajectory",t("trajectory").map(([i,r])=>[i,r,0]),[!0,!0,!1],Ea)];case"developable":return[...Wm("planes",t("planes"),e,i=>[i/5,.5],Ur),...Wm("bounds",t("bounds"),e,i=>[.5,i],Ea)];default:return yy(n).flatMap(([i,r],s)=>r===2?il(t(i),i):er(i,t(i),tr,s?Ea:Ur))}}var yy=n=>Object.entries(it[n.kind]?.fields??{}).flatMap(([e,t])=>t.type==="points"&&t.dimension===3?[[e,t.counts.length]]:[]);function rl(n,e,t){if(e.along){let s=Ae(n,e.key)[e.index[0]],a=-(s[0]*t[0]+s[1]*t[1]+s[2]*t[2]);return nr(n,e.key,e.index,[s[0],s[1],s[2],ku(a)])}let i=e.position.map((s,a)=>e.free[a]?t[a]:s);if(e.mirrored&&(i=ms(i,Ae(n,"mirror"))),Qe(n))return nr(n,e.key,e.index,i.slice(0,e.free[2]?3:2).map(ku));let r=n.kind!=="swung"?i:e.key==="profile"?[i[0],i[2]]:[i[0],i[1]];return nr(n,e.key,e.index,r.map(ku))}function nr(n,e,t,i){let r=(s,a)=>a.length?s.map((o,l)=>l===a[0]?r(o,a.slice(1)):o):i;return{...n,[e]:r(Ae(n,e),t)}}function Xm(n){let e=Ae(n,"points").map(t=>[t[0],t[1],t[2]??0]);return[Ae(n,"close")===!0?[...e,e[0]]:e]}function Ym(n,e){let t=a=>Ae(n,a);switch(n.kind){case"swept":return[t("section").slice(),t("trajectory").slice()];case"swung":return[t("profile").map(([a,o])=>[a,0,o]),t("trajectory").map(([a,o])=>[a,o,0])];case"ruled":return[t("first").slice(),t("second").slice()]}let i=e.net;if(!i||i.n*i.m>$m)return[];let r=(a,o)=>Array.from(i.values.subarray(3*(a*i.m+o),3*(a*i.m+o)+3)),s=a=>Array.from({length:a},(o,l)=>l);return[...s(i.n).map(a=>s(i.m).map(o=>r(a,o))),...s(i.m).map(a=>s(i.n).map(o=>r(o,a)))]}var ku=n=>Number(n.toPrecision(12))+0,Gm=n=>String(n).replace(/\d/g,e=>"₀₁₂₃₄₅₆₇₈₉"[Number(e)]);function il(n,e="points"){return n.length*(n[0]?.length??0)>$m?[]:n.flatMap((t,i)=>t.map((r,s)=>({id:`${e}[${i}][${s}]`,key:e,index:[i,s],label:`P${Gm(i)}${i>9||s>9?",":""}${Gm(s)}`,position:r,free:tr,tint:Ur})))}function er(n,e,t,i){let r=Bm(e);return e.map((s,a)=>({id:`${n}[${a}]`,key:n,index:[a],label:`${n} ${a}`,position:s,free:t,tint:i,...r&&{plane:r}}))}function Wm(n,e,t,i,r){return e.map((s,a)=>{let[o,l]=i(a),c=Array.from(Zn(t,[o],[l],!0,["point"]).point),[h,d,u,p]=s,f=(c[0]*h+c[1]*d+c[2]*u+p)/(h*h+d*d+u*u),b=[c[0]-f*h,c[1]-f*d,c[2]-f*u];return{id:`${n}[${a}]`,key:n,index:[a],label:`${n==="planes"?"plane":"bound"} ${a}`,position:b,free:tr,along:[h,d,u],tint:r}})}var sl=["u0","u1","v0","v1"],ws=17,Bu=.001,vy=[-25/12,4,-3,4/3,-1/4];function Jm(n,e,t){let{rows:i,blend:r,origin:s=[0,0,0]}=n,a=e.length,o=i.size,l=i.dimension,c=new Float64Array(3*a*o*l),h=new Float64Array(3*a*o);i.derivatives(e,a,c),r.derivatives(t,a,h);let d=(p,f,b,m)=>{let g=0;for(let y=0;y<o;y++)g+=c[((p*a+b)*o+y)*l+m]*h[(f*a+b)*o+y];return g},u=[[0,0],[1,0],[0,1],[2,0],[1,1],[0,2]];return Array.from(e,(p,f)=>{let b=new Float64Array(18),m=l===4?u.map(([g,y])=>d(g,y,f,3)):[1,0,0,0,0,0];for(let g=0;g<3;g++){let y=u.map(([w,v])=>d(w,v,f,g)),_=y[0]/m[0],x=(y[1]-m[1]*_)/m[0],E=(y[2]-m[2]*_)/m[0];b[g]=_+s[g],b[3+g]=x,b[6+g]=E,b[9+g]=(y[3]-2*m[1]*x-m[3]*_)/m[0],b[12+g]=(y[4]-m[1]*E-m[2]*x-m[4]*_)/m[0],b[15+g]=(y[5]-2*m[2]*E-m[5]*_)/m[0]}return b})}var jm=new WeakMap;function Zm(n){let e=jm.get(n);return e||jm.set(n,e=n.trim?.length?[]:xy(n)),e}function xy(n){let e=Float64Array.from({length:ws},(s,a)=>a/(ws-1)),t=sl.map(s=>As(n,s,e).map(a=>[a[0],a[1],a[2]])),{size:i}=di(n),r=t.map(s=>s.slice(1).reduce((a,o,l)=>a+Br(o,s[l]),0));return sl.flatMap((s,a)=>{let o=t[a],l=t[a^1],c=o.reduce((u,p,f)=>u+Br(p,l[f]),0)/ws||(r[a<2?2:0]+r[a<2?3:1])/2;if(!(r[a]>1e-9*i))return[];let h=[0,1,2].map(u=>Math.min(...o.map(p=>p[u]))),d=[0,1,2].map(u=>Math.max(...o.map(p=>p[u])));return[{surface:n,side:s,points:o,length:r[a],width:c,low:h,high:d}]})}function As(n,e,t,i=0){let r=new Float64Array(t.length).fill(e[1]==="0"?i:1-i);return e[0]==="u"?Jm(n,r,t):Jm(n,t,r)}function Vu({surface:n,side:e},t,i,r){let s=e[0]==="u",a=e[1]==="0"?1:-1,o=[0,1,2,3,4].map(h=>As(n,e,t,h*Bu)),l=t.map(h=>h<.5?1:-1),c=[0,1,2,3,4].map(h=>As(n,e,t.map((d,u)=>d+h*Bu*l[u])));return o[0].map((h,d)=>{let u=($,ne=h)=>[ne[3*$],ne[3*$+1],ne[3*$+2]],p=($,ne,he)=>qu(vy.map((xe,ue)=>[xe*he/Bu,u($,ne[ue][d])])),[f,b,m,g,y]=[u(1),u(2),u(3),u(4),u(5)],_=[3,4,5].map($=>p($,o,a)),x=p(s?5:3,c,l[d]),E=s?[_[0],_[1],_[2],x]:[x,_[0],_[1],_[2]],w=Ca(f,b),v=Math.hypot(...w),A=Ta(w,1/v),L=_y(Ta(s?b:f,r?-1:1)),R=Ca(A,L),N=Ta(R,Math.sign(yn(R,s?f:b))*a*(i?-1:1)),z=yn(f,f),H=yn(f,b),P=yn(b,b),W=$=>{let ne=yn($,f),he=yn($,b);return[(P*ne-H*he)/v**2,(z*he-H*ne)/v**2]},[B,O]=W(N),Q=qu([[B*B,m],[2*B*O,g],[O*O,y]]),[G,Y]=W(Ta(Q,-1)),ee=qu([[B**3,E[0]],[3*B*B*O,E[1]],[3*B*O*O,E[2]],[O**3,E[3]],[3*B*G,m],[3*(B*Y+O*G),g],[3*O*Y,y]]),ye=Ca(N,L),Ee=Math.sign(yn(ye,A));return{normal:ye,curvature:Ee*yn(A,Q),rate:Ee*yn(A,ee),agrees:Ee>0!==n.flip}})}var yn=(n,e)=>n[0]*e[0]+n[1]*e[1]+n[2]*e[2],Ca=(n,e)=>[n[1]*e[2]-n[2]*e[1],n[2]*e[0]-n[0]*e[2],n[0]*e[1]-n[1]*e[0]],Br=(n,e)=>Math.hypot(n[0]-e[0],n[1]-e[1],n[2]-e[2]),Ta=(n,e)=>[n[0]*e,n[1]*e,n[2]*e],_y=n=>Ta(n,1/Math.hypot(...n)),qu=n=>[0,1,2].map(e=>n.reduce((t,[i,r])=>t+i*r[e],0));var Sy=1e-9;function e0(n,e,t){let i=n.patches,r=i.slice();n0(r,e,t);let s=n.join??[];for(let a=0;a<s.length&&s.filter(o=>i0(i,r,o)).length;a++);return{...n,patches:r}}function t0(n,e){let t=n.patches.slice();return i0(null,t,e)===null?null:{...n,patches:t,join:[...n.join??[],e]}}function Km(n,e){let t=e.lastIndexOf(":");return[n.findIndex(i=>i.name===e.slice(0,t)),e.slice(t+1)]}function n0(n,e,t){let i=n[e],r=Hu(i),s=Hu(t);if(n[e]=t,r.length!==s.length||i.kind!==t.kind)return;let a=Math.max(...[0,1,2].map(l=>Math.max(...r.map(c=>c.point[l]))-Math.min(...r.map(c=>c.point[l])))),o=r.flatMap((l,c)=>Gu(l.point,s[c].point)>0?[{from:l.point,to:s[c].point}]:[]);o.length&&n.forEach((l,c)=>{if(c===e)return;let h=l;for(let{key:d,index:u,point:p}of Hu(l)){let f=o.find(({from:b})=>Gu(b,p)<=Sy*a);f&&(h=nr(h,d,u,f.to))}n[c]=h})}var Qm=new WeakMap;function Hu(n){let e=Qm.get(n);return e||Qm.set(n,e=["tensor","nurbs","symmetric","ruled"].includes(n.kind)?My(n):[]),e}function My(n){if(n.kind==="ruled")return["first","second"].flatMap(i=>Ae(n,i).map((r,s)=>({key:i,index:[s],point:r})));let e=Ae(n,"points"),t=n.kind==="symmetric"?-1:e.length-1;return e.flatMap((i,r)=>i.flatMap((s,a)=>r===0||r===t||a===0||a===i.length-1?[{key:"points",index:[r,a],point:s}]:[]))}function i0(n,e,t){let[i,r]=Km(e,t.first),[s,a]=Km(e,t.second);if(i<0||s<0||n&&n[i]===e[i]&&n[s]===e[s])return!1;let o=al(e[i],r),l=al(e[s],a);if(!o||!l||o.rows[0].length!==l.rows[0].length)return null;let c=Math.min(2,Number(t.order?.[1]??1),o.rows.length-1,l.rows.length-1),h=t.ratio??1,d=o.rows[0],u=l.rows[0],p=d.length,f=_=>d.reduce((x,E,w)=>x+Gu(E,u[_?p-1-w:w]),0),b=f(!0)<f(!1),m=n&&{lead:al(n[i],r),own:al(n[s],a)};if(m&&(!m.lead||!m.own||m.lead.rows[0].length!==p||m.own.rows[0].length!==p))return null;let g=e[s],y=!1;for(let _=0;_<p;_++){let x=b?p-1-_:_,E=[];for(let v=0;v<=c;v++){let A=(-h)**v;E.push([0,1,2].map(L=>A*(o.derivative(v,_,L)-(m?.lead?.derivative(v,_,L)??0))+(m?.own?.derivative(v,x,L)??0)-l.derivative(v,x,L)))}let w=[];for(let v=0;v<=c;v++)w.push(E[v].map((A,L)=>(A-w.reduce((R,N,z)=>R+l.weight(v,z)*N[L],0))/l.weight(v,v)));w.forEach((v,A)=>{Math.hypot(...v)>1e-11*l.size&&(y=!0,g=nr(g,"points",l.index(A,x),l.rows[A][x].map((L,R)=>L+v[R])))})}return y&&n0(e,s,g),y}function al(n,e){if(n.kind!=="tensor"||!sl.includes(e))return null;let t=Xt(n),i=Ae(n,"points"),r=e[0]==="u",s=e[1]==="1";if(!(t.rows instanceof Wt))return null;let a=r?t.rows.functions:t.blend,o=a.size,l=new Float64Array(3*o);a.derivatives(Float64Array.of(s?1:0),1,l);let c=b=>s?o-1-b:b,h=(b,m)=>r?[c(b),m]:[m,c(b)],d=r?i[0].length:i.length,u=Array.from({length:o},(b,m)=>Array.from({length:d},(g,y)=>{let[_,x]=h(m,y);return i[_][x]})),p=(b,m)=>(s?-1:1)**b*l[b*o+c(m)],f=Math.max(...u.flat(2).map(Math.abs));return{rows:u,size:f,index:h,weight:p,derivative:(b,m,g)=>u.reduce((y,_,x)=>y+(x<=b?p(b,x)*_[m][g]:0),0)}}var Gu=(n,e)=>Math.hypot(n[0]-e[0],n[1]-e[1],n[2]-e[2]);var ll={target:"",align:!1,tolerance:null,demands:""},wy=2e3,Ay=2e4,ol=class{constructor(e,t){this.store=e;this.host=t;e.subscribe((i,r)=>{(i.model!==r.model||i.aims!==r.aims||i.patch!==r.patch||i.moving!==r.moving)&&this.follow()})}store;host;asking=!1;asked=null;async follow(){if(!this.asking){for(this.asking=!0;this.behind();){let{model:e,aims:t,patch:i,moving:r}=this.asked=this.store.state,s=r?wy:Ay,a=De(this.store.state).name;try{let o=t.target?await this.host.beside(e,t,s):null,l=t.demands.trim()?await this.host.lights(e,a,t):[],c=this.store.state;c.aims.target===t.target&&c.aims.demands===t.demands&&c.patch===i&&this.store.set({beside:o,lights:l})}catch(o){this.store.set({beside:null,lights:[],message:{kind:"error",text:o.message}})}}this.asking=!1}}behind(){let{asked:e,store:{state:t}}=this;return!t.aims.target&&!t.aims.demands.trim()&&!t.beside&&!t.lights.length?!1:!e||e.model!==t.model||e.aims!==t.aims||e.patch!==t.patch||e.moving!==t.moving}};var Wu={quantity:"gaussian",range:"robust",percentile:2,low:-1,high:1,contours:!1,net:!0,curves:!0,directions:!1,normals:!1,combs:"off",combScale:1,comb:!0,zeroK:!1,zeroH:!1,minRadius:!1,seams:!0,together:!0,stripes:"none",density:24,lightAzimuth:30,lightElevation:60,section:!1,sectionAzimuth:0,sectionTilt:0,sectionAt:0,clip:!1,wireframe:!1,projection:"perspective",theme:"auto",snap:!1,snapStep:1,locks:[!1,!1,!1],resolution:150},r0=["theme","projection","curves","net","resolution"],s0="quintrig:settings";function a0(){try{let n=JSON.parse(localStorage.getItem(s0)??"{}"),e=r0.filter(t=>typeof n[t]==typeof Wu[t]);return{...Wu,...Object.fromEntries(e.map(t=>[t,n[t]]))}}catch{return Wu}}function o0(n){try{localStorage.setItem(s0,JSON.stringify(Object.fromEntries(r0.map(e=>[e,n[e]]))))}catch{}}var hl=class{constructor(e){this.state=e}state;past=[];future=[];openings=1;gesture=null;listeners=[];subscribe(e){this.listeners.push(e)}set(e){let t=this.state;this.state={...t,...e},this.state.settings!==t.settings&&o0(this.state.settings);for(let i of this.listeners)i(this.state,t)}setting(e){this.set({settings:{...this.state.settings,...e}})}edit(e,t=null){if(e===this.state.model)return;let i=e.patches.find(r=>!Fr(r)&&_u(r));if(i)return this.set({message:{kind:"error",text:_u(i)}});(t===null||t!==this.gesture)&&this.remember(),this.gesture=t,this.future=[],this.replace({...cl(this.state),model:e},t!==null)}resume(e){this.remember(),this.gesture=null,this.future=[],this.replace({...e,opened:++this.openings},!1)}written(e,t,i){let r=s=>s.opened===e?{...s,saved:t,source:i??s.source}:s;this.past=this.past.map(r),this.future=this.future.map(r),this.set(r(this.state))}editPatch(e,t=null){let{model:i,patch:r,settings:s}=this.state;this.edit(s.together?e0(i,r,e):{...i,patches:i.patches.with(r,e)},t)}settle(){this.gesture=null,this.state.moving&&this.set({moving:!1})}undo(){let e=this.past.pop();e&&(this.future.push(cl(this.state)),this.gesture=null,this.replace(e,!1))}redo(){let e=this.future.pop();e&&(this.past.push(cl(this.state)),this.gesture=null,this.replace(e,!1))}open(e,t,i=e){this.past=[],this.future=[],this.gesture=null,this.set({model:e,saved:i,source:t,patch:0,selected:null,pins:[],hover:null,kept:[],compare:"off",canUndo:!1,canRedo:!1,moving:!1,joining:null,message:null,aims:ll,beside:null,lights:[],opened:++this.openings})}remember(){this.past.push(cl(this.state)),this.past.length>500&&this.past.shift()}replace(e,t){let i=Math.min(this.state.patch,e.model.patches.length-1);this.set({...e,patch:i,moving:t,canUndo:this.past.length>0,canRedo:this.future.length>0})}},cl=({model:n,saved:e,source:t,opened:i})=>({model:n,saved:e,source:t,opened:i}),ul=Be.presets.map(vt),Es=n=>(Lr(n)?Be.shapeSets[String(mn(n).length)]:void 0)??[],Ts=n=>vt(hu[n]),De=n=>n.model.patches[n.patch];var Ey=0,Ty=n=>`${n}-${++Ey}`,dl=new WeakSet,qr=n=>dl.has(n);function pl(n,e){n.addEventListener("input",()=>dl.add(n)),n.addEventListener("change",()=>dl.delete(n));let t=()=>{dl.delete(n),e()};n.addEventListener("blur",t),n.addEventListener("keydown",i=>{i.key!=="Escape"||!qr(n)||(i.stopPropagation(),t())})}function l0(n,e,t){n.classList.toggle("wrong",!e),n.title=e?"":`${n.value||"That"} was not taken: expected ${t}`}function Kn(n){let{min:e,max:t}=n,{step:i}=n,r=Ty("slider"),s=f=>`${100*(Math.min(t,Math.max(e,f))-e)/(t-e)}%`,a=T("input",{type:"range",id:r,min:e,max:t,step:i,"aria-label":n.name}),o=T("input",{type:"number",class:"number",step:i,"aria-label":`${n.name}, number`,...n.hard&&!n.allowed?{min:e,max:t}:{}}),l=T("div",{class:"track"}),c=NaN,h=()=>{o.value=Number.isNaN(c)?"":String(Number(c.toPrecision(8)))};pl(o,h),a.addEventListener("input",()=>{u(Number(a.value)),n.onInput(Number(a.value))}),a.addEventListener("change",()=>n.onSettle?.()),o.addEventListener("change",()=>{let f=Pu(o),b=n.allowed?.holds(f)??(f>=e&&f<=t),m=Number.isFinite(f)&&(!n.hard||b);if(l0(o,m,n.hard?n.allowed?.words??`a number from ${e} to ${t}`:"a number"),!m||f===c)return h();c=f,h(),n.onInput(f),n.onSettle?.()});let d=(n.marks??[]).map(f=>{let b=T("span",{class:"mark"},String(f).replace("-","−"));return b.style.left=s(f),b}),u=f=>{l.style.setProperty("--share",s(f)),l.style.setProperty("--zero",s(0))};return{element:T("div",{class:"slider"},T("label",{for:r,class:"symbol"},n.label),T("div",{class:"range"},l,a,T("div",{class:"marks","aria-hidden":"true"},...d)),o),update(f){a.value=String(f),c=f,u(f),!qr(o)&&(h(),o.classList.remove("wrong"))},bounds(f,b,m){e=f,t=b,Object.assign(a,{min:String(f),max:String(b),step:String(m)}),o.step=String(m)}}}function Fn(n){let e=T("input",{type:"number",class:"number",step:n.step??"any","aria-label":n.name}),t=NaN,i=()=>{e.value=Number.isNaN(t)?"":String(Number(t.toPrecision(10)))};return pl(e,i),e.addEventListener("change",()=>{let s=Pu(e),a=Number.isFinite(s)&&Math.abs(s)<=1e50&&(!n.positive||s>0);if(l0(e,a,n.positive?"a number greater than 0":"a number"),!a||s===t)return i();t=s,i(),n.onChange(s)}),{element:T("label",{class:"field"},T("span",{},n.label),e),update(s){t=s,!qr(e)&&(e.disabled=Number.isNaN(s),i(),e.classList.remove("wrong"))}}}function Pt(n,e,t,i=""){let r=T("input",{type:"checkbox",class:"switch"});return r.addEventListener("change",()=>e(r.checked)),{element:T("label",{class:"toggle",title:i||!1},r,T("span",{},n),t),update:a=>{r.checked=a}}}function vn(n,e,t){let i=e.map(s=>{let a=T("button",{type:"button",role:"radio",class:"segment",title:s.title??!1,"data-value":s.value},s.label);return a.addEventListener("click",()=>t(s.value)),a}),r=T("div",{class:"segmented",role:"radiogroup","aria-label":n},...i);return r.addEventListener("keydown",s=>{let a={ArrowRight:1,ArrowDown:1,ArrowLeft:-1,ArrowUp:-1}[s.key],o=i.indexOf(s.target);if(!a||o<0)return;s.preventDefault(),s.stopPropagation();let l=(o+a+i.length)%i.length;i[l].focus(),t(e[l].value)}),{element:r,update(s){i.forEach((a,o)=>{let l=e[o].value===s;a.setAttribute("aria-checked",String(l)),a.tabIndex=l||o===0&&!e.some(c=>c.value===s)?0:-1})}}}function Ti(n,e,t){let i=s=>s.options.map(a=>T("option",{value:a.value},a.label)),r=T("select",{"aria-label":n},...e.flatMap(s=>s.label?[T("optgroup",{label:s.label},...i(s))]:i(s)));return r.addEventListener("change",()=>t(r.value)),{element:r,update:s=>{r.value=s}}}function Ve(n,e,t,i="button"){return T("button",{type:"button",class:i,title:e,"aria-label":e,on:{click:t}},n)}function Ra(n,e,t,i="button",r){let s=T("div",{class:"menu",role:"menu","aria-label":e,hidden:!0}),a=T("button",{type:"button",class:i,title:e,"aria-label":e,"aria-haspopup":"menu","aria-expanded":"false"},n),o=T("div",{class:"menu-box"},a,s),l=d=>{s.hidden=!0,a.setAttribute("aria-expanded","false"),d&&a.focus()},c=()=>{s.replaceChildren(...t().map(d=>{if(typeof d=="string")return T("div",{class:"menu-title",role:"presentation"},d);let u=d.reason?T("small",{class:"reason"},d.reason.split(/[:;]\s/)[0]):d.hint?T("small",{},d.hint):null,p=T("button",{type:"button",role:"menuitem",class:"menu-item",title:d.reason??"",disabled:d.disabled??!1},T("span",{},d.label),u);return p.addEventListener("click",()=>{l(!0),d.act()}),p}))},h=()=>{s.hidden=!1,a.setAttribute("aria-expanded","true"),c(),r?.().then(p=>{if(!p||s.hidden)return;let f=[...s.children].indexOf(s.querySelector(":focus"));a.focus(),c(),s.children[f]?.focus()});let d=s.getBoundingClientRect().right,u=o.closest(".studio").getBoundingClientRect().right;s.classList.toggle("to-left",d>u-8),s.querySelector("[role=menuitem]:not([disabled])")?.focus()};return a.addEventListener("click",()=>s.hidden?h():l(!1)),o.addEventListener("focusout",d=>{o.contains(d.relatedTarget)||l(!1)}),o.addEventListener("keydown",d=>{if(s.hidden)return;let u=[...s.querySelectorAll("[role=menuitem]:not([disabled])")],p=u.indexOf(d.target);d.stopPropagation(),d.key==="Escape"?l(!0):(d.key==="ArrowDown"||d.key==="ArrowUp")&&(d.preventDefault(),u[(p+(d.key==="ArrowDown"?1:-1)+u.length)%u.length]?.focus())}),o}function zn(n,e,...t){return T("details",{class:"section",open:e},T("summary",{},n),T("div",{class:"section-body"},...t))}function Ce(n,e=4){if(Number.isNaN(n))return"undefined";if(!Number.isFinite(n))return n>0?"∞":"−∞";if(n===0)return"0";let t=Math.abs(n);return(t>=1e5||t<.001?Cy(n,e):String(Number(n.toPrecision(e)))).replace("-","−")}function Cy(n,e){let[t,i]=n.toExponential(e-1).split("e");return`${Number(t)}·10${$u(Number(i))}`}var c0=n=>!(n>0)||!Number.isFinite(n)||n>=.01&&n<1e4?0:3*Math.floor(Math.log10(n)/3),$u=n=>String(n).replace(/[-\d]/g,e=>e==="-"?"⁻":"⁰¹²³⁴⁵⁶⁷⁸⁹"[Number(e)]),Pa=n=>n>0&&n<.001?"<0.1 %":`${Ce(100*n,n<.1?2:3)} %`,It=n=>n.charAt(0).toUpperCase()+n.slice(1),h0={alpha:"α",beta:"β",gamma:"γ",delta:"δ",zeta:"ζ",theta:"θ",kappa:"κ",lam:"λ",lambda:"λ",mu:"μ",nu:"ν",rho:"ρ",sigma:"σ",tau:"τ",phi:"φ",omega:"ω"};function Xu(n){let e=n.replace(/[\d_]+$/,"");return[e,n.slice(e.length).replaceAll("_",",")]}function u0(n){let[e,t]=Xu(n),i=ir("span","","math");return i.append(ir("i",h0[e]??e),...t?[ir("sub",t)]:[]),i}function Ci(n){let e=document.createElement("span");e.className="math";let t=n.replace(/\\mathrm\{([^}]*)\}/g,"«$1»").replace(/\\mathbf\{([^}]*)\}/g,"‹$1›").replace(/\\,/g," "),i=/«([^»]*)»|‹([^›]*)›|\\([a-z]+)|([_^])(?:\{([^}]*)\}|(.))|([^\\_^])/g;for(let[,r,s,a,o,l,c,h]of t.matchAll(i))r!==void 0?e.append(ir("span",r,"roman")):s!==void 0?e.append(ir("b",s)):a!==void 0?e.append(ir("i",h0[a]??a)):o?e.append(ir(o==="_"?"sub":"sup",l??c??"")):h&&e.append(/[A-Za-z]/.test(h)?ir("i",h):h);return e}function ir(n,e,t=""){let i=document.createElement(n);return i.textContent=e,t&&(i.className=t),i}function fl(n,e,t=5){return n.colour==="classes"?n.classes[e]??"undefined":Ce(e,t)}var fi=(n,e)=>el(n,e);var ml={centre:[0,0,0],scale:1,half:[1,1,1]};function d0(n,e){let t=.5*Math.hypot(e[0]-n[0],e[1]-n[1],e[2]-n[2]),i=t>0&&Number.isFinite(t)?1/t:1,r=a=>.5*(n[a]+e[a]),s=a=>.5*i*(e[a]-n[a]);return{centre:[r(0),r(1),r(2)],scale:i,half:[s(0),s(1),s(2)]}}var wt=(n,e)=>[(e[0]-n.centre[0])*n.scale,(e[1]-n.centre[1])*n.scale,(e[2]-n.centre[2])*n.scale],p0=(n,e)=>[e[0]/n.scale+n.centre[0],e[1]/n.scale+n.centre[1],e[2]/n.scale+n.centre[2]];var Cs=[[5,48,97],[67,147,195],[214,214,214],[214,96,77],[103,0,31]],f0=Cs.map(n=>`rgb(${n.join(" ")})`);function m0(n,e,t){let i=[],r=[],s=e?.distances.length??0,a=e?.reach||1;for(let o=0;o<s;o++){let l=e.places.subarray(3*o,3*o+3),c=Math.min(1,Math.max(-1,e.distances[o]/a));i.push(wt(t,[l[0],l[1],l[2]])),r.push(Ry(c))}n.fill(i,r)}function Ry(n){let e=(n+1)*.5*(Cs.length-1),t=Math.min(Math.floor(e),Cs.length-2);return[...[0,1,2].map(i=>(Cs[t][i]+(e-t)*(Cs[t+1][i]-Cs[t][i]))/255),1]}var Py=`gaussian >= 0
curvature_radius >= 30
deviation <= 0.5`,bl=class{constructor(e,t){this.store=e;this.host=t;this.files.addEventListener("change",()=>this.aim({target:this.files.value})),this.files.addEventListener("pointerdown",()=>{this.look()}),this.demands.addEventListener("input",()=>this.aim({demands:this.demands.value})),this.key.style.background=`linear-gradient(90deg, ${f0.join(", ")})`,this.one=Ve("Fair this point","Fair this point: move the chosen control point to where the surface has the least thin-plate energy",()=>{this.fair(this.store.state.selected?.replace("′","")??"")});let i=Ve("Fair all","Fair all: the patch of least thin-plate energy between its sides, which stay",()=>{this.fair("")});this.element=zn("Target and demands",!1,T("label",{class:"row"},T("span",{class:"caption"},"Target"),this.files),this.align.element,this.tolerance.element,this.key,this.told,T("span",{class:"caption"},"Demands"),this.demands,this.lights,T("div",{class:"row"},this.one,i)),this.look()}store;host;element;files=T("select",{"aria-label":"Target beside the model"});align=Pt("Align first",e=>this.aim({align:e}),void 0,"Move the target onto the model as a rigid body before it is measured");tolerance=Fn({label:"±",name:"Tolerance of the deviation",positive:!0,onChange:e=>this.aim({tolerance:e})});told=T("p",{class:"hint",role:"status"});key=T("div",{class:"distance-key","aria-hidden":"true"});demands=T("textarea",{rows:4,spellcheck:"false",placeholder:Py,"aria-label":"Demands, one a line"});lights=T("ul",{class:"lights","aria-label":"What comes of the demands"});one;refresh(e){let{aims:t,beside:i,lights:r}=e;this.files.value=t.target,this.align.update(t.align),this.tolerance.update(t.tolerance??NaN),this.tolerance.element.querySelector("input").disabled=!1;for(let s of[this.align.element,this.tolerance.element])s.hidden=!t.target;if(this.told.hidden=this.key.hidden=!i,i){let s=i.unit&&` ${i.unit}`,a=i.points<i.count?`${gl(i.points)} of ${gl(i.count)}`:gl(i.count),o=i.within===null?"":` ${Pa(i.within)} are within the tolerance.`,l=i.edge?` ${gl(i.edge)} lie beyond the border.`:"";this.told.textContent=`${a} points: rms ${Ce(i.rms,3)}${s}, from ${Ce(i.min,3)} to ${Ce(i.max,3)}${s}.${o}${l}`,this.key.title=`from ${Ce(-i.reach,3)} to ${Ce(i.reach,3)}${s}, red on the side of the normal`}this.demands.value!==t.demands&&(this.demands.value=t.demands),this.lights.replaceChildren(...r.map(Iy)),this.one.disabled=!e.selected}aim(e){this.store.set({aims:{...this.store.state.aims,...e}})}async look(){let e=await this.host.targets().catch(()=>[]),t=[...this.files.options].slice(1).map(i=>i.value);this.files.options.length&&String(e)===String(t)||(this.files.replaceChildren(T("option",{value:""},e.length?"none":"none in the folder"),...e.map(i=>T("option",{value:i},i))),this.files.value=this.store.state.aims.target)}async fair(e){let{state:t}=this.store,{model:i,patch:r}=t;try{let s=await this.host.fairer(i,De(t).name,e);if(this.store.state.model!==i)return;this.store.editPatch(s.model.patches[r]);let a=s.notes[0]??`Thin-plate energy from ${Ce(s.before)} to ${Ce(s.after)}${i.unit&&` ${i.unit}²`}`;this.store.set({message:{kind:"note",text:a}})}catch(s){this.store.set({message:{kind:"error",text:s.message}})}}},gl=n=>n.toLocaleString("en");function Iy({demand:n,met:e,worst:t,unit:i,u:r,v:s,error:a}){let o=a?"none":e?"met":"missed",l={met:"met",missed:"not met",none:"no demand"}[o],c=r==null||s===null||s===void 0?"":` at (${Ce(r,3)}, ${Ce(s,3)})`,h=t==null?"":`${Ce(t)}${i?` ${i}`:""}${c}`;return T("li",{class:o},T("span",{class:"light",role:"img","aria-label":l}),T("span",{},n),T("small",{},a?a.replace(/^demands: /,""):h))}var g0=new WeakMap;function yl(n){let{model:e,saved:t,compare:i,kept:r,patch:s}=n,a={label:"",model:e,editable:!0};if(i==="before")return[{label:"before",model:t,editable:!1},{...a,label:"now"}];if(i==="kept"&&r.length)return[{...a,label:"now"},...r.map(l=>({...l,editable:!1}))];let o=Es(e.patches[s]);return i==="sets"&&o.length?o.map(l=>({label:`(${l.join(", ").replaceAll("-","−")})`,model:Ny(e,l),editable:!0})):[a]}var Vr=({compare:n},e)=>n==="before"?Math.min(1,e-1):0;function Ny(n,e){let t=i=>{if(Es(i)[0]?.length!==e.length||String(mn(i))===String(e))return i;let r=g0.get(i)??new Map;g0.set(i,r);let s=r.get(String(e))??{...i,shape:e};return r.set(String(e),s),s};return{...n,patches:n.patches.map(t)}}var Yu=41,b0=Array.from({length:Yu},(n,e)=>e/(Yu-1));function Ly(n){let e=di(n),t=[0,1,2];if(!(e.size>0))return{low:e.low,high:e.low};let[i,r,s,a]=Ki(n),o=b0.map(x=>i+x*(s-i)),l=b0.map(x=>r+x*(a-r)),{point:c}=Zn(n,o,l,!1,["point"]),h=tl(n,o,l),d=!h.includes(1),u=t.map(x=>c.filter((E,w)=>w%3===x&&Number.isFinite(E)&&(d||h[(w-x)/3])).sort()),p=(x,E)=>u[x][Math.round(E*(u[x].length-1))],f=t.map(x=>p(x,0)),b=t.map(x=>p(x,1)),m=t.map(x=>p(x,.1)),g=t.map(x=>p(x,.9)),y=(x,E)=>Math.hypot(...t.map(w=>E[w]-x[w]));if(y(f,b)<=8*y(m,g))return{low:f,high:b};let _=t.map(x=>.5*(g[x]-m[x]));return{low:t.map(x=>Math.max(f[x],m[x]-_[x])),high:t.map(x=>Math.min(b[x],g[x]+_[x]))}}function Dy(n){let e=n.sample(Yu).map(({point:i})=>i),t=[0,1,2];return{low:t.map(i=>Math.min(...e.map(r=>r[i]))),high:t.map(i=>Math.max(...e.map(r=>r[i])))}}function y0(n){let e=[1/0,1/0,1/0],t=[-1/0,-1/0,-1/0];for(let i of n.flatMap(({model:r})=>r.patches))try{let r=Qe(i)?Dy(St(i)):Ly(Xt(i));for(let s=0;s<3;s++)e[s]=Math.min(e[s],r.low[s]),t[s]=Math.max(t[s],r.high[s])}catch{}return e[0]<=t[0]?{low:e,high:t}:null}var v0=[.38,.62],Fy=2,zy=16,Oy=50;function Ju(n,e,t){let{x:i,y:r}=n.project(e,t),s=n.ray(e,i,r),a=n.ray(e,i+1,r),o=Math.hypot(...t.map((l,c)=>l-s.origin[c]));return Math.hypot(...t.map((l,c)=>s.origin[c]+o*s.direction[c]-a.origin[c]-o*a.direction[c]))}function vl(n,e,t,i){let r=58*Ju(n,e,t),s=h=>{let{x:d,y:u}=n.project(e,t.map((p,f)=>p+r*h[f]));return[d,u]},a=(h,d)=>[0,1,2].map(u=>u===h?d:0),l=[0,1,2].filter(h=>i[h]).map(h=>({axes:[h],outline:[s(a(h,18/58)),s(a(h,1))]}));return[...[[1,2],[2,0],[0,1]].filter(h=>h.every(d=>i[d])).map(([h,d])=>({axes:[h,d],outline:[[0,0],[1,0],[1,1],[0,1]].map(([u,p])=>s([0,1,2].map(f=>f===h?v0[u]:f===d?v0[p]:0)))})).filter(({outline:h})=>Math.abs(ky(h))>Oy),...l.filter(({outline:[h,d]})=>Math.hypot(d[0]-h[0],d[1]-h[1])>zy)]}function x0(n,e,t,i){let r=s=>n.findLast(({outline:[a,o,...l]})=>!l.length&&Uy(a,o,e,t)<s);return r(Fy)??n.findLast(({outline:s})=>s.length>2&&By(s,e,t))??r(i)??null}var ky=n=>.5*n.reduce((e,[t,i],r)=>e+t*n[(r+1)%n.length][1]-i*n[(r+1)%n.length][0],0);function Uy([n,e],[t,i],r,s){let a=t-n,o=i-e,l=Math.min(1,Math.max(0,((r-n)*a+(s-e)*o)/(a*a+o*o)));return Math.hypot(r-n-l*a,s-e-l*o)}function By(n,e,t){let i=n.map(([r,s],a)=>{let[o,l]=n[(a+1)%n.length];return Math.sign((o-r)*(t-s)-(l-s)*(e-r))});return i.every(r=>r>=0)||i.every(r=>r<=0)}var qy={4:["α1","ζ1","α2","ζ2"],2:["α","ζ"]},Vy=new Set(["name","kind","shape"]);function Zu(n,e){let t=e.patches.length>1,i=[];return n.unit!==e.unit&&i.push(`unit ${n.unit||"none"} → ${e.unit||"none"}`),n.patches.length!==e.patches.length&&i.push(`${n.patches.length} → ${e.patches.length} patches`),e.patches.forEach((r,s)=>{let a=n.patches[s];!a||a===r||i.push(...Hy(a,r,e.unit).map(o=>t?`${r.name}: ${o}`:o))}),i}function Hy(n,e,t){if(n.kind!==e.kind)return[`${n.kind} → ${e.kind}`.replaceAll("_"," ")];let i=mn(n),r=mn(e).flatMap((s,a)=>s===i[a]?[]:[`${qy[i.length]?.[a]??`shape ${a}`} ${Ce(i[a]??NaN)} → ${Ce(s)}`]);for(let s of new Set([...Object.keys(n),...Object.keys(e)])){let a=Ae(n,s),o=Ae(e,s);Vy.has(s)||JSON.stringify(a)===JSON.stringify(o)||(typeof a=="number"&&typeof o=="number"?r.push(`${s} ${Ce(a)} → ${Ce(o)}`):Array.isArray(a)&&Array.isArray(o)?r.push(Gy(s,ju(a),ju(o),t)):r.push(`${s} ${String(a)} → ${String(o)}`))}return r}function Gy(n,e,t,i){if(e.length!==t.length)return`${n}: ${e.length} → ${t.length} points`;let r=t.map((l,c)=>Math.hypot(...l.map((h,d)=>h-(e[c][d]??0)))),s=r.filter(l=>l>0).length,a=Ce(Math.max(...r)),o=n==="planes"||n==="bounds"?"":i&&` ${i}`;return`${n}: ${s} of ${t.length} moved, by ${s>1?"up to ":""}${a}${o}`}var ju=n=>n.every(e=>typeof e=="number")?[n]:n.flatMap(e=>Array.isArray(e)?ju(e):[]);function Qn(n,e,t,i){return new Promise(r=>{let s=T("dialog",{"aria-label":e}),a=l=>{s.close(),s.remove(),r(l)},o=T("form",{method:"dialog"},T("h2",{},e),T("div",{class:"dialog-body"},...t),T("div",{class:"dialog-buttons"},...i.map(([l,c],h)=>Ve(c,c,()=>a(l),h===0?"button primary":"button"))));o.addEventListener("submit",l=>{l.preventDefault(),a(i[0]?.[0]??null)}),s.addEventListener("cancel",l=>{l.preventDefault(),a(null)}),s.addEventListener("keydown",l=>l.stopPropagation()),s.append(o),n.append(s),s.showModal(),(o.querySelector("input")??o.querySelector(".primary"))?.focus()})}async function _0(n,e,t){let i=T("input",{type:"text",value:t,"aria-label":"File name",spellcheck:"false"});return await Qn(n,e,[T("label",{class:"field wide"},T("span",{},"File name"),i),T("p",{class:"hint"},"Ends in .toml or .json; saved in the folder that the studio was opened on.")],[["save","Save"],["cancel","Cancel"]])==="save"?i.value.trim():null}async function S0(n,e,t,i){let r=T("input",{type:"number",class:"number",min:0,step:"any",placeholder:"usual","aria-label":`Tolerance${t?` in ${t}`:""}`}),s=[T("label",{class:"field wide"},T("span",{},`Tolerance${t?` (${t})`:""}`),r),T("p",{class:"hint"},"How far the file may be from the surface. Left empty: a mesh keeps to a thousandth of its size, a flat pattern to what a cutter can do."),...i?[T("p",{class:"hint"},`Colours as shown: ${i}, where the format has colours.`)]:[]];for(;;){if(await Qn(n,`Export ${e}`,s,[["export","Export"],["cancel","Cancel"]])!=="export")return null;if(!r.value&&r.validity.valid)return{tolerance:null};let o=Number(r.value);if(r.validity.valid&&o>0&&o<1/0)return{tolerance:o};s.some(l=>l.classList.contains("error"))||s.push(T("p",{class:"hint error",role:"alert"},"Expected a length greater than 0, or nothing."))}}async function M0(n,e,t){let i=(p,f)=>T("input",{type:"number",class:"number",min:64,max:8192,step:1,value:f,"aria-label":p}),r=i("Width in pixels",Math.round(e)),s=i("Height in pixels",Math.round(t)),a=(p,f)=>{r.value=String(p),s.value=String(f)},o=T("div",{class:"chips"},Ve("1920 × 1080","1920 × 1080",()=>a(1920,1080),"chip"),Ve("3840 × 2160","3840 × 2160",()=>a(3840,2160),"chip"),Ve("2000 × 2000","2000 × 2000",()=>a(2e3,2e3),"chip")),l=T("select",{"aria-label":"Background"},T("option",{value:"theme"},"As shown"),T("option",{value:"white"},"White"),T("option",{value:"none"},"Transparent")),c=!0,h=Pt("With legend",p=>c=p);if(h.update(!0),await Qn(n,"Save a picture",[T("div",{class:"pair"},T("label",{class:"field"},T("span",{},"Width"),r),T("label",{class:"field"},T("span",{},"Height"),s)),o,T("label",{class:"row"},T("span",{class:"caption"},"Background"),l),h.element],[["save","Save PNG"],["cancel","Cancel"]])!=="save")return null;let u=(p,f)=>Math.min(8192,Math.max(64,Math.round(Number(p.value))||f));return{width:u(r,e),height:u(s,t),background:l.value,legend:c}}var Wy=[["Ctrl Z, Ctrl Shift Z","undo, redo"],["Ctrl S, Ctrl O","save, open"],["1 to 6","views: oblique, top, side, back, front, bottom"],["P","perspective or parallel"],["F","fit"],["N","control net"],["I","iso-curves"],["W","wireframe"],["Z","zebra"],["C","compare: next arrangement"],["arrows","turn the view, or move the chosen point by the snap step"],["Shift arrows","pan, or move by ten steps"],["+ −","zoom"],["[ ]","choose the control point before or after"],["Esc","let go of the point"],["Enter","pin the point in the middle of the picture"]],Ku=n=>Qn(n,"Keys and pointer",[T("p",{},"Drag to turn, with Shift or the right button to pan, wheel to zoom; on a screen to touch, two fingers pan and zoom. Drag a control point to move it. Click the surface to pin a point."),T("dl",{class:"keys-list"},...Wy.flatMap(([e,t])=>[T("dt",{},e),T("dd",{},t)])),T("p",{class:"hint"},"Grey is where a quantity has no value. The signs of H, κ1, κ2 and S follow the normal; the bar at the bottom says which way it points.")],[["close","Close"]]);var Qu=5,ed=2;function td(n){let{model:e,kept:t}=n.state;if(t.length>=Qu)return n.set({compare:"kept",message:{kind:"note",text:`${Qu} are kept already: delete one first`}});let i=new Set(t.map(s=>s.label)),r=Array.from({length:Qu+1},(s,a)=>a+1).find(s=>!i.has(`kept ${s}`));n.set({kept:[...t,{label:`kept ${r}`,model:e}],compare:"kept"})}function nd(n,e){let t=Zu(n.kept[e].model,n.model);return t.length?`now: ${t.slice(0,ed).join("; ")}${t.length>ed?`; ${t.length-ed} more`:""}`:"same as now"}function w0(n,e){let{label:t,model:i}=n.state.kept[e],r=Zu(i,n.state.model).join(`
`),s=()=>n.state.kept.findIndex(l=>l.model===i&&l.label===t),a=l=>n.set({kept:n.state.kept.flatMap((c,h)=>h===s()?l(c):[c])}),o=T("div",{class:"kept"},T("div",{class:"kept-tools"},Ve("Restore",`Restore ${t}`,()=>n.edit(i),"button"),Ve("Rename",`Rename ${t}`,()=>{$y(o.closest(".studio"),t).then(l=>l&&a(c=>[{...c,label:l}]))},"button"),Ve("Delete",`Delete ${t}`,()=>{a(()=>[]),n.state.kept.length||n.set({compare:"off"})},"button")),T("div",{class:"differs",title:r||!1},nd(n.state,e)));return o}async function $y(n,e){let t=T("input",{type:"text",value:e,maxlength:60,"aria-label":"Name of the variant"});return await Qn(n,"Rename",[T("label",{class:"field wide"},T("span",{},"Name"),t)],[["rename","Rename"],["cancel","Cancel"]])==="rename"?t.value.trim():""}var Xy=["gaussian","mean","k1","k2","shape_index","curvedness","hk_type","shape_class","point_type"];function Ia(n,e){return Zn(Xt(n.patches[e.patch]),[e.u],[e.v],!0)}var A0=(n,{patch:e,u:t,v:i})=>_s(Xt(n.patches[e]),t,i);function id(n,e,t=0){let i=n[e.key][t];return e.colour==="classes"||e.power>=0?i:Math.abs(i)<=Be.limits.noise*n.curvedness[0]**-e.power?0:i}var Yy=(n,e)=>`normal ${fs(Xt(n))} S_u x S_v${e?` on ${n.name.replaceAll(`
`," ")}`:""}`,xl=n=>n.pins.filter(({patch:e})=>e<n.model.patches.length&&Qe(n.model.patches[e])===Qe(De(n))),_l=class{constructor(e,t){this.store=e;this.unfolded=t;let i=Fn({label:this.first,name:"u to pin",step:.05,onChange:o=>this.u=Math.min(1,Math.max(0,o))}),r=Fn({label:T("i",{class:"math"},"v"),name:"v to pin",step:.05,onChange:o=>this.v=Math.min(1,Math.max(0,o))});i.update(this.u),r.update(this.v);let s=Pt("All quantities",o=>{this.all=o,this.refresh(e.state)});this.surfaces=[r.element,s.element];let a=T("div",{class:"probe-tools"},i.element,r.element,Ve("Pin","Pin the point at these parameters",()=>this.add()),s.element,T("span",{class:"spacer"}),Ve("CSV","Save the table as CSV",()=>this.save()),Ve("Clear","Clear: remove all pins",()=>e.set({pins:[]})));this.element=T("details",{class:"probe"},T("summary",{},xt(Mt.pin),"Probe",this.count,this.hint),a,this.body),this.element.addEventListener("toggle",()=>this.unfolded()),this.suit(e.state),e.subscribe((o,l)=>{(o.model!==l.model||o.patch!==l.patch)&&this.suit(o),o.pins.length>l.pins.length&&(this.element.open=!0),(o.pins!==l.pins||(o.model!==l.model||o.patch!==l.patch)&&o.pins.length)&&this.refresh(o)})}store;unfolded;element;body=T("div",{class:"probe-body"});count=T("span",{class:"badge"});surfaces;hint=T("span",{class:"hint"});first=T("span",{},T("i",{class:"math"},"u"));all=!1;u=.5;v=.5;suit(e){let t=Qe(De(e));for(let i of this.surfaces)i.hidden=t;this.hint.textContent=`click the ${t?"curve":"surface"} to pin a point`,this.first.replaceChildren(T("i",{class:"math"},t?"t":"u"))}add(){let{pins:e,patch:t}=this.store.state;this.store.set({pins:[...e,{patch:t,u:this.u,v:this.v}]})}curves({model:e},t){let i=t.every(l=>St(e.patches[l.patch]).flat),r=e.unit?`1/${e.unit}`:"",s=["x","y",...i?[]:["z"]].map(l=>[l,e.unit]),a=[["t",""],...s,["κ",r],["1/κ",e.unit],...i?[]:[["τ",r]]],o=t.map(l=>{let{t:c,point:h,curvature:d,torsion:u}=St(e.patches[l.patch]).at(l.u);return[c,...h.slice(0,i?2:3),d,1/d,...i?[]:[u]]});return{heads:a,rows:o}}showCurves(e){let t=xl(e),{heads:i,rows:r}=this.curves(e,t),s=e.model.patches.length>1,a=T("tr",{},T("th",{},"#"),s?T("th",{},"curve"):null,...i.map(([l,c])=>T("th",{},T("i",{class:"math"},l),c?T("span",{class:"unit"},c):null)),T("th",{})),o=r.map((l,c)=>T("tr",{},T("td",{},T("span",{class:"pin-number"},c+1)),s?T("td",{},e.model.patches[t[c].patch].name):null,...l.map(h=>T("td",{},Ce(h))),T("td",{},this.remover(t[c],c))));this.body.replaceChildren(T("table",{},T("thead",{},a),T("tbody",{},...o)))}remover(e,t){return Ve(xt(Mt.close),`Remove pin ${t+1}`,()=>this.store.set({pins:this.store.state.pins.filter(i=>i!==e)}),"tiny")}columns(){return(this.all?pi.map(t=>t.key):["point",...Xy]).flatMap(t=>{let i=lt[t];return i.components===1?[{q:i,part:0,head:i.symbol}]:["x","y","z"].map((r,s)=>({q:i,part:s,head:t==="point"?r:`${i.symbol} ${r}`}))})}refresh(e){if(this.count.textContent=e.pins.length?String(e.pins.length):"",!e.pins.length){this.body.replaceChildren();return}if(Qe(De(e)))return this.showCurves(e);let t=e.model.patches.length>1,i=this.columns(),r=T("tr",{},T("th",{},"#"),t?T("th",{},"patch"):null,T("th",{},T("i",{class:"math"},"u")),T("th",{},T("i",{class:"math"},"v")),...i.map(({q:a,head:o})=>T("th",{title:It(a.name)},a.components===1?a.colour==="classes"?It(a.name):Ci(a.latex):T("i",{class:"math"},o),fi(a,e.model.unit)?T("span",{class:"unit"},fi(a,e.model.unit)):null)),T("th",{})),s=xl(e).map((a,o)=>{let l=Ia(e.model,a);return T("tr",{},T("td",{},T("span",{class:"pin-number"},o+1)),t?T("td",{},e.model.patches[a.patch].name):null,T("td",{},Ce(a.u)),T("td",{},Ce(a.v)),...A0(e.model,a)?i.map(({q:c,part:h})=>T("td",{class:c.colour==="classes"?"word":""},fl(c,id(l,c,h)))):[T("td",{class:"word",colspan:i.length},"outside the trimmed face")],T("td",{},this.remover(a,o)))});this.body.replaceChildren(T("table",{},T("thead",{},r),T("tbody",{},...s)))}save(){let{model:e}=this.store.state,t=xl(this.store.state);if(Qe(De(this.store.state)))return this.saveCurves();let i=pi.flatMap(c=>Array.from({length:c.components},(h,d)=>({q:c,part:d}))),r=({q:c,part:h})=>c.components===1?c.key:`${c.key}_${"xyz"[h]}`,s=i.map(({q:c})=>[c.key,fi(c,e.unit)]).filter(([,c])=>c),a=c=>c.replaceAll(/(^|[,;])(\s*)(?=[=+\-@])/g,"$1$2'"),o=c=>/[",\n]/.test(c)?`"${c.replaceAll('"','""')}"`:c,l=[`# ${a(e.name.replaceAll(`
`," "))}: ${[...new Set(t.map(c=>c.patch))].map(c=>Yy(e.patches[c],e.patches.length>1)).join(", ")}`,...s.length?[`# Units: ${[...new Map(s)].map(([c,h])=>`${c} in ${h}`).join(", ")}`]:[],["patch","u","v",...i.map(r)].join(","),...t.map(c=>{let h=Ia(e,c),d=A0(e,c),u=({q:p,part:f})=>{let b=h[p.key][f];return d?p.colour==="classes"?o(p.classes[b]):Number.isNaN(b)?"":String(b):""};return[o(a(e.patches[c.patch].name)),c.u,c.v,...i.map(u)].join(",")})];Jn(`${jn(e.name)}_probe.csv`,`${l.join(`
`)}
`,"text/csv")}saveCurves(){let{model:e}=this.store.state,t=xl(this.store.state),{heads:i,rows:r}=this.curves(this.store.state,t),s=[["curve",...i.map(([a,o])=>o?`${a} (${o})`:a)].join(","),...r.map((a,o)=>[JSON.stringify(e.patches[t[o].patch].name.replace(/^[=+\-@]/,"'$&")),...a.map(l=>Number.isNaN(l)?"":l)].join(","))];Jn(`${jn(e.name)}_probe.csv`,`${s.join(`
`)}
`,"text/csv")}};var Na="http://www.w3.org/2000/svg",rd=["x","y","z"];function Jy(n,e,t){let{flat:i}=St(n),r=St(n).at(e),s=t?`1/${t}`:"",a=(o,l,c)=>T("tr",{},T("th",{},T("i",{class:"math"},o)),T("td",{},l,c?T("span",{class:"unit"},c):null));return[T("div",{class:"tip-title"},`t = ${Ce(e)}`),T("div",{class:"tip-point"},`(${r.point.slice(0,i?2:3).map(o=>Ce(o)).join(", ")})${t?` ${t}`:""}`),T("table",{},a("κ",Ce(r.curvature),s),a("1/κ",Ce(1/r.curvature),t),i?null:a("τ",Ce(r.torsion),s))]}var Sl=class{constructor(e,t,i){this.store=e;this.stage=t;let r=(s,a,o)=>Ve(a,o,()=>i.view(s),"button view-button");this.projection=vn("Projection",[{value:"perspective",label:"Perspective"},{value:"orthographic",label:"Parallel",title:"Orthographic: lengths in the plane of the picture are true"}],s=>{this.stage.orbit.straight=!1,e.setting({projection:s})}),this.triad.setAttribute("viewBox","-32 -32 64 64"),this.triad.setAttribute("class","triad"),this.triad.setAttribute("aria-hidden","true"),this.gizmo.setAttribute("class","gizmo"),this.gizmo.setAttribute("aria-hidden","true"),this.element.append(this.cells,this.gizmo,this.marks,this.tip,this.triad,T("div",{class:"view-tools",role:"toolbar","aria-label":"View"},r("iso","Oblique","Oblique view (1)"),r("top","Top","Top view, along −z (2)"),r("side","Side","Side view, along +y (3)"),r("back","Back","Back view, along −x (4)"),r("front","Front","Front view, along +x (5)"),r("bottom","Bottom","Bottom view, along +z (6)"),Ve(xt(Mt.fit),"Fit (F)",i.fit,"button square"),this.projection.element))}store;stage;element=T("div",{class:"hud"});cells=T("div",{class:"cells"});marks=T("div",{class:"marks-layer"});tip=T("div",{class:"tip",hidden:!0,role:"status"});triad=document.createElementNS(Na,"svg");gizmo=document.createElementNS(Na,"svg");projection;named="";labels(e,t){let i=t.compare==="kept"&&e.length>1?1:e.length,{cells:r}=this.stage,s=JSON.stringify(r.map((a,o)=>[e[o],a.x,a.y,a.width,a.height,o>=i&&nd(t,o-i)]));s!==this.named&&(this.named=s,this.cells.replaceChildren(...r.map((a,o)=>{let l=T("div",{class:"cell"},e[o]?T("span",{class:"cell-label"},e[o]):null,o>=i?w0(this.store,o-i):null);return Object.assign(l.style,{left:`${a.x}px`,top:`${a.y}px`,width:`${a.width}px`,height:`${a.height}px`}),l})))}refresh(e,t,i){this.projection.update(this.stage.orbit.projection),this.drawTriad();let r=[],s=(l,c,h)=>{let d=this.stage.project(l,wt(t,c)),u=this.stage.cells[l];d.x<u.x||d.x>u.x+u.width||d.y<u.y||d.y>u.y+u.height||(r.length<8&&!e.moving&&h.classList.toggle("behind",this.stage.hides(l,wt(t,c),e.settings,t)),h.style.transform=`translate(${d.x.toFixed(1)}px, ${d.y.toFixed(1)}px)`,r.push(h))},a=Vr(e,this.stage.cells.length);this.drawGizmo(e,t,a),e.pins.forEach((l,c)=>{let h=e.model.patches[l.patch];h&&s(a,Qe(h)?St(h).at(l.u).point:Array.from(Ia(e.model,l).point),T("span",{class:"pin"},T("b",{},c+1)))});let o=e.model.unit?` ${e.model.unit}`:"";for(let{cell:l,at:c}of i)s(l,c.point,T("span",{class:"sharpest"},T("b",{},"r",T("sub",{},"min"),` = ${Ce(c.radius)}${o}`)));this.marks.replaceChildren(...r),this.showTip(e)}drawGizmo(e,t,i){let r=e.settings.net&&bn(De(e)).find(a=>a.id===e.selected),s=r&&!r.along?vl(this.stage,i,wt(t,r.position),r.free.map((a,o)=>a&&!e.settings.locks[o])):[];this.gizmo.replaceChildren(...s.map(({axes:a,outline:o})=>{let l=document.createElementNS(Na,"polygon");return l.setAttribute("points",o.map(c=>c.map(h=>h.toFixed(1)).join(",")).join(" ")),l.setAttribute("class",a.length===1?`arm axis-${rd[a[0]]}`:`square axis-${rd[3-a[0]-a[1]]}`),l}))}showTip(e){let{hover:t}=e;if(!t||t.patch>=e.model.patches.length)return void(this.tip.hidden=!0);let i=this.stage.cells[t.cell]?.pieces[t.patch];if(!i?.patch)return void(this.tip.hidden=!0);if(Qe(i.patch))return this.tell(t,Jy(i.patch,t.u,e.model.unit));let r=Ia({...e.model,patches:[i.patch]},{...t,patch:0}),s=[...new Set([e.settings.quantity==="none"?"gaussian":e.settings.quantity,"gaussian","mean","hk_type","shape_class"])],a=(l,c,h="")=>T("tr",{},T("th",{},l),T("td",{},c,h?T("span",{class:"unit"},h):null)),o=r.point;this.tell(t,[T("div",{class:"tip-title"},`u = ${Ce(t.u)}, v = ${Ce(t.v)}`),T("div",{class:"tip-point"},`(${Array.from(o,l=>Ce(l)).join(", ")})${e.model.unit?` ${e.model.unit}`:""}`),T("table",{},...s.map(l=>{let c=lt[l];return a(c.colour==="classes"?c.name:Ci(c.latex),fl(c,id(r,c)),fi(c,e.model.unit))})),T("div",{class:"tip-words"},Qo("hk_type",r.hk_type[0]))])}tell(e,t){this.tip.replaceChildren(...t),this.tip.hidden=!1;let i=this.element.getBoundingClientRect(),r=this.tip.getBoundingClientRect(),s=e.x+18+r.width>i.width?e.x-18-r.width:e.x+18,a=Math.min(Math.max(6,e.y+14),i.height-r.height-6);this.tip.style.transform=`translate(${Math.round(s)}px, ${Math.round(a)}px)`}drawTriad(){let{right:e,up:t,towards:i}=this.stage.orbit.axes(),r=rd.map((s,a)=>{let o=l=>[l.x,l.y,l.z][a];return{name:s,x:20*o(e),y:-20*o(t),depth:o(i)}}).sort((s,a)=>s.depth-a.depth);this.triad.replaceChildren(...r.flatMap(({name:s,x:a,y:o})=>{let l=document.createElementNS(Na,"line"),c=document.createElementNS(Na,"text");return l.setAttribute("x2",String(a)),l.setAttribute("y2",String(o)),l.setAttribute("class",`axis-${s}`),c.setAttribute("x",String(a*1.32)),c.setAttribute("y",String(o*1.32)),c.textContent=s,[l,c]}))}};var j0=0,Ld=1,Z0=2;var so=1,K0=2,Qs=3,gr=0,rn=1,Bn=2,jr=0,ea=1,Dd=2,Fd=3,zd=4,Q0=5;var Zr=100,eg=101,tg=102,ng=103,ig=104,rg=200,sg=201,ag=202,og=203,Od=204,kd=205,lg=206,cg=207,hg=208,ug=209,dg=210,pg=211,fg=212,mg=213,gg=214,Xl=0,Yl=1,Jl=2,Hs=3,jl=4,Zl=5,Gs=6,Kl=7,Ud=0,bg=1,yg=2,vi=0,Bd=1,qd=2,Vd=3,Hd=4,Gd=5,Wd=6,$d=7;var Xd=300,Kr=301,ta=302,wc=303,Ac=304,Ql=1e3,gi=1001,ec=1002,Tt=1003,vg=1004;var ao=1005;var kt=1006,Ec=1007;var ki=1008;var sn=1009,Yd=1010,Jd=1011,na=1012,Tc=1013,ri=1014,En=1015,si=1016,Cc=1017,Rc=1018,Qr=1020,jd=35902,Zd=35899,Kd=1021,Qd=1022,Tn=1023,zi=1026,Ui=1027,oo=1028,Pc=1029,br=1030,Ic=1031;var Nc=1033,lo=33776,co=33777,ho=33778,uo=33779,Lc=35840,Dc=35841,Fc=35842,zc=35843,Oc=36196,kc=37492,Uc=37496,Bc=37488,qc=37489,po=37490,Vc=37491,Hc=37808,Gc=37809,Wc=37810,$c=37811,Xc=37812,Yc=37813,Jc=37814,jc=37815,Zc=37816,Kc=37817,Qc=37818,eh=37819,th=37820,nh=37821,ih=36492,rh=36494,sh=36495,ah=36283,oh=36284,fo=36285,lh=36286;var ka=2300,tc=2301,Wl=2302,Ed=2303,Td=2400,Cd=2401,Rd=2402;var xg=3200;var ep=0,_g=1,Bi="",Sn="srgb",Ua="srgb-linear",Ba="linear",at="srgb";var $l=7680;var Sg=519,Mg=512,wg=513,Ag=514,tp=515,Eg=516,Tg=517,np=518,ip=519,rp=35044,ia=35048;var qi="300 es",kn=2e3,qa=2001;function jy(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function Zy(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function Va(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function Cg(){let n=Va("canvas");return n.style.display="block",n}var E0={},Ws=null;function Ha(...n){let e="THREE."+n.shift();Ws?Ws("log",e,...n):console.log(e,...n)}function Rg(n){let e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Le(...n){n=Rg(n);let e="THREE."+n.shift();if(Ws)Ws("warn",e,...n);else{let t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function ze(...n){n=Rg(n);let e="THREE."+n.shift();if(Ws)Ws("error",e,...n);else{let t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function Oa(...n){let e=n.join(" ");e in E0||(E0[e]=!0,Le(...n))}function Pg(n,e,t){return new Promise(function(i,r){function s(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:r();break;case n.TIMEOUT_EXPIRED:setTimeout(s,t);break;default:i()}}setTimeout(s,t)})}var Ig={[Xl]:Xl,[Jl]:Gs,[jl]:jl,[Hs]:Zl,[Yl]:Yl,[Gs]:Jl,[Kl]:Kl,[Zl]:Hs},bi=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){let i=this._listeners;if(i===void 0)return;let r=i[e];if(r!==void 0){let s=r.indexOf(t);s!==-1&&r.splice(s,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let i=t[e.type];if(i!==void 0){e.target=this;let r=i.slice(0);for(let s=0,a=r.length;s<a;s++)r[s].call(this,e);e.target=null}}},Yt=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var sd=Math.PI/180,nc=180/Math.PI;function es(){let n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Yt[n&255]+Yt[n>>8&255]+Yt[n>>16&255]+Yt[n>>24&255]+"-"+Yt[e&255]+Yt[e>>8&255]+"-"+Yt[e>>16&15|64]+Yt[e>>24&255]+"-"+Yt[t&63|128]+Yt[t>>8&255]+"-"+Yt[t>>16&255]+Yt[t>>24&255]+Yt[i&255]+Yt[i>>8&255]+Yt[i>>16&255]+Yt[i>>24&255]).toLowerCase()}function et(n,e,t){return Math.max(e,Math.min(t,n))}function Ky(n,e){return(n%e+e)%e}function ad(n,e,t){return(1-t)*n+t*e}function Ng(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function ch(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Lg(n,e){if(e.constructor===Float32Array)return n;let t=ch(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/t,-1)}function Dg(n,e){if(e.constructor===Float32Array)return n;let t=ch(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*t)}var Xe=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,i=this.y,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6],this.y=r[1]*t+r[4]*i+r[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=et(this.x,e.x,t.x),this.y=et(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=et(this.x,e,t),this.y=et(this.y,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(et(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(et(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let i=Math.cos(t),r=Math.sin(t),s=this.x-e.x,a=this.y-e.y;return this.x=s*i-a*r+e.x,this.y=s*r+a*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},yi=class{constructor(e=0,t=0,i=0,r=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=r}static slerpFlat(e,t,i,r,s,a,o){let l=i[r+0],c=i[r+1],h=i[r+2],d=i[r+3],u=s[a+0],p=s[a+1],f=s[a+2],b=s[a+3];if(d!==b||l!==u||c!==p||h!==f){let m=l*u+c*p+h*f+d*b;m<0&&(u=-u,p=-p,f=-f,b=-b,m=-m);let g=1-o;if(m<.9995){let y=Math.acos(m),_=Math.sin(y);g=Math.sin(g*y)/_,o=Math.sin(o*y)/_,l=l*g+u*o,c=c*g+p*o,h=h*g+f*o,d=d*g+b*o}else{l=l*g+u*o,c=c*g+p*o,h=h*g+f*o,d=d*g+b*o;let y=1/Math.sqrt(l*l+c*c+h*h+d*d);l*=y,c*=y,h*=y,d*=y}}e[t]=l,e[t+1]=c,e[t+2]=h,e[t+3]=d}static multiplyQuaternionsFlat(e,t,i,r,s,a){let o=i[r],l=i[r+1],c=i[r+2],h=i[r+3],d=s[a],u=s[a+1],p=s[a+2],f=s[a+3];return e[t]=o*f+h*d+l*p-c*u,e[t+1]=l*f+h*u+c*d-o*p,e[t+2]=c*f+h*p+o*u-l*d,e[t+3]=h*f-o*d-l*u-c*p,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,r){return this._x=e,this._y=t,this._z=i,this._w=r,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let i=e._x,r=e._y,s=e._z,a=e._order,o=Math.cos,l=Math.sin,c=o(i/2),h=o(r/2),d=o(s/2),u=l(i/2),p=l(r/2),f=l(s/2);switch(a){case"XYZ":this._x=u*h*d+c*p*f,this._y=c*p*d-u*h*f,this._z=c*h*f+u*p*d,this._w=c*h*d-u*p*f;break;case"YXZ":this._x=u*h*d+c*p*f,this._y=c*p*d-u*h*f,this._z=c*h*f-u*p*d,this._w=c*h*d+u*p*f;break;case"ZXY":this._x=u*h*d-c*p*f,this._y=c*p*d+u*h*f,this._z=c*h*f+u*p*d,this._w=c*h*d-u*p*f;break;case"ZYX":this._x=u*h*d-c*p*f,this._y=c*p*d+u*h*f,this._z=c*h*f-u*p*d,this._w=c*h*d+u*p*f;break;case"YZX":this._x=u*h*d+c*p*f,this._y=c*p*d+u*h*f,this._z=c*h*f-u*p*d,this._w=c*h*d-u*p*f;break;case"XZY":this._x=u*h*d-c*p*f,this._y=c*p*d-u*h*f,this._z=c*h*f+u*p*d,this._w=c*h*d+u*p*f;break;default:Le("Quaternion: .setFromEuler() encountered an unknown order: "+a)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let i=t/2,r=Math.sin(i);return this._x=e.x*r,this._y=e.y*r,this._z=e.z*r,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,i=t[0],r=t[4],s=t[8],a=t[1],o=t[5],l=t[9],c=t[2],h=t[6],d=t[10],u=i+o+d;if(u>0){let p=.5/Math.sqrt(u+1);this._w=.25/p,this._x=(h-l)*p,this._y=(s-c)*p,this._z=(a-r)*p}else if(i>o&&i>d){let p=2*Math.sqrt(1+i-o-d);this._w=(h-l)/p,this._x=.25*p,this._y=(r+a)/p,this._z=(s+c)/p}else if(o>d){let p=2*Math.sqrt(1+o-i-d);this._w=(s-c)/p,this._x=(r+a)/p,this._y=.25*p,this._z=(l+h)/p}else{let p=2*Math.sqrt(1+d-i-o);this._w=(a-r)/p,this._x=(s+c)/p,this._y=(l+h)/p,this._z=.25*p}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(et(this.dot(e),-1,1)))}rotateTowards(e,t){let i=this.angleTo(e);if(i===0)return this;let r=Math.min(1,t/i);return this.slerp(e,r),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let i=e._x,r=e._y,s=e._z,a=e._w,o=t._x,l=t._y,c=t._z,h=t._w;return this._x=i*h+a*o+r*c-s*l,this._y=r*h+a*l+s*o-i*c,this._z=s*h+a*c+i*l-r*o,this._w=a*h-i*o-r*l-s*c,this._onChangeCallback(),this}slerp(e,t){let i=e._x,r=e._y,s=e._z,a=e._w,o=this.dot(e);o<0&&(i=-i,r=-r,s=-s,a=-a,o=-o);let l=1-t;if(o<.9995){let c=Math.acos(o),h=Math.sin(c);l=Math.sin(l*c)/h,t=Math.sin(t*c)/h,this._x=this._x*l+i*t,this._y=this._y*l+r*t,this._z=this._z*l+s*t,this._w=this._w*l+a*t,this._onChangeCallback()}else this._x=this._x*l+i*t,this._y=this._y*l+r*t,this._z=this._z*l+s*t,this._w=this._w*l+a*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),r=Math.sqrt(1-i),s=Math.sqrt(i);return this.set(r*Math.sin(e),r*Math.cos(e),s*Math.sin(t),s*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},U=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(T0.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(T0.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,i=this.y,r=this.z,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6]*r,this.y=s[1]*t+s[4]*i+s[7]*r,this.z=s[2]*t+s[5]*i+s[8]*r,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,i=this.y,r=this.z,s=e.elements,a=1/(s[3]*t+s[7]*i+s[11]*r+s[15]);return this.x=(s[0]*t+s[4]*i+s[8]*r+s[12])*a,this.y=(s[1]*t+s[5]*i+s[9]*r+s[13])*a,this.z=(s[2]*t+s[6]*i+s[10]*r+s[14])*a,this}applyQuaternion(e){let t=this.x,i=this.y,r=this.z,s=e.x,a=e.y,o=e.z,l=e.w,c=2*(a*r-o*i),h=2*(o*t-s*r),d=2*(s*i-a*t);return this.x=t+l*c+a*d-o*h,this.y=i+l*h+o*c-s*d,this.z=r+l*d+s*h-a*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,i=this.y,r=this.z,s=e.elements;return this.x=s[0]*t+s[4]*i+s[8]*r,this.y=s[1]*t+s[5]*i+s[9]*r,this.z=s[2]*t+s[6]*i+s[10]*r,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=et(this.x,e.x,t.x),this.y=et(this.y,e.y,t.y),this.z=et(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=et(this.x,e,t),this.y=et(this.y,e,t),this.z=et(this.z,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(et(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let i=e.x,r=e.y,s=e.z,a=t.x,o=t.y,l=t.z;return this.x=r*l-s*o,this.y=s*a-i*l,this.z=i*o-r*a,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return od.copy(this).projectOnVector(e),this.sub(od)}reflect(e){return this.sub(od.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(et(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y,r=this.z-e.z;return t*t+i*i+r*r}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){let r=Math.sin(t)*e;return this.x=r*Math.sin(i),this.y=Math.cos(t)*e,this.z=r*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),r=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=r,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},od=new U,T0=new yi,ke=class{static{this.prototype.isMatrix3=!0}constructor(e,t,i,r,s,a,o,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,r,s,a,o,l,c)}set(e,t,i,r,s,a,o,l,c){let h=this.elements;return h[0]=e,h[1]=r,h[2]=o,h[3]=t,h[4]=s,h[5]=l,h[6]=i,h[7]=a,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,r=t.elements,s=this.elements,a=i[0],o=i[3],l=i[6],c=i[1],h=i[4],d=i[7],u=i[2],p=i[5],f=i[8],b=r[0],m=r[3],g=r[6],y=r[1],_=r[4],x=r[7],E=r[2],w=r[5],v=r[8];return s[0]=a*b+o*y+l*E,s[3]=a*m+o*_+l*w,s[6]=a*g+o*x+l*v,s[1]=c*b+h*y+d*E,s[4]=c*m+h*_+d*w,s[7]=c*g+h*x+d*v,s[2]=u*b+p*y+f*E,s[5]=u*m+p*_+f*w,s[8]=u*g+p*x+f*v,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[1],r=e[2],s=e[3],a=e[4],o=e[5],l=e[6],c=e[7],h=e[8];return t*a*h-t*o*c-i*s*h+i*o*l+r*s*c-r*a*l}invert(){let e=this.elements,t=e[0],i=e[1],r=e[2],s=e[3],a=e[4],o=e[5],l=e[6],c=e[7],h=e[8],d=h*a-o*c,u=o*l-h*s,p=c*s-a*l,f=t*d+i*u+r*p;if(f===0)return this.set(0,0,0,0,0,0,0,0,0);let b=1/f;return e[0]=d*b,e[1]=(r*c-h*i)*b,e[2]=(o*i-r*a)*b,e[3]=u*b,e[4]=(h*t-r*l)*b,e[5]=(r*s-o*t)*b,e[6]=p*b,e[7]=(i*l-c*t)*b,e[8]=(a*t-i*s)*b,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,r,s,a,o){let l=Math.cos(s),c=Math.sin(s);return this.set(i*l,i*c,-i*(l*a+c*o)+a+e,-r*c,r*l,-r*(-c*a+l*o)+o+t,0,0,1),this}scale(e,t){return Oa("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(ld.makeScale(e,t)),this}rotate(e){return Oa("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(ld.makeRotation(-e)),this}translate(e,t){return Oa("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(ld.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,i=e.elements;for(let r=0;r<9;r++)if(t[r]!==i[r])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}},ld=new ke,C0=new ke().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),R0=new ke().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Qy(){let n={enabled:!0,workingColorSpace:Ua,spaces:{},convert:function(r,s,a){return this.enabled===!1||s===a||!s||!a||(this.spaces[s].transfer===at&&(r.r=Fi(r.r),r.g=Fi(r.g),r.b=Fi(r.b)),this.spaces[s].primaries!==this.spaces[a].primaries&&(r.applyMatrix3(this.spaces[s].toXYZ),r.applyMatrix3(this.spaces[a].fromXYZ)),this.spaces[a].transfer===at&&(r.r=Vs(r.r),r.g=Vs(r.g),r.b=Vs(r.b))),r},workingToColorSpace:function(r,s){return this.convert(r,this.workingColorSpace,s)},colorSpaceToWorking:function(r,s){return this.convert(r,s,this.workingColorSpace)},getPrimaries:function(r){return this.spaces[r].primaries},getTransfer:function(r){return r===Bi?Ba:this.spaces[r].transfer},getToneMappingMode:function(r){return this.spaces[r].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(r,s=this.workingColorSpace){return r.fromArray(this.spaces[s].luminanceCoefficients)},define:function(r){Object.assign(this.spaces,r)},_getMatrix:function(r,s,a){return r.copy(this.spaces[a].fromXYZ).multiply(this.spaces[s].toXYZ)},_getDrawingBufferColorSpace:function(r){return this.spaces[r].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(r=this.workingColorSpace){return this.spaces[r].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[Ua]:{primaries:e,whitePoint:i,transfer:Ba,toXYZ:C0,fromXYZ:R0,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:Sn},outputColorSpaceConfig:{drawingBufferColorSpace:Sn}},[Sn]:{primaries:e,whitePoint:i,transfer:at,toXYZ:C0,fromXYZ:R0,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:Sn}}}),n}var Ke=Qy();function Fi(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function Vs(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var Rs,ic=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{Rs===void 0&&(Rs=Va("canvas")),Rs.width=e.width,Rs.height=e.height;let r=Rs.getContext("2d");e instanceof ImageData?r.putImageData(e,0,0):r.drawImage(e,0,0,e.width,e.height),i=Rs}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=Va("canvas");t.width=e.width,t.height=e.height;let i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let r=i.getImageData(0,0,e.width,e.height),s=r.data;for(let a=0;a<s.length;a++)s[a]=Fi(s[a]/255)*255;return i.putImageData(r,0,0),t}else if(e.data){let t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(Fi(t[i]/255)*255):t[i]=Fi(t[i]);return{data:t,width:e.width,height:e.height}}else return Le("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},ev=0,$s=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:ev++}),this.uuid=es(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},r=this.data;if(r!==null){let s;if(Array.isArray(r)){s=[];for(let a=0,o=r.length;a<o;a++)r[a].isDataTexture?s.push(cd(r[a].image)):s.push(cd(r[a]))}else s=cd(r);i.url=s}return t||(e.images[this.uuid]=i),i}};function cd(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?ic.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Le("Texture: Unable to serialize Texture."),{})}var tv=0,hd=new U,nn=class n extends bi{constructor(e=n.DEFAULT_IMAGE,t=n.DEFAULT_MAPPING,i=gi,r=gi,s=kt,a=ki,o=Tn,l=sn,c=n.DEFAULT_ANISOTROPY,h=Bi){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:tv++}),this.uuid=es(),this.name="",this.source=new $s(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=r,this.magFilter=s,this.minFilter=a,this.anisotropy=c,this.format=o,this.internalFormat=null,this.type=l,this.offset=new Xe(0,0),this.repeat=new Xe(1,1),this.center=new Xe(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new ke,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(hd).x}get height(){return this.source.getSize(hd).y}get depth(){return this.source.getSize(hd).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let i=e[t];if(i===void 0){Le(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let r=this[t];if(r===void 0){Le(`Texture.setValues(): property '${t}' does not exist.`);continue}r&&i&&r.isVector2&&i.isVector2||r&&i&&r.isVector3&&i.isVector3||r&&i&&r.isMatrix3&&i.isMatrix3?r.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Xd)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case Ql:e.x=e.x-Math.floor(e.x);break;case gi:e.x=e.x<0?0:1;break;case ec:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case Ql:e.y=e.y-Math.floor(e.y);break;case gi:e.y=e.y<0?0:1;break;case ec:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};nn.DEFAULT_IMAGE=null;nn.DEFAULT_MAPPING=Xd;nn.DEFAULT_ANISOTROPY=1;var ht=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,i=0,r=1){this.x=e,this.y=t,this.z=i,this.w=r}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,r){return this.x=e,this.y=t,this.z=i,this.w=r,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,i=this.y,r=this.z,s=this.w,a=e.elements;return this.x=a[0]*t+a[4]*i+a[8]*r+a[12]*s,this.y=a[1]*t+a[5]*i+a[9]*r+a[13]*s,this.z=a[2]*t+a[6]*i+a[10]*r+a[14]*s,this.w=a[3]*t+a[7]*i+a[11]*r+a[15]*s,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,r,s,l=e.elements,c=l[0],h=l[4],d=l[8],u=l[1],p=l[5],f=l[9],b=l[2],m=l[6],g=l[10];if(Math.abs(h-u)<.01&&Math.abs(d-b)<.01&&Math.abs(f-m)<.01){if(Math.abs(h+u)<.1&&Math.abs(d+b)<.1&&Math.abs(f+m)<.1&&Math.abs(c+p+g-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let _=(c+1)/2,x=(p+1)/2,E=(g+1)/2,w=(h+u)/4,v=(d+b)/4,A=(f+m)/4;return _>x&&_>E?_<.01?(i=0,r=.707106781,s=.707106781):(i=Math.sqrt(_),r=w/i,s=v/i):x>E?x<.01?(i=.707106781,r=0,s=.707106781):(r=Math.sqrt(x),i=w/r,s=A/r):E<.01?(i=.707106781,r=.707106781,s=0):(s=Math.sqrt(E),i=v/s,r=A/s),this.set(i,r,s,t),this}let y=Math.sqrt((m-f)*(m-f)+(d-b)*(d-b)+(u-h)*(u-h));return Math.abs(y)<.001&&(y=1),this.x=(m-f)/y,this.y=(d-b)/y,this.z=(u-h)/y,this.w=Math.acos((c+p+g-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=et(this.x,e.x,t.x),this.y=et(this.y,e.y,t.y),this.z=et(this.z,e.z,t.z),this.w=et(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=et(this.x,e,t),this.y=et(this.y,e,t),this.z=et(this.z,e,t),this.w=et(this.w,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(et(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},rc=class extends bi{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:kt,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new ht(0,0,e,t),this.scissorTest=!1,this.viewport=new ht(0,0,e,t),this.textures=[];let r=i.count;for(let s=0;s<r;s++)this.textures[s]=new nn({width:e,height:t,depth:i.depth}),this.textures[s].isRenderTargetTexture=!0,this.textures[s].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:kt,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let r=0,s=this.textures.length;r<s;r++)this.textures[r].image.width=e,this.textures[r].image.height=t,this.textures[r].image.depth=i,this.textures[r].isData3DTexture!==!0&&(this.textures[r].isArrayTexture=this.textures[r].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let r=Object.assign({},e.textures[t].image);this.textures[t].source=new $s(r)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},Mn=class extends rc{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}},Ga=class extends nn{constructor(e=null,t=1,i=1,r=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:r},this.magFilter=Tt,this.minFilter=Tt,this.wrapR=gi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var sc=class extends nn{constructor(e=null,t=1,i=1,r=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:r},this.magFilter=Tt,this.minFilter=Tt,this.wrapR=gi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var pt=class n{static{this.prototype.isMatrix4=!0}constructor(e,t,i,r,s,a,o,l,c,h,d,u,p,f,b,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,r,s,a,o,l,c,h,d,u,p,f,b,m)}set(e,t,i,r,s,a,o,l,c,h,d,u,p,f,b,m){let g=this.elements;return g[0]=e,g[4]=t,g[8]=i,g[12]=r,g[1]=s,g[5]=a,g[9]=o,g[13]=l,g[2]=c,g[6]=h,g[10]=d,g[14]=u,g[3]=p,g[7]=f,g[11]=b,g[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){let t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,i=e.elements,r=1/Ps.setFromMatrixColumn(e,0).length(),s=1/Ps.setFromMatrixColumn(e,1).length(),a=1/Ps.setFromMatrixColumn(e,2).length();return t[0]=i[0]*r,t[1]=i[1]*r,t[2]=i[2]*r,t[3]=0,t[4]=i[4]*s,t[5]=i[5]*s,t[6]=i[6]*s,t[7]=0,t[8]=i[8]*a,t[9]=i[9]*a,t[10]=i[10]*a,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,i=e.x,r=e.y,s=e.z,a=Math.cos(i),o=Math.sin(i),l=Math.cos(r),c=Math.sin(r),h=Math.cos(s),d=Math.sin(s);if(e.order==="XYZ"){let u=a*h,p=a*d,f=o*h,b=o*d;t[0]=l*h,t[4]=-l*d,t[8]=c,t[1]=p+f*c,t[5]=u-b*c,t[9]=-o*l,t[2]=b-u*c,t[6]=f+p*c,t[10]=a*l}else if(e.order==="YXZ"){let u=l*h,p=l*d,f=c*h,b=c*d;t[0]=u+b*o,t[4]=f*o-p,t[8]=a*c,t[1]=a*d,t[5]=a*h,t[9]=-o,t[2]=p*o-f,t[6]=b+u*o,t[10]=a*l}else if(e.order==="ZXY"){let u=l*h,p=l*d,f=c*h,b=c*d;t[0]=u-b*o,t[4]=-a*d,t[8]=f+p*o,t[1]=p+f*o,t[5]=a*h,t[9]=b-u*o,t[2]=-a*c,t[6]=o,t[10]=a*l}else if(e.order==="ZYX"){let u=a*h,p=a*d,f=o*h,b=o*d;t[0]=l*h,t[4]=f*c-p,t[8]=u*c+b,t[1]=l*d,t[5]=b*c+u,t[9]=p*c-f,t[2]=-c,t[6]=o*l,t[10]=a*l}else if(e.order==="YZX"){let u=a*l,p=a*c,f=o*l,b=o*c;t[0]=l*h,t[4]=b-u*d,t[8]=f*d+p,t[1]=d,t[5]=a*h,t[9]=-o*h,t[2]=-c*h,t[6]=p*d+f,t[10]=u-b*d}else if(e.order==="XZY"){let u=a*l,p=a*c,f=o*l,b=o*c;t[0]=l*h,t[4]=-d,t[8]=c*h,t[1]=u*d+b,t[5]=a*h,t[9]=p*d-f,t[2]=f*d-p,t[6]=o*h,t[10]=b*d+u}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(nv,e,iv)}lookAt(e,t,i){let r=this.elements;return xn.subVectors(e,t),xn.lengthSq()===0&&(xn.z=1),xn.normalize(),rr.crossVectors(i,xn),rr.lengthSq()===0&&(Math.abs(i.z)===1?xn.x+=1e-4:xn.z+=1e-4,xn.normalize(),rr.crossVectors(i,xn)),rr.normalize(),Ml.crossVectors(xn,rr),r[0]=rr.x,r[4]=Ml.x,r[8]=xn.x,r[1]=rr.y,r[5]=Ml.y,r[9]=xn.y,r[2]=rr.z,r[6]=Ml.z,r[10]=xn.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,r=t.elements,s=this.elements,a=i[0],o=i[4],l=i[8],c=i[12],h=i[1],d=i[5],u=i[9],p=i[13],f=i[2],b=i[6],m=i[10],g=i[14],y=i[3],_=i[7],x=i[11],E=i[15],w=r[0],v=r[4],A=r[8],L=r[12],R=r[1],N=r[5],z=r[9],H=r[13],P=r[2],W=r[6],B=r[10],O=r[14],Q=r[3],G=r[7],Y=r[11],ee=r[15];return s[0]=a*w+o*R+l*P+c*Q,s[4]=a*v+o*N+l*W+c*G,s[8]=a*A+o*z+l*B+c*Y,s[12]=a*L+o*H+l*O+c*ee,s[1]=h*w+d*R+u*P+p*Q,s[5]=h*v+d*N+u*W+p*G,s[9]=h*A+d*z+u*B+p*Y,s[13]=h*L+d*H+u*O+p*ee,s[2]=f*w+b*R+m*P+g*Q,s[6]=f*v+b*N+m*W+g*G,s[10]=f*A+b*z+m*B+g*Y,s[14]=f*L+b*H+m*O+g*ee,s[3]=y*w+_*R+x*P+E*Q,s[7]=y*v+_*N+x*W+E*G,s[11]=y*A+_*z+x*B+E*Y,s[15]=y*L+_*H+x*O+E*ee,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[4],r=e[8],s=e[12],a=e[1],o=e[5],l=e[9],c=e[13],h=e[2],d=e[6],u=e[10],p=e[14],f=e[3],b=e[7],m=e[11],g=e[15],y=l*p-c*u,_=o*p-c*d,x=o*u-l*d,E=a*p-c*h,w=a*u-l*h,v=a*d-o*h;return t*(b*y-m*_+g*x)-i*(f*y-m*E+g*w)+r*(f*_-b*E+g*v)-s*(f*x-b*w+m*v)}determinantAffine(){let e=this.elements,t=e[0],i=e[4],r=e[8],s=e[1],a=e[5],o=e[9],l=e[2],c=e[6],h=e[10];return t*(a*h-o*c)-i*(s*h-o*l)+r*(s*c-a*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){let r=this.elements;return e.isVector3?(r[12]=e.x,r[13]=e.y,r[14]=e.z):(r[12]=e,r[13]=t,r[14]=i),this}invert(){let e=this.elements,t=e[0],i=e[1],r=e[2],s=e[3],a=e[4],o=e[5],l=e[6],c=e[7],h=e[8],d=e[9],u=e[10],p=e[11],f=e[12],b=e[13],m=e[14],g=e[15],y=t*o-i*a,_=t*l-r*a,x=t*c-s*a,E=i*l-r*o,w=i*c-s*o,v=r*c-s*l,A=h*b-d*f,L=h*m-u*f,R=h*g-p*f,N=d*m-u*b,z=d*g-p*b,H=u*g-p*m,P=y*H-_*z+x*N+E*R-w*L+v*A;if(P===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let W=1/P;return e[0]=(o*H-l*z+c*N)*W,e[1]=(r*z-i*H-s*N)*W,e[2]=(b*v-m*w+g*E)*W,e[3]=(u*w-d*v-p*E)*W,e[4]=(l*R-a*H-c*L)*W,e[5]=(t*H-r*R+s*L)*W,e[6]=(m*x-f*v-g*_)*W,e[7]=(h*v-u*x+p*_)*W,e[8]=(a*z-o*R+c*A)*W,e[9]=(i*R-t*z-s*A)*W,e[10]=(f*w-b*x+g*y)*W,e[11]=(d*x-h*w-p*y)*W,e[12]=(o*L-a*N-l*A)*W,e[13]=(t*N-i*L+r*A)*W,e[14]=(b*_-f*E-m*y)*W,e[15]=(h*E-d*_+u*y)*W,this}scale(e){let t=this.elements,i=e.x,r=e.y,s=e.z;return t[0]*=i,t[4]*=r,t[8]*=s,t[1]*=i,t[5]*=r,t[9]*=s,t[2]*=i,t[6]*=r,t[10]*=s,t[3]*=i,t[7]*=r,t[11]*=s,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],r=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,r))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let i=Math.cos(t),r=Math.sin(t),s=1-i,a=e.x,o=e.y,l=e.z,c=s*a,h=s*o;return this.set(c*a+i,c*o-r*l,c*l+r*o,0,c*o+r*l,h*o+i,h*l-r*a,0,c*l-r*o,h*l+r*a,s*l*l+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,r,s,a){return this.set(1,i,s,0,e,1,a,0,t,r,1,0,0,0,0,1),this}compose(e,t,i){let r=this.elements,s=t._x,a=t._y,o=t._z,l=t._w,c=s+s,h=a+a,d=o+o,u=s*c,p=s*h,f=s*d,b=a*h,m=a*d,g=o*d,y=l*c,_=l*h,x=l*d,E=i.x,w=i.y,v=i.z;return r[0]=(1-(b+g))*E,r[1]=(p+x)*E,r[2]=(f-_)*E,r[3]=0,r[4]=(p-x)*w,r[5]=(1-(u+g))*w,r[6]=(m+y)*w,r[7]=0,r[8]=(f+_)*v,r[9]=(m-y)*v,r[10]=(1-(u+b))*v,r[11]=0,r[12]=e.x,r[13]=e.y,r[14]=e.z,r[15]=1,this}decompose(e,t,i){let r=this.elements;e.x=r[12],e.y=r[13],e.z=r[14];let s=this.determinantAffine();if(s===0)return i.set(1,1,1),t.identity(),this;let a=Ps.set(r[0],r[1],r[2]).length(),o=Ps.set(r[4],r[5],r[6]).length(),l=Ps.set(r[8],r[9],r[10]).length();s<0&&(a=-a),ei.copy(this);let c=1/a,h=1/o,d=1/l;return ei.elements[0]*=c,ei.elements[1]*=c,ei.elements[2]*=c,ei.elements[4]*=h,ei.elements[5]*=h,ei.elements[6]*=h,ei.elements[8]*=d,ei.elements[9]*=d,ei.elements[10]*=d,t.setFromRotationMatrix(ei),i.x=a,i.y=o,i.z=l,this}makePerspective(e,t,i,r,s,a,o=kn,l=!1){let c=this.elements,h=2*s/(t-e),d=2*s/(i-r),u=(t+e)/(t-e),p=(i+r)/(i-r),f,b;if(l)f=s/(a-s),b=a*s/(a-s);else if(o===kn)f=-(a+s)/(a-s),b=-2*a*s/(a-s);else if(o===qa)f=-a/(a-s),b=-a*s/(a-s);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+o);return c[0]=h,c[4]=0,c[8]=u,c[12]=0,c[1]=0,c[5]=d,c[9]=p,c[13]=0,c[2]=0,c[6]=0,c[10]=f,c[14]=b,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,i,r,s,a,o=kn,l=!1){let c=this.elements,h=2/(t-e),d=2/(i-r),u=-(t+e)/(t-e),p=-(i+r)/(i-r),f,b;if(l)f=1/(a-s),b=a/(a-s);else if(o===kn)f=-2/(a-s),b=-(a+s)/(a-s);else if(o===qa)f=-1/(a-s),b=-s/(a-s);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+o);return c[0]=h,c[4]=0,c[8]=0,c[12]=u,c[1]=0,c[5]=d,c[9]=0,c[13]=p,c[2]=0,c[6]=0,c[10]=f,c[14]=b,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,i=e.elements;for(let r=0;r<16;r++)if(t[r]!==i[r])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}},Ps=new U,ei=new pt,nv=new U(0,0,0),iv=new U(1,1,1),rr=new U,Ml=new U,xn=new U,P0=new pt,I0=new yi,hr=class n{constructor(e=0,t=0,i=0,r=n.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=r}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,r=this._order){return this._x=e,this._y=t,this._z=i,this._order=r,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){let r=e.elements,s=r[0],a=r[4],o=r[8],l=r[1],c=r[5],h=r[9],d=r[2],u=r[6],p=r[10];switch(t){case"XYZ":this._y=Math.asin(et(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(-h,p),this._z=Math.atan2(-a,s)):(this._x=Math.atan2(u,c),this._z=0);break;case"YXZ":this._x=Math.asin(-et(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(o,p),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-d,s),this._z=0);break;case"ZXY":this._x=Math.asin(et(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(-d,p),this._z=Math.atan2(-a,c)):(this._y=0,this._z=Math.atan2(l,s));break;case"ZYX":this._y=Math.asin(-et(d,-1,1)),Math.abs(d)<.9999999?(this._x=Math.atan2(u,p),this._z=Math.atan2(l,s)):(this._x=0,this._z=Math.atan2(-a,c));break;case"YZX":this._z=Math.asin(et(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-d,s)):(this._x=0,this._y=Math.atan2(o,p));break;case"XZY":this._z=Math.asin(-et(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(u,c),this._y=Math.atan2(o,s)):(this._x=Math.atan2(-h,p),this._y=0);break;default:Le("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return P0.makeRotationFromQuaternion(e),this.setFromRotationMatrix(P0,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return I0.setFromEuler(this),this.setFromQuaternion(I0,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};hr.DEFAULT_ORDER="XYZ";var Wa=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},rv=0,N0=new U,Is=new yi,Ri=new pt,wl=new U,La=new U,sv=new U,av=new yi,L0=new U(1,0,0),D0=new U(0,1,0),F0=new U(0,0,1),z0={type:"added"},ov={type:"removed"},Ns={type:"childadded",child:null},ud={type:"childremoved",child:null},wn=class n extends bi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:rv++}),this.uuid=es(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let e=new U,t=new hr,i=new yi,r=new U(1,1,1);function s(){i.setFromEuler(t,!1)}function a(){t.setFromQuaternion(i,void 0,!1)}t._onChange(s),i._onChange(a),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:r},modelViewMatrix:{value:new pt},normalMatrix:{value:new ke}}),this.matrix=new pt,this.matrixWorld=new pt,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Wa,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Is.setFromAxisAngle(e,t),this.quaternion.multiply(Is),this}rotateOnWorldAxis(e,t){return Is.setFromAxisAngle(e,t),this.quaternion.premultiply(Is),this}rotateX(e){return this.rotateOnAxis(L0,e)}rotateY(e){return this.rotateOnAxis(D0,e)}rotateZ(e){return this.rotateOnAxis(F0,e)}translateOnAxis(e,t){return N0.copy(e).applyQuaternion(this.quaternion),this.position.add(N0.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(L0,e)}translateY(e){return this.translateOnAxis(D0,e)}translateZ(e){return this.translateOnAxis(F0,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(Ri.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?wl.copy(e):wl.set(e,t,i);let r=this.parent;this.updateWorldMatrix(!0,!1),La.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Ri.lookAt(La,wl,this.up):Ri.lookAt(wl,La,this.up),this.quaternion.setFromRotationMatrix(Ri),r&&(Ri.extractRotation(r.matrixWorld),Is.setFromRotationMatrix(Ri),this.quaternion.premultiply(Is.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(ze("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(z0),Ns.child=e,this.dispatchEvent(Ns),Ns.child=null):ze("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(ov),ud.child=e,this.dispatchEvent(ud),ud.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),Ri.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),Ri.multiply(e.parent.matrixWorld)),e.applyMatrix4(Ri),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(z0),Ns.child=e,this.dispatchEvent(Ns),Ns.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,r=this.children.length;i<r;i++){let a=this.children[i].getObjectByProperty(e,t);if(a!==void 0)return a}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);let r=this.children;for(let s=0,a=r.length;s<a;s++)r[s].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(La,e,sv),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(La,av,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let i=0,r=t.length;i<r;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let i=0,r=t.length;i<r;i++)t[i].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,i=e.y,r=e.z,s=this.matrix.elements;s[12]+=t-s[0]*t-s[4]*i-s[8]*r,s[13]+=i-s[1]*t-s[5]*i-s[9]*r,s[14]+=r-s[2]*t-s[6]*i-s[10]*r}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let i=0,r=t.length;i<r;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t,i=!1){let r=this.parent;if(e===!0&&r!==null&&r.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),t===!0){let s=this.children;for(let a=0,o=s.length;a<o;a++)s[a].updateWorldMatrix(!1,!0,i)}}toJSON(e){let t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let r={};r.uuid=this.uuid,r.type=this.type,r.name=this.name,r.castShadow=this.castShadow,r.receiveShadow=this.receiveShadow,r.visible=this.visible,r.frustumCulled=this.frustumCulled,r.renderOrder=this.renderOrder,r.static=this.static,r.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(r.userData=this.userData),r.layers=this.layers.mask,r.matrix=this.matrix.toArray(),r.up=this.up.toArray(),this.pivot!==null&&(r.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(r.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(r.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(r.type="InstancedMesh",r.count=this.count,r.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(r.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(r.type="BatchedMesh",r.perObjectFrustumCulled=this.perObjectFrustumCulled,r.sortObjects=this.sortObjects,r.drawRanges=this._drawRanges,r.reservedRanges=this._reservedRanges,r.geometryInfo=this._geometryInfo.map(o=>({...o,boundingBox:o.boundingBox?o.boundingBox.toJSON():void 0,boundingSphere:o.boundingSphere?o.boundingSphere.toJSON():void 0})),r.instanceInfo=this._instanceInfo.map(o=>({...o})),r.availableInstanceIds=this._availableInstanceIds.slice(),r.availableGeometryIds=this._availableGeometryIds.slice(),r.nextIndexStart=this._nextIndexStart,r.nextVertexStart=this._nextVertexStart,r.geometryCount=this._geometryCount,r.maxInstanceCount=this._maxInstanceCount,r.maxVertexCount=this._maxVertexCount,r.maxIndexCount=this._maxIndexCount,r.geometryInitialized=this._geometryInitialized,r.matricesTexture=this._matricesTexture.toJSON(e),r.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(r.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(r.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(r.boundingBox=this.boundingBox.toJSON()));function s(o,l){return o[l.uuid]===void 0&&(o[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?r.background=this.background.toJSON():this.background.isTexture&&(r.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(r.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){r.geometry=s(e.geometries,this.geometry);let o=this.geometry.parameters;if(o!==void 0&&o.shapes!==void 0){let l=o.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let d=l[c];s(e.shapes,d)}else s(e.shapes,l)}}if(this.isSkinnedMesh&&(r.bindMode=this.bindMode,r.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(s(e.skeletons,this.skeleton),r.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let o=[];for(let l=0,c=this.material.length;l<c;l++)o.push(s(e.materials,this.material[l]));r.material=o}else r.material=s(e.materials,this.material);if(this.children.length>0){r.children=[];for(let o=0;o<this.children.length;o++)r.children.push(this.children[o].toJSON(e).object)}if(this.animations.length>0){r.animations=[];for(let o=0;o<this.animations.length;o++){let l=this.animations[o];r.animations.push(s(e.animations,l))}}if(t){let o=a(e.geometries),l=a(e.materials),c=a(e.textures),h=a(e.images),d=a(e.shapes),u=a(e.skeletons),p=a(e.animations),f=a(e.nodes);o.length>0&&(i.geometries=o),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),h.length>0&&(i.images=h),d.length>0&&(i.shapes=d),u.length>0&&(i.skeletons=u),p.length>0&&(i.animations=p),f.length>0&&(i.nodes=f)}return i.object=r,i;function a(o){let l=[];for(let c in o){let h=o[c];delete h.metadata,l.push(h)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){let r=e.children[i];this.add(r.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};wn.DEFAULT_UP=new U(0,1,0);wn.DEFAULT_MATRIX_AUTO_UPDATE=!0;wn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Di=class extends wn{constructor(){super(),this.isGroup=!0,this.type="Group"}},lv={type:"move"},Xs=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Di,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Di,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new U,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new U),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Di,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new U,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new U,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let r=null,s=null,a=null,o=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){a=!0;for(let b of e.hand.values()){let m=t.getJointPose(b,i),g=this._getHandJoint(c,b);m!==null&&(g.matrix.fromArray(m.transform.matrix),g.matrix.decompose(g.position,g.quaternion,g.scale),g.matrixWorldNeedsUpdate=!0,g.jointRadius=m.radius),g.visible=m!==null}let h=c.joints["index-finger-tip"],d=c.joints["thumb-tip"],u=h.position.distanceTo(d.position),p=.02,f=.005;c.inputState.pinching&&u>p+f?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&u<=p-f&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(s=t.getPose(e.gripSpace,i),s!==null&&(l.matrix.fromArray(s.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,s.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(s.linearVelocity)):l.hasLinearVelocity=!1,s.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(s.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));o!==null&&(r=t.getPose(e.targetRaySpace,i),r===null&&s!==null&&(r=s),r!==null&&(o.matrix.fromArray(r.transform.matrix),o.matrix.decompose(o.position,o.quaternion,o.scale),o.matrixWorldNeedsUpdate=!0,r.linearVelocity?(o.hasLinearVelocity=!0,o.linearVelocity.copy(r.linearVelocity)):o.hasLinearVelocity=!1,r.angularVelocity?(o.hasAngularVelocity=!0,o.angularVelocity.copy(r.angularVelocity)):o.hasAngularVelocity=!1,this.dispatchEvent(lv)))}return o!==null&&(o.visible=r!==null),l!==null&&(l.visible=s!==null),c!==null&&(c.visible=a!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let i=new Di;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}},Fg={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},sr={h:0,s:0,l:0},Al={h:0,s:0,l:0};function dd(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}var We=class{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){let r=e;r&&r.isColor?this.copy(r):typeof r=="number"?this.setHex(r):typeof r=="string"&&this.setStyle(r)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=Sn){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,Ke.colorSpaceToWorking(this,t),this}setRGB(e,t,i,r=Ke.workingColorSpace){return this.r=e,this.g=t,this.b=i,Ke.colorSpaceToWorking(this,r),this}setHSL(e,t,i,r=Ke.workingColorSpace){if(e=Ky(e,1),t=et(t,0,1),i=et(i,0,1),t===0)this.r=this.g=this.b=i;else{let s=i<=.5?i*(1+t):i+t-i*t,a=2*i-s;this.r=dd(a,s,e+1/3),this.g=dd(a,s,e),this.b=dd(a,s,e-1/3)}return Ke.colorSpaceToWorking(this,r),this}setStyle(e,t=Sn){function i(s){s!==void 0&&parseFloat(s)<1&&Le("Color: Alpha component of "+e+" will be ignored.")}let r;if(r=/^(\w+)\(([^\)]*)\)/.exec(e)){let s,a=r[1],o=r[2];switch(a){case"rgb":case"rgba":if(s=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return i(s[4]),this.setRGB(Math.min(255,parseInt(s[1],10))/255,Math.min(255,parseInt(s[2],10))/255,Math.min(255,parseInt(s[3],10))/255,t);if(s=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return i(s[4]),this.setRGB(Math.min(100,parseFloat(s[1]))/100,Math.min(100,parseFloat(s[2]))/100,Math.min(100,parseFloat(s[3]))/100,t);break;case"hsl":case"hsla":if(s=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return i(s[4]),this.setHSL(parseFloat(s[1])/360,parseFloat(s[2])/100,parseFloat(s[3])/100,t);break;default:Le("Color: Unknown color model "+e)}}else if(r=/^\#([A-Fa-f\d]+)$/.exec(e)){let s=r[1],a=s.length;if(a===3)return this.setRGB(parseInt(s.charAt(0),16)/15,parseInt(s.charAt(1),16)/15,parseInt(s.charAt(2),16)/15,t);if(a===6)return this.setHex(parseInt(s,16),t);Le("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=Sn){let i=Fg[e.toLowerCase()];return i!==void 0?this.setHex(i,t):Le("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Fi(e.r),this.g=Fi(e.g),this.b=Fi(e.b),this}copyLinearToSRGB(e){return this.r=Vs(e.r),this.g=Vs(e.g),this.b=Vs(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=Sn){return Ke.workingToColorSpace(Jt.copy(this),e),Math.round(et(Jt.r*255,0,255))*65536+Math.round(et(Jt.g*255,0,255))*256+Math.round(et(Jt.b*255,0,255))}getHexString(e=Sn){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=Ke.workingColorSpace){Ke.workingToColorSpace(Jt.copy(this),t);let i=Jt.r,r=Jt.g,s=Jt.b,a=Math.max(i,r,s),o=Math.min(i,r,s),l,c,h=(o+a)/2;if(o===a)l=0,c=0;else{let d=a-o;switch(c=h<=.5?d/(a+o):d/(2-a-o),a){case i:l=(r-s)/d+(r<s?6:0);break;case r:l=(s-i)/d+2;break;case s:l=(i-r)/d+4;break}l/=6}return e.h=l,e.s=c,e.l=h,e}getRGB(e,t=Ke.workingColorSpace){return Ke.workingToColorSpace(Jt.copy(this),t),e.r=Jt.r,e.g=Jt.g,e.b=Jt.b,e}getStyle(e=Sn){Ke.workingToColorSpace(Jt.copy(this),e);let t=Jt.r,i=Jt.g,r=Jt.b;return e!==Sn?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${r.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(r*255)})`}offsetHSL(e,t,i){return this.getHSL(sr),this.setHSL(sr.h+e,sr.s+t,sr.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(sr),e.getHSL(Al);let i=ad(sr.h,Al.h,t),r=ad(sr.s,Al.s,t),s=ad(sr.l,Al.l,t);return this.setHSL(i,r,s),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,i=this.g,r=this.b,s=e.elements;return this.r=s[0]*t+s[3]*i+s[6]*r,this.g=s[1]*t+s[4]*i+s[7]*r,this.b=s[2]*t+s[5]*i+s[8]*r,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Jt=new We;We.NAMES=Fg;var $a=class extends wn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new hr,this.environmentIntensity=1,this.environmentRotation=new hr,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},ti=new U,Pi=new U,pd=new U,Ii=new U,Ls=new U,Ds=new U,O0=new U,fd=new U,md=new U,gd=new U,bd=new ht,yd=new ht,vd=new ht,cr=class n{constructor(e=new U,t=new U,i=new U){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,r){r.subVectors(i,t),ti.subVectors(e,t),r.cross(ti);let s=r.lengthSq();return s>0?r.multiplyScalar(1/Math.sqrt(s)):r.set(0,0,0)}static getBarycoord(e,t,i,r,s){ti.subVectors(r,t),Pi.subVectors(i,t),pd.subVectors(e,t);let a=ti.dot(ti),o=ti.dot(Pi),l=ti.dot(pd),c=Pi.dot(Pi),h=Pi.dot(pd),d=a*c-o*o;if(d===0)return s.set(0,0,0),null;let u=1/d,p=(c*l-o*h)*u,f=(a*h-o*l)*u;return s.set(1-p-f,f,p)}static containsPoint(e,t,i,r){return this.getBarycoord(e,t,i,r,Ii)===null?!1:Ii.x>=0&&Ii.y>=0&&Ii.x+Ii.y<=1}static getInterpolation(e,t,i,r,s,a,o,l){return this.getBarycoord(e,t,i,r,Ii)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(s,Ii.x),l.addScaledVector(a,Ii.y),l.addScaledVector(o,Ii.z),l)}static getInterpolatedAttribute(e,t,i,r,s,a){return bd.setScalar(0),yd.setScalar(0),vd.setScalar(0),bd.fromBufferAttribute(e,t),yd.fromBufferAttribute(e,i),vd.fromBufferAttribute(e,r),a.setScalar(0),a.addScaledVector(bd,s.x),a.addScaledVector(yd,s.y),a.addScaledVector(vd,s.z),a}static isFrontFacing(e,t,i,r){return ti.subVectors(i,t),Pi.subVectors(e,t),ti.cross(Pi).dot(r)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,r){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[r]),this}setFromAttributeAndIndices(e,t,i,r){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,r),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return ti.subVectors(this.c,this.b),Pi.subVectors(this.a,this.b),ti.cross(Pi).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return n.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return n.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,r,s){return n.getInterpolation(e,this.a,this.b,this.c,t,i,r,s)}containsPoint(e){return n.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return n.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let i=this.a,r=this.b,s=this.c,a,o;Ls.subVectors(r,i),Ds.subVectors(s,i),fd.subVectors(e,i);let l=Ls.dot(fd),c=Ds.dot(fd);if(l<=0&&c<=0)return t.copy(i);md.subVectors(e,r);let h=Ls.dot(md),d=Ds.dot(md);if(h>=0&&d<=h)return t.copy(r);let u=l*d-h*c;if(u<=0&&l>=0&&h<=0&&l-h>0)return a=l/(l-h),t.copy(i).addScaledVector(Ls,a);gd.subVectors(e,s);let p=Ls.dot(gd),f=Ds.dot(gd);if(f>=0&&p<=f)return t.copy(s);let b=p*c-l*f;if(b<=0&&c>=0&&f<=0)return o=c/(c-f),t.copy(i).addScaledVector(Ds,o);let m=h*f-p*d;if(m<=0&&d-h>=0&&p-f>=0)return O0.subVectors(s,r),o=(d-h)/(d-h+(p-f)),t.copy(r).addScaledVector(O0,o);let g=1/(m+b+u);return a=b*g,o=u*g,t.copy(i).addScaledVector(Ls,a).addScaledVector(Ds,o)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},ur=class{constructor(e=new U(1/0,1/0,1/0),t=new U(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(ni.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(ni.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let i=ni.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let s=i.getAttribute("position");if(t===!0&&s!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let a=0,o=s.count;a<o;a++)e.isMesh===!0?e.getVertexPosition(a,ni):ni.fromBufferAttribute(s,a),ni.applyMatrix4(e.matrixWorld),this.expandByPoint(ni);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),El.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),El.copy(i.boundingBox)),El.applyMatrix4(e.matrixWorld),this.union(El)}let r=e.children;for(let s=0,a=r.length;s<a;s++)this.expandByObject(r[s],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,ni),ni.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Da),Tl.subVectors(this.max,Da),Fs.subVectors(e.a,Da),zs.subVectors(e.b,Da),Os.subVectors(e.c,Da),ar.subVectors(zs,Fs),or.subVectors(Os,zs),Hr.subVectors(Fs,Os);let t=[0,-ar.z,ar.y,0,-or.z,or.y,0,-Hr.z,Hr.y,ar.z,0,-ar.x,or.z,0,-or.x,Hr.z,0,-Hr.x,-ar.y,ar.x,0,-or.y,or.x,0,-Hr.y,Hr.x,0];return!xd(t,Fs,zs,Os,Tl)||(t=[1,0,0,0,1,0,0,0,1],!xd(t,Fs,zs,Os,Tl))?!1:(Cl.crossVectors(ar,or),t=[Cl.x,Cl.y,Cl.z],xd(t,Fs,zs,Os,Tl))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,ni).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(ni).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(Ni[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),Ni[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),Ni[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),Ni[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),Ni[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),Ni[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),Ni[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),Ni[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(Ni),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},Ni=[new U,new U,new U,new U,new U,new U,new U,new U],ni=new U,El=new ur,Fs=new U,zs=new U,Os=new U,ar=new U,or=new U,Hr=new U,Da=new U,Tl=new U,Cl=new U,Gr=new U;function xd(n,e,t,i,r){for(let s=0,a=n.length-3;s<=a;s+=3){Gr.fromArray(n,s);let o=r.x*Math.abs(Gr.x)+r.y*Math.abs(Gr.y)+r.z*Math.abs(Gr.z),l=e.dot(Gr),c=t.dot(Gr),h=i.dot(Gr);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>o)return!1}return!0}var At=new U,Rl=new Xe,cv=0,Et=class extends bi{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:cv++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=rp,this.updateRanges=[],this.gpuType=En,this.version=0,this._normalizationScale=e!==void 0?ch(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let r=0,s=this.itemSize;r<s;r++)this.array[e+r]=t.array[i+r];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)Rl.fromBufferAttribute(this,t),Rl.applyMatrix3(e),this.setXY(t,Rl.x,Rl.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)At.fromBufferAttribute(this,t),At.applyMatrix3(e),this.setXYZ(t,At.x,At.y,At.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)At.fromBufferAttribute(this,t),At.applyMatrix4(e),this.setXYZ(t,At.x,At.y,At.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)At.fromBufferAttribute(this,t),At.applyNormalMatrix(e),this.setXYZ(t,At.x,At.y,At.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)At.fromBufferAttribute(this,t),At.transformDirection(e),this.setXYZ(t,At.x,At.y,At.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=r,this}setXYZW(e,t,i,r,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),r=this._normalize(r),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=r,this.array[e+3]=s,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Lg(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Dg(e,this.array)}};var Xa=class extends Et{constructor(e,t,i){super(new Uint16Array(e),t,i)}};var Ya=class extends Et{constructor(e,t,i){super(new Uint32Array(e),t,i)}};var Un=class extends Et{constructor(e,t,i){super(new Float32Array(e),t,i)}},hv=new ur,Fa=new U,_d=new U,Xr=class{constructor(e=new U,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let i=this.center;t!==void 0?i.copy(t):hv.setFromPoints(e).getCenter(i);let r=0;for(let s=0,a=e.length;s<a;s++)r=Math.max(r,i.distanceToSquared(e[s]));return this.radius=Math.sqrt(r),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Fa.subVectors(e,this.center);let t=Fa.lengthSq();if(t>this.radius*this.radius){let i=Math.sqrt(t),r=(i-this.radius)*.5;this.center.addScaledVector(Fa,r/i),this.radius+=r}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(_d.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Fa.copy(e.center).add(_d)),this.expandByPoint(Fa.copy(e.center).sub(_d))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},uv=0,On=new pt,Sd=new wn,ks=new U,_n=new ur,za=new ur,Ot=new U,un=class n extends bi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:uv++}),this.uuid=es(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(jy(e)?Ya:Xa)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let s=new ke().getNormalMatrix(e);i.applyNormalMatrix(s),i.needsUpdate=!0}let r=this.attributes.tangent;return r!==void 0&&(r.transformDirection(e),r.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return On.makeRotationFromQuaternion(e),this.applyMatrix4(On),this}rotateX(e){return On.makeRotationX(e),this.applyMatrix4(On),this}rotateY(e){return On.makeRotationY(e),this.applyMatrix4(On),this}rotateZ(e){return On.makeRotationZ(e),this.applyMatrix4(On),this}translate(e,t,i){return On.makeTranslation(e,t,i),this.applyMatrix4(On),this}scale(e,t,i){return On.makeScale(e,t,i),this.applyMatrix4(On),this}lookAt(e){return Sd.lookAt(e),Sd.updateMatrix(),this.applyMatrix4(Sd.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(ks).negate(),this.translate(ks.x,ks.y,ks.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let i=[];for(let r=0,s=e.length;r<s;r++){let a=e[r];i.push(a.x,a.y,a.z||0)}this.setAttribute("position",new Un(i,3))}else{let i=Math.min(e.length,t.count);for(let r=0;r<i;r++){let s=e[r];t.setXYZ(r,s.x,s.y,s.z||0)}e.length>t.count&&Le("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new ur);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){ze("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new U(-1/0,-1/0,-1/0),new U(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,r=t.length;i<r;i++){let s=t[i];_n.setFromBufferAttribute(s),this.morphTargetsRelative?(Ot.addVectors(this.boundingBox.min,_n.min),this.boundingBox.expandByPoint(Ot),Ot.addVectors(this.boundingBox.max,_n.max),this.boundingBox.expandByPoint(Ot)):(this.boundingBox.expandByPoint(_n.min),this.boundingBox.expandByPoint(_n.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&ze('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Xr);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){ze("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new U,1/0);return}if(e){let i=this.boundingSphere.center;if(_n.setFromBufferAttribute(e),t)for(let s=0,a=t.length;s<a;s++){let o=t[s];za.setFromBufferAttribute(o),this.morphTargetsRelative?(Ot.addVectors(_n.min,za.min),_n.expandByPoint(Ot),Ot.addVectors(_n.max,za.max),_n.expandByPoint(Ot)):(_n.expandByPoint(za.min),_n.expandByPoint(za.max))}_n.getCenter(i);let r=0;for(let s=0,a=e.count;s<a;s++)Ot.fromBufferAttribute(e,s),r=Math.max(r,i.distanceToSquared(Ot));if(t)for(let s=0,a=t.length;s<a;s++){let o=t[s],l=this.morphTargetsRelative;for(let c=0,h=o.count;c<h;c++)Ot.fromBufferAttribute(o,c),l&&(ks.fromBufferAttribute(e,c),Ot.add(ks)),r=Math.max(r,i.distanceToSquared(Ot))}this.boundingSphere.radius=Math.sqrt(r),isNaN(this.boundingSphere.radius)&&ze('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){ze("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=t.position,r=t.normal,s=t.uv,a=this.getAttribute("tangent");(a===void 0||a.count!==i.count)&&(a=new Et(new Float32Array(4*i.count),4),this.setAttribute("tangent",a));let o=[],l=[],c=new Uint8Array(i.count);for(let L=0;L<i.count;L++)o[L]=new U,l[L]=new U;let h=new U,d=new U,u=new U,p=new Xe,f=new Xe,b=new Xe,m=new U,g=new U;function y(L,R,N){c[L]=c[R]=c[N]=1,h.fromBufferAttribute(i,L),d.fromBufferAttribute(i,R),u.fromBufferAttribute(i,N),p.fromBufferAttribute(s,L),f.fromBufferAttribute(s,R),b.fromBufferAttribute(s,N),d.sub(h),u.sub(h),f.sub(p),b.sub(p);let z=1/(f.x*b.y-b.x*f.y);isFinite(z)&&(m.copy(d).multiplyScalar(b.y).addScaledVector(u,-f.y).multiplyScalar(z),g.copy(u).multiplyScalar(f.x).addScaledVector(d,-b.x).multiplyScalar(z),o[L].add(m),o[R].add(m),o[N].add(m),l[L].add(g),l[R].add(g),l[N].add(g))}let _=this.groups;_.length===0&&(_=[{start:0,count:e.count}]);for(let L=0,R=_.length;L<R;++L){let N=_[L],z=N.start,H=N.count;for(let P=z,W=z+H;P<W;P+=3)y(e.getX(P+0),e.getX(P+1),e.getX(P+2))}let x=new U,E=new U,w=new U,v=new U;function A(L){w.fromBufferAttribute(r,L),v.copy(w);let R=o[L];x.copy(R),x.sub(w.multiplyScalar(w.dot(R))).normalize(),E.crossVectors(v,R);let z=E.dot(l[L])<0?-1:1;a.setXYZW(L,x.x,x.y,x.z,z)}for(let L=0,R=i.count;L<R;++L)c[L]&&A(L);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==t.count)i=new Et(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let u=0,p=i.count;u<p;u++)i.setXYZ(u,0,0,0);let r=new U,s=new U,a=new U,o=new U,l=new U,c=new U,h=new U,d=new U;if(e)for(let u=0,p=e.count;u<p;u+=3){let f=e.getX(u+0),b=e.getX(u+1),m=e.getX(u+2);r.fromBufferAttribute(t,f),s.fromBufferAttribute(t,b),a.fromBufferAttribute(t,m),h.subVectors(a,s),d.subVectors(r,s),h.cross(d),o.fromBufferAttribute(i,f),l.fromBufferAttribute(i,b),c.fromBufferAttribute(i,m),o.add(h),l.add(h),c.add(h),i.setXYZ(f,o.x,o.y,o.z),i.setXYZ(b,l.x,l.y,l.z),i.setXYZ(m,c.x,c.y,c.z)}else for(let u=0,p=t.count;u<p;u+=3)r.fromBufferAttribute(t,u+0),s.fromBufferAttribute(t,u+1),a.fromBufferAttribute(t,u+2),h.subVectors(a,s),d.subVectors(r,s),h.cross(d),i.setXYZ(u+0,h.x,h.y,h.z),i.setXYZ(u+1,h.x,h.y,h.z),i.setXYZ(u+2,h.x,h.y,h.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)Ot.fromBufferAttribute(e,t),Ot.normalize(),e.setXYZ(t,Ot.x,Ot.y,Ot.z)}toNonIndexed(){function e(o,l){let c=o.array,h=o.itemSize,d=o.normalized,u=new c.constructor(l.length*h),p=0,f=0;for(let b=0,m=l.length;b<m;b++){o.isInterleavedBufferAttribute?p=l[b]*o.data.stride+o.offset:p=l[b]*h;for(let g=0;g<h;g++)u[f++]=c[p++]}return new Et(u,h,d)}if(this.index===null)return Le("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new n,i=this.index.array,r=this.attributes;for(let o in r){let l=r[o],c=e(l,i);t.setAttribute(o,c)}let s=this.morphAttributes;for(let o in s){let l=[],c=s[o];for(let h=0,d=c.length;h<d;h++){let u=c[h],p=e(u,i);l.push(p)}t.morphAttributes[o]=l}t.morphTargetsRelative=this.morphTargetsRelative;let a=this.groups;for(let o=0,l=a.length;o<l;o++){let c=a[o];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let i=this.attributes;for(let l in i){let c=i[l];e.data.attributes[l]=c.toJSON(e.data)}let r={},s=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let d=0,u=c.length;d<u;d++){let p=c[d];h.push(p.toJSON(e.data))}h.length>0&&(r[l]=h,s=!0)}s&&(e.data.morphAttributes=r,e.data.morphTargetsRelative=this.morphTargetsRelative);let a=this.groups;a.length>0&&(e.data.groups=JSON.parse(JSON.stringify(a)));let o=this.boundingSphere;return o!==null&&(e.data.boundingSphere=o.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let i=e.index;i!==null&&this.setIndex(i.clone());let r=e.attributes;for(let c in r){let h=r[c];this.setAttribute(c,h.clone(t))}let s=e.morphAttributes;for(let c in s){let h=[],d=s[c];for(let u=0,p=d.length;u<p;u++)h.push(d[u].clone(t));this.morphAttributes[c]=h}this.morphTargetsRelative=e.morphTargetsRelative;let a=e.groups;for(let c=0,h=a.length;c<h;c++){let d=a[c];this.addGroup(d.start,d.count,d.materialIndex)}let o=e.boundingBox;o!==null&&(this.boundingBox=o.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},ac=class{constructor(e,t){this.isInterleavedBuffer=!0,this.array=e,this.stride=t,this.count=e!==void 0?e.length/t:0,this.usage=rp,this.updateRanges=[],this.version=0,this.uuid=es()}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.array=new e.array.constructor(e.array),this.count=e.count,this.stride=e.stride,this.usage=e.usage,this}copyAt(e,t,i){e*=this.stride,i*=t.stride;for(let r=0,s=this.stride;r<s;r++)this.array[e+r]=t.array[i+r];return this}set(e,t=0){return this.array.set(e,t),this}clone(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=k0(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=this.array.slice(0).buffer);let i=new this.array.constructor(e.arrayBuffers[t]),r=new this.constructor(i,this.stride);return r.setUsage(this.usage),r}onUpload(e){return this.onUploadCallback=e,this}toJSON(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=k0(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let i={uuid:this.uuid,buffer:t,type:this.array.constructor.name,stride:this.stride};return i.usage=this.usage,i}};function k0(n){return n.buffer._uuid===void 0&&(n.buffer._uuid=es()),n.byteOffset===0&&n.byteLength===n.buffer.byteLength?n.buffer._uuid:n.buffer._uuid+":"+n.byteOffset+":"+n.byteLength}var tn=new U,Ys=class n{constructor(e,t,i,r=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=e,this.itemSize=t,this.offset=i,this.normalized=r,this._normalizationScale=e!==void 0?ch(e.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(e){this.data.needsUpdate=e}applyMatrix4(e){for(let t=0,i=this.data.count;t<i;t++)tn.fromBufferAttribute(this,t),tn.applyMatrix4(e),this.setXYZ(t,tn.x,tn.y,tn.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)tn.fromBufferAttribute(this,t),tn.applyNormalMatrix(e),this.setXYZ(t,tn.x,tn.y,tn.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)tn.fromBufferAttribute(this,t),tn.transformDirection(e),this.setXYZ(t,tn.x,tn.y,tn.z);return this}getComponent(e,t){let i=this.array[e*this.data.stride+this.offset+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.data.array[e*this.data.stride+this.offset+t]=i,this}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset]=t,this}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+1]=t,this}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+2]=t,this}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+3]=t,this}getX(e){let t=this.data.array[e*this.data.stride+this.offset];return this.normalized&&(t=this._denormalize(t)),t}getY(e){let t=this.data.array[e*this.data.stride+this.offset+1];return this.normalized&&(t=this._denormalize(t)),t}getZ(e){let t=this.data.array[e*this.data.stride+this.offset+2];return this.normalized&&(t=this._denormalize(t)),t}getW(e){let t=this.data.array[e*this.data.stride+this.offset+3];return this.normalized&&(t=this._denormalize(t)),t}setXY(e,t,i){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.data.array[e+0]=t,this.data.array[e+1]=i,this}setXYZ(e,t,i,r){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),i=this._normalize(i),r=this._normalize(r)),this.data.array[e+0]=t,this.data.array[e+1]=i,this.data.array[e+2]=r,this}setXYZW(e,t,i,r,s){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),i=this._normalize(i),r=this._normalize(r),s=this._normalize(s)),this.data.array[e+0]=t,this.data.array[e+1]=i,this.data.array[e+2]=r,this.data.array[e+3]=s,this}clone(e){if(e===void 0){Ha("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let i=0;i<this.count;i++){let r=i*this.data.stride+this.offset;for(let s=0;s<this.itemSize;s++)t.push(this.data.array[r+s])}return new Et(new this.array.constructor(t),this.itemSize,this.normalized)}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.clone(e)),new n(e.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(e){if(e===void 0){Ha("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let i=0;i<this.count;i++){let r=i*this.data.stride+this.offset;for(let s=0;s<this.itemSize;s++)t.push(this.data.array[r+s])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:t,normalized:this.normalized}}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.toJSON(e)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Lg(e,this.data.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Dg(e,this.data.array)}},Md=new U,dv=new U,pv=new ke,ii=class{constructor(e=new U(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,r){return this.normal.set(e,t,i),this.constant=r,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){let r=Md.subVectors(i,t).cross(dv.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(r,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){let r=e.delta(Md),s=this.normal.dot(r);if(s===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let a=-(e.start.dot(this.normal)+this.constant)/s;return i===!0&&(a<0||a>1)?null:t.copy(e.start).addScaledVector(r,a)}intersectsLine(e){let t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let i=t||pv.getNormalMatrix(e),r=this.coplanarPoint(Md).applyMatrix4(e),s=this.normal.applyMatrix3(i).normalize();return this.constant=-r.dot(s),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},fv=0,dr=class extends bi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:fv++}),this.uuid=es(),this.name="",this.type="Material",this.blending=ea,this.side=gr,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Od,this.blendDst=kd,this.blendEquation=Zr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new We(0,0,0),this.blendAlpha=0,this.depthFunc=Hs,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Sg,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=$l,this.stencilZFail=$l,this.stencilZPass=$l,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let i=e[t];if(i===void 0){Le(`Material: parameter '${t}' has value of undefined.`);continue}let r=this[t];if(r===void 0){Le(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}r&&r.isColor?r.set(i):r&&r.isVector2&&i&&i.isVector2||r&&r.isEuler&&i&&i.isEuler||r&&r.isVector3&&i&&i.isVector3?r.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(s=>s.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function r(s){let a=[];for(let o in s){let l=s[o];delete l.metadata,a.push(l)}return a}if(t){let s=r(e.textures),a=r(e.images);s.length>0&&(i.textures=s),a.length>0&&(i.images=a)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new We().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(i=>new ii().fromJSON(i))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new Xe().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Xe().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,i=null;if(t!==null){let r=t.length;i=new Array(r);for(let s=0;s!==r;++s)i[s]=t[s].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var Li=new U,wd=new U,Pl=new U,Il=new U,Ja=class{constructor(e=new U,t=new U(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Li)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=Li.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Li.copy(this.origin).addScaledVector(this.direction,t),Li.distanceToSquared(e))}distanceSqToSegment(e,t,i,r){wd.copy(e).add(t).multiplyScalar(.5),Pl.copy(t).sub(e).normalize(),Il.copy(this.origin).sub(wd);let s=e.distanceTo(t)*.5,a=-this.direction.dot(Pl),o=Il.dot(this.direction),l=-Il.dot(Pl),c=Il.lengthSq(),h=Math.abs(1-a*a),d,u,p,f;if(h>0)if(d=a*l-o,u=a*o-l,f=s*h,d>=0)if(u>=-f)if(u<=f){let b=1/h;d*=b,u*=b,p=d*(d+a*u+2*o)+u*(a*d+u+2*l)+c}else u=s,d=Math.max(0,-(a*u+o)),p=-d*d+u*(u+2*l)+c;else u=-s,d=Math.max(0,-(a*u+o)),p=-d*d+u*(u+2*l)+c;else u<=-f?(d=Math.max(0,-(-a*s+o)),u=d>0?-s:Math.min(Math.max(-s,-l),s),p=-d*d+u*(u+2*l)+c):u<=f?(d=0,u=Math.min(Math.max(-s,-l),s),p=u*(u+2*l)+c):(d=Math.max(0,-(a*s+o)),u=d>0?s:Math.min(Math.max(-s,-l),s),p=-d*d+u*(u+2*l)+c);else u=a>0?-s:s,d=Math.max(0,-(a*u+o)),p=-d*d+u*(u+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,d),r&&r.copy(wd).addScaledVector(Pl,u),p}intersectSphere(e,t){if(e.radius<0)return null;Li.subVectors(e.center,this.origin);let i=Li.dot(this.direction),r=Li.dot(Li)-i*i,s=e.radius*e.radius;if(r>s)return null;let a=Math.sqrt(s-r),o=i-a,l=i+a;return l<0?null:o<0?this.at(l,t):this.at(o,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){let i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,r,s,a,o,l,c=1/this.direction.x,h=1/this.direction.y,d=1/this.direction.z,u=this.origin;return c>=0?(i=(e.min.x-u.x)*c,r=(e.max.x-u.x)*c):(i=(e.max.x-u.x)*c,r=(e.min.x-u.x)*c),h>=0?(s=(e.min.y-u.y)*h,a=(e.max.y-u.y)*h):(s=(e.max.y-u.y)*h,a=(e.min.y-u.y)*h),i>a||s>r||((s>i||isNaN(i))&&(i=s),(a<r||isNaN(r))&&(r=a),d>=0?(o=(e.min.z-u.z)*d,l=(e.max.z-u.z)*d):(o=(e.max.z-u.z)*d,l=(e.min.z-u.z)*d),i>l||o>r)||((o>i||i!==i)&&(i=o),(l<r||r!==r)&&(r=l),r<0)?null:this.at(i>=0?i:r,t)}intersectsBox(e){return this.intersectBox(e,Li)!==null}intersectTriangle(e,t,i,r,s){let a=this.origin,o=this.direction,l=o.x,c=o.y,h=o.z,d=e.x-a.x,u=e.y-a.y,p=e.z-a.z,f=t.x-a.x,b=t.y-a.y,m=t.z-a.z,g=i.x-a.x,y=i.y-a.y,_=i.z-a.z,x=Math.abs(l),E=Math.abs(c),w=Math.abs(h),v,A,L,R,N,z,H,P,W,B,O,Q;if(x>=E&&x>=w?(L=l,z=d,W=f,Q=g,l>=0?(v=c,A=h,R=u,N=p,H=b,P=m,B=y,O=_):(v=h,A=c,R=p,N=u,H=m,P=b,B=_,O=y)):E>=w?(L=c,z=u,W=b,Q=y,c>=0?(v=h,A=l,R=p,N=d,H=m,P=f,B=_,O=g):(v=l,A=h,R=d,N=p,H=f,P=m,B=g,O=_)):(L=h,z=p,W=m,Q=_,h>=0?(v=l,A=c,R=d,N=u,H=f,P=b,B=g,O=y):(v=c,A=l,R=u,N=d,H=b,P=f,B=y,O=g)),L===0)return null;let G=v/L,Y=A/L,ee=1/L,ye=R-G*z,Ee=N-Y*z,$=H-G*W,ne=P-Y*W,he=B-G*Q,xe=O-Y*Q,ue=he*ne-xe*$,Fe=ye*xe-Ee*he,ft=$*Ee-ne*ye;if(r){if(ue<0||Fe<0||ft<0)return null}else if((ue<0||Fe<0||ft<0)&&(ue>0||Fe>0||ft>0))return null;let Pe=ue+Fe+ft;if(Pe===0)return null;let tt=ee*(ue*z+Fe*W+ft*Q);return(Pe>0?tt<0:tt>0)?null:this.at(tt/Pe,s)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},oc=class extends dr{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new We(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new hr,this.combine=Ud,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},U0=new pt,Wr=new Ja,Nl=new Xr,B0=new U,Ll=new U,Dl=new U,Fl=new U,Ad=new U,zl=new U,q0=new U,Ol=new U,Zt=class extends wn{constructor(e=new un,t=new oc){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let r=t[i[0]];if(r!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let s=0,a=r.length;s<a;s++){let o=r[s].name||String(s);this.morphTargetInfluences.push(0),this.morphTargetDictionary[o]=s}}}}getVertexPosition(e,t){let i=this.geometry,r=i.attributes.position,s=i.morphAttributes.position,a=i.morphTargetsRelative;t.fromBufferAttribute(r,e);let o=this.morphTargetInfluences;if(s&&o){zl.set(0,0,0);for(let l=0,c=s.length;l<c;l++){let h=o[l],d=s[l];h!==0&&(Ad.fromBufferAttribute(d,e),a?zl.addScaledVector(Ad,h):zl.addScaledVector(Ad.sub(t),h))}t.add(zl)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,r=this.material,s=this.matrixWorld;r!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),Nl.copy(i.boundingSphere),Nl.applyMatrix4(s),Wr.copy(e.ray).recast(e.near),!(Nl.containsPoint(Wr.origin)===!1&&(Wr.intersectSphere(Nl,B0)===null||Wr.origin.distanceToSquared(B0)>(e.far-e.near)**2))&&(U0.copy(s).invert(),Wr.copy(e.ray).applyMatrix4(U0),!(i.boundingBox!==null&&Wr.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,Wr)))}_computeIntersections(e,t,i){let r,s=this.geometry,a=this.material,o=s.index,l=s.attributes.position,c=s.attributes.uv,h=s.attributes.uv1,d=s.attributes.normal,u=s.groups,p=s.drawRange;if(o!==null)if(Array.isArray(a))for(let f=0,b=u.length;f<b;f++){let m=u[f],g=a[m.materialIndex],y=Math.max(m.start,p.start),_=Math.min(o.count,Math.min(m.start+m.count,p.start+p.count));for(let x=y,E=_;x<E;x+=3){let w=o.getX(x),v=o.getX(x+1),A=o.getX(x+2);r=kl(this,g,e,i,c,h,d,w,v,A),r&&(r.faceIndex=Math.floor(x/3),r.face.materialIndex=m.materialIndex,t.push(r))}}else{let f=Math.max(0,p.start),b=Math.min(o.count,p.start+p.count);for(let m=f,g=b;m<g;m+=3){let y=o.getX(m),_=o.getX(m+1),x=o.getX(m+2);r=kl(this,a,e,i,c,h,d,y,_,x),r&&(r.faceIndex=Math.floor(m/3),t.push(r))}}else if(l!==void 0)if(Array.isArray(a))for(let f=0,b=u.length;f<b;f++){let m=u[f],g=a[m.materialIndex],y=Math.max(m.start,p.start),_=Math.min(l.count,Math.min(m.start+m.count,p.start+p.count));for(let x=y,E=_;x<E;x+=3){let w=x,v=x+1,A=x+2;r=kl(this,g,e,i,c,h,d,w,v,A),r&&(r.faceIndex=Math.floor(x/3),r.face.materialIndex=m.materialIndex,t.push(r))}}else{let f=Math.max(0,p.start),b=Math.min(l.count,p.start+p.count);for(let m=f,g=b;m<g;m+=3){let y=m,_=m+1,x=m+2;r=kl(this,a,e,i,c,h,d,y,_,x),r&&(r.faceIndex=Math.floor(m/3),t.push(r))}}}};function mv(n,e,t,i,r,s,a,o){let l;if(e.side===rn?l=i.intersectTriangle(a,s,r,!0,o):l=i.intersectTriangle(r,s,a,e.side===gr,o),l===null)return null;Ol.copy(o),Ol.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(Ol);return c<t.near||c>t.far?null:{distance:c,point:Ol.clone(),object:n}}function kl(n,e,t,i,r,s,a,o,l,c){n.getVertexPosition(o,Ll),n.getVertexPosition(l,Dl),n.getVertexPosition(c,Fl);let h=mv(n,e,t,i,Ll,Dl,Fl,q0);if(h){let d=new U;cr.getBarycoord(q0,Ll,Dl,Fl,d),r&&(h.uv=cr.getInterpolatedAttribute(r,o,l,c,d,new Xe)),s&&(h.uv1=cr.getInterpolatedAttribute(s,o,l,c,d,new Xe)),a&&(h.normal=cr.getInterpolatedAttribute(a,o,l,c,d,new U),h.normal.dot(i.direction)>0&&h.normal.multiplyScalar(-1));let u={a:o,b:l,c,normal:new U,materialIndex:0};cr.getNormal(Ll,Dl,Fl,u.normal),h.face=u,h.barycoord=d}return h}var Yr=class extends nn{constructor(e=null,t=1,i=1,r,s,a,o,l,c=Tt,h=Tt,d,u){super(null,a,o,l,c,h,r,s,d,u),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var $r=new Xr,gv=new Xe(.5,.5),Ul=new U,Jr=class{constructor(e=new ii,t=new ii,i=new ii,r=new ii,s=new ii,a=new ii){this.planes=[e,t,i,r,s,a]}set(e,t,i,r,s,a){let o=this.planes;return o[0].copy(e),o[1].copy(t),o[2].copy(i),o[3].copy(r),o[4].copy(s),o[5].copy(a),this}copy(e){let t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=kn,i=!1){let r=this.planes,s=e.elements,a=s[0],o=s[1],l=s[2],c=s[3],h=s[4],d=s[5],u=s[6],p=s[7],f=s[8],b=s[9],m=s[10],g=s[11],y=s[12],_=s[13],x=s[14],E=s[15];if(r[0].setComponents(c-a,p-h,g-f,E-y).normalize(),r[1].setComponents(c+a,p+h,g+f,E+y).normalize(),r[2].setComponents(c+o,p+d,g+b,E+_).normalize(),r[3].setComponents(c-o,p-d,g-b,E-_).normalize(),i)r[4].setComponents(l,u,m,x).normalize(),r[5].setComponents(c-l,p-u,g-m,E-x).normalize();else if(r[4].setComponents(c-l,p-u,g-m,E-x).normalize(),t===kn)r[5].setComponents(c+l,p+u,g+m,E+x).normalize();else if(t===qa)r[5].setComponents(l,u,m,x).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),$r.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),$r.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere($r)}intersectsSprite(e){$r.center.set(0,0,0);let t=gv.distanceTo(e.center);return $r.radius=.7071067811865476+t,$r.applyMatrix4(e.matrixWorld),this.intersectsSphere($r)}intersectsSphere(e){let t=this.planes,i=e.center,r=-e.radius;for(let s=0;s<6;s++)if(t[s].distanceToPoint(i)<r)return!1;return!0}intersectsBox(e){let t=this.planes;for(let i=0;i<6;i++){let r=t[i];if(Ul.x=r.normal.x>0?e.max.x:e.min.x,Ul.y=r.normal.y>0?e.max.y:e.min.y,Ul.z=r.normal.z>0?e.max.z:e.min.z,r.distanceToPoint(Ul)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},V0=new pt,lc=class n{constructor(){this.coordinateSystem=kn,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,i=this._frustums;for(let r=0;r<t.length;r++){let s=t[r];V0.multiplyMatrices(s.projectionMatrix,s.matrixWorldInverse),i[r]===void 0&&(i[r]=new Jr),i[r].setFromProjectionMatrix(V0,s.coordinateSystem,s.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,i=e._frustums;for(let r=0;r<e._count;r++)t[r]===void 0&&(t[r]=new Jr),t[r].copy(i[r]);return this._count=e._count,this}clone(){return new n().copy(this)}};var cc=class extends dr{constructor(e){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new We(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.alphaMap=e.alphaMap,this.size=e.size,this.sizeAttenuation=e.sizeAttenuation,this.fog=e.fog,this}},H0=new pt,Pd=new Ja,Bl=new Xr,ql=new U,Js=class extends wn{constructor(e=new un,t=new cc){super(),this.isPoints=!0,this.type="Points",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,r=this.matrixWorld,s=e.params.Points.threshold,a=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Bl.copy(i.boundingSphere),Bl.applyMatrix4(r),Bl.radius+=s,e.ray.intersectsSphere(Bl)===!1)return;H0.copy(r).invert(),Pd.copy(e.ray).applyMatrix4(H0);let o=s/((this.scale.x+this.scale.y+this.scale.z)/3),l=o*o,c=i.index,d=i.attributes.position;if(c!==null){let u=Math.max(0,a.start),p=Math.min(c.count,a.start+a.count);for(let f=u,b=p;f<b;f++){let m=c.getX(f);ql.fromBufferAttribute(d,m),G0(ql,m,l,r,e,t,this)}}else{let u=Math.max(0,a.start),p=Math.min(d.count,a.start+a.count);for(let f=u,b=p;f<b;f++)ql.fromBufferAttribute(d,f),G0(ql,f,l,r,e,t,this)}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let r=t[i[0]];if(r!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let s=0,a=r.length;s<a;s++){let o=r[s].name||String(s);this.morphTargetInfluences.push(0),this.morphTargetDictionary[o]=s}}}}};function G0(n,e,t,i,r,s,a){let o=Pd.distanceSqToPoint(n);if(o<t){let l=new U;Pd.closestPointToPoint(n,l),l.applyMatrix4(i);let c=r.ray.origin.distanceTo(l);if(c<r.near||c>r.far)return;s.push({distance:c,distanceToRay:Math.sqrt(o),point:l,index:e,face:null,faceIndex:null,barycoord:null,object:a})}}var ja=class extends nn{constructor(e=[],t=Kr,i,r,s,a,o,l,c,h){super(e,t,i,r,s,a,o,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}},Za=class extends nn{constructor(e,t,i,r,s,a,o,l,c){super(e,t,i,r,s,a,o,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}};var Oi=class extends nn{constructor(e,t,i=ri,r,s,a,o=Tt,l=Tt,c,h=zi,d=1){if(h!==zi&&h!==Ui)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let u={width:e,height:t,depth:d};super(u,r,s,a,o,l,h,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new $s(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},Ka=class extends Oi{constructor(e,t=ri,i=Kr,r,s,a=Tt,o=Tt,l,c=zi){let h={width:e,height:e,depth:1},d=[h,h,h,h,h,h];super(e,e,t,i,r,s,a,o,l,c),this.image=d,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},Qa=class extends nn{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},js=class n extends un{constructor(e=1,t=1,i=1,r=1,s=1,a=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:r,heightSegments:s,depthSegments:a};let o=this;r=Math.floor(r),s=Math.floor(s),a=Math.floor(a);let l=[],c=[],h=[],d=[],u=0,p=0;f("z","y","x",-1,-1,i,t,e,a,s,0),f("z","y","x",1,-1,i,t,-e,a,s,1),f("x","z","y",1,1,e,i,t,r,a,2),f("x","z","y",1,-1,e,i,-t,r,a,3),f("x","y","z",1,-1,e,t,i,r,s,4),f("x","y","z",-1,-1,e,t,-i,r,s,5),this.setIndex(l),this.setAttribute("position",new Un(c,3)),this.setAttribute("normal",new Un(h,3)),this.setAttribute("uv",new Un(d,2));function f(b,m,g,y,_,x,E,w,v,A,L){let R=x/v,N=E/A,z=x/2,H=E/2,P=w/2,W=v+1,B=A+1,O=0,Q=0,G=new U;for(let Y=0;Y<B;Y++){let ee=Y*N-H;for(let ye=0;ye<W;ye++){let Ee=ye*R-z;G[b]=Ee*y,G[m]=ee*_,G[g]=P,c.push(G.x,G.y,G.z),G[b]=0,G[m]=0,G[g]=w>0?1:-1,h.push(G.x,G.y,G.z),d.push(ye/v),d.push(1-Y/A),O+=1}}for(let Y=0;Y<A;Y++)for(let ee=0;ee<v;ee++){let ye=u+ee+W*Y,Ee=u+ee+W*(Y+1),$=u+(ee+1)+W*(Y+1),ne=u+(ee+1)+W*Y;l.push(ye,Ee,ne),l.push(Ee,$,ne),Q+=6}o.addGroup(p,Q,L),p+=Q,u+=O}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var eo=class n extends un{constructor(e=1,t=1,i=1,r=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:r};let s=e/2,a=t/2,o=Math.floor(i),l=Math.floor(r),c=o+1,h=l+1,d=e/o,u=t/l,p=[],f=[],b=[],m=[];for(let g=0;g<h;g++){let y=g*u-a;for(let _=0;_<c;_++){let x=_*d-s;f.push(x,-y,0),b.push(0,0,1),m.push(_/o),m.push(1-g/l)}}for(let g=0;g<l;g++)for(let y=0;y<o;y++){let _=y+c*g,x=y+c*(g+1),E=y+1+c*(g+1),w=y+1+c*g;p.push(_,x,w),p.push(x,E,w)}this.setIndex(p),this.setAttribute("position",new Un(f,3)),this.setAttribute("normal",new Un(b,3)),this.setAttribute("uv",new Un(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.widthSegments,e.heightSegments)}};function ts(n){let e={};for(let t in n){e[t]={};for(let i in n[t]){let r=n[t][i];if(W0(r))r.isRenderTargetTexture?(Le("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=r.clone();else if(Array.isArray(r))if(W0(r[0])){let s=[];for(let a=0,o=r.length;a<o;a++)s[a]=r[a].clone();e[t][i]=s}else e[t][i]=r.slice();else e[t][i]=r}}return e}function Qt(n){let e={};for(let t=0;t<n.length;t++){let i=ts(n[t]);for(let r in i)e[r]=i[r]}return e}function W0(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function bv(n){let e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function sp(n){let e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:Ke.workingColorSpace}var zg={clone:ts,merge:Qt},yv=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,vv=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Kt=class extends dr{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=yv,this.fragmentShader=vv,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=ts(e.uniforms),this.uniformsGroups=bv(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let r in this.uniforms){let a=this.uniforms[r].value;a&&a.isTexture?t.uniforms[r]={type:"t",value:a.toJSON(e).uuid}:a&&a.isColor?t.uniforms[r]={type:"c",value:a.getHex()}:a&&a.isVector2?t.uniforms[r]={type:"v2",value:a.toArray()}:a&&a.isVector3?t.uniforms[r]={type:"v3",value:a.toArray()}:a&&a.isVector4?t.uniforms[r]={type:"v4",value:a.toArray()}:a&&a.isMatrix3?t.uniforms[r]={type:"m3",value:a.toArray()}:a&&a.isMatrix4?t.uniforms[r]={type:"m4",value:a.toArray()}:t.uniforms[r]={value:a}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let i={};for(let r in this.extensions)this.extensions[r]===!0&&(i[r]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let i in e.uniforms){let r=e.uniforms[i];switch(this.uniforms[i]={},r.type){case"t":this.uniforms[i].value=t[r.value]||null;break;case"c":this.uniforms[i].value=new We().setHex(r.value);break;case"v2":this.uniforms[i].value=new Xe().fromArray(r.value);break;case"v3":this.uniforms[i].value=new U().fromArray(r.value);break;case"v4":this.uniforms[i].value=new ht().fromArray(r.value);break;case"m3":this.uniforms[i].value=new ke().fromArray(r.value);break;case"m4":this.uniforms[i].value=new pt().fromArray(r.value);break;default:this.uniforms[i].value=r.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},hc=class extends Kt{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var uc=class extends dr{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=xg,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},dc=class extends dr{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function Us(n,e){return!n||n.constructor===e?n:typeof e.BYTES_PER_ELEMENT=="number"?new e(n):Array.prototype.slice.call(n)}function Vl(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var pr=class{constructor(e,t,i,r){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=r!==void 0?r:new t.constructor(i),this.sampleValues=t,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,i=this._cachedIndex,r=t[i],s=t[i-1];e:{t:{let a;n:{i:if(!(e<r)){for(let o=i+2;;){if(r===void 0){if(e<s)break i;return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===o)break;if(s=r,r=t[++i],e<r)break t}a=t.length;break n}if(!(e>=s)){let o=t[1];e<o&&(i=2,s=o);for(let l=i-2;;){if(s===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(r=s,s=t[--i-1],e>=s)break t}a=i,i=0;break n}break e}for(;i<a;){let o=i+a>>>1;e<t[o]?a=o:i=o+1}if(r=t[i],s=t[i-1],s===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(r===void 0)return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,s,r)}return this.interpolate_(i,s,e,r)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,i=this.sampleValues,r=this.valueSize,s=e*r;for(let a=0;a!==r;++a)t[a]=i[s+a];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},pc=class extends pr{constructor(e,t,i,r){super(e,t,i,r),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Td,endingEnd:Td}}intervalChanged_(e,t,i){let r=this.parameterPositions,s=e-2,a=e+1,o=r[s],l=r[a];if(o===void 0)switch(this.getSettings_().endingStart){case Cd:s=e,o=2*t-i;break;case Rd:s=r.length-2,o=t+r[s]-r[s+1];break;default:s=e,o=i}if(l===void 0)switch(this.getSettings_().endingEnd){case Cd:a=e,l=2*i-t;break;case Rd:a=1,l=i+r[1]-r[0];break;default:a=e-1,l=t}let c=(i-t)*.5,h=this.valueSize;this._weightPrev=c/(t-o),this._weightNext=c/(l-i),this._offsetPrev=s*h,this._offsetNext=a*h}interpolate_(e,t,i,r){let s=this.resultBuffer,a=this.sampleValues,o=this.valueSize,l=e*o,c=l-o,h=this._offsetPrev,d=this._offsetNext,u=this._weightPrev,p=this._weightNext,f=(i-t)/(r-t),b=f*f,m=b*f,g=-u*m+2*u*b-u*f,y=(1+u)*m+(-1.5-2*u)*b+(-.5+u)*f+1,_=(-1-p)*m+(1.5+p)*b+.5*f,x=p*m-p*b;for(let E=0;E!==o;++E)s[E]=g*a[h+E]+y*a[c+E]+_*a[l+E]+x*a[d+E];return s}},fc=class extends pr{constructor(e,t,i,r){super(e,t,i,r)}interpolate_(e,t,i,r){let s=this.resultBuffer,a=this.sampleValues,o=this.valueSize,l=e*o,c=l-o,h=(i-t)/(r-t),d=1-h;for(let u=0;u!==o;++u)s[u]=a[c+u]*d+a[l+u]*h;return s}},mc=class extends pr{constructor(e,t,i,r){super(e,t,i,r)}interpolate_(e){return this.copySampleValue_(e-1)}},gc=class extends pr{interpolate_(e,t,i,r){let s=this.resultBuffer,a=this.sampleValues,o=this.valueSize,l=e*o,c=l-o,h=this.inTangents,d=this.outTangents;if(!h||!d){let f=(i-t)/(r-t),b=1-f;for(let m=0;m!==o;++m)s[m]=a[c+m]*b+a[l+m]*f;return s}let u=o*2,p=e-1;for(let f=0;f!==o;++f){let b=a[c+f],m=a[l+f],g=p*u+f*2,y=d[g],_=d[g+1],x=e*u+f*2,E=h[x],w=h[x+1],v=_v(i,t,y,E,r);s[f]=Og(v,b,_,w,m)}return s}};function Og(n,e,t,i,r){let s=1-n;return s*s*s*e+3*s*s*n*t+3*s*n*n*i+n*n*n*r}function xv(n,e,t,i,r){let s=1-n;return 3*s*s*(t-e)+6*s*n*(i-t)+3*n*n*(r-i)}function _v(n,e,t,i,r){let s=(n-e)/(r-e);for(let a=0;a<8;a++){let o=Og(s,e,t,i,r)-n;if(Math.abs(o)<1e-10)break;let l=xv(s,e,t,i,r);if(Math.abs(l)<1e-10)break;s=Math.max(0,Math.min(1,s-o/l))}return s}var An=class{constructor(e,t,i,r){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Us(t,this.TimeBufferType),this.values=Us(i,this.ValueBufferType),this.setInterpolation(r||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,i;if(t.toJSON!==this.toJSON)i=t.toJSON(e);else{i={name:e.name,times:Us(e.times,Array),values:Us(e.values,Array)};let r=e.getInterpolation();r!==e.DefaultInterpolation&&(i.interpolation=r),Vl(e.settings)&&(i.settings={inTangents:Us(e.settings.inTangents,Array),outTangents:Us(e.settings.outTangents,Array)})}return i.type=e.ValueTypeName,i}InterpolantFactoryMethodDiscrete(e){return new mc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new fc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new pc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new gc(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case ka:t=this.InterpolantFactoryMethodDiscrete;break;case tc:t=this.InterpolantFactoryMethodLinear;break;case Wl:t=this.InterpolantFactoryMethodSmooth;break;case Ed:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return Le("KeyframeTrack:",i),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return ka;case this.InterpolantFactoryMethodLinear:return tc;case this.InterpolantFactoryMethodSmooth:return Wl;case this.InterpolantFactoryMethodBezier:return Ed}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let i=0,r=t.length;i!==r;++i)t[i]+=e;Vl(this.settings)&&($0(this.settings.inTangents,e),$0(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let i=0,r=t.length;i!==r;++i)t[i]*=e;Vl(this.settings)&&(X0(this.settings.inTangents,e),X0(this.settings.outTangents,e))}return this}trim(e,t){let i=this.times,r=i.length,s=0,a=r-1;for(;s!==r&&i[s]<e;)++s;for(;a!==-1&&i[a]>t;)--a;if(++a,s!==0||a!==r){s>=a&&(a=Math.max(a,1),s=a-1);let o=this.getValueSize();this.times=i.slice(s,a),this.values=this.values.slice(s*o,a*o)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(ze("KeyframeTrack: Invalid value size in track.",this),e=!1);let i=this.times,r=this.values,s=i.length;s===0&&(ze("KeyframeTrack: Track is empty.",this),e=!1);let a=null;for(let o=0;o!==s;o++){let l=i[o];if(typeof l=="number"&&isNaN(l)){ze("KeyframeTrack: Time is not a valid number.",this,o,l),e=!1;break}if(a!==null&&a>l){ze("KeyframeTrack: Out of order keys.",this,o,l,a),e=!1;break}a=l}if(r!==void 0&&Zy(r))for(let o=0,l=r.length;o!==l;++o){let c=r[o];if(isNaN(c)){ze("KeyframeTrack: Value is not a valid number.",this,o,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),i=this.getValueSize(),r=this.getInterpolation()===Wl,s=e.length-1,a=1;for(let o=1;o<s;++o){let l=!1,c=e[o],h=e[o+1];if(c!==h&&(o!==1||c!==e[0]))if(r)l=!0;else{let d=o*i,u=d-i,p=d+i;for(let f=0;f!==i;++f){let b=t[d+f];if(b!==t[u+f]||b!==t[p+f]){l=!0;break}}}if(l){if(o!==a){e[a]=e[o];let d=o*i,u=a*i;for(let p=0;p!==i;++p)t[u+p]=t[d+p]}++a}}if(s>0){e[a]=e[s];for(let o=s*i,l=a*i,c=0;c!==i;++c)t[l+c]=t[o+c];++a}return a!==e.length?(this.times=e.slice(0,a),this.values=t.slice(0,a*i)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),i=this.constructor,r=new i(this.name,e,t);return r.createInterpolant=this.createInterpolant,Vl(this.settings)&&(r.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),r}};function $0(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]+=e}function X0(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]*=e}An.prototype.ValueTypeName="";An.prototype.TimeBufferType=Float32Array;An.prototype.ValueBufferType=Float32Array;An.prototype.DefaultInterpolation=tc;var fr=class extends An{constructor(e,t,i){super(e,t,i)}};fr.prototype.ValueTypeName="bool";fr.prototype.ValueBufferType=Array;fr.prototype.DefaultInterpolation=ka;fr.prototype.InterpolantFactoryMethodLinear=void 0;fr.prototype.InterpolantFactoryMethodSmooth=void 0;var bc=class extends An{constructor(e,t,i,r){super(e,t,i,r)}};bc.prototype.ValueTypeName="color";var yc=class extends An{constructor(e,t,i,r){super(e,t,i,r)}};yc.prototype.ValueTypeName="number";var vc=class extends pr{constructor(e,t,i,r){super(e,t,i,r)}interpolate_(e,t,i,r){let s=this.resultBuffer,a=this.sampleValues,o=this.valueSize,l=(i-t)/(r-t),c=e*o;for(let h=c+o;c!==h;c+=4)yi.slerpFlat(s,0,a,c-o,a,c,l);return s}},to=class extends An{constructor(e,t,i,r){super(e,t,i,r)}InterpolantFactoryMethodLinear(e){return new vc(this.times,this.values,this.getValueSize(),e)}};to.prototype.ValueTypeName="quaternion";to.prototype.InterpolantFactoryMethodSmooth=void 0;var mr=class extends An{constructor(e,t,i){super(e,t,i)}};mr.prototype.ValueTypeName="string";mr.prototype.ValueBufferType=Array;mr.prototype.DefaultInterpolation=ka;mr.prototype.InterpolantFactoryMethodLinear=void 0;mr.prototype.InterpolantFactoryMethodSmooth=void 0;var xc=class extends An{constructor(e,t,i,r){super(e,t,i,r)}};xc.prototype.ValueTypeName="vector";var _c=class{constructor(e,t,i){let r=this,s=!1,a=0,o=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=i,this._abortController=null,this.itemStart=function(h){o++,s===!1&&r.onStart!==void 0&&r.onStart(h,a,o),s=!0},this.itemEnd=function(h){a++,r.onProgress!==void 0&&r.onProgress(h,a,o),a===o&&(s=!1,r.onLoad!==void 0&&r.onLoad())},this.itemError=function(h){r.onError!==void 0&&r.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,d){return c.push(h,d),this},this.removeHandler=function(h){let d=c.indexOf(h);return d!==-1&&c.splice(d,2),this},this.getHandler=function(h){for(let d=0,u=c.length;d<u;d+=2){let p=c[d],f=c[d+1];if(p.global&&(p.lastIndex=0),p.test(h))return f}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},kg=new _c,Sc=class{constructor(e){this.manager=e!==void 0?e:kg,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let i=this;return new Promise(function(r,s){i.load(e,r,t,s)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};Sc.DEFAULT_MATERIAL_NAME="__DEFAULT";var Hl=new U,Gl=new yi,mi=new U,no=class extends wn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new pt,this.projectionMatrix=new pt,this.projectionMatrixInverse=new pt,this.coordinateSystem=kn,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(Hl,Gl,mi),mi.x===1&&mi.y===1&&mi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Hl,Gl,mi.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(Hl,Gl,mi),mi.x===1&&mi.y===1&&mi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Hl,Gl,mi.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},lr=new U,Y0=new Xe,J0=new Xe,jt=class extends no{constructor(e=50,t=1,i=.1,r=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=r,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=nc*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(sd*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return nc*2*Math.atan(Math.tan(sd*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){lr.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(lr.x,lr.y).multiplyScalar(-e/lr.z),lr.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(lr.x,lr.y).multiplyScalar(-e/lr.z)}getViewSize(e,t){return this.getViewBounds(e,Y0,J0),t.subVectors(J0,Y0)}setViewOffset(e,t,i,r,s,a){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=r,this.view.width=s,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(sd*.5*this.fov)/this.zoom,i=2*t,r=this.aspect*i,s=-.5*r,a=this.view;if(this.view!==null&&this.view.enabled){let l=a.fullWidth,c=a.fullHeight;s+=a.offsetX*r/l,t-=a.offsetY*i/c,r*=a.width/l,i*=a.height/c}let o=this.filmOffset;o!==0&&(s+=e*o/this.getFilmWidth()),this.projectionMatrix.makePerspective(s,s+r,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var Zs=class extends no{constructor(e=-1,t=1,i=1,r=-1,s=.1,a=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=r,this.near=s,this.far=a,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,r,s,a){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=r,this.view.width=s,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,r=(this.top+this.bottom)/2,s=i-e,a=i+e,o=r+t,l=r-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;s+=c*this.view.offsetX,a=s+c*this.view.width,o-=h*this.view.offsetY,l=o-h*this.view.height}this.projectionMatrix.makeOrthographic(s,a,o,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}};var io=class extends un{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(e){return super.copy(e),this.instanceCount=e.instanceCount,this}toJSON(){let e=super.toJSON();return e.instanceCount=this.instanceCount,e.isInstancedBufferGeometry=!0,e}};var Bs=-90,qs=1,Ks=class extends wn{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let r=new jt(Bs,qs,e,t);r.layers=this.layers,this.add(r);let s=new jt(Bs,qs,e,t);s.layers=this.layers,this.add(s);let a=new jt(Bs,qs,e,t);a.layers=this.layers,this.add(a);let o=new jt(Bs,qs,e,t);o.layers=this.layers,this.add(o);let l=new jt(Bs,qs,e,t);l.layers=this.layers,this.add(l);let c=new jt(Bs,qs,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[i,r,s,a,o,l]=t;for(let c of t)this.remove(c);if(e===kn)i.up.set(0,1,0),i.lookAt(1,0,0),r.up.set(0,1,0),r.lookAt(-1,0,0),s.up.set(0,0,-1),s.lookAt(0,1,0),a.up.set(0,0,1),a.lookAt(0,-1,0),o.up.set(0,1,0),o.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===qa)i.up.set(0,-1,0),i.lookAt(-1,0,0),r.up.set(0,-1,0),r.lookAt(1,0,0),s.up.set(0,0,1),s.lookAt(0,1,0),a.up.set(0,0,-1),a.lookAt(0,-1,0),o.up.set(0,-1,0),o.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:r}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[s,a,o,l,c,h]=this.children,d=e.getRenderTarget(),u=e.getActiveCubeFace(),p=e.getActiveMipmapLevel(),f=e.xr.enabled;e.xr.enabled=!1;let b=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let m=!1;e.isWebGLRenderer===!0?m=e.state.buffers.depth.getReversed():m=e.reversedDepthBuffer,e.setRenderTarget(i,0,r),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,s),e.setRenderTarget(i,1,r),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,2,r),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,3,r),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(i,4,r),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),i.texture.mipmapsAutoUpdate=b,e.setRenderTarget(i,5,r),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,h),e.setRenderTarget(d,u,p),e.xr.enabled=f,i.texture.needsPMREMUpdate=!0}},Mc=class extends jt{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var ap="\\[\\]\\.:\\/",Sv=new RegExp("["+ap+"]","g"),op="[^"+ap+"]",Mv="[^"+ap.replace("\\.","")+"]",wv=/((?:WC+[\/:])*)/.source.replace("WC",op),Av=/(WCOD+)?/.source.replace("WCOD",Mv),Ev=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",op),Tv=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",op),Cv=new RegExp("^"+wv+Av+Ev+Tv+"$"),Rv=["material","materials","bones","map"],Id=class{constructor(e,t,i){let r=i||dt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,r)}getValue(e,t){this.bind();let i=this._targetGroup.nCachedObjects_,r=this._bindings[i];r!==void 0&&r.getValue(e,t)}setValue(e,t){let i=this._bindings;for(let r=this._targetGroup.nCachedObjects_,s=i.length;r!==s;++r)i[r].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].unbind()}},dt=class n{constructor(e,t,i){this.path=t,this.parsedPath=i||n.parseTrackName(t),this.node=n.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,i){return e&&e.isAnimationObjectGroup?new n.Composite(e,t,i):new n(e,t,i)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(Sv,"")}static parseTrackName(e){let t=Cv.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let i={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},r=i.nodeName&&i.nodeName.lastIndexOf(".");if(r!==void 0&&r!==-1){let s=i.nodeName.substring(r+1);Rv.indexOf(s)!==-1&&(i.nodeName=i.nodeName.substring(0,r),i.objectName=s)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return i}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let i=e.skeleton.getBoneByName(t);if(i!==void 0)return i}if(e.children){let i=function(s){for(let a=0;a<s.length;a++){let o=s[a];if(o.name===t||o.uuid===t)return o;let l=i(o.children);if(l)return l}return null},r=i(e.children);if(r)return r}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let i=this.resolvedProperty;for(let r=0,s=i.length;r!==s;++r)e[t++]=i[r]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let i=this.resolvedProperty;for(let r=0,s=i.length;r!==s;++r)i[r]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let i=this.resolvedProperty;for(let r=0,s=i.length;r!==s;++r)i[r]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let i=this.resolvedProperty;for(let r=0,s=i.length;r!==s;++r)i[r]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,i=t.objectName,r=t.propertyName,s=t.propertyIndex;if(e||(e=n.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Le("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=t.objectIndex;switch(i){case"materials":if(!e.material){ze("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){ze("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){ze("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let h=0;h<e.length;h++)if(e[h].name===c){c=h;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){ze("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){ze("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[i]===void 0){ze("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[i]}if(c!==void 0){if(e[c]===void 0){ze("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let a=e[r];if(a===void 0){let c=t.nodeName;ze("PropertyBinding: Trying to update property for track: "+c+"."+r+" but it wasn't found.",e);return}let o=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?o=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(o=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(s!==void 0){if(r==="morphTargetInfluences"){if(!e.geometry){ze("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){ze("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[s]!==void 0&&(s=e.morphTargetDictionary[s])}l=this.BindingType.ArrayElement,this.resolvedProperty=a,this.propertyIndex=s}else a.fromArray!==void 0&&a.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=a):Array.isArray(a)?(l=this.BindingType.EntireArray,this.resolvedProperty=a):this.propertyName=r;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][o]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};dt.Composite=Id;dt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};dt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};dt.prototype.GetterByBindingType=[dt.prototype._getValue_direct,dt.prototype._getValue_array,dt.prototype._getValue_arrayElement,dt.prototype._getValue_toArray];dt.prototype.SetterByBindingTypeAndVersioning=[[dt.prototype._setValue_direct,dt.prototype._setValue_direct_setNeedsUpdate,dt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[dt.prototype._setValue_array,dt.prototype._setValue_array_setNeedsUpdate,dt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[dt.prototype._setValue_arrayElement,dt.prototype._setValue_arrayElement_setNeedsUpdate,dt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[dt.prototype._setValue_fromArray,dt.prototype._setValue_fromArray_setNeedsUpdate,dt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var j3=new Float32Array(1);var ro=class extends ac{constructor(e,t,i=1){super(e,t),this.isInstancedInterleavedBuffer=!0,this.meshPerAttribute=i}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}clone(e){let t=super.clone(e);return t.meshPerAttribute=this.meshPerAttribute,t}toJSON(e){let t=super.toJSON(e);return t.isInstancedInterleavedBuffer=!0,t.meshPerAttribute=this.meshPerAttribute,t}};var Nd=class{static{this.prototype.isMatrix2=!0}constructor(e,t,i,r){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,i,r)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let i=0;i<4;i++)this.elements[i]=e[i+t];return this}set(e,t,i,r){let s=this.elements;return s[0]=e,s[2]=t,s[1]=i,s[3]=r,this}};function lp(n,e,t,i){let r=Pv(i);switch(t){case Kd:return n*e;case oo:return n*e/r.components*r.byteLength;case Pc:return n*e/r.components*r.byteLength;case br:return n*e*2/r.components*r.byteLength;case Ic:return n*e*2/r.components*r.byteLength;case Qd:return n*e*3/r.components*r.byteLength;case Tn:return n*e*4/r.components*r.byteLength;case Nc:return n*e*4/r.components*r.byteLength;case lo:case co:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case ho:case uo:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Dc:case zc:return Math.max(n,16)*Math.max(e,8)/4;case Lc:case Fc:return Math.max(n,8)*Math.max(e,8)/2;case Oc:case kc:case Bc:case qc:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case Uc:case po:case Vc:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Hc:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Gc:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case Wc:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case $c:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case Xc:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case Yc:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case Jc:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case jc:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case Zc:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case Kc:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case Qc:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case eh:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case th:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case nh:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case ih:case rh:case sh:return Math.ceil(n/4)*Math.ceil(e/4)*16;case ah:case oh:return Math.ceil(n/4)*Math.ceil(e/4)*8;case fo:case lh:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function Pv(n){switch(n){case sn:case Yd:return{byteLength:1,components:1};case na:case Jd:case si:return{byteLength:2,components:1};case Cc:case Rc:return{byteLength:2,components:4};case ri:case Tc:case En:return{byteLength:4,components:1};case jd:case Zd:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Le("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function a1(){let n=null,e=!1,t=null,i=null;function r(s,a){i=n.requestAnimationFrame(r),t(s,a)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(r),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(s){t=s},setContext:function(s){n=s}}}function Nv(n){let e=new WeakMap;function t(o,l){let c=o.array,h=o.usage,d=c.byteLength,u=n.createBuffer();n.bindBuffer(l,u),n.bufferData(l,c,h),o.onUploadCallback();let p;if(c instanceof Float32Array)p=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)p=n.HALF_FLOAT;else if(c instanceof Uint16Array)o.isFloat16BufferAttribute?p=n.HALF_FLOAT:p=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)p=n.SHORT;else if(c instanceof Uint32Array)p=n.UNSIGNED_INT;else if(c instanceof Int32Array)p=n.INT;else if(c instanceof Int8Array)p=n.BYTE;else if(c instanceof Uint8Array)p=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)p=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:u,type:p,bytesPerElement:c.BYTES_PER_ELEMENT,version:o.version,size:d}}function i(o,l,c){let h=l.array,d=l.updateRanges;if(n.bindBuffer(c,o),d.length===0)n.bufferSubData(c,0,h);else{d.sort((p,f)=>p.start-f.start);let u=0;for(let p=1;p<d.length;p++){let f=d[u],b=d[p];b.start<=f.start+f.count+1?f.count=Math.max(f.count,b.start+b.count-f.start):(++u,d[u]=b)}d.length=u+1;for(let p=0,f=d.length;p<f;p++){let b=d[p];n.bufferSubData(c,b.start*h.BYTES_PER_ELEMENT,h,b.start,b.count)}l.clearUpdateRanges()}l.onUploadCallback()}function r(o){return o.isInterleavedBufferAttribute&&(o=o.data),e.get(o)}function s(o){o.isInterleavedBufferAttribute&&(o=o.data);let l=e.get(o);l&&(n.deleteBuffer(l.buffer),e.delete(o))}function a(o,l){if(o.isInterleavedBufferAttribute&&(o=o.data),o.isGLBufferAttribute){let h=e.get(o);(!h||h.version<o.version)&&e.set(o,{buffer:o.buffer,type:o.type,bytesPerElement:o.elementSize,version:o.version});return}let c=e.get(o);if(c===void 0)e.set(o,t(o,l));else if(c.version<o.version){if(c.size!==o.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,o,l),c.version=o.version}}return{get:r,remove:s,update:a}}var Lv=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,Dv=`#ifdef USE_ALPHAHASH
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
#endif`,Fv=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,zv=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Ov=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,kv=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,Uv=`#ifdef USE_AOMAP
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
#endif`,Bv=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,qv=`#ifdef USE_BATCHING
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
#endif`,Vv=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,Hv=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,Gv=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,Wv=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,$v=`#ifdef USE_IRIDESCENCE
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
#endif`,Xv=`#ifdef USE_BUMPMAP
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
#endif`,Yv=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,Jv=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,jv=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Zv=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,Kv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,Qv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,ex=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,tx=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,nx=`#define PI 3.141592653589793
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
} // validated`,ix=`vec3 transformedNormal = objectNormal;
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
#endif`,rx=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,sx=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,ax=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,ox=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,lx="gl_FragColor = linearToOutputTexel( gl_FragColor );",cx=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,hx=`#ifdef USE_ENVMAP
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
#endif`,ux=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,dx=`#ifdef USE_ENVMAP
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
#endif`,px=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,fx=`#ifdef USE_ENVMAP
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
#endif`,mx=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,gx=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,bx=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,yx=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,vx=`#ifdef USE_GRADIENTMAP
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
}`,xx=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,_x=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,Sx=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Mx=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,wx=`#ifdef USE_ENVMAP
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
#endif`,Ax=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,Ex=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Tx=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Cx=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,Rx=`PhysicalMaterial material;
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
#endif`,Px=`uniform sampler2D dfgLUT;
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
}`,Ix=`
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
#endif`,Nx=`#if defined( RE_IndirectDiffuse )
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
#endif`,Lx=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Dx=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,Fx=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,zx=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Ox=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,kx=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Ux=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Bx=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,qx=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,Vx=`#if defined( USE_POINTS_UV )
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
#endif`,Hx=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Gx=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,Wx=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,$x=`#if defined( USE_MORPHCOLORS )
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
#endif`,Xx=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Yx=`#ifdef USE_MORPHTARGETS
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
#endif`,Jx=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,jx=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,Zx=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,Kx=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Qx=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,e_=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,t_=`#ifdef USE_NORMALMAP
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
#endif`,n_=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,i_=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,r_=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,s_=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,a_=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,o_=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,l_=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,c_=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,h_=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,u_=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,d_=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,p_=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,f_=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,m_=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,g_=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,b_=`float getShadowMask() {
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
}`,y_=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,v_=`#ifdef USE_SKINNING
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
#endif`,x_=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,__=`#ifdef USE_SKINNING
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
#endif`,S_=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,M_=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,w_=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,A_=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,E_=`#ifdef USE_TRANSMISSION
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
#endif`,T_=`#ifdef USE_TRANSMISSION
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
#endif`,C_=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,R_=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,P_=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,I_=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,N_=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,L_=`uniform sampler2D t2D;
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
}`,D_=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,F_=`uniform float backgroundBlurriness;
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
}`,z_=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,O_=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,k_=`#include <common>
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
}`,U_=`#if DEPTH_PACKING == 3200
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
}`,B_=`#define DISTANCE
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
}`,q_=`#define DISTANCE
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
}`,V_=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,H_=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,G_=`uniform float scale;
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
}`,W_=`uniform vec3 diffuse;
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
}`,$_=`#include <common>
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
}`,X_=`uniform vec3 diffuse;
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
}`,Y_=`#define LAMBERT
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
}`,J_=`#define LAMBERT
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
}`,j_=`#define MATCAP
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
}`,Z_=`#define MATCAP
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
}`,K_=`#define NORMAL
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
}`,Q_=`#define NORMAL
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
}`,eS=`#define PHONG
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
}`,tS=`#define PHONG
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
}`,nS=`#define STANDARD
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
}`,iS=`#define STANDARD
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
}`,rS=`#define TOON
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
}`,sS=`#define TOON
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
}`,aS=`uniform float size;
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
}`,oS=`uniform vec3 diffuse;
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
}`,lS=`#include <common>
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
}`,cS=`uniform vec3 color;
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
}`,hS=`uniform float rotation;
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
}`,uS=`uniform vec3 diffuse;
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
}`,$e={alphahash_fragment:Lv,alphahash_pars_fragment:Dv,alphamap_fragment:Fv,alphamap_pars_fragment:zv,alphatest_fragment:Ov,alphatest_pars_fragment:kv,aomap_fragment:Uv,aomap_pars_fragment:Bv,batching_pars_vertex:qv,batching_vertex:Vv,begin_vertex:Hv,beginnormal_vertex:Gv,bsdfs:Wv,iridescence_fragment:$v,bumpmap_pars_fragment:Xv,clipping_planes_fragment:Yv,clipping_planes_pars_fragment:Jv,clipping_planes_pars_vertex:jv,clipping_planes_vertex:Zv,color_fragment:Kv,color_pars_fragment:Qv,color_pars_vertex:ex,color_vertex:tx,common:nx,defaultnormal_vertex:ix,displacementmap_pars_vertex:rx,displacementmap_vertex:sx,emissivemap_fragment:ax,emissivemap_pars_fragment:ox,colorspace_fragment:lx,colorspace_pars_fragment:cx,envmap_fragment:hx,envmap_common_pars_fragment:ux,envmap_pars_fragment:dx,envmap_pars_vertex:px,envmap_physical_pars_fragment:wx,envmap_vertex:fx,fog_vertex:mx,fog_pars_vertex:gx,fog_fragment:bx,fog_pars_fragment:yx,gradientmap_pars_fragment:vx,lightmap_pars_fragment:xx,lights_lambert_fragment:_x,lights_lambert_pars_fragment:Sx,lights_pars_begin:Mx,lights_toon_fragment:Ax,lights_toon_pars_fragment:Ex,lights_phong_fragment:Tx,lights_phong_pars_fragment:Cx,lights_physical_fragment:Rx,lights_physical_pars_fragment:Px,lights_fragment_begin:Ix,lights_fragment_maps:Nx,lights_fragment_end:Lx,lightprobes_pars_fragment:Dx,logdepthbuf_fragment:Fx,logdepthbuf_pars_fragment:zx,logdepthbuf_pars_vertex:Ox,logdepthbuf_vertex:kx,map_fragment:Ux,map_pars_fragment:Bx,map_particle_fragment:qx,map_particle_pars_fragment:Vx,metalnessmap_fragment:Hx,metalnessmap_pars_fragment:Gx,morphinstance_vertex:Wx,morphcolor_vertex:$x,morphnormal_vertex:Xx,morphtarget_pars_vertex:Yx,morphtarget_vertex:Jx,normal_fragment_begin:jx,normal_fragment_maps:Zx,normal_pars_fragment:Kx,normal_pars_vertex:Qx,normal_vertex:e_,normalmap_pars_fragment:t_,clearcoat_normal_fragment_begin:n_,clearcoat_normal_fragment_maps:i_,clearcoat_pars_fragment:r_,iridescence_pars_fragment:s_,opaque_fragment:a_,packing:o_,premultiplied_alpha_fragment:l_,project_vertex:c_,dithering_fragment:h_,dithering_pars_fragment:u_,roughnessmap_fragment:d_,roughnessmap_pars_fragment:p_,shadowmap_pars_fragment:f_,shadowmap_pars_vertex:m_,shadowmap_vertex:g_,shadowmask_pars_fragment:b_,skinbase_vertex:y_,skinning_pars_vertex:v_,skinning_vertex:x_,skinnormal_vertex:__,specularmap_fragment:S_,specularmap_pars_fragment:M_,tonemapping_fragment:w_,tonemapping_pars_fragment:A_,transmission_fragment:E_,transmission_pars_fragment:T_,uv_pars_fragment:C_,uv_pars_vertex:R_,uv_vertex:P_,worldpos_vertex:I_,background_vert:N_,background_frag:L_,backgroundCube_vert:D_,backgroundCube_frag:F_,cube_vert:z_,cube_frag:O_,depth_vert:k_,depth_frag:U_,distance_vert:B_,distance_frag:q_,equirect_vert:V_,equirect_frag:H_,linedashed_vert:G_,linedashed_frag:W_,meshbasic_vert:$_,meshbasic_frag:X_,meshlambert_vert:Y_,meshlambert_frag:J_,meshmatcap_vert:j_,meshmatcap_frag:Z_,meshnormal_vert:K_,meshnormal_frag:Q_,meshphong_vert:eS,meshphong_frag:tS,meshphysical_vert:nS,meshphysical_frag:iS,meshtoon_vert:rS,meshtoon_frag:sS,points_vert:aS,points_frag:oS,shadow_vert:lS,shadow_frag:cS,sprite_vert:hS,sprite_frag:uS},be={common:{diffuse:{value:new We(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new ke},alphaMap:{value:null},alphaMapTransform:{value:new ke},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new ke}},envmap:{envMap:{value:null},envMapRotation:{value:new ke},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new ke}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new ke}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new ke},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new ke},normalScale:{value:new Xe(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new ke},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new ke}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new ke}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new ke}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new We(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new We(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new ke},alphaTest:{value:0},uvTransform:{value:new ke}},sprite:{diffuse:{value:new We(16777215)},opacity:{value:1},center:{value:new Xe(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new ke},alphaMap:{value:null},alphaMapTransform:{value:new ke},alphaTest:{value:0}}},_i={basic:{uniforms:Qt([be.common,be.specularmap,be.envmap,be.aomap,be.lightmap,be.fog]),vertexShader:$e.meshbasic_vert,fragmentShader:$e.meshbasic_frag},lambert:{uniforms:Qt([be.common,be.specularmap,be.envmap,be.aomap,be.lightmap,be.emissivemap,be.bumpmap,be.normalmap,be.displacementmap,be.fog,be.lights,{emissive:{value:new We(0)},envMapIntensity:{value:1}}]),vertexShader:$e.meshlambert_vert,fragmentShader:$e.meshlambert_frag},phong:{uniforms:Qt([be.common,be.specularmap,be.envmap,be.aomap,be.lightmap,be.emissivemap,be.bumpmap,be.normalmap,be.displacementmap,be.fog,be.lights,{emissive:{value:new We(0)},specular:{value:new We(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:$e.meshphong_vert,fragmentShader:$e.meshphong_frag},standard:{uniforms:Qt([be.common,be.envmap,be.aomap,be.lightmap,be.emissivemap,be.bumpmap,be.normalmap,be.displacementmap,be.roughnessmap,be.metalnessmap,be.fog,be.lights,{emissive:{value:new We(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:$e.meshphysical_vert,fragmentShader:$e.meshphysical_frag},toon:{uniforms:Qt([be.common,be.aomap,be.lightmap,be.emissivemap,be.bumpmap,be.normalmap,be.displacementmap,be.gradientmap,be.fog,be.lights,{emissive:{value:new We(0)}}]),vertexShader:$e.meshtoon_vert,fragmentShader:$e.meshtoon_frag},matcap:{uniforms:Qt([be.common,be.bumpmap,be.normalmap,be.displacementmap,be.fog,{matcap:{value:null}}]),vertexShader:$e.meshmatcap_vert,fragmentShader:$e.meshmatcap_frag},points:{uniforms:Qt([be.points,be.fog]),vertexShader:$e.points_vert,fragmentShader:$e.points_frag},dashed:{uniforms:Qt([be.common,be.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:$e.linedashed_vert,fragmentShader:$e.linedashed_frag},depth:{uniforms:Qt([be.common,be.displacementmap]),vertexShader:$e.depth_vert,fragmentShader:$e.depth_frag},normal:{uniforms:Qt([be.common,be.bumpmap,be.normalmap,be.displacementmap,{opacity:{value:1}}]),vertexShader:$e.meshnormal_vert,fragmentShader:$e.meshnormal_frag},sprite:{uniforms:Qt([be.sprite,be.fog]),vertexShader:$e.sprite_vert,fragmentShader:$e.sprite_frag},background:{uniforms:{uvTransform:{value:new ke},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:$e.background_vert,fragmentShader:$e.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new ke}},vertexShader:$e.backgroundCube_vert,fragmentShader:$e.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:$e.cube_vert,fragmentShader:$e.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:$e.equirect_vert,fragmentShader:$e.equirect_frag},distance:{uniforms:Qt([be.common,be.displacementmap,{referencePosition:{value:new U},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:$e.distance_vert,fragmentShader:$e.distance_frag},shadow:{uniforms:Qt([be.lights,be.fog,{color:{value:new We(0)},opacity:{value:1}}]),vertexShader:$e.shadow_vert,fragmentShader:$e.shadow_frag}};_i.physical={uniforms:Qt([_i.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new ke},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new ke},clearcoatNormalScale:{value:new Xe(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new ke},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new ke},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new ke},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new ke},sheen:{value:0},sheenColor:{value:new We(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new ke},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new ke},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new ke},transmissionSamplerSize:{value:new Xe},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new ke},attenuationDistance:{value:0},attenuationColor:{value:new We(0)},specularColor:{value:new We(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new ke},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new ke},anisotropyVector:{value:new Xe},anisotropyMap:{value:null},anisotropyMapTransform:{value:new ke}}]),vertexShader:$e.meshphysical_vert,fragmentShader:$e.meshphysical_frag};var hh={r:0,b:0,g:0},dS=new pt,o1=new ke;o1.set(-1,0,0,0,1,0,0,0,1);function pS(n,e,t,i,r,s){let a=new We(0),o=r===!0?0:1,l,c,h=null,d=0,u=null;function p(y){let _=y.isScene===!0?y.background:null;if(_&&_.isTexture){let x=y.backgroundBlurriness>0;_=e.get(_,x)}return _}function f(y){let _=!1,x=p(y);x===null?m(a,o):x&&x.isColor&&(m(x,1),_=!0);let E=n.xr.getEnvironmentBlendMode();E==="additive"?t.buffers.color.setClear(0,0,0,1,s):E==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,s),(n.autoClear||_)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function b(y,_){let x=p(_);x&&x.isCubeTexture?(c===void 0&&(c=new Zt(new js(1,1,1),new Kt({name:"BackgroundCubeMaterial",uniforms:ts(_i.backgroundCube.uniforms),vertexShader:_i.backgroundCube.vertexShader,fragmentShader:_i.backgroundCube.fragmentShader,side:rn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(E,w,v){this.matrixWorld.copyPosition(v.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=x,c.material.uniforms.backgroundBlurriness.value=_.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=_.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(dS.makeRotationFromEuler(_.backgroundRotation)).transpose(),x.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(o1),c.material.toneMapped=Ke.getTransfer(x.colorSpace)!==at,(h!==x||d!==x.version||u!==n.toneMapping)&&(c.material.needsUpdate=!0,h=x,d=x.version,u=n.toneMapping),c.layers.enableAll(),y.unshift(c,c.geometry,c.material,0,0,null)):x&&x.isTexture&&(l===void 0&&(l=new Zt(new eo(2,2),new Kt({name:"BackgroundMaterial",uniforms:ts(_i.background.uniforms),vertexShader:_i.background.vertexShader,fragmentShader:_i.background.fragmentShader,side:gr,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=x,l.material.uniforms.backgroundIntensity.value=_.backgroundIntensity,l.material.toneMapped=Ke.getTransfer(x.colorSpace)!==at,x.matrixAutoUpdate===!0&&x.updateMatrix(),l.material.uniforms.uvTransform.value.copy(x.matrix),(h!==x||d!==x.version||u!==n.toneMapping)&&(l.material.needsUpdate=!0,h=x,d=x.version,u=n.toneMapping),l.layers.enableAll(),y.unshift(l,l.geometry,l.material,0,0,null))}function m(y,_){y.getRGB(hh,sp(n)),t.buffers.color.setClear(hh.r,hh.g,hh.b,_,s)}function g(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return a},setClearColor:function(y,_=1){a.set(y),o=_,m(a,o)},getClearAlpha:function(){return o},setClearAlpha:function(y){o=y,m(a,o)},render:f,addToRenderList:b,dispose:g}}function fS(n,e){let t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},r=u(null),s=r,a=!1;function o(N,z,H,P,W){let B=!1,O=d(N,P,H,z);s!==O&&(s=O,c(s.object)),B=p(N,P,H,W),B&&f(N,P,H,W),W!==null&&e.update(W,n.ELEMENT_ARRAY_BUFFER),(B||a)&&(a=!1,x(N,z,H,P),W!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(W).buffer))}function l(){return n.createVertexArray()}function c(N){return n.bindVertexArray(N)}function h(N){return n.deleteVertexArray(N)}function d(N,z,H,P){let W=P.wireframe===!0,B=i[z.id];B===void 0&&(B={},i[z.id]=B);let O=N.isInstancedMesh===!0?N.id:0,Q=B[O];Q===void 0&&(Q={},B[O]=Q);let G=Q[H.id];G===void 0&&(G={},Q[H.id]=G);let Y=G[W];return Y===void 0&&(Y=u(l()),G[W]=Y),Y}function u(N){let z=[],H=[],P=[];for(let W=0;W<t;W++)z[W]=0,H[W]=0,P[W]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:z,enabledAttributes:H,attributeDivisors:P,object:N,attributes:{},index:null}}function p(N,z,H,P){let W=s.attributes,B=z.attributes,O=0,Q=H.getAttributes();for(let G in Q)if(Q[G].location>=0){let ee=W[G],ye=B[G];if(ye===void 0&&(G==="instanceMatrix"&&N.instanceMatrix&&(ye=N.instanceMatrix),G==="instanceColor"&&N.instanceColor&&(ye=N.instanceColor)),ee===void 0||ee.attribute!==ye||ye&&ee.data!==ye.data)return!0;O++}return s.attributesNum!==O||s.index!==P}function f(N,z,H,P){let W={},B=z.attributes,O=0,Q=H.getAttributes();for(let G in Q)if(Q[G].location>=0){let ee=B[G];ee===void 0&&(G==="instanceMatrix"&&N.instanceMatrix&&(ee=N.instanceMatrix),G==="instanceColor"&&N.instanceColor&&(ee=N.instanceColor));let ye={};ye.attribute=ee,ee&&ee.data&&(ye.data=ee.data),W[G]=ye,O++}s.attributes=W,s.attributesNum=O,s.index=P}function b(){let N=s.newAttributes;for(let z=0,H=N.length;z<H;z++)N[z]=0}function m(N){g(N,0)}function g(N,z){let H=s.newAttributes,P=s.enabledAttributes,W=s.attributeDivisors;H[N]=1,P[N]===0&&(n.enableVertexAttribArray(N),P[N]=1),W[N]!==z&&(n.vertexAttribDivisor(N,z),W[N]=z)}function y(){let N=s.newAttributes,z=s.enabledAttributes;for(let H=0,P=z.length;H<P;H++)z[H]!==N[H]&&(n.disableVertexAttribArray(H),z[H]=0)}function _(N,z,H,P,W,B,O){O===!0?n.vertexAttribIPointer(N,z,H,W,B):n.vertexAttribPointer(N,z,H,P,W,B)}function x(N,z,H,P){b();let W=P.attributes,B=H.getAttributes(),O=z.defaultAttributeValues;for(let Q in B){let G=B[Q];if(G.location>=0){let Y=W[Q];if(Y===void 0&&(Q==="instanceMatrix"&&N.instanceMatrix&&(Y=N.instanceMatrix),Q==="instanceColor"&&N.instanceColor&&(Y=N.instanceColor)),Y!==void 0){let ee=Y.normalized,ye=Y.itemSize,Ee=e.get(Y);if(Ee===void 0)continue;let $=Ee.buffer,ne=Ee.type,he=Ee.bytesPerElement,xe=ne===n.INT||ne===n.UNSIGNED_INT||Y.gpuType===Tc;if(Y.isInterleavedBufferAttribute){let ue=Y.data,Fe=ue.isInterleavedBuffer===!0?ue.stride:ue.itemSize,ft=Y.offset;if(ue.isInstancedInterleavedBuffer||ue.isInstancedBufferAttribute){for(let Pe=0;Pe<G.locationSize;Pe++)g(G.location+Pe,ue.meshPerAttribute);N.isInstancedMesh!==!0&&P._maxInstanceCount===void 0&&(P._maxInstanceCount=ue.meshPerAttribute*ue.count)}else for(let Pe=0;Pe<G.locationSize;Pe++)m(G.location+Pe);n.bindBuffer(n.ARRAY_BUFFER,$);for(let Pe=0;Pe<G.locationSize;Pe++)_(G.location+Pe,ye/G.locationSize,ne,ee,Fe*he,(ft+ye/G.locationSize*Pe)*he,xe)}else{if(Y.isInstancedBufferAttribute){for(let ue=0;ue<G.locationSize;ue++)g(G.location+ue,Y.meshPerAttribute);N.isInstancedMesh!==!0&&P._maxInstanceCount===void 0&&(P._maxInstanceCount=Y.meshPerAttribute*Y.count)}else for(let ue=0;ue<G.locationSize;ue++)m(G.location+ue);n.bindBuffer(n.ARRAY_BUFFER,$);for(let ue=0;ue<G.locationSize;ue++)_(G.location+ue,ye/G.locationSize,ne,ee,ye*he,ye/G.locationSize*ue*he,xe)}}else if(O!==void 0){let ee=O[Q];if(ee!==void 0)switch(ee.length){case 2:n.vertexAttrib2fv(G.location,ee);break;case 3:n.vertexAttrib3fv(G.location,ee);break;case 4:n.vertexAttrib4fv(G.location,ee);break;default:n.vertexAttrib1fv(G.location,ee)}}}}y()}function E(){L();for(let N in i){let z=i[N];for(let H in z){let P=z[H];for(let W in P){let B=P[W];for(let O in B)h(B[O].object),delete B[O];delete P[W]}}delete i[N]}}function w(N){if(i[N.id]===void 0)return;let z=i[N.id];for(let H in z){let P=z[H];for(let W in P){let B=P[W];for(let O in B)h(B[O].object),delete B[O];delete P[W]}}delete i[N.id]}function v(N){for(let z in i){let H=i[z];for(let P in H){let W=H[P];if(W[N.id]===void 0)continue;let B=W[N.id];for(let O in B)h(B[O].object),delete B[O];delete W[N.id]}}}function A(N){for(let z in i){let H=i[z],P=N.isInstancedMesh===!0?N.id:0,W=H[P];if(W!==void 0){for(let B in W){let O=W[B];for(let Q in O)h(O[Q].object),delete O[Q];delete W[B]}delete H[P],Object.keys(H).length===0&&delete i[z]}}}function L(){R(),a=!0,s!==r&&(s=r,c(s.object))}function R(){r.geometry=null,r.program=null,r.wireframe=!1}return{setup:o,reset:L,resetDefaultState:R,dispose:E,releaseStatesOfGeometry:w,releaseStatesOfObject:A,releaseStatesOfProgram:v,initAttributes:b,enableAttribute:m,disableUnusedAttributes:y}}function mS(n,e,t){let i;function r(l){i=l}function s(l,c){n.drawArrays(i,l,c),t.update(c,i,1)}function a(l,c,h){h!==0&&(n.drawArraysInstanced(i,l,c,h),t.update(c,i,h))}function o(l,c,h){if(h===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,h);let u=0;for(let p=0;p<h;p++)u+=c[p];t.update(u,i,1)}this.setMode=r,this.render=s,this.renderInstances=a,this.renderMultiDraw=o}function gS(n,e,t,i){let r;function s(){if(r!==void 0)return r;if(e.has("EXT_texture_filter_anisotropic")===!0){let v=e.get("EXT_texture_filter_anisotropic");r=n.getParameter(v.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else r=0;return r}function a(v){return!(v!==Tn&&i.convert(v)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function o(v){let A=v===si&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(v!==sn&&v!==En&&!A&&i.convert(v)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(v){if(v==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";v="mediump"}return v==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",h=l(c);h!==c&&(Le("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let d=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),u=t.logarithmicDepthBuffer===!0&&d===!1;t.reversedDepthBuffer===!0&&d===!1&&Le("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&d===!0&&Le("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let p=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),f=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),b=n.getParameter(n.MAX_TEXTURE_SIZE),m=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),g=n.getParameter(n.MAX_VERTEX_ATTRIBS),y=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),_=n.getParameter(n.MAX_VARYING_VECTORS),x=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),E=n.getParameter(n.MAX_SAMPLES),w=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:s,getMaxPrecision:l,textureFormatReadable:a,textureTypeReadable:o,precision:c,logarithmicDepthBuffer:u,reversedDepthBuffer:d,maxTextures:p,maxVertexTextures:f,maxTextureSize:b,maxCubemapSize:m,maxAttributes:g,maxVertexUniforms:y,maxVaryings:_,maxFragmentUniforms:x,maxSamples:E,samples:w}}function bS(n){let e=this,t=null,i=0,r=!1,s=!1,a=new ii,o=new ke,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(d,u){let p=d.length!==0||u||i!==0||r;return r=u,i=d.length,p},this.beginShadows=function(){s=!0,h(null)},this.endShadows=function(){s=!1},this.setGlobalState=function(d,u){t=h(d,u,0)},this.setState=function(d,u,p){let f=d.clippingPlanes,b=d.clipIntersection,m=d.clipShadows,g=n.get(d);if(!r||f===null||f.length===0||s&&!m)s?h(null):c();else{let y=s?0:i,_=y*4,x=g.clippingState||null;l.value=x,x=h(f,u,_,p);for(let E=0;E!==_;++E)x[E]=t[E];g.clippingState=x,this.numIntersection=b?this.numPlanes:0,this.numPlanes+=y}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function h(d,u,p,f){let b=d!==null?d.length:0,m=null;if(b!==0){if(m=l.value,f!==!0||m===null){let g=p+b*4,y=u.matrixWorldInverse;o.getNormalMatrix(y),(m===null||m.length<g)&&(m=new Float32Array(g));for(let _=0,x=p;_!==b;++_,x+=4)a.copy(d[_]).applyMatrix4(y,o),a.normal.toArray(m,x),m[x+3]=a.constant}l.value=m,l.needsUpdate=!0}return e.numPlanes=b,e.numIntersection=0,m}}var bo=class extends Mn{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},r=[i,i,i,i,i,i];this.texture=new ja(r),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},r=new js(5,5,5),s=new Kt({name:"CubemapFromEquirect",uniforms:ts(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:rn,blending:jr});s.uniforms.tEquirect.value=t;let a=new Zt(r,s),o=t.minFilter;return t.minFilter===ki&&(t.minFilter=kt),new Ks(1,10,this).update(e,a),t.minFilter=o,a.geometry.dispose(),a.material.dispose(),this}clear(e,t=!0,i=!0,r=!0){let s=e.getRenderTarget();for(let a=0;a<6;a++)e.setRenderTarget(this,a),e.clear(t,i,r);e.setRenderTarget(s)}},Ug=256,yS=3,vS=20,l1=256,c1=16,xS=3,_S=new U,SS=new We,dh=class n{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Ks(1,10,null),this._boxMesh=new Zt(new js(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,i=.1,r=100,s={}){let{size:a=256,position:o=_S}=s,l=this._renderer;this._setSize(a);let c=this._allocateTarget(),h=this._getSourceTarget(!0);t>0&&(h.texture.mipmapsAutoUpdate=!1);let d=l.autoClear,u=l.autoClearColor,p=l.autoClearDepth,f=l.autoClearStencil,b=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,b===null&&(e.background=l.getClearColor(SS));let m=new Ks(i,r,h);return m.position.copy(o),m.update(l,e),l.autoClear=d,l.autoClearColor=u,l.autoClearDepth=p,l.autoClearStencil=f,e.background=b,t>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Vg(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=qg(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(Ug,Ng(e))}_fromTexture(e,t){e.mapping===Kr||e.mapping===ta?this._setSize(e.image.length===0?Ug:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let i=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(i),i}_allocateTarget(){let e=this._cubeSize,t=Bg(e,!1,!1),i=Math.log2(e)-yS;for(let r=0;r<=i;r++)t.texture.mipmaps.push({width:e>>r,height:e>>r});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==t||e&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=Bg(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,i){let r=this._boxMesh,s=this._cubeCamera;r.material=i,s.renderTarget=e,s.activeMipmapLevel=t;let a=e.width>>t;e.viewport.set(0,0,a,a),s.update(this._renderer,r),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===Kr||e.mapping===ta?(this._cubemapMaterial===null&&(this._cubemapMaterial=Vg()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=qg()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=MS(),this._integrationMaterial=wS());let t=this._cubeSize,i=e.texture.mipmaps.length-1,r=this._ggxMaterial.uniforms;r.envMap.value=this._sourceTarget.texture;let s=this._integrationMaterial.uniforms;s.envMap.value=this._sourceTarget.texture,s.sourceLod.value=Math.log2(t/c1);for(let a=0;a<=i;a++){let o=n.lodToRoughness(a,i);if(a>i-xS)s.roughness.value=o,this._renderCube(e,a,this._integrationMaterial);else{let l=o>0?Math.log2(t)+.5*Math.log2(6/(l1*Math.pow(o,4)))+.5:0;r.roughness.value=o,r.lodBias.value=l,this._renderCube(e,a,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=AS());let i=this._blurMaterial,r=i.uniforms,s=this._sourceTarget;r.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,r.envMap.value=s.texture,this._renderCube(e,0,i),r.envMap.value=e.texture,this._renderCube(s,0,i)}};function Bg(n,e,t){return new bo(n,{minFilter:ki,generateMipmaps:e,type:si,colorSpace:Ua,depthBuffer:t})}function yo(n,e,t){return new Kt({name:n,uniforms:e,vertexShader:$e.cube_vert,fragmentShader:t,side:rn,blending:jr,depthTest:!1,depthWrite:!1})}function MS(){return yo("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${l1}u

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
	`)}function wS(){return yo("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:c1}},`

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
	`)}function AS(){return yo("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${vS}
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
	`)}function qg(){return yo("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function Vg(){return yo("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function ES(n){let e=new WeakMap,t=new WeakMap,i=null;function r(u,p=!1){return u==null?null:p?a(u):s(u)}function s(u){if(u&&u.isTexture){let p=u.mapping;if(p===wc||p===Ac)if(e.has(u)){let f=e.get(u).texture;return o(f,u.mapping)}else{let f=u.image;if(f&&f.height>0){let b=new bo(f.height);return b.fromEquirectangularTexture(n,u),e.set(u,b),u.addEventListener("dispose",c),o(b.texture,u.mapping)}else return null}}return u}function a(u){if(u&&u.isTexture&&u.isPMREMTexture!==!0){let p=u.mapping,f=p===wc||p===Ac,b=p===Kr||p===ta;if(f||b){let m=t.get(u),g=m!==void 0?m.texture.pmremVersion:0;if(u.isRenderTargetTexture&&u.pmremVersion!==g)return i===null&&(i=new dh(n)),m=f?i.fromEquirectangular(u,m):i.fromCubemap(u,m),m.texture.pmremVersion=u.pmremVersion,t.set(u,m),m.texture;if(m!==void 0)return m.texture;{let y=u.image;return f&&y&&y.height>0||b&&y&&l(y)?(i===null&&(i=new dh(n)),m=f?i.fromEquirectangular(u):i.fromCubemap(u),m.texture.pmremVersion=u.pmremVersion,t.set(u,m),u.addEventListener("dispose",h),m.texture):null}}}return u}function o(u,p){return p===wc?u.mapping=Kr:p===Ac&&(u.mapping=ta),u}function l(u){let p=0,f=6;for(let b=0;b<f;b++)u[b]!==void 0&&p++;return p===f}function c(u){let p=u.target;p.removeEventListener("dispose",c);let f=e.get(p);f!==void 0&&(e.delete(p),f.dispose())}function h(u){let p=u.target;p.removeEventListener("dispose",h);let f=t.get(p);f!==void 0&&(t.delete(p),f.dispose())}function d(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:r,dispose:d}}function TS(n){let e={};function t(i){if(e[i]!==void 0)return e[i];let r=n.getExtension(i);return e[i]=r,r}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){let r=t(i);return r===null&&Oa("WebGLRenderer: "+i+" extension not supported."),r}}}function CS(n,e,t,i){let r={},s=new WeakMap,a=new FinalizationRegistry(f=>delete r[f]);function o(f){l(f.target)}function l(f){f.index!==null&&e.remove(f.index);for(let m in f.attributes)e.remove(f.attributes[m]);f.removeEventListener("dispose",o),delete r[f.id],a.unregister(f);let b=s.get(f);b&&(e.remove(b),s.delete(f)),i.releaseStatesOfGeometry(f),f.isInstancedBufferGeometry===!0&&delete f._maxInstanceCount,t.memory.geometries--}function c(f,b){return r[b.id]!==void 0||(b.addEventListener("dispose",o),r[b.id]=new WeakRef(b),a.register(b,b.id,b),t.memory.geometries++),b}function h(f){let b=f.attributes;for(let m in b)e.update(b[m],n.ARRAY_BUFFER)}function d(f){let b=f.index,m=f.attributes.position,g=0;if(m===void 0)return;let y=b!==null?b.array.length:m.array.length/3-1,_=m.count>=65535?Ya:Xa,x=new _(Math.ceil(y/3)*6,1),E=x.array;if(b!==null){let v=b.array;g=b.version;for(let A=0,L=0;A<y;A+=3){let R=v[A+0],N=v[A+1],z=v[A+2];E[L++]=R,E[L++]=N,E[L++]=N,E[L++]=z,E[L++]=z,E[L++]=R}}else{g=m.version;for(let v=0,A=0;v<y;v+=3){let L=v+0,R=v+1,N=v+2;E[A++]=L,E[A++]=R,E[A++]=R,E[A++]=N,E[A++]=N,E[A++]=L}}x.version=g;let w=s.get(f);w&&e.remove(w),s.set(f,x)}function u(f){let b=s.get(f);if(b){let m=f.index;m!==null&&b.version<m.version&&d(f)}else d(f);return s.get(f)}function p(){for(let f in r){let b=r[f].deref();b!==void 0&&l(b)}}return{get:c,update:h,getWireframeAttribute:u,dispose:p}}function RS(n,e,t){let i;function r(d){i=d}let s,a;function o(d){s=d.type,a=d.bytesPerElement}function l(d,u){n.drawElements(i,u,s,d*a),t.update(u,i,1)}function c(d,u,p){p!==0&&(n.drawElementsInstanced(i,u,s,d*a,p),t.update(u,i,p))}function h(d,u,p){if(p===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,u,0,s,d,0,p);let b=0;for(let m=0;m<p;m++)b+=u[m];t.update(b,i,1)}this.setMode=r,this.setIndex=o,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function PS(n){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(s,a,o){switch(t.calls++,a){case n.TRIANGLES:t.triangles+=o*(s/3);break;case n.LINES:t.lines+=o*(s/2);break;case n.LINE_STRIP:t.lines+=o*(s-1);break;case n.LINE_LOOP:t.lines+=o*s;break;case n.POINTS:t.points+=o*s;break;default:ze("WebGLInfo: Unknown draw mode:",a);break}}function r(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:r,update:i}}function IS(n,e,t){let i=new WeakMap,r=new ht;function s(a,o,l){let c=a.morphTargetInfluences,h=o.morphAttributes.position||o.morphAttributes.normal||o.morphAttributes.color,d=h!==void 0?h.length:0,u=i.get(o);if(u===void 0||u.count!==d){let L=function(){v.dispose(),i.delete(o),o.removeEventListener("dispose",L)};u!==void 0&&u.texture.dispose();let p=o.morphAttributes.position!==void 0,f=o.morphAttributes.normal!==void 0,b=o.morphAttributes.color!==void 0,m=o.morphAttributes.position||[],g=o.morphAttributes.normal||[],y=o.morphAttributes.color||[],_=0;p===!0&&(_=1),f===!0&&(_=2),b===!0&&(_=3);let x=o.attributes.position.count*_,E=1;x>e.maxTextureSize&&(E=Math.ceil(x/e.maxTextureSize),x=e.maxTextureSize);let w=new Float32Array(x*E*4*d),v=new Ga(w,x,E,d);v.type=En,v.needsUpdate=!0;let A=_*4;for(let R=0;R<d;R++){let N=m[R],z=g[R],H=y[R],P=x*E*4*R;for(let W=0;W<N.count;W++){let B=W*A;p===!0&&(r.fromBufferAttribute(N,W),w[P+B+0]=r.x,w[P+B+1]=r.y,w[P+B+2]=r.z,w[P+B+3]=0),f===!0&&(r.fromBufferAttribute(z,W),w[P+B+4]=r.x,w[P+B+5]=r.y,w[P+B+6]=r.z,w[P+B+7]=0),b===!0&&(r.fromBufferAttribute(H,W),w[P+B+8]=r.x,w[P+B+9]=r.y,w[P+B+10]=r.z,w[P+B+11]=H.itemSize===4?r.w:1)}}u={count:d,texture:v,size:new Xe(x,E)},i.set(o,u),o.addEventListener("dispose",L)}if(a.isInstancedMesh===!0&&a.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",a.morphTexture,t);else{let p=0;for(let b=0;b<c.length;b++)p+=c[b];let f=o.morphTargetsRelative?1:1-p;l.getUniforms().setValue(n,"morphTargetBaseInfluence",f),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",u.texture,t),l.getUniforms().setValue(n,"morphTargetsTextureSize",u.size)}return{update:s}}function NS(n,e,t,i,r){let s=new WeakMap;function a(c){let h=r.render.frame,d=c.geometry,u=e.get(c,d);if(s.get(u)!==h&&(e.update(u),s.set(u,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),s.get(c)!==h&&(t.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,n.ARRAY_BUFFER),s.set(c,h))),c.isSkinnedMesh){let p=c.skeleton;s.get(p)!==h&&(p.update(),s.set(p,h))}return u}function o(){s=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),i.releaseStatesOfObject(h),t.remove(h.instanceMatrix),h.instanceColor!==null&&t.remove(h.instanceColor)}return{update:a,dispose:o}}var LS={[Bd]:"LINEAR_TONE_MAPPING",[qd]:"REINHARD_TONE_MAPPING",[Vd]:"CINEON_TONE_MAPPING",[Hd]:"ACES_FILMIC_TONE_MAPPING",[Wd]:"AGX_TONE_MAPPING",[$d]:"NEUTRAL_TONE_MAPPING",[Gd]:"CUSTOM_TONE_MAPPING"};function DS(n,e,t,i,r,s){let a=new Mn(e,t,{type:n,depthBuffer:r,stencilBuffer:s,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),o=null,l=null,c=null,h=new un;h.setAttribute("position",new Un([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new Un([0,2,0,0,2,0],2));let d=new hc({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),u=new Zt(h,d),p=new Zs(-1,1,1,-1,0,1),f=null,b=null,m=!1,g,y=null,_=[],x=!1;this.setSize=function(E,w){a.setSize(E,w),o!==null&&o.setSize(E,w),l!==null&&l.setSize(E,w);for(let v=0;v<_.length;v++){let A=_[v];A.setSize&&A.setSize(E,w)}},this.setEffects=function(E){_=E,x=_.length>0&&_[0].isRenderPass===!0;let w=a.width,v=a.height;_.length>0&&o===null&&(o=new Mn(w,v,{type:si,depthBuffer:!1,stencilBuffer:!1}),l=new Mn(w,v,{type:si,depthBuffer:!1,stencilBuffer:!1}));let A=r===!0&&_.some(L=>L.needsDepthTexture===!0);A!==(a.depthTexture!==null)&&(A===!0&&c===null&&(c=new Oi(w,v),s===!0&&(c.format=Ui,c.type=Qr)),a.dispose(),a.depthTexture=A?c:null,a.resolveDepthBuffer=A,a.storeMultisampledDepthBuffer=A);for(let L=0;L<_.length;L++){let R=_[L];R.setSize&&R.setSize(w,v),A&&R.needsDepthTexture===!0&&R.setDepthTexture&&R.setDepthTexture(c)}},this.begin=function(E,w){if(m||E.toneMapping===vi&&_.length===0)return!1;if(y=w,w!==null){let v=w.width,A=w.height;(a.width!==v||a.height!==A)&&this.setSize(v,A)}return x===!1&&E.setRenderTarget(a),g=E.toneMapping,E.toneMapping=vi,!0},this.hasRenderPass=function(){return x},this.end=function(E,w){E.toneMapping=g,m=!0;let v=a,A=o;for(let L=0;L<_.length;L++){let R=_[L];R.enabled!==!1&&(R.render(E,A,v,w),R.needsSwap!==!1&&(v=A,A=A===o?l:o))}if(f!==E.outputColorSpace||b!==E.toneMapping){f=E.outputColorSpace,b=E.toneMapping,d.defines={},Ke.getTransfer(f)===at&&(d.defines.SRGB_TRANSFER="");let L=LS[b];L&&(d.defines[L]=""),d.needsUpdate=!0}d.uniforms.tDiffuse.value=v.texture,E.setRenderTarget(y),E.render(u,p),y=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){a.dispose(),o!==null&&o.dispose(),l!==null&&l.dispose(),h.dispose(),d.dispose()}}var h1=new nn,u1=new Oi(1,1),d1=new Ka(1),p1=new Ga,f1=new sc,m1=new ja,Hg=[],Gg=[],Wg=new Float32Array(16),$g=new Float32Array(9),Xg=new Float32Array(4);function sa(n,e,t){let i=n[0];if(i<=0||i>0)return n;let r=e*t,s=Hg[r];if(s===void 0&&(s=new Float32Array(r),Hg[r]=s),e!==0){i.toArray(s,0);for(let a=1,o=0;a!==e;++a)o+=t,n[a].toArray(s,o)}return s}function Nt(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function Lt(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function fh(n,e){let t=Gg[e];t===void 0&&(t=new Int32Array(e),Gg[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function FS(n,e){let t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function zS(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Nt(t,e))return;n.uniform2fv(this.addr,e),Lt(t,e)}}function OS(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Nt(t,e))return;n.uniform3fv(this.addr,e),Lt(t,e)}}function kS(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Nt(t,e))return;n.uniform4fv(this.addr,e),Lt(t,e)}}function US(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Nt(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),Lt(t,e)}else{if(Nt(t,i))return;Xg.set(i),n.uniformMatrix2fv(this.addr,!1,Xg),Lt(t,i)}}function BS(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Nt(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),Lt(t,e)}else{if(Nt(t,i))return;$g.set(i),n.uniformMatrix3fv(this.addr,!1,$g),Lt(t,i)}}function qS(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Nt(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),Lt(t,e)}else{if(Nt(t,i))return;Wg.set(i),n.uniformMatrix4fv(this.addr,!1,Wg),Lt(t,i)}}function VS(n,e){let t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function HS(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Nt(t,e))return;n.uniform2iv(this.addr,e),Lt(t,e)}}function GS(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Nt(t,e))return;n.uniform3iv(this.addr,e),Lt(t,e)}}function WS(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Nt(t,e))return;n.uniform4iv(this.addr,e),Lt(t,e)}}function $S(n,e){let t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function XS(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Nt(t,e))return;n.uniform2uiv(this.addr,e),Lt(t,e)}}function YS(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Nt(t,e))return;n.uniform3uiv(this.addr,e),Lt(t,e)}}function JS(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Nt(t,e))return;n.uniform4uiv(this.addr,e),Lt(t,e)}}function mh(n){return n.version===0&&(n.compareFunction=ip,n.needsUpdate=!0),n}function jS(n,e,t){let i=this.cache,r=t.allocateTextureUnit();i[0]!==r&&(n.uniform1i(this.addr,r),i[0]=r);let s;this.type===n.SAMPLER_2D_SHADOW?s=mh(u1):s=h1,t.setTexture2D(e||s,r)}function ZS(n,e,t){let i=this.cache,r=t.allocateTextureUnit();i[0]!==r&&(n.uniform1i(this.addr,r),i[0]=r),t.setTexture3D(e||f1,r)}function KS(n,e,t){let i=this.cache,r=t.allocateTextureUnit();i[0]!==r&&(n.uniform1i(this.addr,r),i[0]=r);let s;this.type===n.SAMPLER_CUBE_SHADOW?s=mh(d1):s=m1,t.setTextureCube(e||s,r)}function QS(n,e,t){let i=this.cache,r=t.allocateTextureUnit();i[0]!==r&&(n.uniform1i(this.addr,r),i[0]=r),t.setTexture2DArray(e||p1,r)}function eM(n){switch(n){case 5126:return FS;case 35664:return zS;case 35665:return OS;case 35666:return kS;case 35674:return US;case 35675:return BS;case 35676:return qS;case 5124:case 35670:return VS;case 35667:case 35671:return HS;case 35668:case 35672:return GS;case 35669:case 35673:return WS;case 5125:return $S;case 36294:return XS;case 36295:return YS;case 36296:return JS;case 35678:case 36198:case 36298:case 36306:case 35682:return jS;case 35679:case 36299:case 36307:return ZS;case 35680:case 36300:case 36308:case 36293:return KS;case 36289:case 36303:case 36311:case 36292:return QS}}function tM(n,e){n.uniform1fv(this.addr,e)}function nM(n,e){let t=sa(e,this.size,2);n.uniform2fv(this.addr,t)}function iM(n,e){let t=sa(e,this.size,3);n.uniform3fv(this.addr,t)}function rM(n,e){let t=sa(e,this.size,4);n.uniform4fv(this.addr,t)}function sM(n,e){let t=sa(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function aM(n,e){let t=sa(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function oM(n,e){let t=sa(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function lM(n,e){n.uniform1iv(this.addr,e)}function cM(n,e){n.uniform2iv(this.addr,e)}function hM(n,e){n.uniform3iv(this.addr,e)}function uM(n,e){n.uniform4iv(this.addr,e)}function dM(n,e){n.uniform1uiv(this.addr,e)}function pM(n,e){n.uniform2uiv(this.addr,e)}function fM(n,e){n.uniform3uiv(this.addr,e)}function mM(n,e){n.uniform4uiv(this.addr,e)}function gM(n,e,t){let i=this.cache,r=e.length,s=fh(t,r);Nt(i,s)||(n.uniform1iv(this.addr,s),Lt(i,s));let a;this.type===n.SAMPLER_2D_SHADOW?a=mh(u1):a=h1;for(let o=0;o!==r;++o)t.setTexture2D(e[o]||a,s[o])}function bM(n,e,t){let i=this.cache,r=e.length,s=fh(t,r);Nt(i,s)||(n.uniform1iv(this.addr,s),Lt(i,s));for(let a=0;a!==r;++a)t.setTexture3D(e[a]||f1,s[a])}function yM(n,e,t){let i=this.cache,r=e.length,s=fh(t,r);Nt(i,s)||(n.uniform1iv(this.addr,s),Lt(i,s));let a;this.type===n.SAMPLER_CUBE_SHADOW?a=mh(d1):a=m1;for(let o=0;o!==r;++o)t.setTextureCube(e[o]||a,s[o])}function vM(n,e,t){let i=this.cache,r=e.length,s=fh(t,r);Nt(i,s)||(n.uniform1iv(this.addr,s),Lt(i,s));for(let a=0;a!==r;++a)t.setTexture2DArray(e[a]||p1,s[a])}function xM(n){switch(n){case 5126:return tM;case 35664:return nM;case 35665:return iM;case 35666:return rM;case 35674:return sM;case 35675:return aM;case 35676:return oM;case 5124:case 35670:return lM;case 35667:case 35671:return cM;case 35668:case 35672:return hM;case 35669:case 35673:return uM;case 5125:return dM;case 36294:return pM;case 36295:return fM;case 36296:return mM;case 35678:case 36198:case 36298:case 36306:case 35682:return gM;case 35679:case 36299:case 36307:return bM;case 35680:case 36300:case 36308:case 36293:return yM;case 36289:case 36303:case 36311:case 36292:return vM}}var up=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=eM(t.type)}},dp=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=xM(t.type)}},pp=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){let r=this.seq;for(let s=0,a=r.length;s!==a;++s){let o=r[s];o.setValue(e,t[o.id],i)}}},cp=/(\w+)(\])?(\[|\.)?/g;function Yg(n,e){n.seq.push(e),n.map[e.id]=e}function _M(n,e,t){let i=n.name,r=i.length;for(cp.lastIndex=0;;){let s=cp.exec(i),a=cp.lastIndex,o=s[1],l=s[2]==="]",c=s[3];if(l&&(o=o|0),c===void 0||c==="["&&a+2===r){Yg(t,c===void 0?new up(o,n,e):new dp(o,n,e));break}else{let d=t.map[o];d===void 0&&(d=new pp(o),Yg(t,d)),t=d}}}var ra=class{constructor(e,t){this.seq=[],this.map={};let i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let a=0;a<i;++a){let o=e.getActiveUniform(t,a),l=e.getUniformLocation(t,o.name);_M(o,l,this)}let r=[],s=[];for(let a of this.seq)a.type===e.SAMPLER_2D_SHADOW||a.type===e.SAMPLER_CUBE_SHADOW||a.type===e.SAMPLER_2D_ARRAY_SHADOW?r.push(a):s.push(a);r.length>0&&(this.seq=r.concat(s))}setValue(e,t,i,r){let s=this.map[t];s!==void 0&&s.setValue(e,i,r)}setOptional(e,t,i){let r=t[i];r!==void 0&&this.setValue(e,i,r)}static upload(e,t,i,r){for(let s=0,a=t.length;s!==a;++s){let o=t[s],l=i[o.id];l.needsUpdate!==!1&&o.setValue(e,l.value,r)}}static seqWithValue(e,t){let i=[];for(let r=0,s=e.length;r!==s;++r){let a=e[r];a.id in t&&i.push(a)}return i}};function Jg(n,e,t){let i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}var SM=37297,MM=0;function wM(n,e){let t=n.split(`
`),i=[],r=Math.max(e-6,0),s=Math.min(e+6,t.length);for(let a=r;a<s;a++){let o=a+1;i.push(`${o===e?">":" "} ${o}: ${t[a]}`)}return i.join(`
`)}var jg=new ke;function AM(n){Ke._getMatrix(jg,Ke.workingColorSpace,n);let e=`mat3( ${jg.elements.map(t=>t.toFixed(4))} )`;switch(Ke.getTransfer(n)){case Ba:return[e,"LinearTransferOETF"];case at:return[e,"sRGBTransferOETF"];default:return Le("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function Zg(n,e,t){let i=n.getShaderParameter(e,n.COMPILE_STATUS),s=(n.getShaderInfoLog(e)||"").trim();if(i&&s==="")return"";let a=/ERROR: 0:(\d+)/.exec(s);if(a){let o=parseInt(a[1]);return t.toUpperCase()+`

`+s+`

`+wM(n.getShaderSource(e),o)}else return s}function EM(n,e){let t=AM(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var TM={[Bd]:"Linear",[qd]:"Reinhard",[Vd]:"Cineon",[Hd]:"ACESFilmic",[Wd]:"AgX",[$d]:"Neutral",[Gd]:"Custom"};function CM(n,e){let t=TM[e];return t===void 0?(Le("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var uh=new U;function RM(){Ke.getLuminanceCoefficients(uh);let n=uh.x.toFixed(4),e=uh.y.toFixed(4),t=uh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function PM(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(go).join(`
`)}function IM(n){let e=[];for(let t in n){let i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function NM(n,e){let t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let r=0;r<i;r++){let s=n.getActiveAttrib(e,r),a=s.name,o=1;s.type===n.FLOAT_MAT2&&(o=2),s.type===n.FLOAT_MAT3&&(o=3),s.type===n.FLOAT_MAT4&&(o=4),t[a]={type:s.type,location:n.getAttribLocation(e,a),locationSize:o}}return t}function go(n){return n!==""}function Kg(n,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function Qg(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var LM=/^[ \t]*#include +<([\w\d./]+)>/gm;function fp(n){return n.replace(LM,DM)}function DM(n,e){let t=$e[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return fp(t)}var FM=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function e1(n){return n.replace(FM,zM)}function zM(n,e,t,i){let r="";for(let s=parseInt(e);s<parseInt(t);s++)r+=i.replace(/\[\s*i\s*\]/g,"[ "+s+" ]").replace(/UNROLLED_LOOP_INDEX/g,s);return r}function t1(n){let e=`precision ${n.precision} float;
	precision ${n.precision} int;
	precision ${n.precision} sampler2D;
	precision ${n.precision} samplerCube;
	precision ${n.precision} sampler3D;
	precision ${n.precision} sampler2DArray;
	precision ${n.precision} sampler2DShadow;
	precision ${n.precision} samplerCubeShadow;
	precision ${n.precision} sampler2DArrayShadow;
	precision ${n.precision} isampler2D;
	precision ${n.precision} isampler3D;
	precision ${n.precision} isamplerCube;
	precision ${n.precision} isampler2DArray;
	precision ${n.precision} usampler2D;
	precision ${n.precision} usampler3D;
	precision ${n.precision} usamplerCube;
	precision ${n.precision} usampler2DArray;
	`;return n.precision==="highp"?e+=`
#define HIGH_PRECISION`:n.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var OM={[so]:"SHADOWMAP_TYPE_PCF",[Qs]:"SHADOWMAP_TYPE_VSM"};function kM(n){return OM[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var UM={[ta]:"ENVMAP_MODE_REFRACTION"};function BM(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":UM[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var qM={[Ud]:"ENVMAP_BLENDING_MULTIPLY",[bg]:"ENVMAP_BLENDING_MIX",[yg]:"ENVMAP_BLENDING_ADD"};function VM(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":qM[n.combine]||"ENVMAP_BLENDING_NONE"}function HM(n,e,t,i){let r=n.getContext(),s=t.defines,a=t.vertexShader,o=t.fragmentShader,l=kM(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=BM(t),d=VM(t),u=PM(t),p=IM(s),f=r.createProgram(),b,m,g=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(b=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p].filter(go).join(`
`),b.length>0&&(b+=`
`),m=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p].filter(go).join(`
`),m.length>0&&(m+=`
`)):(b=[t1(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+h:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(go).join(`
`),m=[t1(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+h:"",t.envMap?"#define "+d:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==vi?"#define TONE_MAPPING":"",t.toneMapping!==vi?$e.tonemapping_pars_fragment:"",t.toneMapping!==vi?CM("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",$e.colorspace_pars_fragment,EM("linearToOutputTexel",t.outputColorSpace),RM(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(go).join(`
`)),a=fp(a),a=Kg(a,t),a=Qg(a,t),o=fp(o),o=Kg(o,t),o=Qg(o,t),a=e1(a),o=e1(o),t.isRawShaderMaterial!==!0&&(g=`#version 300 es
`,b=[u,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+b,m=["#define varying in",t.glslVersion===qi?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===qi?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let y=g+b+a,_=g+m+o,x=Jg(r,r.VERTEX_SHADER,y),E=Jg(r,r.FRAGMENT_SHADER,_);r.attachShader(f,x),r.attachShader(f,E),t.index0AttributeName!==void 0?r.bindAttribLocation(f,0,t.index0AttributeName):t.hasPositionAttribute===!0&&r.bindAttribLocation(f,0,"position"),r.linkProgram(f);function w(R){if(n.debug.checkShaderErrors){let N=r.getProgramInfoLog(f)||"",z=r.getShaderInfoLog(x)||"",H=r.getShaderInfoLog(E)||"",P=N.trim(),W=z.trim(),B=H.trim(),O=!0,Q=!0;if(r.getProgramParameter(f,r.LINK_STATUS)===!1)if(O=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(r,f,x,E);else{let G=Zg(r,x,"vertex"),Y=Zg(r,E,"fragment");ze("WebGLProgram: Shader Error "+r.getError()+" - VALIDATE_STATUS "+r.getProgramParameter(f,r.VALIDATE_STATUS)+`

Material Name: `+R.name+`
Material Type: `+R.type+`

Program Info Log: `+P+`
`+G+`
`+Y)}else P!==""?Le("WebGLProgram: Program Info Log:",P):(W===""||B==="")&&(Q=!1);Q&&(R.diagnostics={runnable:O,programLog:P,vertexShader:{log:W,prefix:b},fragmentShader:{log:B,prefix:m}})}r.deleteShader(x),r.deleteShader(E),v=new ra(r,f),A=NM(r,f)}let v;this.getUniforms=function(){return v===void 0&&w(this),v};let A;this.getAttributes=function(){return A===void 0&&w(this),A};let L=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return L===!1&&(L=r.getProgramParameter(f,SM)),L},this.destroy=function(){i.releaseStatesOfProgram(this),r.deleteProgram(f),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=MM++,this.cacheKey=e,this.usedTimes=1,this.program=f,this.vertexShader=x,this.fragmentShader=E,this}var GM=0,mp=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){let r=this._getShaderCacheForMaterial(e);return r.has(t)===!1&&(r.add(t),t.usedTimes++),r.has(i)===!1&&(r.add(i),i.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){let t=this.shaderCache,i=t.get(e);return i===void 0&&(i=new gp(e),t.set(e,i)),i}},gp=class{constructor(e){this.id=GM++,this.code=e,this.usedTimes=0}};function WM(n){return n===br||n===po||n===fo}function $M(n,e,t,i,r,s){let a=new Wa,o=new mp,l=new Set,c=[],h=new Map,d=i.logarithmicDepthBuffer,u={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function p(v){return l.add(v),v===0?"uv":`uv${v}`}function f(v,A,L,R,N,z){let H=R.fog,P=N.geometry,W=v.isMeshStandardMaterial||v.isMeshLambertMaterial||v.isMeshPhongMaterial?R.environment:null,B=v.isMeshStandardMaterial||v.isMeshLambertMaterial&&!v.envMap||v.isMeshPhongMaterial&&!v.envMap,O=e.get(v.envMap||W,B),Q=u[v.type],G=i.precision;v.precision!==null&&(G=i.getMaxPrecision(v.precision),G!==v.precision&&Le("WebGLProgram.getParameters:",v.precision,"not supported, using",G,"instead."));let Y=P.morphAttributes.position||P.morphAttributes.normal||P.morphAttributes.color,ee=Y!==void 0?Y.length:0,ye=0;P.morphAttributes.position!==void 0&&(ye=1),P.morphAttributes.normal!==void 0&&(ye=2),P.morphAttributes.color!==void 0&&(ye=3);let Ee,$,ne,he;if(Q){let ge=_i[Q];Ee=ge.vertexShader,$=ge.fragmentShader}else{Ee=v.vertexShader,$=v.fragmentShader;let ge=o.getVertexShaderStage(v),ot=o.getFragmentShaderStage(v);o.update(v,ge,ot),ne=ge.id,he=ot.id}let xe=n.getRenderTarget(),ue=n.state.buffers.depth.getReversed(),Fe=N.isInstancedMesh===!0,ft=N.isBatchedMesh===!0,Pe=!!v.map,tt=!!v.matcap,rt=!!O,Ye=rt&&O.isPMREMTexture===!0,Ut=!!v.aoMap,Ct=!!v.lightMap,an=!!v.bumpMap&&v.wireframe===!1,bt=!!v.normalMap,ai=!!v.displacementMap,Dt=!!v.emissiveMap,Cn=!!v.metalnessMap,Rn=!!v.roughnessMap,Pn=v.anisotropy>0,F=v.clearcoat>0,In=v.diffuseRoughness>0,mt=v.dispersion>0,gt=v.retroreflectivity>0,me=v.iridescence>0,Rt=v.sheen>0,Ie=v.transmission>0,Ue=Pn&&!!v.anisotropyMap,C=F&&!!v.clearcoatMap,S=F&&!!v.clearcoatNormalMap,q=F&&!!v.clearcoatRoughnessMap,ie=In&&!!v.diffuseRoughnessMap,te=me&&!!v.iridescenceMap,ae=me&&!!v.iridescenceThicknessMap,pe=Rt&&!!v.sheenColorMap,j=Rt&&!!v.sheenRoughnessMap,Z=!!v.specularMap,le=!!v.specularColorMap,I=!!v.specularIntensityMap,K=Ie&&!!v.transmissionMap,J=Ie&&!!v.thicknessMap,ce=!!v.gradientMap,se=!!v.alphaMap,oe=v.alphaTest>0,Te=!!v.alphaHash,Ge=!!v.extensions,re=vi;v.toneMapped&&(xe===null||xe.isXRRenderTarget===!0)&&(re=n.toneMapping);let Re=Ye?O.isCompressedCubeTexture?O.image[0].mipmaps:O.mipmaps:null,He={shaderID:Q,shaderType:v.type,shaderName:v.name,vertexShader:Ee,fragmentShader:$,defines:v.defines,customVertexShaderID:ne,customFragmentShaderID:he,isRawShaderMaterial:v.isRawShaderMaterial===!0,glslVersion:v.glslVersion,precision:G,batching:ft,batchingColor:ft&&N._colorsTexture!==null,instancing:Fe,instancingColor:Fe&&N.instanceColor!==null,instancingMorph:Fe&&N.morphTexture!==null,outputColorSpace:xe===null?n.outputColorSpace:xe.isXRRenderTarget===!0?xe.texture.colorSpace:Ke.workingColorSpace,alphaToCoverage:!!v.alphaToCoverage,map:Pe,matcap:tt,envMap:rt,envMapMode:rt&&O.mapping,envMapPMREM:Ye,envMapMaxLod:Ye?Re.length-1:null,envMapSize:Ye?Re[0].width:null,aoMap:Ut,lightMap:Ct,bumpMap:an,normalMap:bt,displacementMap:ai,emissiveMap:Dt,normalMapObjectSpace:bt&&v.normalMapType===_g,normalMapTangentSpace:bt&&v.normalMapType===ep,packedNormalMap:bt&&v.normalMapType===ep&&WM(v.normalMap.format),metalnessMap:Cn,roughnessMap:Rn,anisotropy:Pn,anisotropyMap:Ue,clearcoat:F,clearcoatMap:C,clearcoatNormalMap:S,clearcoatRoughnessMap:q,diffuseRoughness:In,diffuseRoughnessMap:ie,dispersion:mt,retroreflection:gt,iridescence:me,iridescenceMap:te,iridescenceThicknessMap:ae,sheen:Rt,sheenColorMap:pe,sheenRoughnessMap:j,specularMap:Z,specularColorMap:le,specularIntensityMap:I,transmission:Ie,transmissionMap:K,thicknessMap:J,gradientMap:ce,opaque:v.transparent===!1&&v.blending===ea&&v.alphaToCoverage===!1,alphaMap:se,alphaTest:oe,alphaHash:Te,combine:v.combine,mapUv:Pe&&p(v.map.channel),aoMapUv:Ut&&p(v.aoMap.channel),lightMapUv:Ct&&p(v.lightMap.channel),bumpMapUv:an&&p(v.bumpMap.channel),normalMapUv:bt&&p(v.normalMap.channel),displacementMapUv:ai&&p(v.displacementMap.channel),emissiveMapUv:Dt&&p(v.emissiveMap.channel),metalnessMapUv:Cn&&p(v.metalnessMap.channel),roughnessMapUv:Rn&&p(v.roughnessMap.channel),anisotropyMapUv:Ue&&p(v.anisotropyMap.channel),clearcoatMapUv:C&&p(v.clearcoatMap.channel),clearcoatNormalMapUv:S&&p(v.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:q&&p(v.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ie&&p(v.diffuseRoughnessMap.channel),iridescenceMapUv:te&&p(v.iridescenceMap.channel),iridescenceThicknessMapUv:ae&&p(v.iridescenceThicknessMap.channel),sheenColorMapUv:pe&&p(v.sheenColorMap.channel),sheenRoughnessMapUv:j&&p(v.sheenRoughnessMap.channel),specularMapUv:Z&&p(v.specularMap.channel),specularColorMapUv:le&&p(v.specularColorMap.channel),specularIntensityMapUv:I&&p(v.specularIntensityMap.channel),transmissionMapUv:K&&p(v.transmissionMap.channel),thicknessMapUv:J&&p(v.thicknessMap.channel),alphaMapUv:se&&p(v.alphaMap.channel),vertexTangents:!!P.attributes.tangent&&(bt||Pn),vertexNormals:!!P.attributes.normal,vertexColors:v.vertexColors,vertexAlphas:v.vertexColors===!0&&!!P.attributes.color&&P.attributes.color.itemSize===4,pointsUvs:N.isPoints===!0&&!!P.attributes.uv&&(Pe||se),fog:!!H,useFog:v.fog===!0,fogExp2:!!H&&H.isFogExp2,flatShading:v.wireframe===!1&&(v.flatShading===!0||P.attributes.normal===void 0&&bt===!1&&(v.isMeshLambertMaterial||v.isMeshPhongMaterial||v.isMeshStandardMaterial||v.isMeshPhysicalMaterial)),sizeAttenuation:v.sizeAttenuation===!0,logarithmicDepthBuffer:d,reversedDepthBuffer:ue,skinning:N.isSkinnedMesh===!0,hasPositionAttribute:P.attributes.position!==void 0,morphTargets:P.morphAttributes.position!==void 0,morphNormals:P.morphAttributes.normal!==void 0,morphColors:P.morphAttributes.color!==void 0,morphTargetsCount:ee,morphTextureStride:ye,numSunLights:A.sun.length,numDirLights:A.directional.length,numPointLights:A.point.length,numSpotLights:A.spot.length,numSpotLightMaps:A.spotLightMap.length,numRectAreaLights:A.rectArea.length,numHemiLights:A.hemi.length,numSunLightShadows:A.sunShadowMap.length,numDirLightShadows:A.directionalShadowMap.length,numPointLightShadows:A.pointShadowMap.length,numSpotLightShadows:A.spotShadowMap.length,numSpotLightShadowsWithMaps:A.numSpotLightShadowsWithMaps,numLightProbes:A.numLightProbes,numLightProbeGrids:z.filter(ge=>ge.texture!==null).length,numClippingPlanes:s.numPlanes,numClipIntersection:s.numIntersection,dithering:v.dithering,shadowMapEnabled:n.shadowMap.enabled&&L.length>0,shadowMapType:n.shadowMap.type,toneMapping:re,decodeVideoTexture:Pe&&v.map.isVideoTexture===!0&&Ke.getTransfer(v.map.colorSpace)===at,decodeVideoTextureEmissive:Dt&&v.emissiveMap.isVideoTexture===!0&&Ke.getTransfer(v.emissiveMap.colorSpace)===at,premultipliedAlpha:v.premultipliedAlpha,doubleSided:v.side===Bn,flipSided:v.side===rn,useDepthPacking:v.depthPacking>=0,depthPacking:v.depthPacking||0,index0AttributeName:v.index0AttributeName,extensionClipCullDistance:Ge&&v.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Ge&&v.extensions.multiDraw===!0||ft)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:v.customProgramCacheKey()};return He.vertexUv1s=l.has(1),He.vertexUv2s=l.has(2),He.vertexUv3s=l.has(3),l.clear(),He}function b(v){let A=[];if(v.shaderID?A.push(v.shaderID):(A.push(v.customVertexShaderID),A.push(v.customFragmentShaderID)),v.defines!==void 0)for(let L in v.defines)A.push(L),A.push(v.defines[L]);return v.isRawShaderMaterial===!1&&(m(A,v),g(A,v),A.push(n.outputColorSpace)),A.push(v.customProgramCacheKey),A.join()}function m(v,A){v.push(A.precision),v.push(A.outputColorSpace),v.push(A.envMapMode),v.push(A.envMapPMREM),v.push(A.envMapMaxLod),v.push(A.envMapSize),v.push(A.mapUv),v.push(A.alphaMapUv),v.push(A.lightMapUv),v.push(A.aoMapUv),v.push(A.bumpMapUv),v.push(A.normalMapUv),v.push(A.displacementMapUv),v.push(A.emissiveMapUv),v.push(A.metalnessMapUv),v.push(A.roughnessMapUv),v.push(A.anisotropyMapUv),v.push(A.clearcoatMapUv),v.push(A.clearcoatNormalMapUv),v.push(A.clearcoatRoughnessMapUv),v.push(A.diffuseRoughnessMapUv),v.push(A.iridescenceMapUv),v.push(A.iridescenceThicknessMapUv),v.push(A.sheenColorMapUv),v.push(A.sheenRoughnessMapUv),v.push(A.specularMapUv),v.push(A.specularColorMapUv),v.push(A.specularIntensityMapUv),v.push(A.transmissionMapUv),v.push(A.thicknessMapUv),v.push(A.combine),v.push(A.fogExp2),v.push(A.sizeAttenuation),v.push(A.morphTargetsCount),v.push(A.numSunLights),v.push(A.numDirLights),v.push(A.numPointLights),v.push(A.numSpotLights),v.push(A.numSpotLightMaps),v.push(A.numHemiLights),v.push(A.numRectAreaLights),v.push(A.numSunLightShadows),v.push(A.numDirLightShadows),v.push(A.numPointLightShadows),v.push(A.numSpotLightShadows),v.push(A.numSpotLightShadowsWithMaps),v.push(A.numLightProbes),v.push(A.numLightProbeGrids),v.push(A.shadowMapType),v.push(A.toneMapping),v.push(A.numClippingPlanes),v.push(A.numClipIntersection),v.push(A.depthPacking)}function g(v,A){a.disableAll(),A.instancing&&a.enable(0),A.instancingColor&&a.enable(1),A.instancingMorph&&a.enable(2),A.matcap&&a.enable(3),A.envMap&&a.enable(4),A.normalMapObjectSpace&&a.enable(5),A.normalMapTangentSpace&&a.enable(6),A.clearcoat&&a.enable(7),A.iridescence&&a.enable(8),A.alphaTest&&a.enable(9),A.vertexColors&&a.enable(10),A.vertexAlphas&&a.enable(11),A.vertexUv1s&&a.enable(12),A.vertexUv2s&&a.enable(13),A.vertexUv3s&&a.enable(14),A.vertexTangents&&a.enable(15),A.anisotropy&&a.enable(16),A.alphaHash&&a.enable(17),A.batching&&a.enable(18),A.dispersion&&a.enable(19),A.retroreflection&&a.enable(24),A.diffuseRoughness&&a.enable(25),A.batchingColor&&a.enable(20),A.gradientMap&&a.enable(21),A.packedNormalMap&&a.enable(22),A.vertexNormals&&a.enable(23),v.push(a.mask),a.disableAll(),A.fog&&a.enable(0),A.useFog&&a.enable(1),A.flatShading&&a.enable(2),A.logarithmicDepthBuffer&&a.enable(3),A.reversedDepthBuffer&&a.enable(4),A.skinning&&a.enable(5),A.morphTargets&&a.enable(6),A.morphNormals&&a.enable(7),A.morphColors&&a.enable(8),A.premultipliedAlpha&&a.enable(9),A.shadowMapEnabled&&a.enable(10),A.doubleSided&&a.enable(11),A.flipSided&&a.enable(12),A.useDepthPacking&&a.enable(13),A.dithering&&a.enable(14),A.transmission&&a.enable(15),A.sheen&&a.enable(16),A.opaque&&a.enable(17),A.pointsUvs&&a.enable(18),A.decodeVideoTexture&&a.enable(19),A.decodeVideoTextureEmissive&&a.enable(20),A.alphaToCoverage&&a.enable(21),A.numLightProbeGrids>0&&a.enable(22),A.hasPositionAttribute&&a.enable(23),v.push(a.mask)}function y(v){let A=u[v.type],L;if(A){let R=_i[A];L=zg.clone(R.uniforms)}else L=v.uniforms;return L}function _(v,A){let L=h.get(A);return L!==void 0?++L.usedTimes:(L=new HM(n,A,v,r),c.push(L),h.set(A,L)),L}function x(v){if(--v.usedTimes===0){let A=c.indexOf(v);c[A]=c[c.length-1],c.pop(),h.delete(v.cacheKey),v.destroy()}}function E(v){o.remove(v)}function w(){o.dispose()}return{getParameters:f,getProgramCacheKey:b,getUniforms:y,acquireProgram:_,releaseProgram:x,releaseShaderCache:E,programs:c,dispose:w}}function XM(){let n=new WeakMap;function e(a){return n.has(a)}function t(a){let o=n.get(a);return o===void 0&&(o={},n.set(a,o)),o}function i(a){n.delete(a)}function r(a,o,l){n.get(a)[o]=l}function s(){n=new WeakMap}return{has:e,get:t,remove:i,update:r,dispose:s}}function YM(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function n1(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function i1(){let n=[],e=0,t=[],i=[],r=[];function s(){e=0,t.length=0,i.length=0,r.length=0}function a(u){let p=0;return u.isInstancedMesh&&(p+=2),u.isSkinnedMesh&&(p+=1),p}function o(u,p,f,b,m,g){let y=n[e];return y===void 0?(y={id:u.id,object:u,geometry:p,material:f,materialVariant:a(u),groupOrder:b,renderOrder:u.renderOrder,z:m,group:g},n[e]=y):(y.id=u.id,y.object=u,y.geometry=p,y.material=f,y.materialVariant=a(u),y.groupOrder=b,y.renderOrder=u.renderOrder,y.z=m,y.group=g),e++,y}function l(u,p,f,b,m,g,y){y.reversedDepth===!0&&(m=-m);let _=o(u,p,f,b,m,g);f.transmission>0?i.push(_):f.transparent===!0?r.push(_):t.push(_)}function c(u,p,f,b,m,g){let y=o(u,p,f,b,m,g);f.transmission>0?i.unshift(y):f.transparent===!0?r.unshift(y):t.unshift(y)}function h(u,p){t.length>1&&t.sort(u||YM),i.length>1&&i.sort(p||n1),r.length>1&&r.sort(p||n1)}function d(){for(let u=e,p=n.length;u<p;u++){let f=n[u];if(f.id===null)break;f.id=null,f.object=null,f.geometry=null,f.material=null,f.group=null}}return{opaque:t,transmissive:i,transparent:r,init:s,push:l,unshift:c,finish:d,sort:h}}function JM(){let n=new WeakMap;function e(i,r){let s=n.get(i),a;return s===void 0?(a=new i1,n.set(i,[a])):r>=s.length?(a=new i1,s.push(a)):a=s[r],a}function t(){n=new WeakMap}return{get:e,dispose:t}}function jM(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new U,color:new We};break;case"SpotLight":t={position:new U,direction:new U,color:new We,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new U,color:new We,distance:0,decay:0};break;case"HemisphereLight":t={direction:new U,skyColor:new We,groundColor:new We};break;case"RectAreaLight":t={color:new We,position:new U,halfWidth:new U,halfHeight:new U};break}return n[e.id]=t,t}}}function ZM(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Xe};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Xe};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Xe,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}var KM=0;function QM(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function ew(n){let e=new jM,t=ZM(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new U);let r=new U,s=new pt,a=new pt;function o(c){let h=0,d=0,u=0;for(let z=0;z<9;z++)i.probe[z].set(0,0,0);let p=0,f=0,b=0,m=0,g=0,y=0,_=0,x=0,E=0,w=0,v=0,A=0,L=0,R=0;c.sort(QM);for(let z=0,H=c.length;z<H;z++){let P=c[z],W=P.color,B=P.intensity,O=P.distance,Q=null;if(P.shadow&&P.shadow.map&&(P.shadow.map.texture.format===br?Q=P.shadow.map.texture:Q=P.shadow.map.depthTexture||P.shadow.map.texture),P.isAmbientLight)h+=W.r*B,d+=W.g*B,u+=W.b*B;else if(P.isLightProbe){for(let G=0;G<9;G++)i.probe[G].addScaledVector(P.sh.coefficients[G],B);R++}else if(P.isSunLight){let G=e.get(P);if(G.color.copy(P.color).multiplyScalar(P.intensity),P.castShadow){let Y=P.shadow,ee=t.get(P);ee.shadowIntensity=Y.intensity,ee.shadowBias=Y.bias,ee.shadowNormalBias=Y.normalBias,ee.shadowRadius=Y.radius,ee.shadowMapSize.copy(Y.mapSize).multiply(Y.getFrameExtents()),i.sunShadow[f]=ee,i.sunShadowMap[f]=Q;let ye=Y.getViewportCount();for(let Ee=0;Ee<ye;Ee++)i.sunShadowMatrix[b+Ee]=Y.getMatrix(Ee),i.sunShadowCascade[b+Ee]=Y._cascadeData[Ee];b+=ye,f++}i.sun[p]=G,p++}else if(P.isDirectionalLight){let G=e.get(P);if(G.color.copy(P.color).multiplyScalar(P.intensity),P.castShadow){let Y=P.shadow,ee=t.get(P);ee.shadowIntensity=Y.intensity,ee.shadowBias=Y.bias,ee.shadowNormalBias=Y.normalBias,ee.shadowRadius=Y.radius,ee.shadowMapSize=Y.mapSize,i.directionalShadow[m]=ee,i.directionalShadowMap[m]=Q,i.directionalShadowMatrix[m]=P.shadow.matrix,E++}i.directional[m]=G,m++}else if(P.isSpotLight){let G=e.get(P);G.position.setFromMatrixPosition(P.matrixWorld),G.color.copy(W).multiplyScalar(B),G.distance=O,G.coneCos=Math.cos(P.angle),G.penumbraCos=Math.cos(P.angle*(1-P.penumbra)),G.decay=P.decay,i.spot[y]=G;let Y=P.shadow;if(P.map&&(i.spotLightMap[A]=P.map,A++,Y.updateMatrices(P),P.castShadow&&L++),i.spotLightMatrix[y]=Y.matrix,P.castShadow){let ee=t.get(P);ee.shadowIntensity=Y.intensity,ee.shadowBias=Y.bias,ee.shadowNormalBias=Y.normalBias,ee.shadowRadius=Y.radius,ee.shadowMapSize=Y.mapSize,i.spotShadow[y]=ee,i.spotShadowMap[y]=Q,v++}y++}else if(P.isRectAreaLight){let G=e.get(P);G.color.copy(W).multiplyScalar(B),G.halfWidth.set(P.width*.5,0,0),G.halfHeight.set(0,P.height*.5,0),i.rectArea[_]=G,_++}else if(P.isPointLight){let G=e.get(P);if(G.color.copy(P.color).multiplyScalar(P.intensity),G.distance=P.distance,G.decay=P.decay,P.castShadow){let Y=P.shadow,ee=t.get(P);ee.shadowIntensity=Y.intensity,ee.shadowBias=Y.bias,ee.shadowNormalBias=Y.normalBias,ee.shadowRadius=Y.radius,ee.shadowMapSize=Y.mapSize,ee.shadowCameraNear=Y.camera.near,ee.shadowCameraFar=Y.camera.far,i.pointShadow[g]=ee,i.pointShadowMap[g]=Q,i.pointShadowMatrix[g]=P.shadow.matrix,w++}i.point[g]=G,g++}else if(P.isHemisphereLight){let G=e.get(P);G.skyColor.copy(P.color).multiplyScalar(B),G.groundColor.copy(P.groundColor).multiplyScalar(B),i.hemi[x]=G,x++}}_>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=be.LTC_FLOAT_1,i.rectAreaLTC2=be.LTC_FLOAT_2):(i.rectAreaLTC1=be.LTC_HALF_1,i.rectAreaLTC2=be.LTC_HALF_2)),i.ambient[0]=h,i.ambient[1]=d,i.ambient[2]=u;let N=i.hash;(N.sunLength!==p||N.directionalLength!==m||N.pointLength!==g||N.spotLength!==y||N.rectAreaLength!==_||N.hemiLength!==x||N.numSunShadows!==f||N.numDirectionalShadows!==E||N.numPointShadows!==w||N.numSpotShadows!==v||N.numSpotMaps!==A||N.numLightProbes!==R)&&(i.sun.length=p,i.directional.length=m,i.spot.length=y,i.rectArea.length=_,i.point.length=g,i.hemi.length=x,i.sunShadow.length=f,i.sunShadowMap.length=f,i.sunShadowMatrix.length=b,i.sunShadowCascade.length=b,i.directionalShadow.length=E,i.directionalShadowMap.length=E,i.directionalShadowMatrix.length=E,i.pointShadow.length=w,i.pointShadowMap.length=w,i.pointShadowMatrix.length=w,i.spotShadow.length=v,i.spotShadowMap.length=v,i.spotLightMatrix.length=v+A-L,i.spotLightMap.length=A,i.numSpotLightShadowsWithMaps=L,i.numLightProbes=R,N.sunLength=p,N.directionalLength=m,N.pointLength=g,N.spotLength=y,N.rectAreaLength=_,N.hemiLength=x,N.numSunShadows=f,N.numDirectionalShadows=E,N.numPointShadows=w,N.numSpotShadows=v,N.numSpotMaps=A,N.numLightProbes=R,i.version=KM++)}function l(c,h){let d=0,u=0,p=0,f=0,b=0,m=0,g=h.matrixWorldInverse;for(let y=0,_=c.length;y<_;y++){let x=c[y];if(x.isSunLight){let E=i.sun[d];E.direction.setFromMatrixPosition(x.matrixWorld),E.direction.transformDirection(g),d++}else if(x.isDirectionalLight){let E=i.directional[u];E.direction.setFromMatrixPosition(x.matrixWorld),r.setFromMatrixPosition(x.target.matrixWorld),E.direction.sub(r),E.direction.transformDirection(g),u++}else if(x.isSpotLight){let E=i.spot[f];E.position.setFromMatrixPosition(x.matrixWorld),E.position.applyMatrix4(g),E.direction.setFromMatrixPosition(x.matrixWorld),r.setFromMatrixPosition(x.target.matrixWorld),E.direction.sub(r),E.direction.transformDirection(g),f++}else if(x.isRectAreaLight){let E=i.rectArea[b];E.position.setFromMatrixPosition(x.matrixWorld),E.position.applyMatrix4(g),a.identity(),s.copy(x.matrixWorld),s.premultiply(g),a.extractRotation(s),E.halfWidth.set(x.width*.5,0,0),E.halfHeight.set(0,x.height*.5,0),E.halfWidth.applyMatrix4(a),E.halfHeight.applyMatrix4(a),b++}else if(x.isPointLight){let E=i.point[p];E.position.setFromMatrixPosition(x.matrixWorld),E.position.applyMatrix4(g),p++}else if(x.isHemisphereLight){let E=i.hemi[m];E.direction.setFromMatrixPosition(x.matrixWorld),E.direction.transformDirection(g),m++}}}return{setup:o,setupView:l,state:i}}function r1(n){let e=new ew(n),t=[],i=[],r=[];function s(d){h.camera=d,t.length=0,i.length=0,r.length=0}function a(d){d.isLightProbeGrid?r.push(d):t.push(d)}function o(d){i.push(d)}function l(){e.setup(t),r.sort((d,u)=>d.priority-u.priority||d.id-u.id)}function c(d){e.setupView(t,d)}let h={lightsArray:t,shadowsArray:i,lightProbeGridArray:r,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:s,state:h,setupLights:l,setupLightsView:c,pushLight:a,pushShadow:o}}function tw(n){let e=new WeakMap;function t(r,s=0){let a=e.get(r),o;return a===void 0?(o=new r1(n),e.set(r,[o])):s>=a.length?(o=new r1(n),a.push(o)):o=a[s],o}function i(){e=new WeakMap}return{get:t,dispose:i}}var nw=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,iw=`uniform sampler2D shadow_pass;
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
}`,rw=[new U(1,0,0),new U(-1,0,0),new U(0,1,0),new U(0,-1,0),new U(0,0,1),new U(0,0,-1)],sw=[new U(0,-1,0),new U(0,-1,0),new U(0,0,1),new U(0,0,-1),new U(0,-1,0),new U(0,-1,0)],s1=new pt,mo=new U,hp=new U;function aw(n,e,t){let i=new Jr,r=new Xe,s=new Xe,a=new ht,o=new uc,l=new dc,c={},h=t.maxTextureSize,d={[gr]:rn,[rn]:gr,[Bn]:Bn},u=new Kt({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Xe},radius:{value:4}},vertexShader:nw,fragmentShader:iw}),p=u.clone();p.defines.HORIZONTAL_PASS=1;let f=new un;f.setAttribute("position",new Et(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let b=new Zt(f,u),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=so;let g=this.type;this.render=function(w,v,A){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||w.length===0)return;this.type===K0&&(Le("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=so);let L=n.getRenderTarget(),R=n.getActiveCubeFace(),N=n.getActiveMipmapLevel(),z=n.state;z.setBlending(jr),z.buffers.depth.getReversed()===!0?z.buffers.color.setClear(0,0,0,0):z.buffers.color.setClear(1,1,1,1),z.buffers.depth.setTest(!0),z.setScissorTest(!1);let H=g!==this.type;H&&v.traverse(function(P){P.material&&(Array.isArray(P.material)?P.material.forEach(W=>W.needsUpdate=!0):P.material.needsUpdate=!0)});for(let P=0,W=w.length;P<W;P++){let B=w[P],O=B.shadow;if(O===void 0){Le("WebGLShadowMap:",B,"has no shadow.");continue}if(O.autoUpdate===!1&&O.needsUpdate===!1)continue;r.copy(O.mapSize);let Q=O.getFrameExtents();r.multiply(Q),s.copy(O.mapSize),(r.x>h||r.y>h)&&(r.x>h&&(s.x=Math.floor(h/Q.x),r.x=s.x*Q.x,O.mapSize.x=s.x),r.y>h&&(s.y=Math.floor(h/Q.y),r.y=s.y*Q.y,O.mapSize.y=s.y));let G=n.state.buffers.depth.getReversed();if(O.camera._reversedDepth=G,O.map===null||H===!0){if(O.map!==null&&(O.map.depthTexture!==null&&(O.map.depthTexture.dispose(),O.map.depthTexture=null),O.map.dispose()),this.type===Qs){if(B.isPointLight){Le("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}O.map=new Mn(r.x,r.y,{format:br,type:si,minFilter:kt,magFilter:kt,generateMipmaps:!1}),O.map.texture.name=B.name+".shadowMap",O.map.depthTexture=new Oi(r.x,r.y,En),O.map.depthTexture.name=B.name+".shadowMapDepth",O.map.depthTexture.format=zi,O.map.depthTexture.compareFunction=null,O.map.depthTexture.minFilter=Tt,O.map.depthTexture.magFilter=Tt}else B.isPointLight?(O.map=new bo(r.x),O.map.depthTexture=new Ka(r.x,ri)):(O.map=new Mn(r.x,r.y),O.map.depthTexture=new Oi(r.x,r.y,ri)),O.map.depthTexture.name=B.name+".shadowMap",O.map.depthTexture.format=zi,this.type===so?(O.map.depthTexture.compareFunction=G?np:tp,O.map.depthTexture.minFilter=kt,O.map.depthTexture.magFilter=kt):(O.map.depthTexture.compareFunction=null,O.map.depthTexture.minFilter=Tt,O.map.depthTexture.magFilter=Tt);O.camera.updateProjectionMatrix()}O.map.isWebGLCubeRenderTarget!==!0&&(O.map.width!==r.x||O.map.height!==r.y)&&O.map.setSize(r.x,r.y);let Y=O.map.isWebGLCubeRenderTarget?6:O.getViewportCount();B.isPointLight!==!0&&O.updateMatrices(B,A);let ee=(O.camera.layers.mask&4294967294)!==0?O.camera.layers:A.layers;for(let ye=0;ye<Y;ye++){let Ee=O.getCamera(ye);if(B.isPointLight){let $=O.camera,ne=O.matrix,he=B.distance||$.far;he!==$.far&&($.far=he,$.updateProjectionMatrix()),mo.setFromMatrixPosition(B.matrixWorld),$.position.copy(mo),hp.copy($.position),hp.add(rw[ye]),$.up.copy(sw[ye]),$.lookAt(hp),$.updateMatrixWorld(),ne.makeTranslation(-mo.x,-mo.y,-mo.z),s1.multiplyMatrices($.projectionMatrix,$.matrixWorldInverse),O._frustum.setFromProjectionMatrix(s1,$.coordinateSystem,$.reversedDepth)}if(O.map.isWebGLCubeRenderTarget)n.setRenderTarget(O.map,ye),n.clear();else{ye===0&&(n.setRenderTarget(O.map),n.clear());let $=O.getViewport(ye);a.set(s.x*$.x,s.y*$.y,s.x*$.z,s.y*$.w),z.viewport(a)}i=O.getFrustum(ye),x(v,A,Ee,B,ee,this.type)}O.isPointLightShadow!==!0&&this.type===Qs&&y(O,A),O.needsUpdate=!1}g=this.type,m.needsUpdate=!1,n.setRenderTarget(L,R,N)};function y(w,v){let A=e.update(b);u.defines.VSM_SAMPLES!==w.blurSamples&&(u.defines.VSM_SAMPLES=w.blurSamples,p.defines.VSM_SAMPLES=w.blurSamples,u.needsUpdate=!0,p.needsUpdate=!0),w.mapPass===null?w.mapPass=new Mn(r.x,r.y,{format:br,type:si}):(w.mapPass.width!==w.map.width||w.mapPass.height!==w.map.height)&&w.mapPass.setSize(w.map.width,w.map.height),u.uniforms.shadow_pass.value=w.map.depthTexture,u.uniforms.resolution.value.set(w.map.width,w.map.height),u.uniforms.radius.value=w.radius,n.setRenderTarget(w.mapPass),n.clear(),n.renderBufferDirect(v,null,A,u,b,null),p.uniforms.shadow_pass.value=w.mapPass.texture,p.uniforms.resolution.value.set(w.map.width,w.map.height),p.uniforms.radius.value=w.radius,n.setRenderTarget(w.map),n.clear(),n.renderBufferDirect(v,null,A,p,b,null)}function _(w,v,A,L){let R=null,N=A.isPointLight===!0?w.customDistanceMaterial:w.customDepthMaterial;if(N!==void 0)R=N;else if(R=A.isPointLight===!0?l:o,n.localClippingEnabled&&v.clipShadows===!0&&Array.isArray(v.clippingPlanes)&&v.clippingPlanes.length!==0||v.displacementMap&&v.displacementScale!==0||v.alphaMap&&v.alphaTest>0||v.map&&v.alphaTest>0||v.alphaToCoverage===!0){let z=R.uuid,H=v.uuid,P=c[z];P===void 0&&(P={},c[z]=P);let W=P[H];W===void 0&&(W=R.clone(),P[H]=W,v.addEventListener("dispose",E)),R=W}if(R.visible=v.visible,R.wireframe=v.wireframe,L===Qs?R.side=v.shadowSide!==null?v.shadowSide:v.side:R.side=v.shadowSide!==null?v.shadowSide:d[v.side],R.alphaMap=v.alphaMap,R.alphaTest=v.alphaToCoverage===!0?.5:v.alphaTest,R.map=v.map,R.clipShadows=v.clipShadows,R.clippingPlanes=v.clippingPlanes,R.clipIntersection=v.clipIntersection,R.displacementMap=v.displacementMap,R.displacementScale=v.displacementScale,R.displacementBias=v.displacementBias,R.wireframeLinewidth=v.wireframeLinewidth,R.linewidth=v.linewidth,A.isPointLight===!0&&R.isMeshDistanceMaterial===!0){let z=n.properties.get(R);z.light=A}return R}function x(w,v,A,L,R,N){if(w.visible===!1)return;if(w.layers.test(R)&&(w.isMesh||w.isLine||w.isPoints)&&(w.castShadow||w.receiveShadow&&N===Qs)&&(!w.frustumCulled||w.intersectsFrustum(i))){w.modelViewMatrix.multiplyMatrices(A.matrixWorldInverse,w.matrixWorld);let P=e.update(w),W=w.material;if(Array.isArray(W)){let B=P.groups;for(let O=0,Q=B.length;O<Q;O++){let G=B[O],Y=W[G.materialIndex];if(Y&&Y.visible){let ee=_(w,Y,L,N);w.onBeforeShadow(n,w,v,A,P,ee,G),n.renderBufferDirect(A,null,P,ee,w,G),w.onAfterShadow(n,w,v,A,P,ee,G)}}}else if(W.visible){let B=_(w,W,L,N);w.onBeforeShadow(n,w,v,A,P,B,null),n.renderBufferDirect(A,null,P,B,w,null),w.onAfterShadow(n,w,v,A,P,B,null)}}let H=w.children;for(let P=0,W=H.length;P<W;P++)x(H[P],v,A,L,R,N)}function E(w){w.target.removeEventListener("dispose",E);for(let A in c){let L=c[A],R=w.target.uuid;R in L&&(L[R].dispose(),delete L[R])}}}function ow(n,e){function t(){let I=!1,K=new ht,J=null,ce=new ht(0,0,0,0);return{setMask:function(se){J!==se&&!I&&(n.colorMask(se,se,se,se),J=se)},setLocked:function(se){I=se},setClear:function(se,oe,Te,Ge,re){re===!0&&(se*=Ge,oe*=Ge,Te*=Ge),K.set(se,oe,Te,Ge),ce.equals(K)===!1&&(n.clearColor(se,oe,Te,Ge),ce.copy(K))},reset:function(){I=!1,J=null,ce.set(-1,0,0,0)}}}function i(){let I=!1,K=!1,J=null,ce=null,se=null;return{setReversed:function(oe){if(K!==oe){let Te=e.get("EXT_clip_control");oe?Te.clipControlEXT(Te.LOWER_LEFT_EXT,Te.ZERO_TO_ONE_EXT):Te.clipControlEXT(Te.LOWER_LEFT_EXT,Te.NEGATIVE_ONE_TO_ONE_EXT),K=oe;let Ge=se;se=null,this.setClear(Ge)}},getReversed:function(){return K},setTest:function(oe){oe?ue(n.DEPTH_TEST):Fe(n.DEPTH_TEST)},setMask:function(oe){J!==oe&&!I&&(n.depthMask(oe),J=oe)},setFunc:function(oe){if(K&&(oe=Ig[oe]),ce!==oe){switch(oe){case Xl:n.depthFunc(n.NEVER);break;case Yl:n.depthFunc(n.ALWAYS);break;case Jl:n.depthFunc(n.LESS);break;case Hs:n.depthFunc(n.LEQUAL);break;case jl:n.depthFunc(n.EQUAL);break;case Zl:n.depthFunc(n.GEQUAL);break;case Gs:n.depthFunc(n.GREATER);break;case Kl:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}ce=oe}},setLocked:function(oe){I=oe},setClear:function(oe){se!==oe&&(se=oe,K&&(oe=1-oe),n.clearDepth(oe))},reset:function(){I=!1,J=null,ce=null,se=null,K=!1}}}function r(){let I=!1,K=null,J=null,ce=null,se=null,oe=null,Te=null,Ge=null,re=null;return{setTest:function(Re){I||(Re?ue(n.STENCIL_TEST):Fe(n.STENCIL_TEST))},setMask:function(Re){K!==Re&&!I&&(n.stencilMask(Re),K=Re)},setFunc:function(Re,He,ge){(J!==Re||ce!==He||se!==ge)&&(n.stencilFunc(Re,He,ge),J=Re,ce=He,se=ge)},setOp:function(Re,He,ge){(oe!==Re||Te!==He||Ge!==ge)&&(n.stencilOp(Re,He,ge),oe=Re,Te=He,Ge=ge)},setLocked:function(Re){I=Re},setClear:function(Re){re!==Re&&(n.clearStencil(Re),re=Re)},reset:function(){I=!1,K=null,J=null,ce=null,se=null,oe=null,Te=null,Ge=null,re=null}}}let s=new t,a=new i,o=new r,l={},c=new WeakMap,h={},d={},u={},p=new WeakMap,f=[],b=null,m=!1,g=null,y=null,_=null,x=null,E=null,w=null,v=null,A=new We(0,0,0),L=0,R=!1,N=null,z=null,H=null,P=null,W=null,B=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),O=!1,Q=0,G=n.getParameter(n.VERSION);G.indexOf("WebGL")!==-1?(Q=parseFloat(/^WebGL (\d)/.exec(G)[1]),O=Q>=1):G.indexOf("OpenGL ES")!==-1&&(Q=parseFloat(/^OpenGL ES (\d)/.exec(G)[1]),O=Q>=2);let Y=null,ee={},ye=n.getParameter(n.SCISSOR_BOX),Ee=n.getParameter(n.VIEWPORT),$=new ht().fromArray(ye),ne=new ht().fromArray(Ee);function he(I,K,J,ce){let se=new Uint8Array(4),oe=n.createTexture();n.bindTexture(I,oe),n.texParameteri(I,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(I,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Te=0;Te<J;Te++)I===n.TEXTURE_3D||I===n.TEXTURE_2D_ARRAY?n.texImage3D(K,0,n.RGBA,1,1,ce,0,n.RGBA,n.UNSIGNED_BYTE,se):n.texImage2D(K+Te,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,se);return oe}let xe={};xe[n.TEXTURE_2D]=he(n.TEXTURE_2D,n.TEXTURE_2D,1),xe[n.TEXTURE_CUBE_MAP]=he(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),xe[n.TEXTURE_2D_ARRAY]=he(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),xe[n.TEXTURE_3D]=he(n.TEXTURE_3D,n.TEXTURE_3D,1,1),s.setClear(0,0,0,1),a.setClear(1),o.setClear(0),ue(n.DEPTH_TEST),a.setFunc(Hs),an(!1),bt(Ld),ue(n.CULL_FACE),Ut(jr);function ue(I){h[I]!==!0&&(n.enable(I),h[I]=!0)}function Fe(I){h[I]!==!1&&(n.disable(I),h[I]=!1)}function ft(I,K){return u[I]!==K?(n.bindFramebuffer(I,K),u[I]=K,I===n.DRAW_FRAMEBUFFER&&(u[n.FRAMEBUFFER]=K),I===n.FRAMEBUFFER&&(u[n.DRAW_FRAMEBUFFER]=K),!0):!1}function Pe(I,K){let J=f,ce=!1;if(I){J=p.get(K),J===void 0&&(J=[],p.set(K,J));let se=I.textures;if(J.length!==se.length||J[0]!==n.COLOR_ATTACHMENT0){for(let oe=0,Te=se.length;oe<Te;oe++)J[oe]=n.COLOR_ATTACHMENT0+oe;J.length=se.length,ce=!0}}else J[0]!==n.BACK&&(J[0]=n.BACK,ce=!0);ce&&n.drawBuffers(J)}function tt(I){return b!==I?(n.useProgram(I),b=I,!0):!1}let rt={[Zr]:n.FUNC_ADD,[eg]:n.FUNC_SUBTRACT,[tg]:n.FUNC_REVERSE_SUBTRACT};rt[ng]=n.MIN,rt[ig]=n.MAX;let Ye={[rg]:n.ZERO,[sg]:n.ONE,[ag]:n.SRC_COLOR,[Od]:n.SRC_ALPHA,[dg]:n.SRC_ALPHA_SATURATE,[hg]:n.DST_COLOR,[lg]:n.DST_ALPHA,[og]:n.ONE_MINUS_SRC_COLOR,[kd]:n.ONE_MINUS_SRC_ALPHA,[ug]:n.ONE_MINUS_DST_COLOR,[cg]:n.ONE_MINUS_DST_ALPHA,[pg]:n.CONSTANT_COLOR,[fg]:n.ONE_MINUS_CONSTANT_COLOR,[mg]:n.CONSTANT_ALPHA,[gg]:n.ONE_MINUS_CONSTANT_ALPHA};function Ut(I,K,J,ce,se,oe,Te,Ge,re,Re){if(I===jr){m===!0&&(Fe(n.BLEND),m=!1);return}if(m===!1&&(ue(n.BLEND),m=!0),I!==Q0){if(I!==g||Re!==R){if((y!==Zr||E!==Zr)&&(n.blendEquation(n.FUNC_ADD),y=Zr,E=Zr),Re)switch(I){case ea:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Dd:n.blendFunc(n.ONE,n.ONE);break;case Fd:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case zd:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:ze("WebGLState: Invalid blending: ",I);break}else switch(I){case ea:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Dd:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case Fd:ze("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case zd:ze("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:ze("WebGLState: Invalid blending: ",I);break}_=null,x=null,w=null,v=null,A.set(0,0,0),L=0,g=I,R=Re}return}se=se||K,oe=oe||J,Te=Te||ce,(K!==y||se!==E)&&(n.blendEquationSeparate(rt[K],rt[se]),y=K,E=se),(J!==_||ce!==x||oe!==w||Te!==v)&&(n.blendFuncSeparate(Ye[J],Ye[ce],Ye[oe],Ye[Te]),_=J,x=ce,w=oe,v=Te),(Ge.equals(A)===!1||re!==L)&&(n.blendColor(Ge.r,Ge.g,Ge.b,re),A.copy(Ge),L=re),g=I,R=!1}function Ct(I,K){I.side===Bn?Fe(n.CULL_FACE):ue(n.CULL_FACE);let J=I.side===rn;K&&(J=!J),an(J),I.blending===ea&&I.transparent===!1?Ut(jr):Ut(I.blending,I.blendEquation,I.blendSrc,I.blendDst,I.blendEquationAlpha,I.blendSrcAlpha,I.blendDstAlpha,I.blendColor,I.blendAlpha,I.premultipliedAlpha),a.setFunc(I.depthFunc),a.setTest(I.depthTest),a.setMask(I.depthWrite),s.setMask(I.colorWrite);let ce=I.stencilWrite;o.setTest(ce),ce&&(o.setMask(I.stencilWriteMask),o.setFunc(I.stencilFunc,I.stencilRef,I.stencilFuncMask),o.setOp(I.stencilFail,I.stencilZFail,I.stencilZPass)),Dt(I.polygonOffset,I.polygonOffsetFactor,I.polygonOffsetUnits),I.alphaToCoverage===!0?ue(n.SAMPLE_ALPHA_TO_COVERAGE):Fe(n.SAMPLE_ALPHA_TO_COVERAGE)}function an(I){N!==I&&(I?n.frontFace(n.CW):n.frontFace(n.CCW),N=I)}function bt(I){I!==j0?(ue(n.CULL_FACE),I!==z&&(I===Ld?n.cullFace(n.BACK):I===Z0?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Fe(n.CULL_FACE),z=I}function ai(I){I!==H&&(O&&n.lineWidth(I),H=I)}function Dt(I,K,J){I?(ue(n.POLYGON_OFFSET_FILL),(P!==K||W!==J)&&(P=K,W=J,a.getReversed()&&(K=-K,J=-J),n.polygonOffset(K,J))):Fe(n.POLYGON_OFFSET_FILL)}function Cn(I){I?ue(n.SCISSOR_TEST):Fe(n.SCISSOR_TEST)}function Rn(I){I===void 0&&(I=n.TEXTURE0+B-1),Y!==I&&(n.activeTexture(I),Y=I)}function Pn(I,K,J){J===void 0&&(Y===null?J=n.TEXTURE0+B-1:J=Y);let ce=ee[J];ce===void 0&&(ce={type:void 0,texture:void 0},ee[J]=ce),(ce.type!==I||ce.texture!==K)&&(Y!==J&&(n.activeTexture(J),Y=J),n.bindTexture(I,K||xe[I]),ce.type=I,ce.texture=K)}function F(){let I=ee[Y];I!==void 0&&I.type!==void 0&&(n.bindTexture(I.type,null),I.type=void 0,I.texture=void 0)}function In(){try{n.compressedTexImage2D(...arguments)}catch(I){ze("WebGLState:",I)}}function mt(){try{n.compressedTexImage3D(...arguments)}catch(I){ze("WebGLState:",I)}}function gt(){try{n.texSubImage2D(...arguments)}catch(I){ze("WebGLState:",I)}}function me(){try{n.texSubImage3D(...arguments)}catch(I){ze("WebGLState:",I)}}function Rt(){try{n.compressedTexSubImage2D(...arguments)}catch(I){ze("WebGLState:",I)}}function Ie(){try{n.compressedTexSubImage3D(...arguments)}catch(I){ze("WebGLState:",I)}}function Ue(){try{n.texStorage2D(...arguments)}catch(I){ze("WebGLState:",I)}}function C(){try{n.texStorage3D(...arguments)}catch(I){ze("WebGLState:",I)}}function S(){try{n.texImage2D(...arguments)}catch(I){ze("WebGLState:",I)}}function q(){try{n.texImage3D(...arguments)}catch(I){ze("WebGLState:",I)}}function ie(I){return d[I]!==void 0?d[I]:n.getParameter(I)}function te(I,K){d[I]!==K&&(n.pixelStorei(I,K),d[I]=K)}function ae(I){$.equals(I)===!1&&(n.scissor(I.x,I.y,I.z,I.w),$.copy(I))}function pe(I){ne.equals(I)===!1&&(n.viewport(I.x,I.y,I.z,I.w),ne.copy(I))}function j(I,K){let J=c.get(K);J===void 0&&(J=new WeakMap,c.set(K,J));let ce=J.get(I);ce===void 0&&(ce=n.getUniformBlockIndex(K,I.name),n.uniformBlockBinding(K,ce,ce),J.set(I,ce))}function Z(I,K,J){let se=c.get(K).get(I);l[se]!==J&&(n.bindBufferBase(n.UNIFORM_BUFFER,se,J),l[se]=J)}function le(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),a.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),h={},d={},Y=null,ee={},u={},l={},p=new WeakMap,f=[],b=null,m=!1,g=null,y=null,_=null,x=null,E=null,w=null,v=null,A=new We(0,0,0),L=0,R=!1,N=null,z=null,H=null,P=null,W=null,$.set(0,0,n.canvas.width,n.canvas.height),ne.set(0,0,n.canvas.width,n.canvas.height),s.reset(),a.reset(),o.reset()}return{buffers:{color:s,depth:a,stencil:o},enable:ue,disable:Fe,bindFramebuffer:ft,drawBuffers:Pe,useProgram:tt,setBlending:Ut,setMaterial:Ct,setFlipSided:an,setCullFace:bt,setLineWidth:ai,setPolygonOffset:Dt,setScissorTest:Cn,activeTexture:Rn,bindTexture:Pn,unbindTexture:F,compressedTexImage2D:In,compressedTexImage3D:mt,texImage2D:S,texImage3D:q,pixelStorei:te,getParameter:ie,updateUBOMapping:j,uniformBlockBinding:Z,texStorage2D:Ue,texStorage3D:C,texSubImage2D:gt,texSubImage3D:me,compressedTexSubImage2D:Rt,compressedTexSubImage3D:Ie,scissor:ae,viewport:pe,reset:le}}function lw(n,e,t,i,r,s,a){let o=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Xe,h=new WeakMap,d=new Set,u,p=new WeakMap,f=new Set,b=new FinalizationRegistry(C=>f.delete(C)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(C,S){return m?new OffscreenCanvas(C,S):Va("canvas")}function y(C,S,q){let ie=1,te=Ue(C);if((te.width>q||te.height>q)&&(ie=q/Math.max(te.width,te.height)),ie<1)if(typeof HTMLImageElement<"u"&&C instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&C instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&C instanceof ImageBitmap||typeof VideoFrame<"u"&&C instanceof VideoFrame){let ae=Math.floor(ie*te.width),pe=Math.floor(ie*te.height);u===void 0&&(u=g(ae,pe));let j=S?g(ae,pe):u;return j.width=ae,j.height=pe,j.getContext("2d").drawImage(C,0,0,ae,pe),Le("WebGLRenderer: Texture has been resized from ("+te.width+"x"+te.height+") to ("+ae+"x"+pe+")."),j}else return"data"in C&&Le("WebGLRenderer: Image in DataTexture is too big ("+te.width+"x"+te.height+")."),C;return C}function _(C){return C.generateMipmaps}function x(C){n.generateMipmap(C)}function E(C){return C.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:C.isWebGL3DRenderTarget?n.TEXTURE_3D:C.isWebGLArrayRenderTarget||C.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function w(C,S,q,ie,te,ae=!1){if(C!==null){if(n[C]!==void 0)return n[C];Le("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+C+"'")}let pe;ie&&(pe=e.get("EXT_texture_norm16"),pe||Le("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let j=S;if(S===n.RED&&(q===n.FLOAT&&(j=n.R32F),q===n.HALF_FLOAT&&(j=n.R16F),q===n.UNSIGNED_BYTE&&(j=n.R8),q===n.UNSIGNED_SHORT&&pe&&(j=pe.R16_EXT),q===n.SHORT&&pe&&(j=pe.R16_SNORM_EXT)),S===n.RED_INTEGER&&(q===n.UNSIGNED_BYTE&&(j=n.R8UI),q===n.UNSIGNED_SHORT&&(j=n.R16UI),q===n.UNSIGNED_INT&&(j=n.R32UI),q===n.BYTE&&(j=n.R8I),q===n.SHORT&&(j=n.R16I),q===n.INT&&(j=n.R32I)),S===n.RG&&(q===n.FLOAT&&(j=n.RG32F),q===n.HALF_FLOAT&&(j=n.RG16F),q===n.UNSIGNED_BYTE&&(j=n.RG8),q===n.UNSIGNED_SHORT&&pe&&(j=pe.RG16_EXT),q===n.SHORT&&pe&&(j=pe.RG16_SNORM_EXT)),S===n.RG_INTEGER&&(q===n.UNSIGNED_BYTE&&(j=n.RG8UI),q===n.UNSIGNED_SHORT&&(j=n.RG16UI),q===n.UNSIGNED_INT&&(j=n.RG32UI),q===n.BYTE&&(j=n.RG8I),q===n.SHORT&&(j=n.RG16I),q===n.INT&&(j=n.RG32I)),S===n.RGB_INTEGER&&(q===n.UNSIGNED_BYTE&&(j=n.RGB8UI),q===n.UNSIGNED_SHORT&&(j=n.RGB16UI),q===n.UNSIGNED_INT&&(j=n.RGB32UI),q===n.BYTE&&(j=n.RGB8I),q===n.SHORT&&(j=n.RGB16I),q===n.INT&&(j=n.RGB32I)),S===n.RGBA_INTEGER&&(q===n.UNSIGNED_BYTE&&(j=n.RGBA8UI),q===n.UNSIGNED_SHORT&&(j=n.RGBA16UI),q===n.UNSIGNED_INT&&(j=n.RGBA32UI),q===n.BYTE&&(j=n.RGBA8I),q===n.SHORT&&(j=n.RGBA16I),q===n.INT&&(j=n.RGBA32I)),S===n.RGB&&(q===n.UNSIGNED_SHORT&&pe&&(j=pe.RGB16_EXT),q===n.SHORT&&pe&&(j=pe.RGB16_SNORM_EXT),q===n.UNSIGNED_INT_5_9_9_9_REV&&(j=n.RGB9_E5),q===n.UNSIGNED_INT_10F_11F_11F_REV&&(j=n.R11F_G11F_B10F)),S===n.RGBA){let Z=ae?Ba:Ke.getTransfer(te);q===n.FLOAT&&(j=n.RGBA32F),q===n.HALF_FLOAT&&(j=n.RGBA16F),q===n.UNSIGNED_BYTE&&(j=Z===at?n.SRGB8_ALPHA8:n.RGBA8),q===n.UNSIGNED_SHORT&&pe&&(j=pe.RGBA16_EXT),q===n.SHORT&&pe&&(j=pe.RGBA16_SNORM_EXT),q===n.UNSIGNED_SHORT_4_4_4_4&&(j=n.RGBA4),q===n.UNSIGNED_SHORT_5_5_5_1&&(j=n.RGB5_A1)}return(j===n.R16F||j===n.R32F||j===n.RG16F||j===n.RG32F||j===n.RGBA16F||j===n.RGBA32F)&&e.get("EXT_color_buffer_float"),j}function v(C,S){let q;return C?S===null||S===ri||S===Qr?q=n.DEPTH24_STENCIL8:S===En?q=n.DEPTH32F_STENCIL8:S===na&&(q=n.DEPTH24_STENCIL8,Le("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):S===null||S===ri||S===Qr?q=n.DEPTH_COMPONENT24:S===En?q=n.DEPTH_COMPONENT32F:S===na&&(q=n.DEPTH_COMPONENT16),q}function A(C,S){return _(C)===!0||C.isFramebufferTexture&&C.minFilter!==Tt&&C.minFilter!==kt?Math.log2(Math.max(S.width,S.height))+1:C.mipmaps.length>0?C.mipmaps.length:C.isCompressedTexture&&Array.isArray(C.image)?S.mipmaps.length:1}function L(C){let S=new WeakRef(C);i.get(C).__ref=S,f.add(S),b.register(C,S,S)}function R(C){let S=i.get(C).__ref;S!==void 0&&(f.delete(S),b.unregister(S))}function N(C){H(C.target)}function z(C){P(C.target)}function H(C){C.removeEventListener("dispose",N),R(C),B(C),C.isVideoTexture&&h.delete(C),C.isHTMLTexture&&d.delete(C)}function P(C){C.removeEventListener("dispose",z),R(C),Q(C)}function W(){for(let C of f){let S=C.deref();S!==void 0&&(S.isRenderTarget===!0?P(S):H(S))}f.clear(),d.clear()}function B(C){let S=i.get(C);if(S.__webglInit===void 0)return;let q=C.source,ie=p.get(q);if(ie){let te=ie[S.__cacheKey];te.usedTimes--,te.usedTimes===0&&O(C),Object.keys(ie).length===0&&p.delete(q)}i.remove(C)}function O(C){let S=i.get(C);n.deleteTexture(S.__webglTexture);let q=C.source,ie=p.get(q);delete ie[S.__cacheKey],a.memory.textures--}function Q(C){let S=i.get(C);S.__depthDisposeCallback&&S.__depthDisposeCallback();let q=C.depthTexture;if(q&&q.renderTarget===C&&H(q),C.isWebGLCubeRenderTarget)for(let te=0;te<6;te++){if(Array.isArray(S.__webglFramebuffer[te]))for(let ae=0;ae<S.__webglFramebuffer[te].length;ae++)n.deleteFramebuffer(S.__webglFramebuffer[te][ae]);else n.deleteFramebuffer(S.__webglFramebuffer[te]);S.__webglDepthbuffer&&n.deleteRenderbuffer(S.__webglDepthbuffer[te])}else{if(Array.isArray(S.__webglFramebuffer))for(let te=0;te<S.__webglFramebuffer.length;te++)n.deleteFramebuffer(S.__webglFramebuffer[te]);else n.deleteFramebuffer(S.__webglFramebuffer);if(S.__webglDepthbuffer&&n.deleteRenderbuffer(S.__webglDepthbuffer),S.__webglMultisampledFramebuffer&&n.deleteFramebuffer(S.__webglMultisampledFramebuffer),S.__webglColorRenderbuffer)for(let te=0;te<S.__webglColorRenderbuffer.length;te++)S.__webglColorRenderbuffer[te]&&n.deleteRenderbuffer(S.__webglColorRenderbuffer[te]);S.__webglDepthRenderbuffer&&n.deleteRenderbuffer(S.__webglDepthRenderbuffer)}let ie=C.textures;for(let te=0,ae=ie.length;te<ae;te++){let pe=i.get(ie[te]);pe.__webglTexture&&(n.deleteTexture(pe.__webglTexture),a.memory.textures--),i.remove(ie[te])}i.remove(C)}let G=0;function Y(){G=0}function ee(){return G}function ye(C){G=C}function Ee(){let C=G;return C>=r.maxTextures&&Le("WebGLTextures: Trying to use "+(C+1)+" texture units while this GPU supports only "+r.maxTextures),G+=1,C}function $(C){let S=[];return S.push(C.wrapS),S.push(C.wrapT),S.push(C.wrapR||0),S.push(C.magFilter),S.push(C.minFilter),S.push(C.anisotropy),S.push(C.internalFormat),S.push(C.format),S.push(C.type),S.push(C.generateMipmaps),S.push(C.mipmapsAutoUpdate),S.push(C.premultiplyAlpha),S.push(C.flipY),S.push(C.unpackAlignment),S.push(C.colorSpace),S.join()}function ne(C,S){let q=i.get(C);if(C.isVideoTexture&&Rt(C),C.isRenderTargetTexture===!1&&C.isExternalTexture!==!0&&C.version>0&&q.__version!==C.version){let ie=C.image;if(ie===null)Le("WebGLRenderer: Texture marked for update but no image data found.");else if(ie.complete===!1)Le("WebGLRenderer: Texture marked for update but image is incomplete");else{Ct(q,C,S);return}}else C.isExternalTexture&&(q.__webglTexture=C.sourceTexture?C.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,q.__webglTexture,n.TEXTURE0+S)}function he(C,S){let q=i.get(C);if(C.isRenderTargetTexture===!1&&C.version>0&&q.__version!==C.version){Ct(q,C,S);return}else C.isExternalTexture&&(q.__webglTexture=C.sourceTexture?C.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,q.__webglTexture,n.TEXTURE0+S)}function xe(C,S){let q=i.get(C);if(C.isRenderTargetTexture===!1&&C.version>0&&q.__version!==C.version){Ct(q,C,S);return}t.bindTexture(n.TEXTURE_3D,q.__webglTexture,n.TEXTURE0+S)}function ue(C,S){let q=i.get(C);if(C.version>0&&q.__version!==C.version){an(q,C,S);return}t.bindTexture(n.TEXTURE_CUBE_MAP,q.__webglTexture,n.TEXTURE0+S)}let Fe={[Ql]:n.REPEAT,[gi]:n.CLAMP_TO_EDGE,[ec]:n.MIRRORED_REPEAT},ft={[Tt]:n.NEAREST,[vg]:n.NEAREST_MIPMAP_NEAREST,[ao]:n.NEAREST_MIPMAP_LINEAR,[kt]:n.LINEAR,[Ec]:n.LINEAR_MIPMAP_NEAREST,[ki]:n.LINEAR_MIPMAP_LINEAR},Pe={[Mg]:n.NEVER,[ip]:n.ALWAYS,[wg]:n.LESS,[tp]:n.LEQUAL,[Ag]:n.EQUAL,[np]:n.GEQUAL,[Eg]:n.GREATER,[Tg]:n.NOTEQUAL};function tt(C,S){if(S.type===En&&e.has("OES_texture_float_linear")===!1&&(S.magFilter===kt||S.magFilter===Ec||S.magFilter===ao||S.magFilter===ki||S.minFilter===kt||S.minFilter===Ec||S.minFilter===ao||S.minFilter===ki)&&Le("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(C,n.TEXTURE_WRAP_S,Fe[S.wrapS]),n.texParameteri(C,n.TEXTURE_WRAP_T,Fe[S.wrapT]),(C===n.TEXTURE_3D||C===n.TEXTURE_2D_ARRAY)&&n.texParameteri(C,n.TEXTURE_WRAP_R,Fe[S.wrapR]),n.texParameteri(C,n.TEXTURE_MAG_FILTER,ft[S.magFilter]),n.texParameteri(C,n.TEXTURE_MIN_FILTER,ft[S.minFilter]),S.compareFunction&&(n.texParameteri(C,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(C,n.TEXTURE_COMPARE_FUNC,Pe[S.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(S.magFilter===Tt||S.minFilter!==ao&&S.minFilter!==ki||S.type===En&&e.has("OES_texture_float_linear")===!1)return;if(S.anisotropy>1||i.get(S).__currentAnisotropy){let q=e.get("EXT_texture_filter_anisotropic");n.texParameterf(C,q.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(S.anisotropy,r.getMaxAnisotropy())),i.get(S).__currentAnisotropy=S.anisotropy}}}function rt(C,S){let q=!1;C.__webglInit===void 0&&(C.__webglInit=!0,S.addEventListener("dispose",N),L(S));let ie=S.source,te=p.get(ie);te===void 0&&(te={},p.set(ie,te));let ae=$(S);if(ae!==C.__cacheKey){te[ae]===void 0&&(te[ae]={texture:n.createTexture(),usedTimes:0},a.memory.textures++,q=!0),te[ae].usedTimes++;let pe=te[C.__cacheKey];pe!==void 0&&(te[C.__cacheKey].usedTimes--,pe.usedTimes===0&&O(S)),C.__cacheKey=ae,C.__webglTexture=te[ae].texture}return q}function Ye(C,S,q){return Math.floor(Math.floor(C/q)/S)}function Ut(C,S,q,ie){let ae=C.updateRanges;if(ae.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,S.width,S.height,q,ie,S.data);else{ae.sort((I,K)=>I.start-K.start);let pe=0;for(let I=1;I<ae.length;I++){let K=ae[pe],J=ae[I],ce=K.start+K.count,se=Ye(J.start,S.width,4),oe=Ye(K.start,S.width,4);J.start<=ce+1&&se===oe&&Ye(J.start+J.count-1,S.width,4)===se?K.count=Math.max(K.count,J.start+J.count-K.start):(++pe,ae[pe]=J)}ae.length=pe+1;let j=t.getParameter(n.UNPACK_ROW_LENGTH),Z=t.getParameter(n.UNPACK_SKIP_PIXELS),le=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,S.width);for(let I=0,K=ae.length;I<K;I++){let J=ae[I],ce=Math.floor(J.start/4),se=Math.ceil(J.count/4),oe=ce%S.width,Te=Math.floor(ce/S.width),Ge=se,re=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,oe),t.pixelStorei(n.UNPACK_SKIP_ROWS,Te),t.texSubImage2D(n.TEXTURE_2D,0,oe,Te,Ge,re,q,ie,S.data)}C.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,j),t.pixelStorei(n.UNPACK_SKIP_PIXELS,Z),t.pixelStorei(n.UNPACK_SKIP_ROWS,le)}}function Ct(C,S,q){let ie=n.TEXTURE_2D;(S.isDataArrayTexture||S.isCompressedArrayTexture)&&(ie=n.TEXTURE_2D_ARRAY),S.isData3DTexture&&(ie=n.TEXTURE_3D);let te=rt(C,S),ae=S.source;t.bindTexture(ie,C.__webglTexture,n.TEXTURE0+q);let pe=i.get(ae);if(ae.version!==pe.__version||te===!0){if(t.activeTexture(n.TEXTURE0+q),(typeof ImageBitmap<"u"&&S.image instanceof ImageBitmap)===!1){let re=Ke.getPrimaries(Ke.workingColorSpace),Re=S.colorSpace===Bi?null:Ke.getPrimaries(S.colorSpace),He=S.colorSpace===Bi||re===Re?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,S.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,He)}t.pixelStorei(n.UNPACK_ALIGNMENT,S.unpackAlignment);let Z=y(S.image,!1,r.maxTextureSize);Z=Ie(S,Z);let le=s.convert(S.format,S.colorSpace),I=s.convert(S.type),K=w(S.internalFormat,le,I,S.normalized,S.colorSpace,S.isVideoTexture);tt(ie,S);let J,ce=S.mipmaps,se=S.isVideoTexture!==!0,oe=pe.__version===void 0||te===!0,Te=ae.dataReady,Ge=A(S,Z);if(S.isDepthTexture)K=v(S.format===Ui,S.type),oe&&(se?t.texStorage2D(n.TEXTURE_2D,1,K,Z.width,Z.height):t.texImage2D(n.TEXTURE_2D,0,K,Z.width,Z.height,0,le,I,null));else if(S.isDataTexture)if(ce.length>0){se&&oe&&t.texStorage2D(n.TEXTURE_2D,Ge,K,ce[0].width,ce[0].height);for(let re=0,Re=ce.length;re<Re;re++)J=ce[re],se?Te&&t.texSubImage2D(n.TEXTURE_2D,re,0,0,J.width,J.height,le,I,J.data):t.texImage2D(n.TEXTURE_2D,re,K,J.width,J.height,0,le,I,J.data);S.generateMipmaps=!1}else se?(oe&&t.texStorage2D(n.TEXTURE_2D,Ge,K,Z.width,Z.height),Te&&Ut(S,Z,le,I)):t.texImage2D(n.TEXTURE_2D,0,K,Z.width,Z.height,0,le,I,Z.data);else if(S.isCompressedTexture)if(S.isCompressedArrayTexture){se&&oe&&t.texStorage3D(n.TEXTURE_2D_ARRAY,Ge,K,ce[0].width,ce[0].height,Z.depth);for(let re=0,Re=ce.length;re<Re;re++)if(J=ce[re],S.format!==Tn)if(le!==null)if(se){if(Te)if(S.layerUpdates.size>0){let He=lp(J.width,J.height,S.format,S.type);for(let ge of S.layerUpdates){let ot=J.data.subarray(ge*He/J.data.BYTES_PER_ELEMENT,(ge+1)*He/J.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,re,0,0,ge,J.width,J.height,1,le,ot)}}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,re,0,0,0,J.width,J.height,Z.depth,le,J.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,re,K,J.width,J.height,Z.depth,0,J.data,0,0);else Le("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else se?Te&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,re,0,0,0,J.width,J.height,Z.depth,le,I,J.data):t.texImage3D(n.TEXTURE_2D_ARRAY,re,K,J.width,J.height,Z.depth,0,le,I,J.data);S.layerUpdates.size>0&&S.clearLayerUpdates()}else{se&&oe&&t.texStorage2D(n.TEXTURE_2D,Ge,K,ce[0].width,ce[0].height);for(let re=0,Re=ce.length;re<Re;re++)J=ce[re],S.format!==Tn?le!==null?se?Te&&t.compressedTexSubImage2D(n.TEXTURE_2D,re,0,0,J.width,J.height,le,J.data):t.compressedTexImage2D(n.TEXTURE_2D,re,K,J.width,J.height,0,J.data):Le("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):se?Te&&t.texSubImage2D(n.TEXTURE_2D,re,0,0,J.width,J.height,le,I,J.data):t.texImage2D(n.TEXTURE_2D,re,K,J.width,J.height,0,le,I,J.data)}else if(S.isDataArrayTexture)if(se){if(oe&&t.texStorage3D(n.TEXTURE_2D_ARRAY,Ge,K,Z.width,Z.height,Z.depth),Te)if(S.layerUpdates.size>0){let re=lp(Z.width,Z.height,S.format,S.type);for(let Re of S.layerUpdates){let He=Z.data.subarray(Re*re/Z.data.BYTES_PER_ELEMENT,(Re+1)*re/Z.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Re,Z.width,Z.height,1,le,I,He)}S.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,Z.width,Z.height,Z.depth,le,I,Z.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,K,Z.width,Z.height,Z.depth,0,le,I,Z.data);else if(S.isData3DTexture)se?(oe&&t.texStorage3D(n.TEXTURE_3D,Ge,K,Z.width,Z.height,Z.depth),Te&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,Z.width,Z.height,Z.depth,le,I,Z.data)):t.texImage3D(n.TEXTURE_3D,0,K,Z.width,Z.height,Z.depth,0,le,I,Z.data);else if(S.isFramebufferTexture){if(oe)if(se)t.texStorage2D(n.TEXTURE_2D,Ge,K,Z.width,Z.height);else{let re=Z.width,Re=Z.height;for(let He=0;He<Ge;He++)t.texImage2D(n.TEXTURE_2D,He,K,re,Re,0,le,I,null),re>>=1,Re>>=1}}else if(S.isHTMLTexture){if("texElementImage2D"in n){let re=n.canvas;if(re.hasAttribute("layoutsubtree")||re.setAttribute("layoutsubtree","true"),Z.parentNode!==re){re.appendChild(Z),d.add(S),re.onpaint=Re=>{let He=Re.changedElements;for(let ge of d)He.includes(ge.image)&&(ge.needsUpdate=!0)},re.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,Z);else{let He=n.RGBA,ge=n.RGBA,ot=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,He,ge,ot,Z)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(ce.length>0){if(se&&oe){let re=Ue(ce[0]);t.texStorage2D(n.TEXTURE_2D,Ge,K,re.width,re.height)}for(let re=0,Re=ce.length;re<Re;re++)J=ce[re],se?Te&&t.texSubImage2D(n.TEXTURE_2D,re,0,0,le,I,J):t.texImage2D(n.TEXTURE_2D,re,K,le,I,J);S.generateMipmaps=!1}else if(se){if(oe){let re=Ue(Z);t.texStorage2D(n.TEXTURE_2D,Ge,K,re.width,re.height)}Te&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,le,I,Z)}else t.texImage2D(n.TEXTURE_2D,0,K,le,I,Z);_(S)&&S.mipmapsAutoUpdate===!0&&x(ie),pe.__version=ae.version,S.onUpdate&&S.onUpdate(S)}C.__version=S.version}function an(C,S,q){if(S.image.length!==6)return;let ie=rt(C,S),te=S.source;t.bindTexture(n.TEXTURE_CUBE_MAP,C.__webglTexture,n.TEXTURE0+q);let ae=i.get(te);if(te.version!==ae.__version||ie===!0){t.activeTexture(n.TEXTURE0+q);let pe=Ke.getPrimaries(Ke.workingColorSpace),j=S.colorSpace===Bi?null:Ke.getPrimaries(S.colorSpace),Z=S.colorSpace===Bi||pe===j?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,S.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,S.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,Z);let le=S.isCompressedTexture||S.image[0].isCompressedTexture,I=S.image[0]&&S.image[0].isDataTexture,K=[];for(let ge=0;ge<6;ge++)!le&&!I?K[ge]=y(S.image[ge],!0,r.maxCubemapSize):K[ge]=I?S.image[ge].image:S.image[ge],K[ge]=Ie(S,K[ge]);let J=K[0],ce=s.convert(S.format,S.colorSpace),se=s.convert(S.type),oe=w(S.internalFormat,ce,se,S.normalized,S.colorSpace),Te=S.isVideoTexture!==!0,Ge=ae.__version===void 0||ie===!0,re=te.dataReady,Re=A(S,J);tt(n.TEXTURE_CUBE_MAP,S);let He;if(S.isDepthTexture){if(oe=v(S.format===Ui,S.type),Ge)if(Te)t.texStorage2D(n.TEXTURE_CUBE_MAP,1,oe,J.width,J.height);else for(let ge=0;ge<6;ge++)t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ge,0,oe,J.width,J.height,0,ce,se,null)}else if(le){Te&&Ge&&t.texStorage2D(n.TEXTURE_CUBE_MAP,Re,oe,J.width,J.height);for(let ge=0;ge<6;ge++){He=K[ge].mipmaps;for(let ot=0;ot<He.length;ot++){let Ft=He[ot];S.format!==Tn?ce!==null?Te?re&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ge,ot,0,0,Ft.width,Ft.height,ce,Ft.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ge,ot,oe,Ft.width,Ft.height,0,Ft.data):Le("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Te?re&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ge,ot,0,0,Ft.width,Ft.height,ce,se,Ft.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ge,ot,oe,Ft.width,Ft.height,0,ce,se,Ft.data)}}}else{if(He=S.mipmaps,Te&&Ge){He.length>0&&Re++;let ge=Ue(K[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,Re,oe,ge.width,ge.height)}for(let ge=0;ge<6;ge++)if(I){Te?re&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ge,0,0,0,K[ge].width,K[ge].height,ce,se,K[ge].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ge,0,oe,K[ge].width,K[ge].height,0,ce,se,K[ge].data);for(let ot=0;ot<He.length;ot++){let Vi=He[ot].image[ge].image;Te?re&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ge,ot+1,0,0,Vi.width,Vi.height,ce,se,Vi.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ge,ot+1,oe,Vi.width,Vi.height,0,ce,se,Vi.data)}}else{Te?re&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ge,0,0,0,ce,se,K[ge]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ge,0,oe,ce,se,K[ge]);for(let ot=0;ot<He.length;ot++){let Ft=He[ot];Te?re&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ge,ot+1,0,0,ce,se,Ft.image[ge]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ge,ot+1,oe,ce,se,Ft.image[ge])}}}_(S)&&S.mipmapsAutoUpdate===!0&&x(n.TEXTURE_CUBE_MAP),ae.__version=te.version,S.onUpdate&&S.onUpdate(S)}C.__version=S.version}function bt(C,S,q,ie,te,ae){let pe=s.convert(q.format,q.colorSpace),j=s.convert(q.type),Z=w(q.internalFormat,pe,j,q.normalized,q.colorSpace),le=i.get(S),I=i.get(q);if(I.__renderTarget=S,!le.__hasExternalTextures){let K=Math.max(1,S.width>>ae),J=Math.max(1,S.height>>ae);te===n.TEXTURE_3D||te===n.TEXTURE_2D_ARRAY?t.texImage3D(te,ae,Z,K,J,S.depth,0,pe,j,null):t.texImage2D(te,ae,Z,K,J,0,pe,j,null)}t.bindFramebuffer(n.FRAMEBUFFER,C),me(S)?o.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ie,te,I.__webglTexture,0,gt(S)):(te===n.TEXTURE_2D||te>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&te<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,ie,te,I.__webglTexture,ae),t.bindFramebuffer(n.FRAMEBUFFER,null)}function ai(C,S,q){if(n.bindRenderbuffer(n.RENDERBUFFER,C),S.depthBuffer){let ie=S.depthTexture,te=ie&&ie.isDepthTexture?ie.type:null,ae=v(S.stencilBuffer,te),pe=S.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;me(S)?o.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,gt(S),ae,S.width,S.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,gt(S),ae,S.width,S.height):n.renderbufferStorage(n.RENDERBUFFER,ae,S.width,S.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,pe,n.RENDERBUFFER,C)}else{let ie=S.textures;for(let te=0;te<ie.length;te++){let ae=ie[te],pe=s.convert(ae.format,ae.colorSpace),j=s.convert(ae.type),Z=w(ae.internalFormat,pe,j,ae.normalized,ae.colorSpace);me(S)?o.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,gt(S),Z,S.width,S.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,gt(S),Z,S.width,S.height):n.renderbufferStorage(n.RENDERBUFFER,Z,S.width,S.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function Dt(C,S,q){let ie=S.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,C),!(S.depthTexture&&S.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let te=i.get(S.depthTexture);te.__renderTarget=S;let ae=ie?S.depthTexture.image[0]:S.depthTexture.image;(!te.__webglTexture||ae.width!==S.width||ae.height!==S.height)&&(ae.width=S.width,ae.height=S.height,S.depthTexture.needsUpdate=!0),ie?ue(S.depthTexture,0):ne(S.depthTexture,0);let pe=te.__webglTexture,j=gt(S),Z=ie?n.TEXTURE_CUBE_MAP_POSITIVE_X+q:n.TEXTURE_2D,le=S.depthTexture.format===Ui?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(S.depthTexture.format===zi)me(S)?o.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,le,Z,pe,0,j):n.framebufferTexture2D(n.FRAMEBUFFER,le,Z,pe,0);else if(S.depthTexture.format===Ui)me(S)?o.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,le,Z,pe,0,j):n.framebufferTexture2D(n.FRAMEBUFFER,le,Z,pe,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Cn(C){let S=i.get(C),q=C.isWebGLCubeRenderTarget===!0;if(S.__boundDepthTexture!==C.depthTexture){let ie=C.depthTexture;if(S.__depthDisposeCallback&&S.__depthDisposeCallback(),ie){let te=()=>{delete S.__boundDepthTexture,delete S.__depthDisposeCallback,ie.removeEventListener("dispose",te)};ie.addEventListener("dispose",te),S.__depthDisposeCallback=te}S.__boundDepthTexture=ie}if(C.depthTexture&&!S.__autoAllocateDepthBuffer)if(q)for(let ie=0;ie<6;ie++)Dt(S.__webglFramebuffer[ie],C,ie);else C.texture.mipmaps.length>0?Dt(S.__webglFramebuffer[0],C,0):Dt(S.__webglFramebuffer,C,0);else if(q){S.__webglDepthbuffer=[];for(let ie=0;ie<6;ie++)if(t.bindFramebuffer(n.FRAMEBUFFER,S.__webglFramebuffer[ie]),S.__webglDepthbuffer[ie]===void 0)S.__webglDepthbuffer[ie]=n.createRenderbuffer(),ai(S.__webglDepthbuffer[ie],C,!1);else{let te=C.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ae=S.__webglDepthbuffer[ie];n.bindRenderbuffer(n.RENDERBUFFER,ae),n.framebufferRenderbuffer(n.FRAMEBUFFER,te,n.RENDERBUFFER,ae)}}else if(C.texture.mipmaps.length>0?t.bindFramebuffer(n.FRAMEBUFFER,S.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,S.__webglFramebuffer),S.__webglDepthbuffer===void 0)S.__webglDepthbuffer=n.createRenderbuffer(),ai(S.__webglDepthbuffer,C,!1);else{let te=C.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ae=S.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,ae),n.framebufferRenderbuffer(n.FRAMEBUFFER,te,n.RENDERBUFFER,ae)}t.bindFramebuffer(n.FRAMEBUFFER,null)}function Rn(C,S,q){let ie=i.get(C);S!==void 0&&bt(ie.__webglFramebuffer,C,C.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),q!==void 0&&Cn(C)}function Pn(C){let S=C.texture,q=i.get(C),ie=i.get(S);C.addEventListener("dispose",z),L(C);let te=C.textures,ae=C.isWebGLCubeRenderTarget===!0,pe=te.length>1;if(pe||(ie.__webglTexture===void 0&&(ie.__webglTexture=n.createTexture()),ie.__version=S.version,a.memory.textures++),ae){q.__webglFramebuffer=[];for(let j=0;j<6;j++)if(S.mipmaps.length>0){q.__webglFramebuffer[j]=[];for(let Z=0;Z<S.mipmaps.length;Z++)q.__webglFramebuffer[j][Z]=n.createFramebuffer()}else q.__webglFramebuffer[j]=n.createFramebuffer()}else{if(S.mipmaps.length>0){q.__webglFramebuffer=[];for(let j=0;j<S.mipmaps.length;j++)q.__webglFramebuffer[j]=n.createFramebuffer()}else q.__webglFramebuffer=n.createFramebuffer();if(pe)for(let j=0,Z=te.length;j<Z;j++){let le=i.get(te[j]);le.__webglTexture===void 0&&(le.__webglTexture=n.createTexture(),a.memory.textures++)}if(C.samples>0&&me(C)===!1){q.__webglMultisampledFramebuffer=n.createFramebuffer(),q.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,q.__webglMultisampledFramebuffer);for(let j=0;j<te.length;j++){let Z=te[j];q.__webglColorRenderbuffer[j]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,q.__webglColorRenderbuffer[j]);let le=s.convert(Z.format,Z.colorSpace),I=s.convert(Z.type),K=w(Z.internalFormat,le,I,Z.normalized,Z.colorSpace,C.isXRRenderTarget===!0),J=gt(C);n.renderbufferStorageMultisample(n.RENDERBUFFER,J,K,C.width,C.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+j,n.RENDERBUFFER,q.__webglColorRenderbuffer[j])}n.bindRenderbuffer(n.RENDERBUFFER,null),C.depthBuffer&&(q.__webglDepthRenderbuffer=n.createRenderbuffer(),ai(q.__webglDepthRenderbuffer,C,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(ae){t.bindTexture(n.TEXTURE_CUBE_MAP,ie.__webglTexture),tt(n.TEXTURE_CUBE_MAP,S);for(let j=0;j<6;j++)if(S.mipmaps.length>0)for(let Z=0;Z<S.mipmaps.length;Z++)bt(q.__webglFramebuffer[j][Z],C,S,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+j,Z);else bt(q.__webglFramebuffer[j],C,S,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+j,0);_(S)?x(n.TEXTURE_CUBE_MAP):S.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),t.unbindTexture()}else if(pe){for(let j=0,Z=te.length;j<Z;j++){let le=te[j],I=i.get(le),K=n.TEXTURE_2D;(C.isWebGL3DRenderTarget||C.isWebGLArrayRenderTarget)&&(K=C.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(K,I.__webglTexture),tt(K,le),bt(q.__webglFramebuffer,C,le,n.COLOR_ATTACHMENT0+j,K,0),_(le)&&x(K)}t.unbindTexture()}else{let j=n.TEXTURE_2D;if((C.isWebGL3DRenderTarget||C.isWebGLArrayRenderTarget)&&(j=C.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(j,ie.__webglTexture),tt(j,S),S.mipmaps.length>0)for(let Z=0;Z<S.mipmaps.length;Z++)bt(q.__webglFramebuffer[Z],C,S,n.COLOR_ATTACHMENT0,j,Z);else bt(q.__webglFramebuffer,C,S,n.COLOR_ATTACHMENT0,j,0);_(S)?x(j):S.mipmaps.length>0&&n.texParameteri(j,n.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),t.unbindTexture()}C.depthBuffer&&Cn(C)}function F(C){let S=C.textures;for(let q=0,ie=S.length;q<ie;q++){let te=S[q];if(_(te)&&te.mipmapsAutoUpdate===!0){let ae=E(C),pe=i.get(te).__webglTexture;t.bindTexture(ae,pe),x(ae),t.unbindTexture()}}}let In=[];function mt(C){if(C.samples>0){if(me(C)===!1){let S=C.textures,q=C.width,ie=C.height,te=n.COLOR_BUFFER_BIT,ae=C.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,pe=i.get(C),j=S.length>1;if(j)for(let le=0;le<S.length;le++)t.bindFramebuffer(n.FRAMEBUFFER,pe.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+le,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,pe.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+le,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,pe.__webglMultisampledFramebuffer),C.texture.mipmaps.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,pe.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,pe.__webglFramebuffer);for(let le=0;le<S.length;le++){if(C.resolveDepthBuffer&&(C.depthBuffer&&(te|=n.DEPTH_BUFFER_BIT),C.stencilBuffer&&C.resolveStencilBuffer&&(te|=n.STENCIL_BUFFER_BIT)),j){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,pe.__webglColorRenderbuffer[le]);let I=i.get(S[le]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,I,0)}n.blitFramebuffer(0,0,q,ie,0,0,q,ie,te,n.NEAREST),l===!0&&(In.length=0,In.push(n.COLOR_ATTACHMENT0+le),C.depthBuffer&&C.storeMultisampledDepthBuffer===!1&&In.push(ae),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,In))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),j)for(let le=0;le<S.length;le++){t.bindFramebuffer(n.FRAMEBUFFER,pe.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+le,n.RENDERBUFFER,pe.__webglColorRenderbuffer[le]);let I=i.get(S[le]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,pe.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+le,n.TEXTURE_2D,I,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,pe.__webglMultisampledFramebuffer)}else if(C.depthBuffer&&C.storeMultisampledDepthBuffer===!1&&l){let S=C.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[S])}}}function gt(C){return Math.min(r.maxSamples,C.samples)}function me(C){let S=i.get(C);return C.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&S.__useRenderToTexture!==!1}function Rt(C){let S=a.render.frame;h.get(C)!==S&&(h.set(C,S),C.update())}function Ie(C,S){let q=C.colorSpace,ie=C.format,te=C.type;return C.isCompressedTexture===!0||C.isVideoTexture===!0||q!==Ua&&q!==Bi&&(Ke.getTransfer(q)===at?(ie!==Tn||te!==sn)&&Le("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):ze("WebGLTextures: Unsupported texture color space:",q)),S}function Ue(C){return typeof HTMLImageElement<"u"&&C instanceof HTMLImageElement?(c.width=C.naturalWidth||C.width,c.height=C.naturalHeight||C.height):typeof VideoFrame<"u"&&C instanceof VideoFrame?(c.width=C.displayWidth,c.height=C.displayHeight):(c.width=C.width,c.height=C.height),c}this.allocateTextureUnit=Ee,this.resetTextureUnits=Y,this.getTextureUnits=ee,this.setTextureUnits=ye,this.setTexture2D=ne,this.setTexture2DArray=he,this.setTexture3D=xe,this.setTextureCube=ue,this.rebindTextures=Rn,this.setupRenderTarget=Pn,this.updateRenderTargetMipmap=F,this.updateMultisampleRenderTarget=mt,this.setupDepthRenderbuffer=Cn,this.setupFrameBufferTexture=bt,this.useMultisampledRTT=me,this.dispose=W}function cw(n,e){function t(i,r=Bi){let s,a=Ke.getTransfer(r);if(i===sn)return n.UNSIGNED_BYTE;if(i===Cc)return n.UNSIGNED_SHORT_4_4_4_4;if(i===Rc)return n.UNSIGNED_SHORT_5_5_5_1;if(i===jd)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Zd)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===Yd)return n.BYTE;if(i===Jd)return n.SHORT;if(i===na)return n.UNSIGNED_SHORT;if(i===Tc)return n.INT;if(i===ri)return n.UNSIGNED_INT;if(i===En)return n.FLOAT;if(i===si)return n.HALF_FLOAT;if(i===Kd)return n.ALPHA;if(i===Qd)return n.RGB;if(i===Tn)return n.RGBA;if(i===zi)return n.DEPTH_COMPONENT;if(i===Ui)return n.DEPTH_STENCIL;if(i===oo)return n.RED;if(i===Pc)return n.RED_INTEGER;if(i===br)return n.RG;if(i===Ic)return n.RG_INTEGER;if(i===Nc)return n.RGBA_INTEGER;if(i===lo||i===co||i===ho||i===uo)if(a===at)if(s=e.get("WEBGL_compressed_texture_s3tc_srgb"),s!==null){if(i===lo)return s.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===co)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===ho)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===uo)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(s=e.get("WEBGL_compressed_texture_s3tc"),s!==null){if(i===lo)return s.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===co)return s.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===ho)return s.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===uo)return s.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===Lc||i===Dc||i===Fc||i===zc)if(s=e.get("WEBGL_compressed_texture_pvrtc"),s!==null){if(i===Lc)return s.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===Dc)return s.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===Fc)return s.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===zc)return s.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===Oc||i===kc||i===Uc||i===Bc||i===qc||i===po||i===Vc)if(s=e.get("WEBGL_compressed_texture_etc"),s!==null){if(i===Oc||i===kc)return a===at?s.COMPRESSED_SRGB8_ETC2:s.COMPRESSED_RGB8_ETC2;if(i===Uc)return a===at?s.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:s.COMPRESSED_RGBA8_ETC2_EAC;if(i===Bc)return s.COMPRESSED_R11_EAC;if(i===qc)return s.COMPRESSED_SIGNED_R11_EAC;if(i===po)return s.COMPRESSED_RG11_EAC;if(i===Vc)return s.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===Hc||i===Gc||i===Wc||i===$c||i===Xc||i===Yc||i===Jc||i===jc||i===Zc||i===Kc||i===Qc||i===eh||i===th||i===nh)if(s=e.get("WEBGL_compressed_texture_astc"),s!==null){if(i===Hc)return a===at?s.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:s.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Gc)return a===at?s.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:s.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Wc)return a===at?s.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:s.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===$c)return a===at?s.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:s.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===Xc)return a===at?s.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:s.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Yc)return a===at?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:s.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Jc)return a===at?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:s.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===jc)return a===at?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:s.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Zc)return a===at?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:s.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===Kc)return a===at?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:s.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Qc)return a===at?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:s.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===eh)return a===at?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:s.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===th)return a===at?s.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:s.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===nh)return a===at?s.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:s.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===ih||i===rh||i===sh)if(s=e.get("EXT_texture_compression_bptc"),s!==null){if(i===ih)return a===at?s.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:s.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===rh)return s.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===sh)return s.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===ah||i===oh||i===fo||i===lh)if(s=e.get("EXT_texture_compression_rgtc"),s!==null){if(i===ah)return s.COMPRESSED_RED_RGTC1_EXT;if(i===oh)return s.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===fo)return s.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===lh)return s.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Qr?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}var hw=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,uw=`
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

}`,bp=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let i=new Qa(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,i=new Kt({vertexShader:hw,fragmentShader:uw,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Zt(new eo(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},yp=class extends bi{constructor(e,t){super();let i=this,r=null,s=1,a=null,o="local-floor",l=1,c=null,h=null,d=null,u=null,p=null,f=null,b=typeof XRWebGLBinding<"u",m=new bp,g={},y=t.getContextAttributes(),_=null,x=null,E=[],w=[],v=new Xe,A=null,L=null,R=new jt;R.viewport=new ht;let N=new jt;N.viewport=new ht;let z=[R,N],H=new Mc,P=null,W=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function($){let ne=E[$];return ne===void 0&&(ne=new Xs,E[$]=ne),ne.getTargetRaySpace()},this.getControllerGrip=function($){let ne=E[$];return ne===void 0&&(ne=new Xs,E[$]=ne),ne.getGripSpace()},this.getHand=function($){let ne=E[$];return ne===void 0&&(ne=new Xs,E[$]=ne),ne.getHandSpace()};function B($){let ne=w.indexOf($.inputSource);if(ne===-1)return;let he=E[ne];he!==void 0&&(he.update($.inputSource,$.frame,c||a),he.dispatchEvent({type:$.type,data:$.inputSource}))}function O(){r.removeEventListener("select",B),r.removeEventListener("selectstart",B),r.removeEventListener("selectend",B),r.removeEventListener("squeeze",B),r.removeEventListener("squeezestart",B),r.removeEventListener("squeezeend",B),r.removeEventListener("end",O),r.removeEventListener("inputsourceschange",Q);for(let $=0;$<E.length;$++){let ne=w[$];ne!==null&&(w[$]=null,E[$].disconnect(ne))}P=null,W=null,m.reset();for(let $ in g)delete g[$];if(e.setRenderTarget(_),p=null,u=null,d=null,r=null,x=null,Ee.stop(),i.isPresenting=!1,e.setPixelRatio(A),e.setSize(v.width,v.height,!1),L!==null){let $=L.camera;$.fov=L.fov,$.zoom=L.zoom,$.updateProjectionMatrix(),L=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function($){s=$,i.isPresenting===!0&&Le("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function($){o=$,i.isPresenting===!0&&Le("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||a},this.setReferenceSpace=function($){c=$},this.getBaseLayer=function(){return u!==null?u:p},this.getBinding=function(){return d===null&&b&&(d=new XRWebGLBinding(r,t)),d},this.getFrame=function(){return f},this.getSession=function(){return r},this.setSession=async function($){if(r=$,r!==null){if(_=e.getRenderTarget(),r.addEventListener("select",B),r.addEventListener("selectstart",B),r.addEventListener("selectend",B),r.addEventListener("squeeze",B),r.addEventListener("squeezestart",B),r.addEventListener("squeezeend",B),r.addEventListener("end",O),r.addEventListener("inputsourceschange",Q),y.xrCompatible!==!0&&await t.makeXRCompatible(),A=e.getPixelRatio(),e.getSize(v),b&&"createProjectionLayer"in XRWebGLBinding.prototype){let he=null,xe=null,ue=null;y.depth&&(ue=y.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,he=y.stencil?Ui:zi,xe=y.stencil?Qr:ri);let Fe={colorFormat:t.RGBA8,depthFormat:ue,scaleFactor:s};d=this.getBinding(),u=d.createProjectionLayer(Fe),r.updateRenderState({layers:[u]}),e.setPixelRatio(1),e.setSize(u.textureWidth,u.textureHeight,!1),x=new Mn(u.textureWidth,u.textureHeight,{format:Tn,type:sn,depthTexture:new Oi(u.textureWidth,u.textureHeight,xe,void 0,void 0,void 0,void 0,void 0,void 0,he),stencilBuffer:y.stencil,colorSpace:e.outputColorSpace,samples:y.antialias?4:0,resolveDepthBuffer:u.ignoreDepthValues===!1,resolveStencilBuffer:u.ignoreDepthValues===!1,storeMultisampledDepthBuffer:u.ignoreDepthValues===!1,storeMultisampledStencilBuffer:u.ignoreDepthValues===!1})}else{let he={antialias:y.antialias,alpha:!0,depth:y.depth,stencil:y.stencil,framebufferScaleFactor:s};p=new XRWebGLLayer(r,t,he),r.updateRenderState({baseLayer:p}),e.setPixelRatio(1),e.setSize(p.framebufferWidth,p.framebufferHeight,!1),x=new Mn(p.framebufferWidth,p.framebufferHeight,{format:Tn,type:sn,colorSpace:e.outputColorSpace,stencilBuffer:y.stencil,resolveDepthBuffer:p.ignoreDepthValues===!1,resolveStencilBuffer:p.ignoreDepthValues===!1,storeMultisampledDepthBuffer:p.ignoreDepthValues===!1,storeMultisampledStencilBuffer:p.ignoreDepthValues===!1})}x.isXRRenderTarget=!0,this.setFoveation(l),c=null,a=await r.requestReferenceSpace(o),Ee.setContext(r),Ee.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(r!==null)return r.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function Q($){for(let ne=0;ne<$.removed.length;ne++){let he=$.removed[ne],xe=w.indexOf(he);xe>=0&&(w[xe]=null,E[xe].disconnect(he))}for(let ne=0;ne<$.added.length;ne++){let he=$.added[ne],xe=w.indexOf(he);if(xe===-1){for(let Fe=0;Fe<E.length;Fe++)if(Fe>=w.length){w.push(he),xe=Fe;break}else if(w[Fe]===null){w[Fe]=he,xe=Fe;break}if(xe===-1)break}let ue=E[xe];ue&&ue.connect(he)}}function G($,ne){ne===null?$.matrixWorld.copy($.matrix):$.matrixWorld.multiplyMatrices(ne.matrixWorld,$.matrix),$.matrixWorldInverse.copy($.matrixWorld).invert()}this.updateCamera=function($){if(r===null)return;let ne=$.near,he=$.far;m.texture!==null&&(m.depthNear>0&&(ne=m.depthNear),m.depthFar>0&&(he=m.depthFar)),H.near=N.near=R.near=ne,H.far=N.far=R.far=he,(P!==H.near||W!==H.far)&&(r.updateRenderState({depthNear:H.near,depthFar:H.far}),P=H.near,W=H.far),H.layers.mask=$.layers.mask|6,R.layers.mask=H.layers.mask&-5,N.layers.mask=H.layers.mask&-3;let xe=$.parent,ue=H.cameras;G(H,xe);for(let Fe=0;Fe<ue.length;Fe++)G(ue[Fe],xe);H.projectionMatrix.copy(R.projectionMatrix),H.projectionMatrixInverse.copy(R.projectionMatrixInverse),L===null&&$.isPerspectiveCamera&&(L={camera:$,fov:$.fov,zoom:$.zoom}),Y($,H,xe)};function Y($,ne,he){he===null?$.matrix.copy(ne.matrixWorld):($.matrix.copy(he.matrixWorld),$.matrix.invert(),$.matrix.multiply(ne.matrixWorld)),$.matrix.decompose($.position,$.quaternion,$.scale),$.updateMatrixWorld(!0),$.projectionMatrix.copy(ne.projectionMatrix),$.projectionMatrixInverse.copy(ne.projectionMatrixInverse),$.isPerspectiveCamera&&($.fov=nc*2*Math.atan(1/$.projectionMatrix.elements[5]),$.zoom=1)}this.getCamera=function(){return H},this.getFoveation=function(){if(!(u===null&&p===null))return l},this.setFoveation=function($){l=$,u!==null&&(u.fixedFoveation=$),p!==null&&p.fixedFoveation!==void 0&&(p.fixedFoveation=$)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(H)},this.getCameraTexture=function($){return g[$]};let ee=null;function ye($,ne){if(h=ne.getViewerPose(c||a),f=ne,h!==null){let he=h.views;p!==null&&(e.setRenderTargetFramebuffer(x,p.framebuffer),e.setRenderTarget(x));let xe=!1;he.length!==H.cameras.length&&(H.cameras.length=0,xe=!0);for(let Pe=0;Pe<he.length;Pe++){let tt=he[Pe],rt=null;if(p!==null)rt=p.getViewport(tt);else{let Ut=d.getViewSubImage(u,tt);rt=Ut.viewport,Pe===0&&(e.setRenderTargetTextures(x,Ut.colorTexture,Ut.depthStencilTexture),e.setRenderTarget(x))}let Ye=z[Pe];Ye===void 0&&(Ye=new jt,Ye.layers.enable(Pe),Ye.viewport=new ht,z[Pe]=Ye),Ye.matrix.fromArray(tt.transform.matrix),Ye.matrix.decompose(Ye.position,Ye.quaternion,Ye.scale),Ye.projectionMatrix.fromArray(tt.projectionMatrix),Ye.projectionMatrixInverse.copy(Ye.projectionMatrix).invert(),Ye.viewport.set(rt.x,rt.y,rt.width,rt.height),Pe===0&&(H.matrix.copy(Ye.matrix),H.matrix.decompose(H.position,H.quaternion,H.scale)),xe===!0&&H.cameras.push(Ye)}let ue=r.enabledFeatures;if(ue&&ue.includes("depth-sensing")&&r.depthUsage=="gpu-optimized"&&b){d=i.getBinding();let Pe=d.getDepthInformation(he[0]);Pe&&Pe.isValid&&Pe.texture&&m.init(Pe,r.renderState)}if(ue&&ue.includes("camera-access")&&b){e.state.unbindTexture(),d=i.getBinding();for(let Pe=0;Pe<he.length;Pe++){let tt=he[Pe].camera;if(tt){let rt=g[tt];rt||(rt=new Qa,g[tt]=rt);let Ye=d.getCameraImage(tt);rt.sourceTexture=Ye}}}}for(let he=0;he<E.length;he++){let xe=w[he],ue=E[he];xe!==null&&ue!==void 0&&ue.update(xe,ne,c||a)}ee&&ee($,ne),ne.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:ne}),f=null}let Ee=new a1;Ee.setAnimationLoop(ye),this.setAnimationLoop=function($){ee=$},this.dispose=function(){}}},dw=new pt,g1=new ke;g1.set(-1,0,0,0,1,0,0,0,1);function pw(n,e){function t(m,g){m.matrixAutoUpdate===!0&&m.updateMatrix(),g.value.copy(m.matrix)}function i(m,g){g.color.getRGB(m.fogColor.value,sp(n)),g.isFog?(m.fogNear.value=g.near,m.fogFar.value=g.far):g.isFogExp2&&(m.fogDensity.value=g.density)}function r(m,g,y,_,x){g.isNodeMaterial?g.uniformsNeedUpdate=!1:g.isMeshBasicMaterial?s(m,g):g.isMeshLambertMaterial?(s(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshToonMaterial?(s(m,g),d(m,g)):g.isMeshPhongMaterial?(s(m,g),h(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshStandardMaterial?(s(m,g),u(m,g),g.isMeshPhysicalMaterial&&p(m,g,x)):g.isMeshMatcapMaterial?(s(m,g),f(m,g)):g.isMeshDepthMaterial?s(m,g):g.isMeshDistanceMaterial?(s(m,g),b(m,g)):g.isMeshNormalMaterial?s(m,g):g.isLineBasicMaterial?(a(m,g),g.isLineDashedMaterial&&o(m,g)):g.isPointsMaterial?l(m,g,y,_):g.isSpriteMaterial?c(m,g):g.isShadowMaterial?(m.color.value.copy(g.color),m.opacity.value=g.opacity):g.isShaderMaterial&&(g.uniformsNeedUpdate=!1)}function s(m,g){m.opacity.value=g.opacity,g.color&&m.diffuse.value.copy(g.color),g.emissive&&m.emissive.value.copy(g.emissive).multiplyScalar(g.emissiveIntensity),g.map&&(m.map.value=g.map,t(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,t(g.alphaMap,m.alphaMapTransform)),g.bumpMap&&(m.bumpMap.value=g.bumpMap,t(g.bumpMap,m.bumpMapTransform),m.bumpScale.value=g.bumpScale,g.side===rn&&(m.bumpScale.value*=-1)),g.normalMap&&(m.normalMap.value=g.normalMap,t(g.normalMap,m.normalMapTransform),m.normalScale.value.copy(g.normalScale),g.side===rn&&m.normalScale.value.negate()),g.displacementMap&&(m.displacementMap.value=g.displacementMap,t(g.displacementMap,m.displacementMapTransform),m.displacementScale.value=g.displacementScale,m.displacementBias.value=g.displacementBias),g.emissiveMap&&(m.emissiveMap.value=g.emissiveMap,t(g.emissiveMap,m.emissiveMapTransform)),g.specularMap&&(m.specularMap.value=g.specularMap,t(g.specularMap,m.specularMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest);let y=e.get(g),_=y.envMap,x=y.envMapRotation;_&&(m.envMap.value=_,m.envMapRotation.value.setFromMatrix4(dw.makeRotationFromEuler(x)).transpose(),_.isCubeTexture&&_.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(g1),m.reflectivity.value=g.reflectivity,m.ior.value=g.ior,m.refractionRatio.value=g.refractionRatio),g.lightMap&&(m.lightMap.value=g.lightMap,m.lightMapIntensity.value=g.lightMapIntensity,t(g.lightMap,m.lightMapTransform)),g.aoMap&&(m.aoMap.value=g.aoMap,m.aoMapIntensity.value=g.aoMapIntensity,t(g.aoMap,m.aoMapTransform))}function a(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,g.map&&(m.map.value=g.map,t(g.map,m.mapTransform))}function o(m,g){m.dashSize.value=g.dashSize,m.totalSize.value=g.dashSize+g.gapSize,m.scale.value=g.scale}function l(m,g,y,_){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.size.value=g.size*y,m.scale.value=_*.5,g.map&&(m.map.value=g.map,t(g.map,m.uvTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,t(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function c(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.rotation.value=g.rotation,g.map&&(m.map.value=g.map,t(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,t(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function h(m,g){m.specular.value.copy(g.specular),m.shininess.value=Math.max(g.shininess,1e-4)}function d(m,g){g.gradientMap&&(m.gradientMap.value=g.gradientMap)}function u(m,g){m.metalness.value=g.metalness,g.metalnessMap&&(m.metalnessMap.value=g.metalnessMap,t(g.metalnessMap,m.metalnessMapTransform)),m.roughness.value=g.roughness,g.roughnessMap&&(m.roughnessMap.value=g.roughnessMap,t(g.roughnessMap,m.roughnessMapTransform)),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)}function p(m,g,y){m.ior.value=g.ior,g.diffuseRoughness>0&&(m.diffuseRoughness.value=g.diffuseRoughness,g.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=g.diffuseRoughnessMap,t(g.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),g.sheen>0&&(m.sheenColor.value.copy(g.sheenColor).multiplyScalar(g.sheen),m.sheenRoughness.value=g.sheenRoughness,g.sheenColorMap&&(m.sheenColorMap.value=g.sheenColorMap,t(g.sheenColorMap,m.sheenColorMapTransform)),g.sheenRoughnessMap&&(m.sheenRoughnessMap.value=g.sheenRoughnessMap,t(g.sheenRoughnessMap,m.sheenRoughnessMapTransform))),g.clearcoat>0&&(m.clearcoat.value=g.clearcoat,m.clearcoatRoughness.value=g.clearcoatRoughness,g.clearcoatMap&&(m.clearcoatMap.value=g.clearcoatMap,t(g.clearcoatMap,m.clearcoatMapTransform)),g.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=g.clearcoatRoughnessMap,t(g.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),g.clearcoatNormalMap&&(m.clearcoatNormalMap.value=g.clearcoatNormalMap,t(g.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(g.clearcoatNormalScale),g.side===rn&&m.clearcoatNormalScale.value.negate())),g.dispersion>0&&(m.dispersion.value=g.dispersion),g.retroreflectivity>0&&(m.retroreflectivity.value=g.retroreflectivity),g.iridescence>0&&(m.iridescence.value=g.iridescence,m.iridescenceIOR.value=g.iridescenceIOR,m.iridescenceThicknessMinimum.value=g.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=g.iridescenceThicknessMaximum,g.iridescenceMap&&(m.iridescenceMap.value=g.iridescenceMap,t(g.iridescenceMap,m.iridescenceMapTransform)),g.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=g.iridescenceThicknessMap,t(g.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),g.transmission>0&&(m.transmission.value=g.transmission,m.transmissionSamplerMap.value=y.texture,m.transmissionSamplerSize.value.set(y.width,y.height),g.transmissionMap&&(m.transmissionMap.value=g.transmissionMap,t(g.transmissionMap,m.transmissionMapTransform)),m.thickness.value=g.thickness,g.thicknessMap&&(m.thicknessMap.value=g.thicknessMap,t(g.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=g.attenuationDistance,m.attenuationColor.value.copy(g.attenuationColor)),g.anisotropy>0&&(m.anisotropyVector.value.set(g.anisotropy*Math.cos(g.anisotropyRotation),g.anisotropy*Math.sin(g.anisotropyRotation)),g.anisotropyMap&&(m.anisotropyMap.value=g.anisotropyMap,t(g.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=g.specularIntensity,m.specularColor.value.copy(g.specularColor),g.specularColorMap&&(m.specularColorMap.value=g.specularColorMap,t(g.specularColorMap,m.specularColorMapTransform)),g.specularIntensityMap&&(m.specularIntensityMap.value=g.specularIntensityMap,t(g.specularIntensityMap,m.specularIntensityMapTransform))}function f(m,g){g.matcap&&(m.matcap.value=g.matcap)}function b(m,g){let y=e.get(g).light;m.referencePosition.value.setFromMatrixPosition(y.matrixWorld),m.nearDistance.value=y.shadow.camera.near,m.farDistance.value=y.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:r}}function fw(n,e,t,i){let r={},s={};function a(y,_){let x=_.program;i.uniformBlockBinding(y,x,r[y.id])}function o(y,_){let x=r[y.id];x===void 0&&(f(y),x=l(y),r[y.id]=x,y.addEventListener("dispose",m));let E=_.program;i.updateUBOMapping(y,E);let w=e.render.frame;s[y.id]!==w&&(c(y),s[y.id]=w)}function l(y){let _=n.createBuffer(),x=y.__size,E=y.usage;return n.bindBuffer(n.UNIFORM_BUFFER,_),n.bufferData(n.UNIFORM_BUFFER,x,E),n.bindBuffer(n.UNIFORM_BUFFER,null),_}function c(y){let _=r[y.id],x=y.uniforms,E=y.__cache;n.bindBuffer(n.UNIFORM_BUFFER,_);for(let w=0,v=x.length;w<v;w++){let A=x[w];if(Array.isArray(A))for(let L=0,R=A.length;L<R;L++)h(A[L],w,L,E);else h(A,w,0,E)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function h(y,_,x,E){if(u(y,_,x,E)===!0){let w=y.__offset,v=y.value;if(Array.isArray(v)){let A=0;for(let L=0;L<v.length;L++){let R=v[L],N=b(R,!0);d(R,y.__data,A),A+=N.storage/Float32Array.BYTES_PER_ELEMENT}}else d(v,y.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,w,y.__data)}}function d(y,_,x){typeof y=="number"||typeof y=="boolean"?_[x]=y:y.isMatrix3?(_[x]=y.elements[0],_[x+1]=y.elements[1],_[x+2]=y.elements[2],_[x+3]=0,_[x+4]=y.elements[3],_[x+5]=y.elements[4],_[x+6]=y.elements[5],_[x+7]=0,_[x+8]=y.elements[6],_[x+9]=y.elements[7],_[x+10]=y.elements[8],_[x+11]=0):ArrayBuffer.isView(y)?_.set(y.subarray(0,_.length-x),x):y.toArray(_,x)}function u(y,_,x,E){let w=y.value,v=_+"_"+x;if(Array.isArray(w)){E[v]===void 0&&(E[v]=[]);let A=E[v],L=!1;for(let R=0;R<w.length;R++)p(w[R],A,R)===!0&&(L=!0);return L}return p(w,E,v)}function p(y,_,x){if(_[x]===void 0)return typeof y=="number"||typeof y=="boolean"?_[x]=y:ArrayBuffer.isView(y)?_[x]=y.slice():_[x]=y.clone(),!0;{let E=_[x];if(typeof y=="number"||typeof y=="boolean"){if(E!==y)return _[x]=y,!0}else{if(ArrayBuffer.isView(y))return!0;if(E.equals(y)===!1)return E.copy(y),!0}}return!1}function f(y){let _=y.uniforms,x=0,E=16;for(let v=0,A=_.length;v<A;v++){let L=Array.isArray(_[v])?_[v]:[_[v]];for(let R=0,N=L.length;R<N;R++){let z=L[R],H=Array.isArray(z.value)?z.value:[z.value],P=Array.isArray(_[v])||Array.isArray(z.value),W=x;for(let O=0,Q=H.length;O<Q;O++){let G=H[O],Y=b(G,P),ee=x%E,ye=ee%Y.boundary,Ee=ee+ye;x+=ye,Ee!==0&&E-Ee<Y.storage&&(x+=E-Ee),O===0&&(W=x),x+=Y.storage}let B=z.type==="int"?Int32Array:z.type==="uint"?Uint32Array:Float32Array;z.__data=new B((x-W)/Float32Array.BYTES_PER_ELEMENT),z.__offset=W}}let w=x%E;return w>0&&(x+=E-w),y.__size=x,y.__cache={},this}function b(y,_){let x={boundary:0,storage:0};return typeof y=="number"||typeof y=="boolean"?(x.boundary=4,x.storage=4):y.isVector2?(x.boundary=8,x.storage=8):y.isVector3||y.isColor?(x.boundary=16,x.storage=12):y.isVector4?(x.boundary=16,x.storage=16):y.isMatrix3?(x.boundary=16,x.storage=48):y.isMatrix4?(x.boundary=16,x.storage=64):y.isTexture?Le("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(y)?(x.boundary=16,x.storage=y.byteLength):Le("WebGLRenderer: Unsupported uniform value type.",y),_===!0&&(x.boundary=16,x.storage=Math.ceil(x.storage/16)*16),x}function m(y){let _=y.target;_.removeEventListener("dispose",m),n.deleteBuffer(r[_.id]),delete r[_.id],delete s[_.id]}function g(){for(let y in r)n.deleteBuffer(r[y]);r={},s={}}return{bind:a,update:o,dispose:g}}var mw=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),xi=null;function gw(){return xi===null&&(xi=new Yr(mw,16,16,br,si),xi.name="DFG_LUT",xi.minFilter=kt,xi.magFilter=kt,xi.wrapS=gi,xi.wrapT=gi,xi.generateMipmaps=!1,xi.needsUpdate=!0),xi}var ph=class{constructor(e={}){let{canvas:t=Cg(),context:i=null,depth:r=!0,stencil:s=!1,alpha:a=!1,antialias:o=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:d=!1,reversedDepthBuffer:u=!1,outputBufferType:p=sn}=e;this.isWebGLRenderer=!0;let f;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");f=i.getContextAttributes().alpha}else f=a;let b=p,m=new Set([Nc,Ic,Pc]),g=new Set([sn,ri,na,Qr,Cc,Rc]),y=new Uint32Array(4),_=new Int32Array(4),x={textures:[],min:[],max:[],resolution:[]},E=null,w=null,v=[],A=[],L=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=vi,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let R=this,N=!1,z=null,H=null,P=null,W=null;this._outputColorSpace=Sn;let B=0,O=0,Q=null,G=-1,Y=null,ee=new ht,ye=new ht,Ee=null,$=new We(0),ne=0,he=t.width,xe=t.height,ue=1,Fe=null,ft=null,Pe=new ht(0,0,he,xe),tt=new ht(0,0,he,xe),rt=!1,Ye=new Jr,Ut=new lc,Ct=!1,an=!1,bt=new pt,ai=new U,Dt=new ht,Cn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Rn=!1;function Pn(){return Q===null?ue:1}let F=i;function In(M,D){return t.getContext(M,D)}let mt,gt,me,Rt,Ie,Ue,C,S,q,ie,te,ae,pe,j,Z,le,I,K,J,ce,se,oe,Te;try{let M={alpha:!0,depth:r,stencil:s,antialias:o,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:d};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",Re,!1),t.addEventListener("webglcontextrestored",He,!1),t.addEventListener("webglcontextcreationerror",ge,!1),F===null){let D="webgl2";if(F=In(D,M),F===null)throw In(D)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Ge()}catch(M){throw t.removeEventListener("webglcontextlost",Re,!1),t.removeEventListener("webglcontextrestored",He,!1),t.removeEventListener("webglcontextcreationerror",ge,!1),ze("WebGLRenderer: "+M.message),M}function Ge(){mt=new TS(F),mt.init(),se=new cw(F,mt),gt=new gS(F,mt,e,se),me=new ow(F,mt),gt.reversedDepthBuffer&&u&&me.buffers.depth.setReversed(!0),H=F.createFramebuffer(),P=F.createFramebuffer(),W=F.createFramebuffer(),Rt=new PS(F),Ie=new XM,Ue=new lw(F,mt,me,Ie,gt,se,Rt),C=new ES(R),S=new Nv(F),oe=new fS(F,S),q=new CS(F,S,Rt,oe),ie=new NS(F,q,S,oe,Rt),K=new IS(F,gt,Ue),Z=new bS(Ie),te=new $M(R,C,mt,gt,oe,Z),ae=new pw(R,Ie),pe=new JM,j=new tw(mt),I=new pS(R,C,me,ie,f,l),le=new aw(R,ie,gt),Te=new fw(F,Rt,gt,me),J=new mS(F,mt,Rt),ce=new RS(F,mt,Rt),Rt.programs=te.programs,R.capabilities=gt,R.extensions=mt,R.properties=Ie,R.renderLists=pe,R.shadowMap=le,R.state=me,R.info=Rt}b!==sn&&(L=new DS(b,t.width,t.height,o,r,s));let re=new yp(R,F);this.xr=re,this.getContext=function(){return F},this.getContextAttributes=function(){return F.getContextAttributes()},this.forceContextLoss=function(){let M=mt.get("WEBGL_lose_context");M&&M.loseContext()},this.forceContextRestore=function(){let M=mt.get("WEBGL_lose_context");M&&M.restoreContext()},this.getPixelRatio=function(){return ue},this.setPixelRatio=function(M){M!==void 0&&(ue=M,this.setSize(he,xe,!1))},this.getSize=function(M){return M.set(he,xe)},this.setSize=function(M,D,X=!0){if(re.isPresenting){Le("WebGLRenderer: Can't change size while VR device is presenting.");return}he=M,xe=D,t.width=Math.floor(M*ue),t.height=Math.floor(D*ue),X===!0&&(t.style.width=M+"px",t.style.height=D+"px"),L!==null&&L.setSize(t.width,t.height),this.setViewport(0,0,M,D)},this.getDrawingBufferSize=function(M){return M.set(he*ue,xe*ue).floor()},this.setDrawingBufferSize=function(M,D,X){he=M,xe=D,ue=X,t.width=Math.floor(M*X),t.height=Math.floor(D*X),this.setViewport(0,0,M,D)},this.setEffects=function(M){if(b===sn){ze("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(M){for(let D=0;D<M.length;D++)if(M[D].isOutputPass===!0){Le("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}L.setEffects(M||[])},this.getCurrentViewport=function(M){return M.copy(ee)},this.getViewport=function(M){return M.copy(Pe)},this.setViewport=function(M,D,X,k){M.isVector4?Pe.set(M.x,M.y,M.z,M.w):Pe.set(M,D,X,k),me.viewport(ee.copy(Pe).multiplyScalar(Pn()).round())},this.getScissor=function(M){return M.copy(tt)},this.setScissor=function(M,D,X,k){M.isVector4?tt.set(M.x,M.y,M.z,M.w):tt.set(M,D,X,k),me.scissor(ye.copy(tt).multiplyScalar(Pn()).round())},this.getScissorTest=function(){return rt},this.setScissorTest=function(M){me.setScissorTest(rt=M)},this.setOpaqueSort=function(M){Fe=M},this.setTransparentSort=function(M){ft=M},this.getClearColor=function(M){return M.copy(I.getClearColor())},this.setClearColor=function(){I.setClearColor(...arguments)},this.getClearAlpha=function(){return I.getClearAlpha()},this.setClearAlpha=function(){I.setClearAlpha(...arguments)},this.clear=function(M=!0,D=!0,X=!0){let k=0;if(M){let V=!1;if(Q!==null){let fe=Q.texture.format;V=m.has(fe)}if(V){let fe=Q.texture.type,_e=g.has(fe),de=I.getClearColor(),ve=I.getClearAlpha(),we=de.r,qe=de.g,Je=de.b;_e?(y[0]=we,y[1]=qe,y[2]=Je,y[3]=ve,F.clearBufferuiv(F.COLOR,0,y)):(_[0]=we,_[1]=qe,_[2]=Je,_[3]=ve,F.clearBufferiv(F.COLOR,0,_))}else k|=F.COLOR_BUFFER_BIT}D&&(k|=F.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),X&&(k|=F.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),k!==0&&F.clear(k)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(M){M.setRenderer(this),z=M},this.dispose=function(){t.removeEventListener("webglcontextlost",Re,!1),t.removeEventListener("webglcontextrestored",He,!1),t.removeEventListener("webglcontextcreationerror",ge,!1),I.dispose(),pe.dispose(),j.dispose(),Ue.dispose(),Ie.dispose(),C.dispose(),ie.dispose(),q.dispose(),oe.dispose(),Te.dispose(),te.dispose(),re.dispose(),re.removeEventListener("sessionstart",zp),re.removeEventListener("sessionend",Op),_r.stop()};function Re(M){M.preventDefault(),Ha("WebGLRenderer: Context Lost."),N=!0}function He(){Ha("WebGLRenderer: Context Restored."),N=!1;let M=Rt.autoReset,D=le.enabled,X=le.autoUpdate,k=le.needsUpdate,V=le.type;Ge(),Rt.autoReset=M,le.enabled=D,le.autoUpdate=X,le.needsUpdate=k,le.type=V}function ge(M){ze("WebGLRenderer: A WebGL context could not be created. Reason: ",M.statusMessage)}function ot(M){let D=M.target;D.removeEventListener("dispose",ot),Ft(D)}function Ft(M){Vi(M),Ie.remove(M)}function Vi(M){let D=Ie.get(M).programs;D!==void 0&&(D.forEach(function(X){te.releaseProgram(X)}),M.isShaderMaterial&&te.releaseShaderCache(M))}this.renderBufferDirect=function(M,D,X,k,V,fe){D===null&&(D=Cn);let _e=V.isMesh&&V.matrixWorld.determinantAffine()<0,de=ub(M,D,X,k,V);me.setMaterial(k,_e);let ve=X.index,we=1;if(k.wireframe===!0){if(ve=q.getWireframeAttribute(X),ve===void 0)return;we=2}let qe=X.drawRange,Je=X.attributes.position,Se=qe.start*we,je=(qe.start+qe.count)*we;fe!==null&&(Se=Math.max(Se,fe.start*we),je=Math.min(je,(fe.start+fe.count)*we)),ve!==null?(Se=Math.max(Se,0),je=Math.min(je,ve.count)):Je!=null&&(Se=Math.max(Se,0),je=Math.min(je,Je.count));let _t=je-Se;if(_t<0||_t===1/0)return;oe.setup(V,k,de,X,ve);let ut,ct=J;if(ve!==null&&(ut=S.get(ve),ct=ce,ct.setIndex(ut)),V.isMesh)k.wireframe===!0?(me.setLineWidth(k.wireframeLinewidth*Pn()),ct.setMode(F.LINES)):ct.setMode(F.TRIANGLES);else if(V.isLine){let Ht=k.linewidth;Ht===void 0&&(Ht=1),me.setLineWidth(Ht*Pn()),V.isLineSegments?ct.setMode(F.LINES):V.isLineLoop?ct.setMode(F.LINE_LOOP):ct.setMode(F.LINE_STRIP)}else V.isPoints?ct.setMode(F.POINTS):V.isSprite&&ct.setMode(F.TRIANGLES);if(V.isBatchedMesh)if(mt.get("WEBGL_multi_draw"))ct.renderMultiDraw(V._multiDrawStarts,V._multiDrawCounts,V._multiDrawCount);else{let Ht=V._multiDrawStarts,Me=V._multiDrawCounts,en=V._multiDrawCount,st=ve?S.get(ve).bytesPerElement:1,Sr=Ie.get(k).currentProgram.getUniforms();for(let Gt=0;Gt<en;Gt++)Sr.setValue(F,"_gl_DrawID",Gt),ct.render(Ht[Gt]/st,Me[Gt])}else if(V.isInstancedMesh)ct.renderInstances(Se,_t,V.count);else if(X.isInstancedBufferGeometry){let Ht=X._maxInstanceCount!==void 0?X._maxInstanceCount:1/0,Me=Math.min(X.instanceCount,Ht);ct.renderInstances(Se,_t,Me)}else ct.render(Se,_t)};function Fp(M,D,X,k){z!==null&&M.isNodeMaterial&&z.setObject(k,M),Ct===!0&&Z.setState(M,X,!1),M.transparent===!0&&M.side===Bn&&M.forceSinglePass===!1?(M.side=rn,M.needsUpdate=!0,ca(M,D,k),M.side=gr,M.needsUpdate=!0,ca(M,D,k),M.side=Bn):ca(M,D,k)}this.compile=function(M,D,X=null){X===null&&(X=M),z!==null&&z.renderStart(M,D,X),w=j.get(X),w.init(D),A.push(w),X.traverseVisible(function(V){V.isLight&&V.layers.test(D.layers)&&(w.pushLight(V),V.castShadow&&w.pushShadow(V))}),M!==X&&M.traverseVisible(function(V){V.isLight&&V.layers.test(D.layers)&&(w.pushLight(V),V.castShadow&&w.pushShadow(V))}),w.setupLights(),z!==null&&z.updateLights(w.state.lightsArray),an=this.localClippingEnabled,Ct=Z.init(this.clippingPlanes,an),Ct===!0&&Z.setGlobalState(this.clippingPlanes,D),z!==null&&le.render(w.state.shadowsArray,X,D);let k=new Set;return M.traverse(function(V){if(!(V.isMesh||V.isPoints||V.isLine||V.isSprite))return;let fe=V.material;if(fe)if(Array.isArray(fe))for(let _e=0;_e<fe.length;_e++){let de=fe[_e];Fp(de,X,D,V),k.add(de)}else Fp(fe,X,D,V),k.add(fe)}),w=A.pop(),z!==null&&z.renderEnd(),k},this.compileAsync=function(M,D,X=null){let k=this.compile(M,D,X);return new Promise(V=>{function fe(){if(k.forEach(function(_e){let ve=Ie.get(_e).currentProgram;(ve===void 0||ve.isReady())&&k.delete(_e)}),k.size===0){V(M);return}setTimeout(fe,10)}mt.get("KHR_parallel_shader_compile")!==null?fe():setTimeout(fe,10)})};let Yh=null;function cb(M){Yh&&Yh(M)}function zp(){_r.stop()}function Op(){_r.start()}let _r=new a1;_r.setAnimationLoop(cb),typeof self<"u"&&_r.setContext(self),this.setAnimationLoop=function(M){Yh=M,re.setAnimationLoop(M),M===null?_r.stop():_r.start()},re.addEventListener("sessionstart",zp),re.addEventListener("sessionend",Op),this.render=function(M,D){if(D!==void 0&&D.isCamera!==!0){ze("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(N===!0)return;z!==null&&z.renderStart(M,D);let X=re.enabled===!0&&re.isPresenting===!0,k=L!==null&&(Q===null||X)&&L.begin(R,Q);if(M.matrixWorldAutoUpdate===!0&&M.updateMatrixWorld(),D.parent===null&&D.matrixWorldAutoUpdate===!0&&D.updateMatrixWorld(),re.enabled===!0&&re.isPresenting===!0&&(L===null||L.isCompositing()===!1)&&(re.cameraAutoUpdate===!0&&re.updateCamera(D),D=re.getCamera()),M.isScene===!0&&M.onBeforeRender(R,M,D,Q),w=j.get(M,A.length),w.init(D),w.state.textureUnits=Ue.getTextureUnits(),A.push(w),bt.multiplyMatrices(D.projectionMatrix,D.matrixWorldInverse),D.isArrayCamera?Ut.setFromArrayCamera(D):Ye.setFromProjectionMatrix(bt,kn,D.reversedDepth),an=this.localClippingEnabled,Ct=Z.init(this.clippingPlanes,an),E=pe.get(M,v.length),E.init(),v.push(E),this.info.render.frame++,re.enabled===!0&&re.isPresenting===!0){let _e=R.xr.getDepthSensingMesh();_e!==null&&Jh(_e,D,-1/0,R.sortObjects)}Jh(M,D,0,R.sortObjects),E.finish(),z!==null&&z.updateLights(w.state.lightsArray),R.sortObjects===!0&&E.sort(Fe,ft),Rn=re.enabled===!1||re.isPresenting===!1||re.hasDepthSensing()===!1,Rn&&I.addToRenderList(E,M),this.info.autoReset===!0&&this.info.reset(),Ct===!0&&Z.beginShadows();let V=w.state.shadowsArray;if(le.render(V,M,D),Ct===!0&&Z.endShadows(),(k&&L.hasRenderPass())===!1){let _e=E.opaque,de=E.transmissive;if(w.setupLights(),D.isArrayCamera){let ve=D.cameras;if(de.length>0)for(let we=0,qe=ve.length;we<qe;we++){let Je=ve[we];Up(_e,de,M,Je)}Rn&&I.render(M);for(let we=0,qe=ve.length;we<qe;we++){let Je=ve[we];kp(E,M,Je,Je.viewport)}}else de.length>0&&Up(_e,de,M,D),Rn&&I.render(M),kp(E,M,D)}Q!==null&&O===0&&(Ue.updateMultisampleRenderTarget(Q),Ue.updateRenderTargetMipmap(Q)),k&&L.end(R),M.isScene===!0&&M.onAfterRender(R,M,D),oe.resetDefaultState(),G=-1,Y=null,A.pop(),A.length>0?(w=A[A.length-1],Ue.setTextureUnits(w.state.textureUnits),Ct===!0&&Z.setGlobalState(R.clippingPlanes,w.state.camera)):w=null,v.pop(),v.length>0?E=v[v.length-1]:E=null,z!==null&&z.renderEnd()};function Jh(M,D,X,k){if(M.visible===!1)return;if(M.layers.test(D.layers)){if(M.isGroup)X=M.renderOrder;else if(M.isLOD)M.autoUpdate===!0&&M.update(D);else if(M.isLight)w.pushLight(M),M.castShadow&&w.pushShadow(M);else if(M.isSprite){let _e=D.isArrayCamera?Ut:Ye;if(!M.frustumCulled||M.intersectsFrustum(_e)){k&&Dt.setFromMatrixPosition(M.matrixWorld).applyMatrix4(bt);let de=ie.update(M),ve=M.material;ve.visible&&E.push(M,de,ve,X,Dt.z,null,D)}}else if(M.isMesh||M.isLine||M.isPoints){let _e=D.isArrayCamera?Ut:Ye;if(!M.frustumCulled||M.intersectsFrustum(_e)){let de=ie.update(M),ve=M.material;if(k&&(M.boundingSphere!==void 0?(M.boundingSphere===null&&M.computeBoundingSphere(),Dt.copy(M.boundingSphere.center)):(de.boundingSphere===null&&de.computeBoundingSphere(),Dt.copy(de.boundingSphere.center)),Dt.applyMatrix4(M.matrixWorld).applyMatrix4(bt)),Array.isArray(ve)){let we=de.groups;for(let qe=0,Je=we.length;qe<Je;qe++){let Se=we[qe],je=ve[Se.materialIndex];je&&je.visible&&E.push(M,de,je,X,Dt.z,Se,D)}}else ve.visible&&E.push(M,de,ve,X,Dt.z,null,D)}}}let fe=M.children;for(let _e=0,de=fe.length;_e<de;_e++)Jh(fe[_e],D,X,k)}function kp(M,D,X,k){let{opaque:V,transmissive:fe,transparent:_e}=M;w.setupLightsView(X),Ct===!0&&Z.setGlobalState(R.clippingPlanes,X),k&&me.viewport(ee.copy(k)),V.length>0&&To(V,D,X),fe.length>0&&To(fe,D,X),_e.length>0&&To(_e,D,X),me.buffers.depth.setTest(!0),me.buffers.depth.setMask(!0),me.buffers.color.setMask(!0),me.setPolygonOffset(!1)}function Up(M,D,X,k){if((X.isScene===!0?X.overrideMaterial:null)!==null)return;if(w.state.transmissionRenderTarget[k.id]===void 0){let Se=mt.has("EXT_color_buffer_half_float")||mt.has("EXT_color_buffer_float");w.state.transmissionRenderTarget[k.id]=new Mn(1,1,{generateMipmaps:!0,type:Se?si:sn,minFilter:ki,samples:Math.max(4,gt.samples),stencilBuffer:s,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:Ke.workingColorSpace})}let fe=w.state.transmissionRenderTarget[k.id],_e=k.viewport||ee;fe.setSize(_e.z*R.transmissionResolutionScale,_e.w*R.transmissionResolutionScale);let de=R.getRenderTarget(),ve=R.getActiveCubeFace(),we=R.getActiveMipmapLevel();R.setRenderTarget(fe),R.getClearColor($),ne=R.getClearAlpha(),ne<1&&R.setClearColor(16777215,.5),R.clear(),Rn&&I.render(X);let qe=R.toneMapping;R.toneMapping=vi;let Je=k.viewport;if(k.viewport!==void 0&&(k.viewport=void 0),w.setupLightsView(k),Ct===!0&&Z.setGlobalState(R.clippingPlanes,k),To(M,X,k),Ue.updateMultisampleRenderTarget(fe),Ue.updateRenderTargetMipmap(fe),mt.has("WEBGL_multisampled_render_to_texture")===!1){let Se=!1;for(let je=0,_t=D.length;je<_t;je++){let ut=D[je],{object:ct,geometry:Ht,material:Me,group:en}=ut;if(Me.side===Bn&&ct.layers.test(k.layers)){let st=Me.side;Me.side=rn,Me.needsUpdate=!0,Bp(ct,X,k,Ht,Me,en),Me.side=st,Me.needsUpdate=!0,Se=!0}}Se===!0&&(Ue.updateMultisampleRenderTarget(fe),Ue.updateRenderTargetMipmap(fe))}R.setRenderTarget(de,ve,we),R.setClearColor($,ne),Je!==void 0&&(k.viewport=Je),R.toneMapping=qe}function To(M,D,X){let k=D.isScene===!0?D.overrideMaterial:null;for(let V=0,fe=M.length;V<fe;V++){let _e=M[V],{object:de,geometry:ve,group:we}=_e,qe=_e.material;qe.allowOverride===!0&&k!==null&&(qe=k),de.layers.test(X.layers)&&Bp(de,D,X,ve,qe,we)}}function Bp(M,D,X,k,V,fe){z!==null&&V.isNodeMaterial&&z.setObject(M,V),M.onBeforeRender(R,D,X,k,V,fe),M.modelViewMatrix.multiplyMatrices(X.matrixWorldInverse,M.matrixWorld),M.normalMatrix.getNormalMatrix(M.modelViewMatrix),V.onBeforeRender(R,D,X,k,M,fe),V.transparent===!0&&V.side===Bn&&V.forceSinglePass===!1?(V.side=rn,V.needsUpdate=!0,R.renderBufferDirect(X,D,k,V,M,fe),V.side=gr,V.needsUpdate=!0,R.renderBufferDirect(X,D,k,V,M,fe),V.side=Bn):R.renderBufferDirect(X,D,k,V,M,fe),M.onAfterRender(R,D,X,k,V,fe)}function qp(M){let D=0;for(let X of M)X.texture!==null&&D++;return D}function ca(M,D,X){D.isScene!==!0&&(D=Cn);let k=Ie.get(M),V=w.state.lights,fe=w.state.shadowsArray,_e=V.state.version,de=te.getParameters(M,V.state,fe,D,X,w.state.lightProbeGridArray),ve=te.getProgramCacheKey(de),we=k.programs;k.environment=M.isMeshStandardMaterial||M.isMeshLambertMaterial||M.isMeshPhongMaterial?D.environment:null,k.fog=D.fog;let qe=M.isMeshStandardMaterial||M.isMeshLambertMaterial&&!M.envMap||M.isMeshPhongMaterial&&!M.envMap;k.envMap=C.get(M.envMap||k.environment,qe),k.envMapRotation=k.environment!==null&&M.envMap===null?D.environmentRotation:M.envMapRotation,we===void 0&&(M.addEventListener("dispose",ot),we=new Map,k.programs=we,k.programVariants=new Map);let Je=we.get(ve);if(Je!==void 0){if(k.currentProgram===Je&&k.lightsStateVersion===_e)return Hp(M,de),Je}else de.uniforms=te.getUniforms(M),z!==null&&M.isNodeMaterial&&z.build(M,X,de),M.onBeforeCompile(de,R),Je=te.acquireProgram(de,ve),we.set(ve,Je),k.uniforms=de.uniforms;let Se=k.uniforms;return(!M.isShaderMaterial&&!M.isRawShaderMaterial||M.clipping===!0)&&(Se.clippingPlanes=Z.uniform),Hp(M,de),k.needsLights=pb(M),k.lightsStateVersion=_e,k.needsLights&&(Se.ambientLightColor.value=V.state.ambient,Se.lightProbe.value=V.state.probe,Se.sunLights.value=V.state.sun,Se.sunLightShadows.value=V.state.sunShadow,Se.directionalLights.value=V.state.directional,Se.directionalLightShadows.value=V.state.directionalShadow,Se.spotLights.value=V.state.spot,Se.spotLightShadows.value=V.state.spotShadow,Se.rectAreaLights.value=V.state.rectArea,Se.ltc_1.value=V.state.rectAreaLTC1,Se.ltc_2.value=V.state.rectAreaLTC2,Se.pointLights.value=V.state.point,Se.pointLightShadows.value=V.state.pointShadow,Se.hemisphereLights.value=V.state.hemi,Se.sunShadowMatrix.value=V.state.sunShadowMatrix,Se.sunShadowCascade.value=V.state.sunShadowCascade,Se.directionalShadowMatrix.value=V.state.directionalShadowMatrix,Se.spotLightMatrix.value=V.state.spotLightMatrix,Se.spotLightMap.value=V.state.spotLightMap,Se.pointShadowMatrix.value=V.state.pointShadowMatrix),k.numLightProbeGrids=qp(w.state.lightProbeGridArray),k.currentProgram=Je,k.uniformsList=null,Je}function hb(M,D,X,k,V){let fe=Ie.get(M),_e=fe.currentProgram.id+","+k+","+V,de=fe.programVariants.get(_e);return de===void 0?(de=ca(M,D,X),fe.programVariants.set(_e,de)):(fe.currentProgram=de,fe.uniformsList=null,fe.outputColorSpace=k,fe.toneMapping=V),de}function Vp(M){if(M.uniformsList===null){let D=M.currentProgram.getUniforms();M.uniformsList=ra.seqWithValue(D.seq,M.uniforms)}return M.uniformsList}function Hp(M,D){let X=Ie.get(M);X.outputColorSpace=D.outputColorSpace,X.batching=D.batching,X.batchingColor=D.batchingColor,X.instancing=D.instancing,X.instancingColor=D.instancingColor,X.instancingMorph=D.instancingMorph,X.skinning=D.skinning,X.morphTargets=D.morphTargets,X.morphNormals=D.morphNormals,X.morphColors=D.morphColors,X.morphTargetsCount=D.morphTargetsCount,X.numClippingPlanes=D.numClippingPlanes,X.numIntersection=D.numClipIntersection,X.vertexAlphas=D.vertexAlphas,X.vertexTangents=D.vertexTangents,X.toneMapping=D.toneMapping}function ub(M,D,X,k,V){D.isScene!==!0&&(D=Cn),Ue.resetTextureUnits();let fe=D.fog,_e=k.isMeshStandardMaterial||k.isMeshLambertMaterial||k.isMeshPhongMaterial?D.environment:null,de=Q===null?R.outputColorSpace:Q.isXRRenderTarget===!0?Q.texture.colorSpace:Ke.workingColorSpace,ve=k.isMeshStandardMaterial||k.isMeshLambertMaterial&&!k.envMap||k.isMeshPhongMaterial&&!k.envMap,we=C.get(k.envMap||_e,ve),qe=k.vertexColors===!0&&!!X.attributes.color&&X.attributes.color.itemSize===4,Je=!!X.attributes.tangent&&(!!k.normalMap||k.anisotropy>0),Se=!!X.morphAttributes.position,je=!!X.morphAttributes.normal,_t=!!X.morphAttributes.color,ut=vi;k.toneMapped&&(Q===null||Q.isXRRenderTarget===!0)&&(ut=R.toneMapping);let ct=X.morphAttributes.position||X.morphAttributes.normal||X.morphAttributes.color,Ht=ct!==void 0?ct.length:0,Me=Ie.get(k),en=w.state.lights;if(Ct===!0&&(an===!0||M!==Y)){let yt=M===Y&&k.id===G;Z.setState(k,M,yt)}let st=!1,Sr=!1;k.version===Me.__version?Me.needsLights&&Me.lightsStateVersion!==en.state.version||V.isBatchedMesh&&Me.batching===!1||!V.isBatchedMesh&&Me.batching===!0||V.isBatchedMesh&&Me.batchingColor===!0&&V._colorsTexture===null||V.isBatchedMesh&&Me.batchingColor===!1&&V._colorsTexture!==null||V.isInstancedMesh&&Me.instancing===!1||!V.isInstancedMesh&&Me.instancing===!0||V.isSkinnedMesh&&Me.skinning===!1||!V.isSkinnedMesh&&Me.skinning===!0||V.isInstancedMesh&&Me.instancingColor===!0&&V.instanceColor===null||V.isInstancedMesh&&Me.instancingColor===!1&&V.instanceColor!==null||V.isInstancedMesh&&Me.instancingMorph===!0&&V.morphTexture===null||V.isInstancedMesh&&Me.instancingMorph===!1&&V.morphTexture!==null||Me.envMap!==we||k.fog===!0&&Me.fog!==fe||Me.numClippingPlanes!==void 0&&(Me.numClippingPlanes!==Z.numPlanes||Me.numIntersection!==Z.numIntersection)||Me.vertexAlphas!==qe||Me.vertexTangents!==Je||Me.morphTargets!==Se||Me.morphNormals!==je||Me.morphColors!==_t||Me.morphTargetsCount!==Ht||Me.numLightProbeGrids!==qp(w.state.lightProbeGridArray)?st=!0:(Me.outputColorSpace!==de||Me.toneMapping!==ut)&&(Sr=!0):(st=!0,Me.__version=k.version);let Gt=Me.currentProgram;(st===!0||Sr===!0)&&(Gt=Sr===!0?hb(k,D,V,de,ut):ca(k,D,V),z&&k.isNodeMaterial&&z.onUpdateProgram(k,Gt,Me));let Co=!1,Hi=!1,Mr=!1,nt=Gt.getUniforms(),Bt=Me.uniforms;if(me.useProgram(Gt.program)&&(Co=!0,Hi=!0,Mr=!0),k.id!==G&&(G=k.id,Hi=!0),Co||Y!==M){me.buffers.depth.getReversed()&&M.reversedDepth!==!0&&(M._reversedDepth=!0,M.updateProjectionMatrix()),nt.setValue(F,"projectionMatrix",M.projectionMatrix),nt.setValue(F,"viewMatrix",M.matrixWorldInverse);let zt=nt.map.cameraPosition;zt!==void 0&&zt.setValue(F,ai.setFromMatrixPosition(M.matrixWorld)),gt.logarithmicDepthBuffer&&nt.setValue(F,"logDepthBufFC",2/(Math.log(M.far+1)/Math.LN2)),(k.isMeshPhongMaterial||k.isMeshToonMaterial||k.isMeshLambertMaterial||k.isMeshBasicMaterial||k.isMeshStandardMaterial||k.isShaderMaterial)&&nt.setValue(F,"isOrthographic",M.isOrthographicCamera===!0),Y!==M&&(Y=M,Hi=!0,Mr=!0)}if(Me.needsLights&&(en.state.sunShadowMap.length>0&&nt.setValue(F,"sunShadowMap",en.state.sunShadowMap,Ue),en.state.directionalShadowMap.length>0&&nt.setValue(F,"directionalShadowMap",en.state.directionalShadowMap,Ue),en.state.spotShadowMap.length>0&&nt.setValue(F,"spotShadowMap",en.state.spotShadowMap,Ue),en.state.pointShadowMap.length>0&&nt.setValue(F,"pointShadowMap",en.state.pointShadowMap,Ue)),V.isSkinnedMesh){nt.setOptional(F,V,"bindMatrix"),nt.setOptional(F,V,"bindMatrixInverse");let yt=V.skeleton;yt&&(yt.boneTexture===null&&yt.computeBoneTexture(),nt.setValue(F,"boneTexture",yt.boneTexture,Ue))}V.isBatchedMesh&&(nt.setOptional(F,V,"batchingTexture"),nt.setValue(F,"batchingTexture",V._matricesTexture,Ue),nt.setOptional(F,V,"batchingIdTexture"),nt.setValue(F,"batchingIdTexture",V._indirectTexture,Ue),nt.setOptional(F,V,"batchingColorTexture"),V._colorsTexture!==null&&nt.setValue(F,"batchingColorTexture",V._colorsTexture,Ue));let Vn=X.morphAttributes;if((Vn.position!==void 0||Vn.normal!==void 0||Vn.color!==void 0)&&K.update(V,X,Gt),(Hi||Me.receiveShadow!==V.receiveShadow)&&(Me.receiveShadow=V.receiveShadow,nt.setValue(F,"receiveShadow",V.receiveShadow)),(k.isMeshStandardMaterial||k.isMeshLambertMaterial||k.isMeshPhongMaterial)&&k.envMap===null&&D.environment!==null&&(Bt.envMapIntensity.value=D.environmentIntensity),Bt.dfgLUT!==void 0&&(Bt.dfgLUT.value=gw()),Hi){if(nt.setValue(F,"toneMappingExposure",R.toneMappingExposure),Me.needsLights&&db(Bt,Mr),fe&&k.fog===!0&&ae.refreshFogUniforms(Bt,fe),ae.refreshMaterialUniforms(Bt,k,ue,xe,w.state.transmissionRenderTarget[M.id]),Me.needsLights&&Me.numLightProbeGrids>0){let yt=x,zt=0;for(let Si of w.state.lightProbeGridArray)Si.texture!==null&&(yt.textures[zt]=Si.texture,yt.min[zt]=Si.boundingBox.min,yt.max[zt]=Si.boundingBox.max,yt.resolution[zt]=Si.resolution,zt++);for(let Si in yt)yt[Si].length=zt;Bt.probesSH.value=yt.textures,Bt.probesMin.value=yt.min,Bt.probesMax.value=yt.max,Bt.probesResolution.value=yt.resolution}ra.upload(F,Vp(Me),Bt,Ue)}if(k.isShaderMaterial&&k.uniformsNeedUpdate===!0&&(ra.upload(F,Vp(Me),Bt,Ue),k.uniformsNeedUpdate=!1),k.isSpriteMaterial&&nt.setValue(F,"center",V.center),nt.setValue(F,"modelViewMatrix",V.modelViewMatrix),nt.setValue(F,"normalMatrix",V.normalMatrix),nt.setValue(F,"modelMatrix",V.matrixWorld),k.uniformsGroups!==void 0){let yt=k.uniformsGroups;for(let zt=0,Si=yt.length;zt<Si;zt++){let Wp=yt[zt];Te.update(Wp,Gt),Te.bind(Wp,Gt)}}return Gt}function db(M,D){M.ambientLightColor.needsUpdate=D,M.lightProbe.needsUpdate=D,M.sunLights.needsUpdate=D,M.sunLightShadows.needsUpdate=D,M.directionalLights.needsUpdate=D,M.directionalLightShadows.needsUpdate=D,M.pointLights.needsUpdate=D,M.pointLightShadows.needsUpdate=D,M.spotLights.needsUpdate=D,M.spotLightShadows.needsUpdate=D,M.rectAreaLights.needsUpdate=D,M.hemisphereLights.needsUpdate=D}function pb(M){return M.isMeshLambertMaterial||M.isMeshToonMaterial||M.isMeshPhongMaterial||M.isMeshStandardMaterial||M.isShadowMaterial||M.isShaderMaterial&&M.lights===!0}this.getActiveCubeFace=function(){return B},this.getActiveMipmapLevel=function(){return O},this.getRenderTarget=function(){return Q},this.setRenderTargetTextures=function(M,D,X){let k=Ie.get(M);k.__autoAllocateDepthBuffer=M.resolveDepthBuffer===!1,k.__autoAllocateDepthBuffer===!1&&(k.__useRenderToTexture=!1),Ie.get(M.texture).__webglTexture=D,Ie.get(M.depthTexture).__webglTexture=k.__autoAllocateDepthBuffer?void 0:X,k.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(M,D){let X=Ie.get(M);X.__webglFramebuffer=D,X.__useDefaultFramebuffer=D===void 0},this.setRenderTarget=function(M,D=0,X=0){Q=M,B=D,O=X;let k=null,V=!1,fe=!1;if(M){let de=Ie.get(M);if(de.__useDefaultFramebuffer!==void 0){me.bindFramebuffer(F.FRAMEBUFFER,de.__webglFramebuffer),ee.copy(M.viewport),ye.copy(M.scissor),Ee=M.scissorTest,me.viewport(ee),me.scissor(ye),me.setScissorTest(Ee),G=-1;return}else if(de.__webglFramebuffer===void 0)Ue.setupRenderTarget(M);else if(de.__hasExternalTextures)Ue.rebindTextures(M,Ie.get(M.texture).__webglTexture,Ie.get(M.depthTexture).__webglTexture);else if(M.depthBuffer){let qe=M.depthTexture;if(de.__boundDepthTexture!==qe){if(qe!==null&&Ie.has(qe)&&(M.width!==qe.image.width||M.height!==qe.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Ue.setupDepthRenderbuffer(M)}}let ve=M.texture;(ve.isData3DTexture||ve.isDataArrayTexture||ve.isCompressedArrayTexture)&&(fe=!0);let we=Ie.get(M).__webglFramebuffer;M.isWebGLCubeRenderTarget?(Array.isArray(we[D])?k=we[D][X]:k=we[D],V=!0):M.samples>0&&Ue.useMultisampledRTT(M)===!1?k=Ie.get(M).__webglMultisampledFramebuffer:Array.isArray(we)?k=we[X]:k=we,ee.copy(M.viewport),ye.copy(M.scissor),Ee=M.scissorTest}else ee.copy(Pe).multiplyScalar(ue).floor(),ye.copy(tt).multiplyScalar(ue).floor(),Ee=rt;if(X!==0&&(k=H),me.bindFramebuffer(F.FRAMEBUFFER,k)&&me.drawBuffers(M,k),me.viewport(ee),me.scissor(ye),me.setScissorTest(Ee),V){let de=Ie.get(M.texture);F.framebufferTexture2D(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_CUBE_MAP_POSITIVE_X+D,de.__webglTexture,X)}else if(fe){let de=D;for(let ve=0;ve<M.textures.length;ve++){let we=Ie.get(M.textures[ve]);F.framebufferTextureLayer(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0+ve,we.__webglTexture,X,de)}}else if(M!==null&&X!==0){let de=Ie.get(M.texture);F.framebufferTexture2D(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,de.__webglTexture,X)}G=-1};function Gp(M){let D=Ie.get(M);return(D.__readFormat!==M.format||D.__readType!==M.type)&&(D.__readFormat=M.format,D.__readType=M.type,D.__formatReadable=gt.textureFormatReadable(M.format),D.__typeReadable=gt.textureTypeReadable(M.type)),D}this.readRenderTargetPixels=function(M,D,X,k,V,fe,_e,de=0){if(!(M&&M.isWebGLRenderTarget)){ze("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let ve=Ie.get(M).__webglFramebuffer;if(M.isWebGLCubeRenderTarget&&_e!==void 0&&(ve=ve[_e],Array.isArray(ve)&&(ve=ve[0])),ve){me.bindFramebuffer(F.FRAMEBUFFER,ve);try{let we=M.textures[de],qe=we.format,Je=we.type;M.textures.length>1&&F.readBuffer(F.COLOR_ATTACHMENT0+de);let Se=Gp(we);if(Se.__formatReadable===!1){ze("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Se.__typeReadable===!1){ze("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}D>=0&&D<=M.width-k&&X>=0&&X<=M.height-V&&F.readPixels(D,X,k,V,se.convert(qe),se.convert(Je),fe)}finally{let we=Q!==null?Ie.get(Q).__webglFramebuffer:null;me.bindFramebuffer(F.FRAMEBUFFER,we)}}},this.readRenderTargetPixelsAsync=async function(M,D,X,k,V,fe,_e,de=0){if(!(M&&M.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let ve=Ie.get(M).__webglFramebuffer;if(M.isWebGLCubeRenderTarget&&_e!==void 0&&(ve=ve[_e],Array.isArray(ve)&&(ve=ve[0])),ve)if(D>=0&&D<=M.width-k&&X>=0&&X<=M.height-V){me.bindFramebuffer(F.FRAMEBUFFER,ve);let we=M.textures[de],qe=we.format,Je=we.type;M.textures.length>1&&F.readBuffer(F.COLOR_ATTACHMENT0+de);let Se=Gp(we);if(Se.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Se.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let je=F.createBuffer();F.bindBuffer(F.PIXEL_PACK_BUFFER,je),F.bufferData(F.PIXEL_PACK_BUFFER,fe.byteLength,F.STREAM_READ),F.readPixels(D,X,k,V,se.convert(qe),se.convert(Je),0),F.bindBuffer(F.PIXEL_PACK_BUFFER,null);let _t=Q!==null?Ie.get(Q).__webglFramebuffer:null;me.bindFramebuffer(F.FRAMEBUFFER,_t);let ut=F.fenceSync(F.SYNC_GPU_COMMANDS_COMPLETE,0);return F.flush(),await Pg(F,ut,4),F.bindBuffer(F.PIXEL_PACK_BUFFER,je),F.getBufferSubData(F.PIXEL_PACK_BUFFER,0,fe),F.bindBuffer(F.PIXEL_PACK_BUFFER,null),F.deleteBuffer(je),F.deleteSync(ut),fe}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(M,D=null,X=0){let k=Math.pow(2,-X),V=Math.floor(M.image.width*k),fe=Math.floor(M.image.height*k),_e=D!==null?D.x:0,de=D!==null?D.y:0;Ue.setTexture2D(M,0),F.copyTexSubImage2D(F.TEXTURE_2D,X,0,0,_e,de,V,fe),me.unbindTexture()},this.copyTextureToTexture=function(M,D,X=null,k=null,V=0,fe=0){let _e,de,ve,we,qe,Je,Se,je,_t,ut=M.isCompressedTexture?M.mipmaps[fe]:M.image;if(X!==null)_e=X.max.x-X.min.x,de=X.max.y-X.min.y,ve=X.isBox3?X.max.z-X.min.z:1,we=X.min.x,qe=X.min.y,Je=X.isBox3?X.min.z:0;else{let nt=Math.pow(2,-V);_e=Math.floor(ut.width*nt),de=Math.floor(ut.height*nt),M.isDataArrayTexture?ve=ut.depth:M.isData3DTexture?ve=Math.floor(ut.depth*nt):ve=1,we=0,qe=0,Je=0}k!==null?(Se=k.x,je=k.y,_t=k.z):(Se=0,je=0,_t=0);let ct=se.convert(D.format),Ht=se.convert(D.type),Me;D.isData3DTexture?(Ue.setTexture3D(D,0),Me=F.TEXTURE_3D):D.isDataArrayTexture||D.isCompressedArrayTexture?(Ue.setTexture2DArray(D,0),Me=F.TEXTURE_2D_ARRAY):(Ue.setTexture2D(D,0),Me=F.TEXTURE_2D),me.activeTexture(F.TEXTURE0),me.pixelStorei(F.UNPACK_FLIP_Y_WEBGL,D.flipY),me.pixelStorei(F.UNPACK_PREMULTIPLY_ALPHA_WEBGL,D.premultiplyAlpha),me.pixelStorei(F.UNPACK_ALIGNMENT,D.unpackAlignment);let en=me.getParameter(F.UNPACK_ROW_LENGTH),st=me.getParameter(F.UNPACK_IMAGE_HEIGHT),Sr=me.getParameter(F.UNPACK_SKIP_PIXELS),Gt=me.getParameter(F.UNPACK_SKIP_ROWS),Co=me.getParameter(F.UNPACK_SKIP_IMAGES);me.pixelStorei(F.UNPACK_ROW_LENGTH,ut.width),me.pixelStorei(F.UNPACK_IMAGE_HEIGHT,ut.height),me.pixelStorei(F.UNPACK_SKIP_PIXELS,we),me.pixelStorei(F.UNPACK_SKIP_ROWS,qe),me.pixelStorei(F.UNPACK_SKIP_IMAGES,Je);let Hi=M.isDataArrayTexture||M.isData3DTexture,Mr=D.isDataArrayTexture||D.isData3DTexture;if(M.isDepthTexture){let nt=Ie.get(M),Bt=Ie.get(D),Vn=Ie.get(nt.__renderTarget),yt=Ie.get(Bt.__renderTarget);me.bindFramebuffer(F.READ_FRAMEBUFFER,Vn.__webglFramebuffer),me.bindFramebuffer(F.DRAW_FRAMEBUFFER,yt.__webglFramebuffer);for(let zt=0;zt<ve;zt++)Hi&&(F.framebufferTextureLayer(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,Ie.get(M).__webglTexture,V,Je+zt),F.framebufferTextureLayer(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,Ie.get(D).__webglTexture,fe,_t+zt)),F.blitFramebuffer(we,qe,we+_e,qe+de,Se,je,Se+_e,je+de,F.DEPTH_BUFFER_BIT,F.NEAREST);me.bindFramebuffer(F.READ_FRAMEBUFFER,null),me.bindFramebuffer(F.DRAW_FRAMEBUFFER,null)}else if(V!==0||M.isRenderTargetTexture||Ie.has(M)){let nt=Ie.get(M),Bt=Ie.get(D);me.bindFramebuffer(F.READ_FRAMEBUFFER,P),me.bindFramebuffer(F.DRAW_FRAMEBUFFER,W);for(let Vn=0;Vn<ve;Vn++)Hi?F.framebufferTextureLayer(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,nt.__webglTexture,V,Je+Vn):F.framebufferTexture2D(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,nt.__webglTexture,V),Mr?F.framebufferTextureLayer(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,Bt.__webglTexture,fe,_t+Vn):F.framebufferTexture2D(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,Bt.__webglTexture,fe),V!==0?F.blitFramebuffer(we,qe,we+_e,qe+de,Se,je,Se+_e,je+de,F.COLOR_BUFFER_BIT,F.NEAREST):Mr?F.copyTexSubImage3D(Me,fe,Se,je,_t+Vn,we,qe,_e,de):F.copyTexSubImage2D(Me,fe,Se,je,we,qe,_e,de);me.bindFramebuffer(F.READ_FRAMEBUFFER,null),me.bindFramebuffer(F.DRAW_FRAMEBUFFER,null)}else Mr?M.isDataTexture||M.isData3DTexture?F.texSubImage3D(Me,fe,Se,je,_t,_e,de,ve,ct,Ht,ut.data):D.isCompressedArrayTexture?F.compressedTexSubImage3D(Me,fe,Se,je,_t,_e,de,ve,ct,ut.data):F.texSubImage3D(Me,fe,Se,je,_t,_e,de,ve,ct,Ht,ut):M.isDataTexture?F.texSubImage2D(F.TEXTURE_2D,fe,Se,je,_e,de,ct,Ht,ut.data):M.isCompressedTexture?F.compressedTexSubImage2D(F.TEXTURE_2D,fe,Se,je,ut.width,ut.height,ct,ut.data):F.texSubImage2D(F.TEXTURE_2D,fe,Se,je,_e,de,ct,Ht,ut);me.pixelStorei(F.UNPACK_ROW_LENGTH,en),me.pixelStorei(F.UNPACK_IMAGE_HEIGHT,st),me.pixelStorei(F.UNPACK_SKIP_PIXELS,Sr),me.pixelStorei(F.UNPACK_SKIP_ROWS,Gt),me.pixelStorei(F.UNPACK_SKIP_IMAGES,Co),fe===0&&D.generateMipmaps===!0&&D.mipmapsAutoUpdate===!0&&F.generateMipmap(Me),me.unbindTexture()},this.initRenderTarget=function(M){Ie.get(M).__webglFramebuffer===void 0&&Ue.setupRenderTarget(M)},this.initTexture=function(M){M.isCubeTexture?Ue.setTextureCube(M,0):M.isData3DTexture?Ue.setTexture3D(M,0):M.isDataArrayTexture||M.isCompressedArrayTexture?Ue.setTexture2DArray(M,0):Ue.setTexture2D(M,0),me.unbindTexture()},this.resetState=function(){B=0,O=0,Q=null,me.reset(),oe.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return kn}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=Ke._getDrawingBufferColorSpace(e),t.unpackColorSpace=Ke._getUnpackColorSpace()}};var xp=["open","G0","G1","G2","G3"],bw={um:1e3,mm:1,cm:.1,m:.001,km:1e-6,in:1/25.4,ft:1/304.8},yw=.2,vw=.001,xw=.01,_w=.1,b1=.05,y1=new WeakMap;function _p(n,e){let t=n.flatMap((h,d)=>h?Zm(h).map(u=>({patch:d,edge:u})):[]);if(!t.length)return[];let i=Math.min(...n.flatMap(h=>h?[Mw(h)]:[]))||1,r=Math.hypot(...[0,1,2].map(h=>Math.max(...t.map(({edge:d})=>d.high[h]))-Math.min(...t.map(({edge:d})=>d.low[h])))),s=xw*(bw[e]??.001*r),a=vw/i,o=[];t.forEach(({patch:h,edge:d},u)=>{for(let p of t.slice(u+1)){let f=ww(d,p.edge,s);if(!f)continue;let{curvatures:b,rates:m,...g}=f,y=v1(b,a),_=v1(m,a/i),x=[g.gap<=s,g.angle<=_w,y<=b1,_<=b1],E=x.indexOf(!1);o.push({first:{patch:h,side:d.side},second:{patch:p.patch,side:p.edge.side},...g,curvature:y,rate:_,order:xp[E<0?4:E]})}});let l=h=>`${h.patch} ${h.side}`,c=new Set(o.filter(h=>h.order!=="open").flatMap(h=>[l(h.first),l(h.second)]));return o.filter(h=>h.order!=="open"||!(c.has(l(h.first))||c.has(l(h.second))))}var Sw=n=>_p(n.patches.map(Xt),n.unit),vp=new WeakMap;function Mw(n){return vp.has(n)||vp.set(n,di(n).size),vp.get(n)}var v1=(n,e)=>Math.max(...n.map(([t,i])=>Math.abs(t-i)/Math.max(Math.abs(t)+Math.abs(i),e)));function ww(n,e,t){let i=Math.max(t,yw*Math.min(n.length,n.width,e.length,e.width));for(let s of[0,1,2])if(n.low[s]>e.high[s]+i||e.low[s]>n.high[s]+i)return null;let r=y1.get(n)??new WeakMap;return y1.set(n,r),r.has(e)||r.set(e,Aw(n,e,i)),r.get(e)}function Aw(n,e,t){let i=ws-1,r=f=>Math.max(Br(n.points[0],e.points[f?i:0]),Br(n.points[i],e.points[f?0:i])),s=f=>n.points.reduce((b,m,g)=>b+Br(m,e.points[f?i-g:g]),0),a=s(!0)<s(!1);if(r(a)>t)return null;let o=Float64Array.from({length:ws},(f,b)=>b/i),l=Ew(n,e,o.map(f=>a?1-f:f)),c=As(e.surface,e.side,l),h=Math.max(...c.map((f,b)=>Br(n.points[b],[f[0],f[1],f[2]])));if(h>t)return null;let d=Vu(n,o,!0,!1),u=Vu(e,l,!1,a),p=d.flatMap((f,b)=>Number.isFinite(f.curvature+u[b].curvature)?[b]:[]);return p.length?{reversed:a,gap:h,points:n.points,angle:Math.max(...p.map(f=>180/Math.PI*Math.atan2(Math.hypot(...Ca(d[f].normal,u[f].normal)),yn(d[f].normal,u[f].normal)))),curvatures:p.map(f=>[d[f].curvature,u[f].curvature]),rates:p.map(f=>[d[f].rate,u[f].rate])}:{reversed:a,gap:h,angle:NaN,curvatures:[],rates:[],points:n.points}}function Ew(n,e,t){let i=t,r=e.side[0]==="u"?6:3;for(let s=0;s<10;s++){let a=As(e.surface,e.side,i),o=i.map((c,h)=>{let d=a[h],u=[d[r],d[r+1],d[r+2]],p=n.points[h],f=yn([p[0]-d[0],p[1]-d[1],p[2]-d[2]],u)/Math.max(yn(u,u),1e-300);return Math.min(1,Math.max(0,c+f))}),l=Math.max(...o.map((c,h)=>Math.abs(c-i[h])));if(i=o,l<1e-13)break}return i}function bh(n,e,t,i){let r=new Float64Array(12);for(let s=0;s<e-1;s++)for(let a=0;a<e-1;a++){let o=s*e+a,l=[o,o+e,o+e+1,o+1],c=n(l[0]),h=n(l[1]),d=n(l[2]),u=n(l[3]);if(!(Math.min(c,h,d,u)<0&&Math.max(c,h,d,u)>0))continue;let p=0;p=gh(t,l[0],l[1],c,h,r,p),p=gh(t,l[1],l[2],h,d,r,p),p=gh(t,l[2],l[3],d,u,r,p),p=gh(t,l[3],l[0],u,c,r,p);for(let f=0;f+1<p;f+=2)i.segment(r[3*f],r[3*f+1],r[3*f+2],r[3*f+3],r[3*f+4],r[3*f+5])}}function gh(n,e,t,i,r,s,a){if(i<0==r<0||a>3)return a;let o=i/(i-r);for(let l=0;l<3;l++)s[3*a+l]=n[3*e+l]+o*(n[3*t+l]-n[3*e+l]);return a+1}var Tw=`
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
}`,Cw=`
precision highp float;
in float across;
uniform vec4 colour;
uniform float width;
uniform float veil;
layout(location = 0) out vec4 pixel;
void main() {
  float edge = 1.0 - smoothstep(0.5 * width - 0.25, 0.5 * width + 0.75, abs(across));
  pixel = vec4(colour.rgb, colour.a * veil * edge);
}`,yh=class{constructor(e,t,i=1,r=!1,s=0){this.width=t;let a=new We().setStyle(e,"srgb-linear");this.material=new Kt({glslVersion:qi,vertexShader:Tw,fragmentShader:Cw,transparent:!0,depthWrite:!1,depthTest:!r,uniforms:{viewport:{value:new Xe(1,1)},width:{value:t},colour:{value:new ht(a.r,a.g,a.b,i)},lift:{value:r?0:4e-4},veil:{value:1}}}),this.geometry=this.allocate(),this.mesh=new Zt(this.geometry,this.material),this.mesh.frustumCulled=!1,this.mesh.renderOrder=r?3:2,this.behind=s?x1(this.mesh,this.material,s):null}width;mesh;material;behind;data=new Float32Array(6*256);count=0;geometry;set colour(e){let t=new We().setStyle(e,"srgb-linear"),i=this.material.uniforms.colour.value;i.set(t.r,t.g,t.b,i.w)}resize(e,t,i,r){this.material.uniforms.viewport.value.set(.5*e,.5*t),this.material.uniforms.width.value=r*i}get drawn(){let{x:e,y:t,z:i,w:r}=this.material.uniforms.colour.value;return{ends:this.data.subarray(0,6*this.count),colour:`rgb(${[e,t,i].map(s=>Math.round(255*s)).join(" ")})`,width:this.width,opacity:r}}begin(){this.count=0}segment(e,t,i,r,s,a){let o=6*this.count;if(e-e+t-t+i-i+r-r+s-s+a-a!==0)return;if(o+6>this.data.length){let c=new Float32Array(2*this.data.length);c.set(this.data),this.data=c,this.geometry.dispose(),this.geometry=this.allocate(),this.mesh.geometry=this.geometry,this.behind&&(this.behind.geometry=this.geometry)}let l=this.data;l[o]=e,l[o+1]=t,l[o+2]=i,l[o+3]=r,l[o+4]=s,l[o+5]=a,this.count++}join(e,t){this.segment(e[0],e[1],e[2],t[0],t[1],t[2])}end(){this.geometry.instanceCount=this.count,this.mesh.visible=this.count>0;let e=this.geometry.getAttribute("start");e.data.needsUpdate=!0}dispose(){this.geometry.dispose(),this.material.dispose()}allocate(){let e=new io,t=new Float32Array([0,-1,0,1,-1,0,1,1,0,0,-1,0,1,1,0,0,1,0]);e.setAttribute("position",new Et(t,3));let i=new ro(this.data,6,1);return i.setUsage(ia),e.setAttribute("start",new Ys(i,3,0)),e.setAttribute("end",new Ys(i,3,3)),e}};function x1(n,{uniforms:e,vertexShader:t,fragmentShader:i},r){let s=new Kt({glslVersion:qi,vertexShader:t,fragmentShader:i,transparent:!0,depthWrite:!1,depthFunc:Gs,uniforms:{...e,veil:{value:r}}}),a=n instanceof Zt?new Zt(n.geometry,s):new Js(n.geometry,s);return a.frustumCulled=!1,a.renderOrder=n.renderOrder,n.add(a),a}var Rw=`
in vec4 tint;
uniform float size;
uniform float lift;
out vec4 shade_;
void main() {
  shade_ = tint;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  gl_Position.z -= lift * gl_Position.w;
  gl_PointSize = size * (tint.a > 1.5 ? 1.45 : 1.0);
}`,Pw=`
precision highp float;
in vec4 shade_;
uniform float size;
uniform vec3 rim;
uniform float ring;
uniform float veil;
layout(location = 0) out vec4 pixel;
void main() {
  float big = shade_.a > 1.5 ? size * 1.45 : size;
  float r = length(gl_PointCoord - 0.5) * big;
  float edge = 0.5 * big - 0.5;
  float inside = 1.0 - smoothstep(edge - 1.0, edge, r);
  if (inside < 0.02) discard;
  float hollow = shade_.a < 0.75 ? 1.0 : 0.0;
  float core = ring > 0.0 ? 1.0 - smoothstep(edge - ring * big - 0.5, edge - ring * big + 0.5, r) : 1.0;
  vec3 colour = mix(rim, mix(shade_.rgb, rim, hollow), core);
  colour = mix(colour, shade_.rgb, hollow * (1.0 - core));
  pixel = vec4(colour, veil * inside * (hollow > 0.5 ? 0.75 : 1.0));
}`,aa=class{constructor(e=!1,t=11){this.across=t;this.material=new Kt({glslVersion:qi,vertexShader:Rw,fragmentShader:Pw,transparent:!0,depthTest:!e,depthWrite:!1,uniforms:{size:{value:10},lift:{value:.002},veil:{value:1},rim:{value:new We(1,1,1)},ring:{value:t<8?0:.22}}}),this.mesh=new Js(this.geometry,this.material),this.mesh.frustumCulled=!1,this.mesh.renderOrder=e?5:4,e||x1(this.mesh,this.material,.3)}across;mesh;material;geometry=new un;resize(e){this.material.uniforms.size.value=this.across*e}get drawn(){let e=t=>this.geometry.getAttribute(t)?.array??[];return{places:e("position"),tints:e("tint")}}fill(e,t){this.geometry.setAttribute("position",new Et(Float32Array.from(e.flat()),3)),this.geometry.setAttribute("tint",new Et(Float32Array.from(t.flat()),4)),this.mesh.visible=e.length>0}dispose(){this.geometry.dispose(),this.material.dispose()}};var vh=Math.PI/180,_1=.34,vo={x:[0,0],y:[90,0],z:[0,90]};function oa({sectionAzimuth:n,sectionTilt:e}){let[t,i]=Sp(e),[r,s]=Sp(n);return[t*r,t*s,i]}function ns(n,e){return[...oa(n),n.sectionAt*e.scale]}function is(n,e){let[t,i,r,s]=ns(n,e),a=o=>[t*o,i*o,r*o];return{move:a(s),tilt:a(s+_1)}}function S1(n,e,t,i){let[r,s,a]=e;if(n==="move"){let[h,d,u]=oa(t);return{sectionAt:Number(((h*r+d*s+u*a)/i.scale).toPrecision(6))}}let o=t.sectionAt*i.scale+_1<0?-1:1,l=Math.hypot(r,s);return{sectionAzimuth:l>.02?Math.round(Math.atan2(o*s,o*r)/vh):t.sectionAzimuth,sectionTilt:Math.round(Math.atan2(o*a,l)/vh)}}function M1(n,e){let[t,i,r,s]=ns(n,e),a=e.half.map(g=>1.06*g+.04),o=g=>t*g[0]+i*g[1]+r*g[2]-s,l=Array.from({length:8},(g,y)=>a.map((_,x)=>y>>x&1?_:-_)),c=l.flatMap((g,y)=>[1,2,4].filter(_=>!(y&_)).flatMap(_=>{let x=l[y|_],E=o(g),w=o(x);return E<0==w<0?[]:[g.map((v,A)=>v+E/(E-w)*(x[A]-v))]})),h=[0,1,2].map(g=>c.reduce((y,_)=>y+_[g],0)/c.length),[d,u]=Sp(n.sectionAzimuth),p=[-u,d,0],f=[-r*d,-r*u,t*d+i*u],b=(g,y)=>g.reduce((_,x,E)=>_+(x-h[E])*y[E],0),m=g=>Math.atan2(b(g,f),b(g,p));return c.sort((g,y)=>m(g)-m(y))}function Sp(n){return n%90?[Math.cos(n*vh),Math.sin(n*vh)]:[[1,0],[0,1],[-1,0],[0,-1]][(n/90%4+4)%4]}var yr={curve:{width:2.75,light:"#101418",dark:"#ffffff",opacity:1},net:{width:1.25,light:"#44566c",dark:"#c3d0e0",opacity:.75,hidden:.35},first:{width:1.75,light:"#101418",dark:"#ffffff",opacity:.95},second:{width:1.25,light:"#7a4b00",dark:"#ffd28a",opacity:.95},normals:{width:1.5,light:"#00785a",dark:"#58dcae",opacity:.95},teethU:{width:1,light:"#0060a8",dark:"#7cc4ff",opacity:.55},teethV:{width:1,light:"#b04500",dark:"#ffae70",opacity:.55},combU:{width:1.75,light:"#0060a8",dark:"#7cc4ff",opacity:1},combV:{width:1.75,light:"#b04500",dark:"#ffae70",opacity:1},zeroK:{width:2.75,light:"#101418",dark:"#ffffff",opacity:1},zeroH:{width:2.75,light:"#a3008f",dark:"#ff9cf2",opacity:1},edge:{width:2.5,light:"#c4007a",dark:"#ff7ac8",opacity:1},plane:{width:1.25,light:"#c2102e",dark:"#ff6b81",opacity:.55},arm:{width:1.75,light:"#c2102e",dark:"#ff6b81",opacity:.8,onTop:!0},"seam open":{width:4,light:"#c2102e",dark:"#ff6b81",opacity:1,hidden:.2},"seam G0":{width:3,light:"#b85c00",dark:"#ffb057",opacity:1,hidden:.2},"seam G1":{width:3,light:"#8a7a00",dark:"#f2e05c",opacity:1,hidden:.2},"seam G2":{width:3,light:"#00785a",dark:"#58dcae",opacity:1,hidden:.2},"seam G3":{width:3,light:"#0060a8",dark:"#7cc4ff",opacity:1,hidden:.2},section:{width:3,light:"#c2102e",dark:"#ff6b81",opacity:1}},rs=Object.keys(yr),Mp=rs.filter(n=>n!=="net"&&n!=="edge"&&n!=="curve"&&!n.startsWith("seam")),xo=(n,e)=>yr[n][e?"dark":"light"],w1=[.76,.06,.18,1],A1=xs.relative,xh=class{group=new Di;points=new aa;target=new aa(!1,4.5);grips=new aa(!0);curvePoints=[];netPoints=[];lines=Object.fromEntries(rs.map(e=>[e,new yh(yr[e].light,yr[e].width,yr[e].opacity,yr[e].onTop,yr[e].hidden)]));constructor(){for(let e of rs)this.group.add(this.lines[e].mesh);this.group.add(this.target.mesh,this.points.mesh,this.grips.mesh),this.target.fill([],[]),this.grips.fill([],[]),this.lines.curve.end(),this.seams([],ml)}get drawn(){return{lines:rs.map(e=>this.lines[e].drawn),points:[this.target.drawn,this.points.drawn,this.grips.drawn]}}resize(e,t,i){for(let r of rs)this.lines[r].resize(e,t,i,yr[r].width);this.target.resize(i),this.points.resize(i),this.grips.resize(i)}theme(e){for(let t of rs)this.lines[t].colour=xo(t,e)}update(e,t,i,r){let s=e.side;for(let a of Mp)this.lines[a].begin();if(s>1){t.directions&&this.directions(e),t.normals&&this.normals(e),(t.combs==="u"||t.combs==="both")&&this.combs(e,!0,r),(t.combs==="v"||t.combs==="both")&&this.combs(e,!1,r);let{planes:a,stride:o}=e.grid,l=(c,h)=>d=>{if(!e.covered[d])return NaN;let u=a[c*o+d],p=a[Oe.curvedness*o+d];return Math.abs(u)<=A1*p**h?0:u};if(t.zeroK&&bh(l(Oe.gaussian,2),s,e.position,this.lines.zeroK),t.zeroH&&bh(l(Oe.mean,1),s,e.position,this.lines.zeroH),t.section){let[c,h,d,u]=ns(t,i),p=e.position;bh(f=>e.covered[f]?c*p[3*f]+h*p[3*f+1]+d*p[3*f+2]-u:NaN,s,p,this.lines.section),this.showPlane(t,i)}else this.grips.fill([],[])}for(let a of Mp)this.lines[a].end()}curve(e,t,i){let{curve:r,teethU:s,combU:a}=this.lines,o=[...Mp,"curve"];for(let h of o)this.lines[h].begin();this.grips.fill([],[]);let l=e.map(({point:h})=>wt(t,h)),c=i?e.map(({bend:h},d)=>l[d].map((u,p)=>u-i*h[p])):[];for(let h=0;h+1<l.length;h++)r.join(l[h],l[h+1]),i&&a.join(c[h],c[h+1]);for(let h=0;h<c.length;h+=Iw)s.join(l[h],c[h]);for(let h of o)this.lines[h].end();this.curvePoints=[...l,...c.filter(h=>h.every(Number.isFinite))]}showPlane(e,t){let i=M1(e,t),{move:r,tilt:s}=is(e,t);i.forEach((a,o)=>this.lines.plane.join(a,i[(o+1)%i.length])),this.lines.arm.join(r,s),this.grips.fill([r,s],[w1,[...w1.slice(0,3),.5]])}net(e,t,i,r){let{net:s}=this.lines;s.begin(),this.netPoints=[];for(let o of e){let l=o.map(c=>wt(r,c));this.netPoints.push(...l);for(let c=0;c+1<l.length;c++)s.join(l[c],l[c+1])}s.end();let a=o=>o.id===i?[.93,.42,.05,2]:o.mirrored?[.25,.38,.55,.5]:[...o.tint,1];this.points.fill(t.map(o=>wt(r,o.position)),t.map(a))}edge(e,t){let{edge:i}=this.lines;i.begin();for(let r of e){let s=r.map(a=>wt(t,a));for(let a=0;a+1<s.length;a++)i.join(s[a],s[a+1])}i.end()}seams(e,t){for(let i of xp){let r=this.lines[`seam ${i}`];r.begin();for(let{points:s}of e.filter(a=>a.order===i)){let a=s.map(o=>wt(t,o));for(let o=0;o+1<a.length;o++)r.join(a[o],a[o+1])}r.end()}}dispose(){for(let e of rs)this.lines[e].dispose();this.target.dispose(),this.points.dispose(),this.grips.dispose()}directions(e){let{planes:t,stride:i,size:r}=e.grid;E1(e,(s,a)=>{let o=t[Oe.halfDifference*i+s];if(!(o>A1*t[Oe.curvedness*i+s]&&t[Oe.curvedness*i+s]*r>1e-9))return;Ko(t[s],t[i+s],t[2*i+s],o);let l=e.position.subarray(3*s,3*s+3),c=.36*a,h=[0,0,0],d=[0,0,0];for(let p=0;p<3;p++){let f=t[(Oe.e1+p)*i+s],b=t[(Oe.e2+p)*i+s];h[p]=c*(Or*f+kr*b),d[p]=c*(Or*b-kr*f)}let u=(p,f)=>p.segment(l[0]-f[0],l[1]-f[1],l[2]-f[2],l[0]+f[0],l[1]+f[1],l[2]+f[2]);u(this.lines.first,h),u(this.lines.second,d)})}normals(e){let{planes:t,stride:i}=e.grid;E1(e,(r,s)=>{let a=e.position.subarray(3*r,3*r+3),o=.9*s,l=c=>o*t[(Oe.normal+c)*i+r];this.lines.normals.segment(a[0],a[1],a[2],a[0]+l(0),a[1]+l(1),a[2]+l(2))})}combs(e,t,i){let{planes:r,stride:s,nu:a}=e.grid,o=t?this.lines.teethU:this.lines.teethV,l=t?this.lines.combU:this.lines.combV,c=wp,h=Math.max(1,Math.round((a-1)/60)),d=(u,p)=>{let f=Math.round(u*(a-1)/(c-1));return t?p*a+f:f*a+p};for(let u=0;u<c;u++){let p=null;for(let f=0;f<a;f+=h){let b=d(u,Math.min(f,a-1)),m=e.position.subarray(3*b,3*b+3),g=-i*T1(e,t,b),y=[0,1,2].map(_=>m[_]+g*r[(Oe.normal+_)*s+b]);if(!e.covered[b]||y.some(Number.isNaN)){p=null;continue}o.segment(m[0],m[1],m[2],y[0],y[1],y[2]),p&&l.join(p,y),p=y}}}},wp=7,Iw=3;function T1(n,e,t){let{planes:i,stride:r}=n.grid,s=Oe.forms+(e?0:2);return i[(s+3)*r+t]/i[s*r+t]}function C1(n,e,t){let i=0,r=0;for(let s of n){let a=s.grid.nu;r=Math.max(r,s.grid.size);for(let o=0;o<wp;o++){let l=Math.round(o*(a-1)/(wp-1));for(let c=0;c<a;c+=3){let h=(d,u)=>s.covered[u]&&Math.abs(T1(s,d,u))||0;e.combs!=="v"&&(i=Math.max(i,h(!0,c*a+l))),e.combs!=="u"&&(i=Math.max(i,h(!1,l*a+c)))}}}return i*r>1e-9?.22*e.combScale*r*t.scale/i:0}function R1(n,e,t){let i=Math.max(0,...n.flat().map(({curvature:s})=>Math.abs(s)||0).filter(Number.isFinite)),r=2*Math.hypot(...t.half)/t.scale;return i*r>1e-9?.15*e*r*t.scale/i:0}function E1(n,e){let t=n.side,i=Math.min(t,17),r=n.position,s=u=>[r[3*u],r[3*u+1],r[3*u+2]],[a,o,l,c]=[s(0),s(t*(t-1)),s(t-1),s(t*t-1)],h=(u,p)=>Math.hypot(u[0]-p[0],u[1]-p[1],u[2]-p[2]),d=Math.min(.1,Math.max(.035,(h(a,o)+h(a,l)+h(l,c)+h(o,c))/(4*(i-1))));for(let u=0;u<i;u++)for(let p=0;p<i;p++){let f=Math.round(u*(t-1)/(i-1))*t+Math.round(p*(t-1)/(i-1));n.covered[f]&&e(f,d)}}var _h=class{constructor(e){this.store=e;this.surfaces=[zn("Colour",!0,...this.colour()),zn("Light lines",!0,...this.stripes()),zn("Section",!1,...this.cut())];let[t,i,r]=this.surfaces;this.element.append(zn("Shape",!0,this.shape),t,zn("Show",!0,...this.overlays()),i,r),e.subscribe((s,a)=>{(s.model!==a.model||s.patch!==a.patch)&&this.showShape(s)})}store;element=T("aside",{class:"panel right","aria-label":"Shape and analysis"});shape=T("div",{class:"shape"});fixed=T("p",{class:"hint",hidden:!0},"Four sets are shown side by side; choose “One” to set the shape.");bindings=[];surfaces;controls=[];curves=!1;some=!1;shapeFor="";fields=[];refresh(e,t){let{patches:i}=e.model;this.curves=i.every(Qe),this.some=i.some(Qe);for(let r of this.surfaces)r.hidden=this.curves;for(let r of this.bindings)r(e.settings,t);this.showShape(e)}showShape(e){let t=De(e),i=Ei(t),r=i.length?mn(t):[],s=t.unchecked_shape===!0,a=Object.entries(it[t.kind].fields).filter(([,h])=>h.type==="number"||h.type==="positive").map(([h])=>h),o=JSON.stringify([t.kind,t.basis,i,s]);o!==this.shapeFor&&(this.shapeFor=o,this.build(t,i,a,s)),r.forEach((h,d)=>this.controls[d]?.update(h));for(let{key:h,control:d}of this.fields)d.update(Ae(t,h));let l=e.compare==="sets"&&Es(t).length>0;this.fixed.hidden=!l;for(let{element:h}of this.controls)for(let d of h.querySelectorAll("input"))d.disabled=l;for(let h of this.shape.querySelectorAll(".chip"))h.disabled=l;let c=JSON.stringify(r);for(let h of this.shape.querySelectorAll(".chip"))h.setAttribute("aria-pressed",String(h.dataset.shape===c))}build(e,t,i,r){let{store:s}=this,a=(u,p)=>{let f=De(s.state);s.editPatch({...f,shape:mn(f).map((b,m)=>m===u?p:b)},`shape ${u}`)};this.controls=t.map((u,p)=>{let{low:f,high:b,open:m,label:g}=u,y=10**Math.floor(Math.log10((b-f)/200));return Kn({label:u0(g),name:Xu(g).filter(Boolean).join(" "),step:y,marks:Lw(f,b),hard:!r,min:f+y*Number(m[0]),max:m[1]?f+y*Math.ceil((b-f)/y-1-1e-9):b,allowed:{holds:_=>us(u,_),words:`a number in ${ds(u)}`},onInput:_=>a(p,_),onSettle:()=>s.settle()})});let o=Nw(e),l=new Set(t.map(u=>u.of)).size>1||!Lr(e),c=[];this.controls.forEach((u,p)=>{let{of:f}=t[p];l&&o[f]&&f!==t[p-1]?.of&&c.push(T("div",{class:"subtitle"},o[f])),c.push(u.element)}),this.fields=i.map(u=>{let p=(b,m)=>s.editPatch({...De(s.state),[u]:b},m);if(u==="scale"){let b=Kn({label:Ci("\\lambda"),name:"lambda",min:.1,max:4,step:.01,marks:[1,1.5,3],onInput:m=>p(m,"scale"),onSettle:()=>s.settle()});return{key:u,control:b}}let f=it[e.kind].fields[u].type==="positive";return{key:u,control:Fn({label:It(u),name:It(u),positive:f,step:.1,onChange:b=>p(b,null)})}}),this.fields.length&&c.push(T("div",{class:"subtitle"},e.kind==="swung"?"scale of the trajectory":"dimensions"),...this.fields.map(u=>u.control.element));let h=Es(e);h.length&&c.push(T("div",{class:"subtitle"},"sets of the thesis"),T("div",{class:"chips"},...[...h,h[0].map(()=>0)].map(u=>{let p=Ve(`(${u.join(", ").replaceAll("-","−")})`,`Set the shape parameters to ${u.join(", ")}`,()=>s.editPatch({...De(s.state),shape:u}),"chip");return p.dataset.shape=JSON.stringify(u),p})));let d=Qe(e)?"curve":"surface";c.length||c.push(T("p",{class:"hint"},Ji(e)?"On the Bernstein basis no shape parameters act: drag the control points.":`This ${d} has no shape parameters: drag its control points.`)),this.shape.replaceChildren(this.fixed,...c)}colour(){let{store:e}=this,t=(u,p)=>({label:u,options:pi.filter(f=>f.colour!=="vector"&&p(f)).map(f=>({value:f.key,label:`${It(f.name)}${f.colour==="classes"?"":`  ${f.symbol}`}`}))}),i=u=>"EFGLMN".includes(u.key),r=u=>/^(beta|gamma)\d/.test(u.key),s=Ti("Colour by",[{label:"",options:[{value:"none",label:"No colour"}]},t("Curvature",u=>u.colour!=="classes"&&!i(u)&&!r(u)),t("Types",u=>u.colour==="classes"),t("Invariants, plane metric",u=>r(u)&&!u.key.endsWith("_surface")),t("Invariants, surface metric",u=>u.key.endsWith("_surface")),t("Fundamental forms",i)],u=>e.setting({quantity:u,range:e.state.settings.range==="fixed"?"robust":e.state.settings.range})),a=vn("Range of colours",[{value:"robust",label:"Percentiles",title:"Leave out a few extreme values at either end"},{value:"full",label:"All",title:"From the least to the greatest value"},{value:"fixed",label:"Fixed",title:"Ends given by hand"}],u=>e.setting({range:u})),o=Kn({label:"cut",name:"Percentile cut at either end",min:0,max:20,step:.5,marks:[2,5,10],hard:!0,onInput:u=>e.setting({percentile:u})}),l=Fn({label:"from",name:"Lowest colour",onChange:u=>e.setting({low:u})}),c=Fn({label:"to",name:"Highest colour",onChange:u=>e.setting({high:u})}),h=T("div",{class:"pair"},l.element,c.element),d=Pt("Contour lines",u=>e.setting({contours:u}),void 0,"Ten steps from end to end");return this.bindings.push(u=>{let p=pi.find(b=>b.key===u.quantity),f=p!==void 0&&p.colour!=="classes";s.update(u.quantity),a.update(u.range),o.update(u.percentile),l.update(u.low),c.update(u.high),d.update(u.contours),a.element.hidden=d.element.hidden=!f,o.element.hidden=!f||u.range!=="robust",h.hidden=!f||u.range!=="fixed"}),[s.element,a.element,o.element,h,d.element]}overlays(){let{store:e}=this,t=(...l)=>{let c=T("span",{class:"keys"},...l.map(()=>T("span",{class:"key"})));return this.bindings.push((h,d)=>l.forEach((u,p)=>c.children[p].style.background=xo(u,d))),c},i=(l,c,h,d="")=>{let u=Pt(c,p=>e.setting({[l]:p}),h,d);return this.bindings.push(p=>{u.update(p[l]),u.element.hidden=l==="comb"?!this.some:l!=="net"&&this.curves}),u.element},r=(l,...c)=>T("span",{},Ci(l),...c),s=vn("Combs along iso-curves",[{value:"off",label:"Off"},{value:"u",label:T("i",{},"u")},{value:"v",label:T("i",{},"v")},{value:"both",label:"Both"}],l=>e.setting({combs:l})),a=Kn({label:"size",name:"Size of the combs",min:.1,max:3,step:.1,marks:[1],onInput:l=>e.setting({combScale:l})});this.bindings.push(l=>{s.update(l.combs),a.update(l.combScale),s.element.parentElement.hidden=this.curves,a.element.hidden=!(this.some&&l.comb)&&(this.curves||l.combs==="off")});let o=T("span",{});return this.bindings.push(()=>o.textContent=this.curves?"Polygon":"Control net"),[T("div",{class:"switches"},i("net",o,t("net")),i("comb","Comb",t("combU"),"Curvature comb: teeth as long as the curvature, on the outer side of the bend"),i("curves","Iso-curves"),i("directions","Directions",t("first","second"),"Principal directions. Strong: of κ1; light: of κ2"),i("normals","Normals",t("normals")),i("zeroK",r("K"," = 0"),t("zeroK"),"Parabolic lines"),i("zeroH",r("H"," = 0"),t("zeroH")),i("minRadius","Smallest radius"),i("seams","Seams",void 0,"Red: open; orange: G0; yellow: G1; green: G2; blue: G3"),i("wireframe","Wireframe")),T("div",{class:"row"},T("span",{class:"caption"},"Combs"),s.element),a.element]}stripes(){let{store:e}=this,t=vn("Light lines",[{value:"none",label:"Off"},{value:"zebra",label:"Zebra",title:"Stripes of a striped room, reflected"},{value:"isophotes",label:"Isophotes",title:"Lines of equal angle between normal and light"},{value:"reflection",label:"Reflect",title:"Reflections of parallel tube lights"},{value:"highlight",label:"Highlight",title:"Highlight lines: where the normal meets a tube light; the same from everywhere"}],c=>e.setting({stripes:c})),i=Kn({label:"lines",name:"Number of lines",min:4,max:80,step:1,onInput:c=>e.setting({density:c}),onSettle:()=>e.settle()}),r=Kn({label:"turn",name:"Azimuth of the light in degrees",min:-180,max:180,step:1,marks:[-90,0,90],onInput:c=>e.setting({lightAzimuth:c})}),s=Kn({label:"height",name:"Height of the light in degrees",min:-90,max:90,step:1,marks:[0,45],onInput:c=>e.setting({lightElevation:c})}),a=T("div",{class:"light-ball",title:"Drag the light"},T("span",{})),o=c=>{let h=a.getBoundingClientRect(),d=(c.clientX-h.left)/h.width*2-1,u=1-(c.clientY-h.top)/h.height*2,p=Math.min(1,Math.hypot(d,u));e.setting({lightAzimuth:Math.round(Math.atan2(u,d)*180/Math.PI),lightElevation:Math.round(Math.acos(p)*180/Math.PI)})};a.addEventListener("pointerdown",c=>{a.setPointerCapture(c.pointerId),o(c)}),a.addEventListener("pointermove",c=>{a.hasPointerCapture(c.pointerId)&&o(c)});let l=T("div",{class:"light"},a,T("div",{class:"stack"},r.element,s.element));return this.bindings.push(c=>{t.update(c.stripes),i.update(c.density),r.update(c.lightAzimuth),s.update(c.lightElevation),i.element.hidden=l.hidden=c.stripes==="none";let h=c.lightAzimuth*Math.PI/180,d=Math.cos(c.lightElevation*Math.PI/180),u=a.firstElementChild;u.style.left=`${50+50*d*Math.cos(h)}%`,u.style.top=`${50-50*d*Math.sin(h)}%`,u.classList.toggle("under",c.lightElevation<0)}),[t.element,i.element,l]}cut(){let{store:e}=this,t=Pt("Section by a plane",h=>e.setting({section:h})),i=Pt("Cut the front away",h=>e.setting({clip:h})),r=vn("Normal of the plane",["x","y","z"].map(h=>({value:h,label:T("i",{},h),title:`Plane across ${h}`})),h=>e.setting({sectionAzimuth:vo[h][0],sectionTilt:vo[h][1],sectionAt:0})),s=Kn({label:"turn",name:"Azimuth of the plane's normal in degrees",min:-180,max:180,step:1,marks:[-90,0,90],onInput:h=>e.setting({sectionAzimuth:h})}),a=Kn({label:"tilt",name:"Tilt of the plane's normal in degrees",min:-90,max:90,step:1,marks:[-45,0,45],hard:!0,onInput:h=>e.setting({sectionTilt:h})}),o=T("p",{class:"hint"}),l=Kn({label:"at",name:"Place of the section plane",min:-1,max:1,step:.01,onInput:h=>e.setting({sectionAt:h-this.middle})}),c=[T("div",{class:"row"},T("span",{class:"caption"},"Across"),r.element),s.element,a.element,l.element,o,i.element];return this.bindings.push(h=>{t.update(h.section),i.update(h.clip);let d=["x","y","z"].find(u=>h.sectionTilt===vo[u][1]&&(u==="z"||h.sectionAzimuth===vo[u][0]));r.update(d??"free"),s.update(h.sectionAzimuth),a.update(h.sectionTilt);for(let u of c)u.hidden=!h.section;h.section&&(o.textContent=`${this.showOffset(h,l)}; drag the red points in the picture`)}),[t.element,...c]}middle=0;box={low:[0,0,0],high:[1,1,1]};sectionBox(e){this.box=e}showOffset(e,t){let i=oa(e),{low:r,high:s}=this.box;this.middle=i.reduce((h,d,u)=>h+.5*d*(r[u]+s[u]),0);let a=i.reduce((h,d,u)=>h+.5*Math.abs(d)*(s[u]-r[u]),0)||1;t.bounds(this.middle-a,this.middle+a,10**Math.floor(Math.log10(a/500)));let o=this.middle+e.sectionAt,{unit:l}=this.store.state.model;return t.update(Number(o.toPrecision(5))),`${i.map((h,d)=>[Number(h.toFixed(3)),"xyz"[d]]).filter(([h])=>h!==0).map(([h,d],u)=>`${h<0?"− ":u?"+ ":""}${Math.abs(h)===1?"":`${Math.abs(h)} `}${d}`).join(" ")} = ${Ce(o)}${l?` ${l}`:""}`}};function Nw(n){try{let e=$n(n),t=n.kind==="ruled"?["first curve","second curve"]:e.length>1?["along u","along v"]:[""];return e.map(({entry:i},r)=>[t[r],Lr(n)?"":i.title].filter(Boolean).join(": "))}catch{return[]}}function Lw(n,e){for(let t of[1,2,5,10,20,50,100]){let i=Math.ceil(n/t),r=Math.floor(e/t)-i+1;if(r>=2&&r<=6)return Array.from({length:r},(s,a)=>(i+a)*t)}return[n,e].map(t=>Number(t.toPrecision(3)))}var P1=256,ss=_o(Be.palette.undefined),Sh=_o(Be.palette.front),la=_o(Be.palette.back),h4=Be.palette.series;function vr(n){let e=(n.colour==="diverging"?Be.palette.diverging:Be.palette.sequential).map(_o);return Array.from({length:P1},(t,i)=>{let r=i/(P1-1)*(e.length-1),s=Math.min(Math.floor(r),e.length-2);return[0,1,2].map(a=>Math.round(e[s][a]+(r-s)*(e[s+1][a]-e[s][a])))})}var xr=n=>Be.palette.classes[n].map(_o),I1=n=>Uint8Array.from(n.flatMap(e=>[...e,255])),qn=([n,e,t])=>`rgb(${n} ${e} ${t})`;function _o(n){return[1,3,5].map(e=>parseInt(n.slice(e,e+2),16))}var wh=class{element=T("figure",{class:"legend","aria-label":"Legend"});bar=T("canvas",{class:"colours",width:1,height:256});plot=T("canvas",{class:"histogram",width:64,height:192,"aria-hidden":"true"});shown="";ticks=[];note=T("figcaption",{});real(e,t,i,r){this.element.hidden=!1;let s=lt[e],a=c0(Math.max(Math.abs(t.low),Math.abs(t.high)));if(this.shown!==`${e} ${i} ${a}`){this.shown=`${e} ${i} ${a}`;let u=this.bar.getContext("2d");vr(s).forEach((f,b,m)=>{u.fillStyle=qn(f),u.fillRect(0,m.length-1-b,1,1)}),this.ticks=Array.from({length:5},()=>T("span",{class:"tick"}));let p=`${a?`10${$u(a)} `:""}${fi(s,i)}`.trim();this.element.replaceChildren(T("div",{class:"legend-title"},T("span",{},It(s.name)),T("span",{class:"legend-symbol"},Ci(s.latex),p?T("span",{class:"unit"},p):null)),T("div",{class:"scale"},this.plot,this.bar,T("div",{class:"ticks"},...this.ticks)),this.note)}let{low:o,high:l}=t,c=u=>Ce(Math.abs(u)<=t.noise?0:u/10**a,3);this.ticks.forEach((u,p)=>{let f=p/(this.ticks.length-1);u.textContent=c(o+(l-o)*f),u.style.bottom=`${100*f}%`}),this.histogram(t,r);let h=t.finite?[T("dl",{class:"facts"},T("dt",{},"max"),T("dd",{},c(t.most)),T("dt",{},"mean"),T("dd",{},c(t.mean)),T("dt",{},"min"),T("dd",{},c(t.least)))]:["no point has a finite value"];t.below+t.above>0&&h.push(T("div",{},`${Pa(t.below+t.above)} beyond ends`));let d=[[t.missing-t.infinite,"undefined"],[t.infinite,"infinite"]];for(let[u,p]of d)u&&h.push(T("div",{class:"missing"},Mh(qn(ss)),`${u} ${p}`));this.note.replaceChildren(...h)}classes(e,t){this.shown="",this.element.hidden=!1;let i=lt[e],r=xr(e),s=r.map((l,c)=>t.reduce((h,d)=>h+(d[c]??0),0)),a=s.reduce((l,c)=>l+c,0),o=i.classes.map((l,c)=>({name:l,code:c})).filter(({code:l})=>l>0||s[0]>0);this.element.replaceChildren(T("div",{class:"legend-title"},T("span",{},It(i.name))),T("ul",{class:"types"},...o.map(({name:l,code:c})=>T("li",{class:s[c]?"":"absent",title:Qo(e,c)||!1},Mh(qn(r[c])),T("span",{},l),T("span",{class:"share"},s[c]?Pa(s[c]/a):"–")))))}plain(e){this.element.hidden=e,this.shown!=="plain"&&(this.shown="plain",this.element.replaceChildren(T("ul",{class:"types"},T("li",{},Mh(qn(Sh)),T("span",{},"side the normal points to")),T("li",{},Mh(qn(la)),T("span",{},"other side")))))}histogram(e,t){let{width:i,height:r}=this.plot,s=this.plot.getContext("2d");s.clearRect(0,0,i,r);let a=Math.max(...e.histogram,1),o=r/e.histogram.length;s.fillStyle=t?"rgb(255 255 255 / 38%)":"rgb(20 30 45 / 30%)",e.histogram.forEach((l,c)=>{let h=l?Math.max(2,Math.sqrt(l/a)*i):0;s.fillRect(i-h,r-(c+1)*o,h,o-1)})}},Mh=n=>{let e=T("span",{class:"swatch"});return e.style.background=n,e};function Ep(n,e){if(e===n.kind)return n;if(Qe(n)||!["trigonometric","bernstein",void 0].includes(Ae(n,"basis")))return null;let t=Dw(n);if(!t)return null;let i=n.kind==="nurbs"||Ae(n,"basis")==="bernstein",{name:r}=n,s=Ap(n,"flip");if(e==="tensor")return{kind:e,name:r,points:t,...Ap(n,"shape"),...Ap(n,"unchecked_shape"),...i?{basis:"bernstein"}:{},...s};if(e!=="nurbs"||!i)return null;let a=[t.length-1,t[0].length-1];return{kind:e,name:r,degrees:a,knots:a.map(N1),points:t,...s}}function Dw(n){let e=t=>Ae(n,t);switch(n.kind){case"tensor":return e("points");case"symmetric":{let t=e("points"),i=Ae(n,"mirror");return[...t,...t.map(r=>r.map(s=>ms(s,i))).reverse()]}case"swept":return e("section").map(t=>e("trajectory").map(i=>t.map((r,s)=>r+i[s])));case"swung":{let t=Ae(n,"scale");return e("profile").map(([i,r])=>e("trajectory").map(([s,a])=>[t*i*s,t*i*a,r]))}case"ruled":{let t=e("first"),i=e("second");return Ae(n,"basis")==="bernstein"&&t.length===i.length?t.map((r,s)=>[r,i[s]]):null}case"nurbs":return Fw(n)?e("points"):null;default:return null}}function Fw(n){let e=Ae(n,"weights")?.flat()??[],t=Ae(n,"degrees"),i=Ae(n,"knots"),r=Ae(n,"trim");return e.every(s=>s===e[0])&&!r?.length&&t.every(s=>s<=63)&&t.every((s,a)=>String(i[a])===String(N1(s)))}var N1=n=>[...Array(n+1).fill(0),...Array(n+1).fill(1)],Ap=(n,e)=>n[e]===void 0?{}:{[e]:n[e]};function L1(n,e){let t=n.patches.map(r=>r.name),i=e.name;for(let r=2;t.includes(i);r++)i=`${e.name} ${r}`;return{...n,patches:[...n.patches,{...e,name:i}]}}function D1(n,e){if(n.patches.length<2)return n;let{name:t}=n.patches[e],i=r=>r.slice(0,r.lastIndexOf(":"))===t;return Tp({...n,patches:n.patches.filter((r,s)=>s!==e)},(n.join??[]).filter(r=>!i(r.first)&&!i(r.second)))}function Tp({join:n,...e},t){return t.length?{...e,join:t}:e}function F1(n,e){let t=Object.entries(it[n.kind].fields),i=t.filter(([,a])=>a.type==="points");if(!i.length||Ae(n,"flip")===void 0)return null;let r=(a,o)=>Array.isArray(a)&&Array.isArray(a[0])?a.map(l=>r(l,o)):a.map((l,c)=>c===o?0-l:l),s={...n,name:`${n.name} mirrored`,flip:Ae(n,"flip")!==!0};for(let[a]of[...i,...t.filter(([,o])=>o.type==="plane")]){let o=Ae(n,a),l=n.kind!=="swung"?e:a==="profile"?e===2?1:-1:e===2?-1:e;o!==void 0&&(s[a]=r(o,l))}return s}var zw=["G0","G1","G2","G3"],Ah=class{constructor(e){this.store=e;let t=Ti("Order of joins",[{label:"",options:zw.map(a=>({value:a,label:a}))}],a=>{this.order=a,e.state.joining&&e.set({joining:{...e.state.joining,order:a}})});t.update(this.order),this.row.append(this.joining.element,t.element);let i=(a,o)=>{e.edit(a),e.set({patch:Math.min(o,a.patches.length-1),selected:null})},r=a=>i(L1(e.state.model,a),e.state.model.patches.length),s=a=>{let o=F1(De(e.state),a);o?r(o):e.set({message:{kind:"error",text:"This patch has no points to mirror: make it a tensor-product surface first"}})};this.element.append(T("div",{class:"row",role:"group","aria-label":"Patches of the model"},Ve("Add","Add a new patch of this construction",()=>r(Ts(De(e.state).kind).patches[0])),Ve("Duplicate","Duplicate this patch",()=>r(De(e.state))),...["x","y","z"].map((a,o)=>Ve(`Mirror ${a}`,`Mirror ${a}: add the image of this patch across ${a} = 0`,()=>s(o))),Ve("Delete","Delete this patch, and its joins",()=>i(D1(e.state.model,e.state.patch),e.state.patch))),this.row,this.together.element,this.hint,this.seams)}store;element=T("section",{class:"body-tools stack","aria-label":"Patches and seams"});seams=T("ul",{class:"seams","aria-label":"Seams of this patch"});hint=T("p",{class:"hint",role:"status"});joining=Pt("Join or release",e=>this.store.set({joining:e?{order:this.order,first:null}:null}),void 0,"Click a side of one patch, then a side of another: the second follows the first from then on. Sides that are joined are released.");together=Pt("Shared points move together",e=>this.store.setting({together:e}),void 0,"Points that patches have in common, and sides held by a join, follow what is dragged");row=T("div",{class:"row"});order="G1";refresh(e,t,i){let r=e.model.patches.length>1;this.element.hidden=e.model.patches.every(Qe);for(let c of[this.row,this.together.element,this.hint,this.seams])c.hidden=!r;this.joining.update(e.joining!==null),this.together.update(e.settings.together),this.hint.textContent=e.joining?e.joining.first?`${e.joining.first}: now click a side of another patch`:"Click near a side of the patch that leads":"",this.hint.hidden=!r||!e.joining;let{patches:s,unit:a}=e.model,o=c=>`${s[c.patch].name}:${c.side}`,l=t.filter(c=>c.first.patch===e.patch||c.second.patch===e.patch);this.seams.replaceChildren(...l.map(c=>{let h=T("b",{class:"order"},c.order);return h.style.color=xo(`seam ${c.order}`,i),T("li",{},h,T("span",{},`${o(c.first)} – ${o(c.second)}`),T("small",{},`gap ${Ce(c.gap,3)}${a&&` ${a}`} · angle ${Ce(c.angle,3)}° · jump ${Ce(c.curvature,3)}`))}))}};function z1(n,e){let{joining:t,model:i}=n.state;if(!t)return;let{first:r,order:s}=t,a=u=>u.slice(0,u.lastIndexOf(":"));if(!r)return n.set({joining:{...t,first:e}});n.set({joining:{order:s,first:null}});let o=i.join??[],l=u=>n.set({message:{kind:"error",text:u}}),c=o.filter(u=>u.first===r&&u.second===e||u.first===e&&u.second===r);if(c.length)return n.edit(Tp(i,o.filter(u=>!c.includes(u))));if(a(r)===a(e))return l("A patch is not joined to itself: click sides of two patches");if(o.some(u=>u.second===e))return l(`${e} follows another side already: release that first`);let h=u=>u===a(r)||o.some(p=>a(p.first)===u&&h(a(p.second)));if(h(a(e)))return l(`${a(r)} follows ${a(e)} already: joins cannot run in a circle`);let d={first:r,second:e,order:s};n.edit(t0(i,d)??{...i,join:[...o,d]})}var Eh=class{constructor(e){this.store=e}store;element=T("div",{class:"stack bases"});shown="";refresh(e){let t=Th(e),i=Ow(e),r=JSON.stringify([t.map(({entry:o,points:l})=>[o.name,l]),Object.values(i).map(({name:o,sizes:l})=>[o,l]),e.kind]);if(r===this.shown)return;let s=this.element.getRootNode().activeElement,a=[...this.element.querySelectorAll("select")].indexOf(s);this.shown=r,this.element.replaceChildren(...t.map((o,l)=>this.row(e,t,o,l,Object.values(i)))),a>=0&&this.element.querySelectorAll("select")[a]?.focus()}row(e,t,{entry:i,points:r},s,a){let o=t.length<2?"Basis":e.kind==="ruled"?`Basis of the ${["first","second"][s]} curve`:`Basis in ${"uv"[s]}`,l=p=>p.has(r),c=Object.values(Wn).filter(p=>l(p)&&(p.name!=="quintic"||i.name==="quintic")&&(p.name!=="trigonometric"||i.name!=="quintic")),h=p=>p.map(({name:f,title:b})=>({value:f,label:b})),d=Ti(o,[{label:"Of this model",options:h(a.filter(l))},{label:`For ${r} points`,options:h(c)}].filter(p=>p.options.length),p=>this.choose(s,p));d.update(i.name);let u=t.length<2?"Basis":e.kind==="ruled"?["Basis of first","Basis of second"][s]:o;return T("label",{class:"row basis"},T("span",{class:"caption"},u),d.element)}choose(e,t){let i=De(this.store.state),r=Th(i).map(({entry:s},a)=>a===e?t:s.name);this.store.editPatch(Ch(i,r))}};function Ch(n,e,t=n.bases){let{shape:i,bases:r,basis:s,...a}=n,o=e.every(p=>p===e[0]),l=o?e[0]:e,c={...a,kind:n.kind,name:n.name,basis:l,...t===void 0?{}:{bases:t}},h={...c,shape:i},d=p=>String(Ei(p).map(f=>f.label)),u=d(h)===d(n)||Ji(h)||Ji(n);try{return i===void 0||!u?c:(du(h,$n(h)),h)}catch{return c}}function Th(n){try{return it[n.kind].fields.basis?$n(n):[]}catch{return[]}}function Ow(n){try{return Pr(Ae(n,"bases"))}catch{return{}}}var kw=120,Rh=class{constructor(e){this.store=e;let t=vn("Which text",[{value:"file",label:"Whole file",title:"The model as a TOML file"},{value:"bases",label:"Own bases",title:"The [bases.NAME] tables: functions as formulas, parameters with ranges"}],i=>{this.part=i,t.update(i),this.write()});t.update(this.part),this.copy=Ve("Copy the basis to a basis of your own","Copy the formulas of the basis into the model, to change them",()=>this.own(),"button"),this.element=zn("Model as text",!1,t.element,this.wrong,this.text,this.copy,this.hint),this.element.classList.add("model-text"),this.element.addEventListener("toggle",()=>this.refresh(e.state)),this.text.addEventListener("input",()=>{clearTimeout(this.timer),this.timer=window.setTimeout(()=>this.read(),kw)}),this.text.addEventListener("blur",()=>{this.timer&&this.read(),e.settle()}),this.text.addEventListener("keydown",i=>{i.stopPropagation(),i.key==="Escape"&&this.write()})}store;element;text=T("textarea",{spellcheck:"false",autocapitalize:"off",rows:14,"aria-label":"The model as text"});wrong=T("p",{class:"hint error",role:"alert",hidden:!0});copy;hint=T("p",{class:"hint"});part="file";shown=null;shownPatch=-1;timer=0;refresh({model:e,patch:t}){!this.element.open||e===this.shown&&t===this.shownPatch||(this.text.getRootNode().activeElement===this.text?this.shown=e:this.write())}write(){let{state:e}=this.store,{model:t}=e,i=De(e).bases;clearTimeout(this.timer),this.timer=0,this.shown=t,this.shownPatch=e.patch,this.text.value=this.part==="file"?hn(t):i?Ru({bases:i}).trimStart():"",this.text.setAttribute("aria-label",this.part==="file"?"The model file":"The model's own bases"),this.wrong.hidden=!0;let r=it[De(e).kind].fields.bases!==void 0;this.copy.hidden=this.part==="file"||!r||!!i,this.text.disabled=this.part==="bases"&&!r,this.hint.textContent=this.part==="file"?"":r?"In formulas stand t, r = 1 − t, s = sin(πt/2), c = cos(πt/2), a = 1 − s, b = 1 − c, pi, the parameters, + − * / ^, and sin, cos, sinh, cosh, sqrt, exp.":"A surface of this kind has no basis."}read(){clearTimeout(this.timer),this.timer=0;try{let e=this.part==="file"?vt(bs(this.text.value)):this.withBases(bs(this.text.value));this.wrong.hidden=!0,this.shown=e,this.store.edit(e,"text")}catch(e){this.wrong.hidden=!1,this.wrong.textContent=e.message}}withBases({bases:e={},...t}){let{model:i,patch:r}=this.store.state,s=Object.keys(t)[0];if(s)throw new Error(`unknown key '${s}': expected [bases.NAME] tables alone`);let a=JSON.stringify(i.patches[r].bases),o=i.patches.map((l,c)=>c===r||a&&JSON.stringify(l.bases)===a?Uw(l,e):l);return vt(cn({...i,patches:o}))}own(){let e=De(this.store.state),t={},i=Th(e).map(({entry:r,points:s},a,o)=>{let l=o.some(p=>p.entry===r&&p.points!==s)?`my_${r.name}_${s}`:`my_${r.name}`,{functions:c,parameters:h}=r.basis(s),d=(p,f)=>.001*(f-p),u=h.map(({name:p,low:f,high:b,start:m,open:g})=>[p,[f+d(f,b)*Number(g[0]),b-d(f,b)*Number(g[1]),m]]);return t[l]={functions:c,...u.length?{parameters:Object.fromEntries(u)}:{}},l});i.length&&(this.store.editPatch(Ch(e,i,t)),this.write())}};function Uw(n,e){let t=n.basis??[],i=[t].flat(),{bases:r,...s}=n,a=Object.keys(e).length?{...s,kind:n.kind,name:n.name,bases:e}:{...s,kind:n.kind,name:n.name};return i.length&&n.shape!==void 0?Ch(a,i,a.bases):a}var Ih=class{constructor(e){this.store=e;let t=[{label:"Constructions",options:Ph(i=>i.construction&&i.surface)},{label:"Curves",options:Ph(i=>!i.surface)},{label:"Closed forms",options:Ph(i=>!i.construction&&!i.fields.points)},{label:"From CAD",options:Ph(i=>!i.construction&&!!i.fields.points)}];this.kind=Ti("Construction",t,i=>{this.become(i)}),this.unit=Ti("Unit of length",[{label:"",options:[{value:"",label:"no unit"},...Wo.map(i=>({value:i,label:i}))]}],i=>e.edit({...e.state.model,unit:i})),this.flip=Pt("Turn the normal",i=>e.editPatch({...De(e.state),flip:i}),void 0,"The signs of H, κ1, κ2 and S follow the normal"),this.close=Pt("End in the first point",i=>this.closed(i),void 0,"A closed curve: the first control point counts once more, as the last"),this.basis=new Eh(e),this.text=new Rh(e),this.body=new Ah(e),this.locks=["x","y","z"].map((i,r)=>Pt(i,s=>{let a=[...e.state.settings.locks];a[r]=s,e.setting({locks:a})},void 0,`Keep ${i} while dragging`)),this.snap=Pt("Snap to",i=>e.setting({snap:i}),void 0,"Round coordinates while dragging"),this.step=Fn({label:"",name:"Snap step",positive:!0,onChange:i=>e.setting({snapStep:i})}),this.element.append(this.patches,this.body.element,T("div",{class:"stack"},T("label",{class:"row"},T("span",{class:"caption"},"Construction"),this.kind.element),this.about,T("label",{class:"row"},T("span",{class:"caption"},"Unit"),this.unit.element),this.basis.element,this.flip.element,this.close.element),zn("Control points",!0,this.points,T("div",{class:"drag-tools"},T("div",{class:"locks",role:"group","aria-label":"Axes kept while dragging"},T("span",{class:"caption"},"Keep"),...this.locks.map(i=>i.element)),T("div",{class:"snap"},this.snap.element,this.step.element))),this.text.element),e.subscribe((i,r)=>{(i.model!==r.model||i.patch!==r.patch||i.selected!==r.selected||i.settings!==r.settings)&&this.refresh(i)})}store;element=T("aside",{class:"panel left","aria-label":"Model"});patches=T("div",{class:"patches",role:"listbox","aria-label":"Patches"});body;kind;unit;flip;basis;text;close;about=T("p",{class:"hint"});points=T("div",{class:"points"});locks;snap;step;names="";list=[];shownPatch=null;tab="";coordinates=[];form=null;refresh(e){let t=De(e),i=it[t.kind];this.kind.update(t.kind),this.unit.update(e.model.unit),this.flip.update(Ae(t,"flip")===!0),this.flip.element.hidden=!i.surface,this.close.element.hidden=!i.fields.close,this.close.update(Ae(t,"close")===!0),this.basis.refresh(t),this.text.refresh(e),this.about.textContent=It(i.title),e.settings.locks.forEach((s,a)=>this.locks[a].update(s)),this.snap.update(e.settings.snap),this.step.update(e.settings.snapStep),this.patches.hidden=e.model.patches.length<2;let r=JSON.stringify([e.patch,e.model.patches.map(s=>[s.name,s.kind])]);r!==this.names&&this.patches.replaceChildren(...e.model.patches.map((s,a)=>T("button",{type:"button",class:"patch",role:"option","aria-selected":a===e.patch,on:{click:()=>this.store.set({patch:a,selected:null})}},T("span",{},s.name),T("small",{},s.kind.replaceAll("_"," "))))),this.names=r,this.showPoints(e,t)}showPoints(e,t){t!==this.shownPatch&&(this.list=bn(t).filter(f=>!f.mirrored),this.shownPatch=t);let i=this.points.parentElement.parentElement;if(i.hidden=!this.list.length,!this.list.length)return;let r=this.list.find(f=>f.id===e.selected?.replace("′","")),s=[...new Set(this.list.map(f=>f.key))];r&&(this.tab=r.key),s.includes(this.tab)||(this.tab=s[0]);let a={patch:t,chosen:r?.id,tab:this.tab};if(a.patch===this.form?.patch&&a.chosen===this.form.chosen&&a.tab===this.form.tab)return;this.form=a;let o=vn("Which points",s.map(f=>({value:f,label:It(f)})),f=>{this.tab=f,this.store.set({selected:null}),this.showPoints(this.store.state,t)});o.update(this.tab);let l=this.list.filter(f=>f.key===this.tab),c=Math.max(...l.map(f=>f.index.at(-1)))+1,h=T("div",{class:"net",role:"group","aria-label":`${It(this.tab)}: choose one`},...l.map((f,b)=>T("button",{type:"button",class:"knob",title:f.label,"aria-label":f.label,"aria-pressed":f===r,tabindex:f===r||!r&&b===0?0:-1,on:{click:()=>this.store.set({selected:f===r?null:f.id})}},f.index.length>1?"":f.index[0])));h.style.setProperty("--columns",String(c)),h.addEventListener("keydown",f=>this.walk(f,l,c));let d=this.points.getRootNode().activeElement,u=d?.classList.contains("knob")??!1,p=this.coordinates.findIndex(f=>f.element.contains(d));this.coordinates=r?this.fields(r):[],this.points.replaceChildren(s.length>1?o.element:"",h,r?T("div",{class:"coordinates"},T("span",{class:"caption"},r.label),...this.coordinates.map(f=>f.element)):T("p",{class:"hint"},`${l.length} points: choose one here, or drag one in the picture`)),u&&h.querySelector('[tabindex="0"]')?.focus(),p>=0&&this.coordinates[p]?.element.querySelector("input")?.focus()}fields(e){let t=De(this.store.state),i=Ae(t,e.key);for(let a of e.index)i=i[a];let r=i,s=Qe(t)?["x","y","z"]:e.along?["a","b","c","d"]:t.kind==="swung"?e.key==="profile"?["r","z"]:["x","y"]:["x","y","z"];return r.map((a,o)=>{let l=Fn({label:T("i",{class:"math"},s[o]),name:`${e.label} ${s[o]}`,onChange:c=>this.store.editPatch(nr(De(this.store.state),e.key,e.index,r.map((h,d)=>d===o?c:h)))});return l.update(a),l})}walk(e,t,i){let r={ArrowRight:1,ArrowLeft:-1,ArrowDown:i,ArrowUp:-i}[e.key];if(!r)return;e.preventDefault(),e.stopPropagation();let s=t.findIndex(o=>o.id===this.store.state.selected),a=t[Math.min(t.length-1,Math.max(0,s+r))];this.store.set({selected:a.id})}closed(e){let{store:t}=this,i=De(t.state),r=Ae(i,"points"),[s,a]=[r[0],r.at(-1)],o=s.every((c,h)=>c===a[h]),l={...i,close:e,points:e?r.slice(0,-1):o?r:[...r,s]};try{St(l),t.editPatch(l)}catch(c){t.set({message:{kind:"error",text:c.message}}),this.close.update(!e)}}async become(e){let{store:t}=this,i=De(t.state),{patch:r,opened:s}=t.state,a=Ep(i,e);if(!a){let l=this.element.closest(".studio");await Qn(l,"Another surface?",[T("p",{},`“${i.name}” cannot be kept exactly as “${k1(e)}”: a new surface to start from would take its place.`)],[["stay","Keep it"],["replace","Start anew"]])==="replace"&&(a={...Ts(e).patches[0],name:i.name})}let o=t.state.patch===r&&t.state.opened===s&&De(t.state)===i;if(!a||!o)return this.kind.update(De(t.state).kind);t.set({selected:null}),t.editPatch(a)}};function O1(n,e){let t=De(n.state),i=bn(t).find(r=>r.id===n.state.selected);i&&n.editPatch(rl(t,i,i.position.map((r,s)=>r+e[s])),`nudge ${i.id}`)}var Ph=n=>Object.entries(it).filter(([,e])=>n(e)).map(([e])=>({value:e,label:It(k1(e))})),k1=n=>n==="nurbs"?"NURBS":n.replaceAll("_"," ");var Nh=class{constructor(e){this.store=e;this.element.append(this.left,this.warning,T("span",{class:"spacer"}),this.right),e.subscribe(t=>{t.message!==this.shown&&this.say(t.message)})}store;element=T("footer",{class:"status"});banner=T("div",{class:"banners"});left=T("span",{});warning=T("span",{class:"warning"});right=T("span",{class:"quiet"});shown=null;timer=0;refresh(e,t){let{unit:i}=e.model;if(t.curve){this.left.textContent=qw(t.curve,i),this.warning.textContent=t.warning,this.right.textContent="";return}this.left.replaceChildren(...t.surface?["Normal ",fs(t.surface)," ",T("i",{class:"math"},"S"),T("sub",{},"u")," × ",T("i",{class:"math"},"S"),T("sub",{},"v")]:["No surface"],i?` · lengths in ${i}`:" · no unit",t.sharp?` · smallest radius ${Ce(t.sharp.radius)}${i?` ${i}`:""} at u = ${Ce(t.sharp.u)}, v = ${Ce(t.sharp.v)}`:"");let r=t.singular===t.points&&!t.warning?"No point has a tangent plane: this is a curve":"",s=!t.singular||t.singular===t.points?r:`${t.singular} of ${t.points} points singular (grey)`;this.warning.textContent=[s,t.warning].filter(Boolean).join(" · "),this.right.textContent=`${t.side} × ${t.side} points, ${t.cost.toFixed(1)} ms`}offer(e,t,i,r,s){let a=T("div",{class:"banner",role:"alert"},T("span",{},e));return a.append(Ve(t,t,()=>{a.remove(),i()},"button primary"),Ve(r,r,()=>{a.remove(),s()})),this.banner.append(a),()=>a.remove()}warn(e){this.store.set({message:{kind:"error",text:e}})}say(e){this.shown=e,clearTimeout(this.timer),this.banner.querySelector(".message")?.remove(),e&&(this.banner.append(T("div",{class:`banner message ${e.kind}`,role:e.kind==="error"?"alert":"status"},T("div",{},e.text,e.lines?.length?T("ul",{},...e.lines.map(t=>T("li",{},t))):null),...(e.actions??[]).map(({label:t,act:i})=>Ve(t,t,i)),Ve(xt(Mt.close),"Close",()=>this.store.set({message:null}),"tiny"))),e.kind==="note"&&!e.lines&&!e.actions&&(this.timer=window.setTimeout(()=>this.store.set({message:null}),4e3)))}},Bw=401;function qw(n,e){let t=n.sample(Bw).filter(({curvature:o})=>Number.isFinite(o)),i=e?` ${e}`:"",r=t.reduce((o,l)=>Math.abs(l.curvature)>Math.abs(o.curvature)?l:o,t[0]??n.at(.5)),s=n.bends(r.curvature)?`greatest curvature ${Ce(r.curvature)}${e?` 1/${e}`:""} at t = ${Ce(r.t,3)}`:"straight",a=n.flat?" · positive turns left":"";return`Length ${Ce(n.length,5)}${i} · ${s}${a}${e?"":" · no unit"}`}var Lh=class{element;name;dirty=T("span",{class:"dirty",title:"Not saved"});undo;redo;compare;constructor(e,t,i,r,s,a){this.name=T("input",{class:"name","aria-label":"Name of the model",spellcheck:"false",maxlength:200}),pl(this.name,()=>{this.name.value=e.state.model.name}),this.name.addEventListener("change",()=>{let c=this.name.value.trim();if(!c)return void(this.name.value=e.state.model.name);let{model:h}=e.state,d=h.patches.length===1?[{...h.patches[0],name:c}]:h.patches;e.edit({...h,name:c,patches:d})}),this.undo=Ve(xt(Mt.undo),"Undo (Ctrl Z)",()=>e.undo(),"button square"),this.redo=Ve(xt(Mt.redo),"Redo (Ctrl Shift Z)",()=>e.redo(),"button square");let o=()=>["Presets",...ul.map(c=>({label:c.name,hint:c.patches[0].kind.replaceAll("_"," "),act:()=>{t.start(c)}})),"Starters",...Object.entries(it).filter(([,c])=>c.construction).map(([c,{title:h}])=>({label:It(c),hint:h,act:()=>{t.start(Ts(c))}}))];this.compare=vn("Compare",[{value:"off",label:"One",title:"The model alone"},{value:"before",label:"Before | now",title:"As last saved or opened, beside the model now"},{value:"sets",label:"Four sets",title:"The four sets of shape parameters of the thesis, on one scale"},{value:"kept",label:"Kept",title:"The model beside those you kept"}],c=>c==="kept"&&!e.state.kept.length?td(e):e.set({compare:c}));let l=Ve("Keep","Keep the model as it is now, to compare with",()=>td(e),"button quiet");this.element=T("header",{class:"bar"},a?null:T("span",{class:"brand",title:"quintrig"},Vw(),T("span",{},"quintrig")),Ve(xt(Mt.side),"Construction and control points",s,"button square drawer"),this.name,this.dirty,T("div",{class:"group"},Ra(T("span",{},"Models",xt(Mt.down)),"Models: presets and starters",o),Ra(T("span",{},xt(Mt.open),T("span",{class:"word"},"Open"),xt(Mt.down)),"Open a model",()=>t.openItems()),Ra(T("span",{},xt(Mt.save),T("span",{class:"word"},"Save"),xt(Mt.down)),"Save the model",()=>t.saveItems())),T("div",{class:"group tight"},this.undo,this.redo),T("div",{class:"group tight"},this.compare.element,l),T("span",{class:"spacer"}),T("div",{class:"group tight last"},Ve(xt(Mt.picture),"Save a picture",()=>{t.picture()},"button square"),Ra(xt(Mt.export),"Export",()=>t.exportItems(),"button square",()=>t.lookAtFormats()),Ve(xt(Mt.sun),"Light or dark",i,"button square theme"),Ve(xt(Mt.help),"Keys and pointer (?)",r,"button square")))}refresh(e){qr(this.name)||(this.name.value=e.model.name),this.name.style.setProperty("--letters",String(Math.min(30,Math.max(6,this.name.value.length)))),this.dirty.hidden=e.model===e.saved,this.undo.disabled=!e.canUndo,this.redo.disabled=!e.canRedo,this.compare.update(e.compare)}};function Vw(){let n=xt("M2 11c3-6 9-1 12-7M2 11c2 3 5 3 6.5 2.2M14 4c.3 3-1.500 7.200-5.500 9.200M5.500 7.700c1 2.500 3 4 5.600 3.700M9.500 6.600c.7 1.900 1.900 3 3.400 3.100");return n.classList.add("mark-icon"),n}function U1(n,e,t,i,r,s,a){let o=n.getContext("2d"),{width:l,height:c}=n,h=Math.max(11,Math.min(l,c)/48);o.fillStyle=o.strokeStyle=a?"#e8edf3":"#1c232c",o.textBaseline="middle",o.font=`600 ${h}px Helvetica, Arial, sans-serif`;let d=r.length?Math.max(...r.map(E=>E.x+E.width)):1;if(s.forEach((E,w)=>{let v=r[w];v&&E&&o.fillText(E,v.x/d*l+h,v.y/d*l+1.4*h)}),!e.legend)return n;let u=r[0]?.pieces[t.patch],p=u?.surface,f=p?`normal ${fs(p)} Su × Sv`:u?.curve.length?t.settings.comb?"curvature comb":"curve":"no surface";o.font=`${.85*h}px Helvetica, Arial, sans-serif`,o.fillText(`${t.model.name} · ${f}${t.model.unit?` · lengths in ${t.model.unit}`:""}`,h,c-1.2*h);let b=lt[t.settings.quantity];if(!b||!r[0]?.pieces.some(E=>E.surface))return n;let m=fi(b,t.model.unit),g=`${It(b.name)}${b.colour==="classes"?"":` ${b.symbol}`}${m?` (${m})`:""}`,y=l-h,_=o.measureText(g).width;if(o.textAlign="right",o.fillText(g,y,1.4*h),o.textAlign="left",i){let E=2.6*h,w=Math.min(14*h,c*.5),v=y-Math.max(4.6*h,.3*_),A=vr(b);A.forEach((L,R)=>{o.fillStyle=qn(L),o.fillRect(v,E+w*(1-(R+1)/A.length),h,w/A.length+.6)}),o.fillStyle=a?"#e8edf3":"#1c232c";for(let L=0;L<5;L++)o.fillText(Ce(i.low+(i.high-i.low)*L/4,3),v+1.4*h,E+w*(1-L/4));return n}let x=xr(b.key);return b.classes.slice(1).forEach((E,w)=>{let v=(2.9+1.4*w)*h;o.fillStyle=qn(x[w+1]),o.fillRect(y-h,v-.5*h,h,h),o.fillStyle=a?"#e8edf3":"#1c232c",o.textAlign="right",o.fillText(E,y-1.5*h,v),o.textAlign="left"}),n}var{sameColour:Cp,noise:Hw}=Be.limits,Dh=48,Fh=new Float32Array(0),B1=new WeakMap;function Gw(n,e){let t=B1.get(n);if(t?.version===n.version)return t;let{values:i,repeated:r,covered:s}=n,a=new Float32Array(i.length),o=0,l=0,c=0,h=0;for(let u=0;u<i.length;u++){if(!s[u])continue;let p=i[u];p-p===0?(a[o++]=p,l+=p):r[u]||(h++,p===p&&c++)}let d={version:n.version,sorted:a.subarray(0,o).sort(),sum:l,missing:h,infinite:c,scale:$w(n,e)};return B1.set(n,d),d}function V1(n,e,t){let i=n.map(b=>Gw(b,e)),r=i.map(b=>b.sorted).filter(b=>b.length),s=b=>i.reduce((m,g)=>m+b(g),0),a=s(b=>b.sorted.length),o=Math.max(...i.map(b=>b.scale)),l=Math.min(...r.map(b=>b[0])),c=Math.max(...r.map(b=>b.at(-1))),[h,d]=Ww(r,a,l,c,e,t,o);d>h||([h,d]=[h-.5*(Math.abs(h)||1),h+.5*(Math.abs(h)||1)]);let u=Array.from({length:Dh+1},(b,m)=>zh(r,h+(d-h)*m/Dh,m===Dh)),p=u.slice(1).map((b,m)=>b-u[m]),f=a?1/a:0;return{low:h,high:d,below:u[0]*f,above:(a-u[Dh])*f,least:l,most:c,mean:a?s(b=>b.sum)/a:NaN,finite:a,missing:s(b=>b.missing),infinite:s(b=>b.infinite),histogram:p,noise:Hw*o}}function Ww(n,e,t,i,r,s,a){if(s.range==="fixed")return[s.low,s.high];if(r.key==="shape_index")return[-1,1];if(!e)return r.colour==="diverging"?[-1,1]:[0,1];let o=s.range==="robust",l=s.percentile/100,c=b=>Math.round(b*(e-1));if(r.colour==="diverging"){let b=Math.max(-t,i),m=b;return o&&(m=Rp(q1(0,b,c(1-l),g=>zh(n,g,!0)-zh(n,-g)),b)),(m<=Cp*a||m===0)&&(m=a>0?a:1),[-m,m]}let h=b=>q1(t,i,c(b),m=>zh(n,m,!0)),d=o?h(l):t,u=o?h(1-l):i,p=.5*(d+u);if(o&&(d=p-Rp(p-d,p-t),u=p+Rp(u-p,i-p)),d>=0&&d<=.4*u&&(d=0),u>d&&u-d>=Math.max(.02*Math.abs(p),Cp*a))return[d,u];let f=Math.abs(p)>Cp*a?.5*Math.abs(p):a||1;return[p-f,p+f]}function zh(n,e,t=!1){let i=0;for(let r of n){let s=0,a=r.length;for(;s<a;){let o=s+a>>1,l=r[o];l<e||t&&l===e?s=o+1:a=o}i+=s}return i}function q1(n,e,t,i){if(i(n)>t)return n;for(;;){let r=Math.fround(.5*n+.5*e);if(r<=n||r>=e)return e;i(r)>t?e=r:n=r}}var Rp=(n,e)=>e<=1.5*n?e:n;function $w(n,e){let{size:t,planes:i,stride:r,count:s}=n.grid;if(e.power===0||!(t>0))return 1;if(e.power>0)return t**e.power;Fh.length<s&&(Fh=new Float32Array(s));let a=0;for(let o=0;o<s;o+=7){let l=i[Oe.curvedness*r+o];n.covered[o]&&l<1/0&&(Fh[a++]=l)}return Math.max(a?Xw(Fh.subarray(0,a),.98):0,1/t)**-e.power}function Xw(n,e){let t=Math.round(e*(n.length-1)),i=0,r=n.length-1;for(;i<r;){let s=n[i+r>>1],a=i,o=r;for(;a<=o;){for(;n[a]<s;)a++;for(;n[o]>s;)o--;if(a<=o){let l=n[a];n[a++]=n[o],n[o--]=l}}if(t<=o)r=o;else if(t>=a)i=a;else break}return n[t]}var Oh={iso:[-55,26],top:[-90,90],side:[-90,0],back:[0,0],front:[180,0],bottom:[-90,-90]},H1=14*Math.PI/180,Pp=Math.PI/180;function Yw(n,e){let t=n*Pp,i=e*Pp;return{right:new U(-Math.sin(t),Math.cos(t),0),up:new U(-Math.sin(i)*Math.cos(t),-Math.sin(i)*Math.sin(t),Math.cos(i)),towards:new U(Math.cos(i)*Math.cos(t),Math.cos(i)*Math.sin(t),Math.sin(i))}}var So=class{azimuth=Oh.iso[0];elevation=Oh.iso[1];span=1.1;target=new U;chosen="perspective";straight=!1;moved=!1;perspective=new jt(2*H1/Pp,1,.01,100);orthographic=new Zs;goal=null;from={azimuth:0,elevation:0,span:1,target:new U};get projection(){return this.straight?"orthographic":this.chosen}camera(e){let t=this.projection==="perspective"?this.perspective:this.orthographic,i=this.span/Math.min(1,e),r=i/Math.tan(H1),{right:s,up:a,towards:o}=this.axes();return t.position.copy(this.target).addScaledVector(o,r),t.matrixWorld.copy(new pt().makeBasis(s,a,o)).setPosition(t.position),t.matrixWorld.decompose(t.position,t.quaternion,t.scale),t instanceof jt?(t.aspect=e,t.near=Math.max(r-6,.02*r),t.far=r+12):(t.left=-i*e,t.right=i*e,t.top=i,t.bottom=-i,t.near=r-12,t.far=r+12),t.updateProjectionMatrix(),t.updateMatrixWorld(!0),t}axes(){return Yw(this.azimuth,this.elevation)}turn(e,t){this.goal=null,this.moved=!0,this.straight=!1,this.azimuth-=e*.35,this.elevation=Math.max(-90,Math.min(90,this.elevation+t*.35))}pan(e,t,i=1){this.goal=null,this.moved=!0;let{right:r,up:s}=this.axes(),a=2*this.span/Math.min(1,i);this.target.addScaledVector(r,-e*a).addScaledVector(s,t*a)}zoom(e,t=0,i=0,r=1){this.goal=null;let s=this.span;this.span=Math.max(1e-4,Math.min(20,this.span*e));let a=s/this.span-1;this.pan(-t*a,-i*a,r)}go(e,t,i,r,s){if(this.moved=!1,s){this.azimuth=e,this.elevation=t,this.span=i,this.target.copy(r);return}let a=(e-this.azimuth)%360;a>180&&(a-=360),a<-180&&(a+=360),this.from={azimuth:this.azimuth,elevation:this.elevation,span:this.span,target:this.target.clone()},this.goal={azimuth:this.azimuth+a,elevation:t,span:i,target:r.clone(),start:performance.now()}}step(e){if(!this.goal)return!1;let t=Math.min(1,Math.max(0,(e-this.goal.start)/260)),i=1-(1-t)**3,r=(s,a)=>s+(a-s)*i;return this.azimuth=r(this.from.azimuth,this.goal.azimuth),this.elevation=r(this.from.elevation,this.goal.elevation),this.span=r(this.from.span,this.goal.span),this.target.lerpVectors(this.from.target,this.goal.target,i),t>=1&&(this.goal=null),t<1}};var G1=`
out vec3 place;
out vec3 way;
out vec2 parameters;
void main() {
  place = position;
  way = normal;
  parameters = uv;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`,W1=`
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
}`;var Jw=1e38,$1=new Map,kh=class{grid=new Ms;material;mesh;values=new Float32Array(0);version=0;covered=new Uint8Array(0);repeated=new Uint8Array(0);places=0;singular=0;box=[];trim;counted=null;buffers=new Map;current=null;constructor(){this.material=new Kt({glslVersion:qi,vertexShader:G1,fragmentShader:W1,side:Bn,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1,uniforms:{mode:{value:0},field:{value:null},colours:{value:null},range:{value:new Xe(-1,1)},contour:{value:0},cells:{value:new Xe(2,2)},front:{value:new U},back:{value:new U},undefinedColour:{value:new U},stripes:{value:0},density:{value:20},light:{value:new U(0,0,1)},curves:{value:0},cut:{value:new ht},clipped:{value:!1},wire:{value:!1},shade:{value:1},towards:{value:new U(0,0,1)},faded:{value:0},face:{value:null},trimmed:{value:!1}}}),this.mesh=new Zt(void 0,this.material),this.mesh.frustumCulled=!1}update(e,t,i,r){let s=this.current=this.prepare(t),{grid:a}=this;a.evaluate(e,t,t),this.cut(e,t);let{planes:o,stride:l,count:c}=a;this.singular=this.places=0,this.repeated.length!==c&&(this.repeated=new Uint8Array(c));let h=[1/0,1/0,1/0],d=[-1/0,-1/0,-1/0],u=s.position,p=(b,m)=>u[3*b]===u[3*m]&&u[3*b+1]===u[3*m+1]&&u[3*b+2]===u[3*m+2];this.repeated.fill(0);for(let b=0;b<c;b++){for(let y=0;y<3;y++){s.position[3*b+y]=(o[(Oe.point+y)*l+b]-r.centre[y])*r.scale;let _=o[(Oe.normal+y)*l+b];s.normal[3*b+y]=_===_?_:0;let x=u[3*b+y];x<h[y]&&(h[y]=x),x>d[y]&&(d[y]=x)}if(!this.covered[b])continue;let m=b%t>0&&p(b,b-1)||b>=t&&p(b,b-t);if(this.repeated[b]=m?1:0,m)continue;this.places++;let g=o[Oe.gaussian*l+b];g!==g&&this.singular++}this.box.splice(0,6,...h,...d),s.geometry.attributes.position.needsUpdate=!0,s.geometry.attributes.normal.needsUpdate=!0,this.mesh.geometry=s.geometry,this.mesh.visible=!0,this.material.uniforms.cells.value.set(t,t),this.paint(i)}cut(e,t){if(this.trim===e.trim&&this.covered.length===t*t)return;this.covered=tl(e,this.grid.u,this.grid.v);let i=this.material.uniforms;this.trim!==e.trim&&(i.face.value?.dispose(),i.face.value=e.trim?.length?jw(e):null,i.trimmed.value=i.face.value!==null),this.trim=e.trim}paint(e){let t=this.current;if(this.version++,!t)return;let i=this.material.uniforms,r=lt[e];if(i.mode.value=r?r.colour==="classes"?2:1:0,this.values=r?t.values:new Float32Array(0),r){this.grid.quantity(e,t.values,xs);let s=t.texture.image.data;for(let a=0;a<s.length;a++){let o=t.values[a];s[a]=o-o===0?o:Jw}t.texture.needsUpdate=!0,i.field.value=t.texture,i.colours.value=Zw(e)}}clear(){this.current=null,this.mesh.visible=!1,this.box.length=0}get counts(){if(this.counted?.version===this.version)return this.counted.counts;let e=[];for(let t=0;t<this.values.length;t++)this.covered[t]&&!this.repeated[t]&&(e[this.values[t]]=(e[this.values[t]]??0)+1);return this.counted={version:this.version,counts:e},e}get position(){return this.current?.position??new Float32Array(0)}get side(){return this.current?this.grid.nu:0}dispose(){for(let e of this.buffers.values())e.geometry.dispose(),e.texture.dispose();this.material.uniforms.face.value?.dispose(),this.material.dispose()}prepare(e){let t=this.buffers.get(e);if(t)return t;if(this.buffers.size>5){let h=this.buffers.keys().next().value;this.buffers.get(h).geometry.dispose(),this.buffers.get(h).texture.dispose(),this.buffers.delete(h)}let i=new un,r=new Float32Array(3*e*e),s=new Float32Array(3*e*e),a=new Float32Array(2*e*e);for(let h=0,d=0;h<e;h++)for(let u=0;u<e;u++,d+=2)a.set([h/(e-1),u/(e-1)],d);let o=new Uint32Array(6*(e-1)*(e-1));for(let h=0,d=0;h<e-1;h++)for(let u=0;u<e-1;u++){let p=h*e+u;o[d++]=p,o[d++]=p+e,o[d++]=p+e+1,o[d++]=p,o[d++]=p+e+1,o[d++]=p+1}i.setIndex(new Et(o,1)),i.setAttribute("position",new Et(r,3).setUsage(ia)),i.setAttribute("normal",new Et(s,3).setUsage(ia)),i.setAttribute("uv",new Et(a,2));let l=new Yr(new Float32Array(e*e),e,e,oo,En),c={geometry:i,position:r,normal:s,values:new Float32Array(e*e),texture:l};return this.buffers.set(e,c),c}},Mo=1024;function jw(n){let e=document.createElement("canvas"),[t,i,r,s]=Ki(n);e.width=e.height=Mo;let a=e.getContext("2d");a.fillRect(0,0,Mo,Mo),a.fillStyle="#ffffff",a.beginPath();for(let l of n.trim)l.forEach(([c,h],d)=>{let u=[Mo*(c-t)/(r-t),Mo*(1-(h-i)/(s-i))];d?a.lineTo(...u):a.moveTo(...u)}),a.closePath();a.fill("evenodd");let o=new Za(e);return o.minFilter=o.magFilter=kt,o.generateMipmaps=!1,o}var X1=([n,e,t])=>new U(n/255,e/255,t/255);function Zw(n){let e=lt[n],t=e.colour==="classes"?n:e.colour,i=$1.get(t);if(!i){let r=e.colour==="classes"?xr(n):vr(e);i=new Yr(I1(r),r.length,1,Tn,sn),i.magFilter=i.minFilter=e.colour==="classes"?Tt:kt,i.needsUpdate=!0,$1.set(t,i)}return i}var Ip=class{mesh=new kh;overlays=new xh;patch=null;surface=null;curve=[];side=0;frame=null;quantity="";lines="";net="";seams=[];seamsFrame=null;beside=null;besideFrame=null},Uh=class{scene=new $a;pieces=[];x=0;y=0;width=1;height=1;resizePieces(e){for(;this.pieces.length>e;){let t=this.pieces.pop();this.scene.remove(t.mesh.mesh,t.overlays.group),t.mesh.dispose(),t.overlays.dispose()}for(;this.pieces.length<e;){let t=new Ip;this.pieces.push(t),this.scene.add(t.mesh.mesh,t.overlays.group)}}};function Y1(n,e,t){let i=-1/0,r=1/0;for(let s=0;s<3;s++){let a=(n[s]-1e-5-e[s])/t[s],o=(n[s+3]+1e-5-e[s])/t[s];i=Math.max(i,Math.min(a,o)||i),r=Math.min(r,Math.max(a,o)||r)}return i<=r}function J1(n,e,t,i,r){let s=1/0,a=0,o=0,[l,c,h]=t,[d,u,p]=i;for(let b=0;b<e-1;b++)for(let m=0;m<e-1;m++){let g=3*(b*e+m);for(let y=0;y<2;y++){let _=y===0?g+3*e:g+3*e+3,x=y===0?g+3*e+3:g+3,E=n[g],w=n[g+1],v=n[g+2],A=n[_]-E,L=n[_+1]-w,R=n[_+2]-v,N=n[x]-E,z=n[x+1]-w,H=n[x+2]-v,P=u*H-p*z,W=p*N-d*H,B=d*z-u*N,O=A*P+L*W+R*B;if(O===0)continue;let Q=l-E,G=c-w,Y=h-v,ee=(Q*P+G*W+Y*B)/O;if(ee<-1e-9||ee>1+1e-9)continue;let ye=G*R-Y*L,Ee=Y*A-Q*R,$=Q*L-G*A,ne=(d*ye+u*Ee+p*$)/O;if(ne<-1e-9||ee+ne>1+1e-9)continue;let he=(N*ye+z*Ee+H*$)/O;if(he>=s)continue;let xe=(b+(y===0?ee+ne:ee))/(e-1),ue=(m+(y===0?ne:ee+ne))/(e-1);r(l+he*d,c+he*u,h+he*p,xe,ue)&&([s,a,o]=[he,xe,ue])}}if(s===1/0)return null;let f=b=>Math.min(1,Math.max(0,b));return{u:f(a),v:f(o),distance:s}}function j1(){let n=document.createElement("canvas").getContext("webgl2"),e=n?.getExtension("WEBGL_debug_renderer_info"),t=e?String(n.getParameter(e.UNMASKED_RENDERER_WEBGL)):"";return n?.getExtension("WEBGL_lose_context")?.loseContext(),/swiftshader|llvmpipe|softpipe|software|basic render/i.test(t)}var Kw=64;function Z1(n,e,t,i,r,s){let a=n.getContext("2d");a.setTransform(i,0,0,i,0,0),a.clearRect(0,0,n.width,n.height);let o=lt[r],l=o?o.colour==="classes"?xr(r):vr(o):[],c=p=>o?p-p!==0?ss:o.colour==="classes"||!s?l[p]??ss:l[Math.round(255*Math.min(1,Math.max(0,(p-s.low)/(s.high-s.low))))]:la,{right:h,up:d,towards:u}=t.axes();for(let p of e){let f=t.span/Math.min(1,p.width/p.height),b=p.height/(2*f),m=[];for(let{mesh:g}of p.pieces){let y=g.side,_=g.position,x=Math.max(1,Math.ceil((y-1)/Kw)),E=v=>{let A=[_[3*v]-t.target.x,_[3*v+1]-t.target.y,_[3*v+2]-t.target.z],L=R=>A[0]*R.x+A[1]*R.y+A[2]*R.z;return[p.x+p.width/2+b*L(h),p.y+p.height/2-b*L(d),L(u)]},w=Array.from({length:Math.ceil((y-1)/x)},(v,A)=>A*x);for(let v of w)for(let A of w){let L=Math.min(y-1,v+x),R=Math.min(y-1,A+x),[N,z,H,P]=[E(v*y+A),E(L*y+A),E(L*y+R),E(v*y+R)],W=(v+L>>1)*y+(A+R>>1);if(!g.covered[W])continue;let B=g.grid.planes,O=g.grid.stride,Q=Math.abs(B[3*O+W]*u.x+B[4*O+W]*u.y+B[5*O+W]*u.z);m.push({depth:N[2]+z[2]+H[2]+P[2],corners:[N[0],N[1],z[0],z[1],H[0],H[1],P[0],P[1]],colour:c(g.values[W]??NaN),lit:Q||.5})}}a.save(),a.beginPath(),a.rect(p.x,p.y,p.width,p.height),a.clip();for(let g of m.sort((y,_)=>y.depth-_.depth)){let y=.68+.32*g.lit;a.fillStyle=a.strokeStyle=qn(g.colour.map(_=>Math.round(_*y))),a.beginPath(),a.moveTo(g.corners[0],g.corners[1]);for(let _=2;_<8;_+=2)a.lineTo(g.corners[_],g.corners[_+1]);a.closePath(),a.fill(),a.stroke()}for(let{overlays:g}of p.pieces)Qw(a,g,(y,_,x)=>{let E=[y-t.target.x,_-t.target.y,x-t.target.z],w=v=>E[0]*v.x+E[1]*v.y+E[2]*v.z;return[p.x+p.width/2+b*w(h),p.y+p.height/2-b*w(d)]});a.restore()}}function Qw(n,e,t){let{lines:i,points:r}=e.drawn;for(let{ends:s,colour:a,width:o,opacity:l}of i){n.strokeStyle=a,n.lineWidth=o,n.globalAlpha=l,n.beginPath();for(let c=0;c<s.length;c+=6)n.moveTo(...t(s[c],s[c+1],s[c+2])),n.lineTo(...t(s[c+3],s[c+4],s[c+5]));n.stroke()}n.globalAlpha=1,n.lineWidth=1.5,n.strokeStyle="#ffffff";for(let{places:s,tints:a}of r)for(let o=0;3*o<s.length;o++)n.fillStyle=qn([0,1,2].map(l=>Math.round(255*a[4*o+l]))),n.beginPath(),n.arc(...t(s[3*o],s[3*o+1],s[3*o+2]),a[4*o+3]>1.5?6:4,0,7),n.fill(),n.stroke()}var e2=6,Bh=class{constructor(e){this.canvas=e;this.software=j1();let t=e.getContext("webgl2",{antialias:!this.software,alpha:!0,powerPreference:"high-performance"});this.renderer=t&&new ph({canvas:e,context:t}),this.renderer?.setClearColor(0,0),this.renderer&&(this.renderer.autoClear=!1)}canvas;orbit=new So;cells=[];renderer;range=null;quantity="none";width=1;height=1;ratio=1;margin=0;covered=0;software;detail=1;get works(){return this.renderer!==null}resize(e,t,i){this.width=Math.max(1,e),this.height=Math.max(1,t),this.ratio=i,this.renderer?(this.renderer.setPixelRatio(this.pixels),this.renderer.setSize(this.width,this.height,!1)):(this.canvas.width=this.width*i,this.canvas.height=this.height*i),this.arrange()}economy(e){let t=this.software?e?.6:1.5:1;t!==this.detail&&(this.detail=t,this.resize(this.width,this.height,this.ratio))}get pixels(){return this.ratio*this.detail}layout(e,t=0){for(this.margin=t;this.cells.length>e;)this.cells.pop().resizePieces(0);for(;this.cells.length<e;)this.cells.push(new Uh);this.arrange()}arrange(){let e=this.cells.length,t=e>4?3:e>1?2:1,i=Math.ceil(e/t),r=e>1?Math.max(.6*this.width,this.width-this.margin):this.width,s=e>1?this.height-50:this.height;this.cells.forEach((a,o)=>{a.width=r/t,a.height=s/i,a.x=o%t*a.width,a.y=Math.floor(o/t)*a.height;for(let l of a.pieces)l.overlays.resize(a.width*this.pixels,a.height*this.pixels,this.pixels)})}style(e,t,i,r,s){let a=t2(e);this.range=t,this.quantity=e.quantity;let o=ns(e,r);for(let l of this.cells)l.pieces.forEach((c,h)=>{let d=c.mesh.material.uniforms;Np(d.front.value,Sh),Np(d.back.value,la),Np(d.undefinedColour.value,ss),t&&d.range.value.set(t.low,t.high),d.contour.value=t&&e.contours?(t.high-t.low)/10:0,d.stripes.value=["none","zebra","isophotes","reflection","highlight"].indexOf(e.stripes),d.density.value=e.density,d.light.value.copy(a),d.curves.value=e.wireframe?30:e.curves?10:0,d.cut.value.set(...o),d.clipped.value=e.section&&e.clip,d.wire.value=e.wireframe,d.shade.value=e.stripes==="none"?1:.6,d.faded.value=(l.pieces.length>1&&h!==s,0),c.overlays.theme(i),c.overlays.resize(l.width*this.pixels,l.height*this.pixels,this.pixels)});this.orbit.chosen=this.works?e.projection:"orthographic"}draw(){let{renderer:e}=this;if(!e)return Z1(this.canvas,this.cells,this.orbit,this.ratio,this.quantity,this.range);e.setScissorTest(!1),e.setViewport(0,0,this.width,this.height),e.clear(),e.setScissorTest(!0);let t=this.orbit.axes().towards;for(let i of this.cells){let r=this.height-i.y-i.height;e.setViewport(i.x,r,i.width,i.height),e.setScissor(i.x,r,i.width,i.height);for(let s of i.pieces)s.mesh.material.uniforms.towards.value.copy(t);e.render(i.scene,this.orbit.camera(i.width/i.height))}}zoomAt(e,t,i){let r=this.cells[Math.max(0,this.cellAt(t,i))];this.orbit.zoom(e,(t-r.x)/r.height-.5*r.width/r.height,(i-r.y)/r.height-.5,r.width/r.height)}pan(e,t){let{width:i,height:r}=this.cells[0];this.orbit.pan(e/r,t/r,i/r)}cellAt(e,t){return this.cells.findIndex(i=>e>=i.x&&e<i.x+i.width&&t>=i.y&&t<i.y+i.height)}ray(e,t,i){let r=this.cells[e],s=this.orbit.camera(r.width/r.height),a=(t-r.x)/r.width*2-1,o=1-(i-r.y)/r.height*2,l=new U(a,o,-1).unproject(s),h=new U(a,o,1).unproject(s).sub(l).normalize();return{origin:[l.x,l.y,l.z],direction:[h.x,h.y,h.z]}}project(e,t){let i=this.cells[e],r=new U(t[0],t[1],t[2]).project(this.orbit.camera(i.width/i.height));return{x:i.x+(r.x+1)*.5*i.width,y:i.y+(1-r.y)*.5*i.height,depth:r.z}}pick(e,t,i,r){let s=this.cellAt(e,t);if(s<0)return null;let{origin:a,direction:o}=this.ray(s,e,t),[l,c,h,d]=ns(i,r),u=i.section&&i.clip,p=null;return this.cells[s].pieces.forEach((f,b)=>{let m=f.mesh.side,{surface:g}=f;if(!g||m<2||!Y1(f.mesh.box,a,o))return;let[y,_,x,E]=Ki(g),w=(N,z)=>[y+(x-y)*N,_+(E-_)*z],v=(N,z,H,P,W)=>(!u||l*N+c*z+h*H<=d)&&_s(g,...w(P,W)),A=J1(f.mesh.position,m,a,o,v);if(!A||p&&A.distance>=p.distance)return;let[L,R]=w(A.u,A.v);p={u:L,v:R,distance:A.distance,cell:s,piece:b}}),p}pickCurve(e,t,i,r){let s=this.cellAt(e,t),a=null,o=r;for(let[l,{curve:c}]of s<0?[]:this.cells[s].pieces.entries()){let h=c.map(({point:d})=>this.project(s,wt(i,d)));for(let d=0;d+1<h.length;d++){let u=h[d],p=h[d+1],f=p.x-u.x,b=p.y-u.y,m=Math.min(1,Math.max(0,((e-u.x)*f+(t-u.y)*b)/(f*f+b*b||1))),g=Math.hypot(u.x+m*f-e,u.y+m*b-t);g<o&&([o,a]=[g,{cell:s,piece:l,u:c[d].t+m*(c[d+1].t-c[d].t),v:0}])}}return a}hides(e,t,i,r){let s=this.project(e,t),a=this.pick(s.x,s.y,i,r);if(!a)return!1;let{origin:o}=this.ray(e,s.x,s.y);return a.distance<Math.hypot(...t.map((l,c)=>l-o[c]))-.03}view(e,t,i,r){this.orbit.straight=e!=="iso",this.fit(t,i,r,Oh[e])}fit(e,t,i,[r,s]=[this.orbit.azimuth,this.orbit.elevation]){let a=this.cells[0];if(!a)return;let o=new So;o.azimuth=r,o.elevation=s,o.chosen=this.orbit.projection;let{right:l,up:c}=o.axes(),h=a.width/a.height,d=this.cells.length>1,u=a.width<300?10:24,p=!d&&i>.3*a.width,f=1-2*(d||p?u:i+u)/a.width,b=-1+2*(d?u:62+Math.min(this.covered,.5*a.height))/a.height,m=-1+2*u/a.width,g=1-2*(p?Math.min(.3*a.height,150):d?u+22:u)/a.height,y=new U;for(let _=0;_<6;_++){let x=o.camera(h),[E,w,v,A]=[1/0,-1/0,1/0,-1/0],L=(N,z,H)=>{y.set(N,z,H).project(x),E=Math.min(E,y.x),w=Math.max(w,y.x),v=Math.min(v,y.y),A=Math.max(A,y.y)};for(let{pieces:N}of this.cells)for(let{mesh:z,overlays:H}of N){let P=z.position,W=3*Math.max(1,Math.floor(z.side/24));for(let B=0;B+2<P.length;B+=W)z.covered[B/3]&&n2(e,P[B],P[B+1],P[B+2])&&L(P[B],P[B+1],P[B+2]);for(let[B,O,Q]of[...H.netPoints,...H.curvePoints])Math.hypot(B,O,Q)<e2&&L(B,O,Q)}if(!(w>=E))break;let R=o.span/Math.min(1,h);o.target.addScaledVector(l,R*h*(.5*(E+w)-.5*(m+f))).addScaledVector(c,R*(.5*(v+A)-.5*(b+g))),o.span=Math.min(20,Math.max(.02,o.span*Math.max((w-E)/(f-m),(A-v)/(g-b))))}this.orbit.go(r,s,o.span,o.target,t)}async picture(e,t,i){let r={width:this.width,height:this.height,ratio:this.ratio,detail:this.detail};this.detail=this.software&&Math.max(e,t)<=4096?2:1,this.renderer?.setClearColor(i?new We().setStyle(i,"srgb-linear"):0,i?1:0),this.resize(e,t,1),this.draw();let s=document.createElement("canvas");return s.width=e,s.height=t,s.getContext("2d").drawImage(this.canvas,0,0,e,t),this.renderer?.setClearColor(0,0),this.detail=r.detail,this.resize(r.width,r.height,r.ratio),this.draw(),s}finish(){let e=this.renderer?.getContext();e?.readPixels(0,0,1,1,e.RGBA,e.UNSIGNED_BYTE,new Uint8Array(4))}dispose(){this.layout(0),this.renderer?.dispose()}};function t2(n){let e=n.lightAzimuth*Math.PI/180,t=n.lightElevation*Math.PI/180;return new U(Math.cos(t)*Math.cos(e),Math.cos(t)*Math.sin(e),Math.sin(t))}var n2=({half:[n,e,t]},i,r,s)=>Math.abs(i)<=n+.04&&Math.abs(r)<=e+.04&&Math.abs(s)<=t+.04;function Np(n,e){n.copy(X1(e))}var K1="quintrig:draft:",i2=3,qh=class{constructor(e){this.place=e;let t=Math.random().toString(36).slice(2,10);this.key=`${K1}${e}:${t}`,navigator.locks?.request(this.key,()=>new Promise(()=>{})).catch(()=>{})}place;key;offers=[];watch(e,t){let i=0,r=()=>this.keep(e.state);e.subscribe((s,a)=>{s.opened!==a.opened&&this.offer(e,t,s.source),!(s.model===a.model&&s.saved===a.saved&&s.source===a.source)&&(clearTimeout(i),s.model===s.saved?r():i=window.setTimeout(r,400))}),window.addEventListener("pagehide",r),this.offer(e,t)}async offer(e,t,i){for(let o of this.offers.splice(0))o();let{opened:r}=e.state,s=await this.left();if(e.state.opened!==r)return;let a=i===void 0?s:s.filter(o=>i&&o.source?.name===i.name);this.offers=a.slice(0,i2).map(o=>{let l=new Date(o.when).toLocaleString([],{dateStyle:"medium",timeStyle:"short"}),c=o.source?` (${o.source.name})`:"";return t.offer(`Unsaved work on “${o.model.name}”${c} from ${l} was kept.`,"Restore it",()=>{e.resume(o),this.keep(e.state)&&Lp(o.key)},"Discard",()=>Lp(o.key))})}keep({model:e,saved:t,source:i}){try{return e===t?localStorage.removeItem(this.key):localStorage.setItem(this.key,JSON.stringify({when:Date.now(),model:cn(e),saved:cn(t),source:i,library:Af()})),!0}catch{return!1}}async left(){let e=new Set((await navigator.locks?.query().catch(()=>null))?.held?.map(i=>i.name)??[]),t=[];for(let i of r2())if(!(!i.startsWith(`${K1}${this.place}:`)||i===this.key||e.has(i)))try{let{when:r,model:s,saved:a,source:o,library:l}=JSON.parse(localStorage.getItem(i));Rr(l??[]);let c=vt(s);t.push({key:i,when:r,model:c,saved:a?vt(a):{...c},source:o??null})}catch{Lp(i)}return t.sort((i,r)=>r.when-i.when)}};function Lp(n){localStorage.removeItem(n)}function r2(){try{return Object.keys(localStorage)}catch{return[]}}var s2=16*2**20,a2=15e3,Vh=class{constructor(e,t,i,r,s,a){this.store=e;this.host=t;this.root=i;this.draw=r;this.size=s;this.ends=a;this.look()}store;host;root;draw;size;ends;known=[];formats=[];asked="";lost=!1;async look(){try{this.known=await this.host.list()}catch{this.known=[]}}async lookAtFormats(){let{state:e}=this.store,t=De(e).name,i=`${t}
${hn(e.model)}`;if(i===this.asked)return!1;this.asked=i;try{this.formats=await this.host.formats(e.model,t)}catch{this.asked=""}return!0}openItems(){let e=this.known.map(t=>({label:t,act:()=>{this.load(t)}}));return[{label:"From this computer …",hint:"or drop a file on the picture",act:()=>this.choose()},...e.length?["In the folder",...e]:[]]}saveItems(){let{model:e,source:t}=this.store.state;return[...this.host.kind==="live"?[{label:t?`Save ${t.name}`:"Save …",hint:"Ctrl S",act:()=>{this.save()}},{label:"Save as …",act:()=>{this.saveAs()}}]:[],{label:"Download TOML",act:()=>Jn(`${jn(e.name)}.toml`,hn(e))},{label:"Download JSON",act:()=>Jn(`${jn(e.name)}.json`,`${JSON.stringify(cn(e),null,1)}
`,"application/json")}]}exportItems(){return this.host.kind!=="live"?[{label:"Exports need the live studio",hint:"quintrig view MODEL",disabled:!0,act:()=>{}}]:this.formats.length?[...new Set(this.formats.map(t=>t.family))].flatMap(t=>[t,...this.formats.filter(i=>i.family===t).map(i=>({label:i.label,hint:i.suffix,...i.reason?{disabled:!0,reason:i.reason}:{},act:()=>{this.guard(()=>this.export(i))}}))]):[{label:"Asking what this model can be written as …",disabled:!0,act:()=>{}}]}async export(e){let{model:t,settings:i}=this.store.state,r=De(this.store.state).name,s=this.ends(),a=lt[i.quantity],o=a?`${a.name}${s?`, ${Ce(s[0])} to ${Ce(s[1])} ${el(a,t.unit)}`:""}`.trim():"none",l=e.takes?await S0(this.root(),e.label,t.unit,e.takes==="tolerance"?"":o):{tolerance:null};if(!l)return;this.store.set({message:{kind:"note",text:`Writing ${e.label} …`,lines:[]}});let c={model:t,patch:r,colour:a?i.quantity:"",low:s?.[0]??null,high:s?.[1]??null,...l},{name:h,notes:d}=await this.host.export(c,e);this.store.set({message:{kind:"note",text:`Exported ${h}`,lines:d}})}async start(e){await this.leave()&&this.store.open(e,null)}async load(e){await this.guard(async()=>{let{model:t,source:i}=await this.host.load(e);await this.leave()&&this.store.open(t,i)})}choose(){let e=T("input",{type:"file",accept:".toml,.json"});e.addEventListener("change",()=>{let t=e.files?.[0];t&&this.take(t)}),e.click()}async take(e){await this.guard(async()=>{if(e.size>s2)throw new Error(`${e.name}: expected at most 16 MB, found ${Math.round(e.size/2**20)} MB; is this a model?`);let t=await this.host.read(e.name,await e.text());await this.leave()&&this.store.open(t,null)})}receive(e){e.addEventListener("dragover",t=>{t.preventDefault(),e.classList.add("receiving")}),e.addEventListener("dragleave",()=>e.classList.remove("receiving")),e.addEventListener("drop",t=>{t.preventDefault(),e.classList.remove("receiving");let i=t.dataTransfer?.files[0];i&&this.take(i)})}async save(){let{source:e}=this.store.state;e?await this.write(e.name,e.tag):await this.saveAs()}async saveAs(){let e=this.host.kind==="live"?await _0(this.root(),"Save as",`${jn(this.store.state.model.name)}.toml`):this.store.state.model.name;e&&await this.write(e,"")}async picture(){let[e,t]=this.size(),i=await M0(this.root(),2*e,2*t);if(!i)return;(await this.draw(i)).toBlob(s=>s&&Jn(`${jn(this.store.state.model.name)}.png`,s),"image/png")}async write(e,t){let{model:i,opened:r}=this.store.state;try{let s=await this.host.save(e,i,t);this.store.written(r,i,s),this.store.set({message:{kind:"note",text:s?`Saved ${s.name}`:"Downloaded"}}),this.look()}catch(s){if(!(s instanceof Aa))return this.fail(s);let a=await Qn(this.root(),"The file is another one now",[T("p",{},s.message)],[["other","Save under another name"],["over","Overwrite it"],["cancel","Cancel"]]);a==="over"&&await this.write(e,null),a==="other"&&await this.saveAs()}}async leave(){let{model:e,saved:t}=this.store.state;return e===t?!0:await Qn(this.root(),"Leave this model?",[T("p",{},`The changes to “${e.name}” are not saved.`)],[["stay","Go on working"],["leave","Leave them"]])==="leave"}async guard(e){try{await e()}catch(t){this.fail(t)}}watch(){let e=()=>{this.connected()};window.addEventListener("focus",e),setInterval(()=>document.visibilityState==="visible"&&e(),a2)}async connected(){try{await this.host.list(),this.lost&&this.store.set({message:{kind:"note",text:"Connected to the studio's server again"}}),this.lost&&this.look(),this.lost=!1}catch(e){e instanceof zr&&!this.lost&&this.fail(e)}}fail(e){let{message:t}=e;if(!(e instanceof zr))return this.store.set({message:{kind:"error",text:t}});this.lost=!0;let{source:i}=this.store.state;this.store.set({message:{kind:"error",text:t,lines:[`To reconnect: ${e.stopped?`run “quintrig view ${i?.name??"MODEL"}” in a terminal, `:""}open the address that quintrig view printed in this browser, then try again here.`,"Or download the model, and open it in the new tab."],actions:[{label:"Download the model",act:()=>this.download()},{label:"Try again",act:()=>{this.again()}}]}})}async again(){this.store.set({message:null}),await this.guard(async()=>{await this.host.list()}),await this.connected()}download(){let{model:e,source:t}=this.store.state;Jn(t?.name.replace(/\.\w+$/,".toml")??`${jn(e.name)}.toml`,hn(e))}};var o2={1:"iso",2:"top",3:"side",4:"back",5:"front",6:"bottom"},l2={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]},c2="input:not([type=checkbox], [type=range], [type=radio]), select, textarea, [contenteditable]",h2="input[type=range], input[type=radio], [role=radio], .knob";function Q1(n,e){let{store:t,stage:i}=e,{settings:r}=t.state,s=n.composedPath()[0];if(!(s instanceof HTMLElement))return!1;if(n.ctrlKey||n.metaKey){let l=n.key.toLowerCase();if(l==="s")e.files.save();else if(l==="o")e.files.choose();else{if(qr(s))return!1;if(l==="z"&&n.shiftKey)t.redo();else if(l==="z")t.undo();else if(l==="y")t.redo();else return!1}return!0}if(n.altKey||s.matches(c2))return!1;let a=o2[n.key],o=l2[n.key];if(o&&s.matches(h2))return!1;if(a)e.view(a);else if(o)u2(o,n.shiftKey,e);else if(n.key==="+"||n.key==="=")i.orbit.zoom(.85);else if(n.key==="-")i.orbit.zoom(1/.85);else switch(n.key.length===1?n.key.toLowerCase():n.key){case"p":{let l=i.orbit.projection==="perspective"?"orthographic":"perspective";i.orbit.straight=!1,t.setting({projection:l});break}case"f":e.fit();break;case"n":t.setting({net:!r.net});break;case"i":t.setting({curves:!r.curves});break;case"w":t.setting({wireframe:!r.wireframe});break;case"z":t.setting({stripes:r.stripes==="zebra"?"none":"zebra"});break;case"c":{let l=["off","before","sets","kept"];t.set({compare:l[(l.indexOf(t.state.compare)+1)%l.length]});break}case"[":case"]":d2(t,n.key==="]"?1:-1);break;case"Escape":t.set({selected:null,message:null});break;case"?":e.help();break;case"Enter":{if(!s.matches("canvas"))return!1;let l=i.cells[0],c=i.pick(l.x+l.width/2,l.y+l.height/2,r,e.frame());c&&t.set({pins:[...t.state.pins,{patch:c.piece,u:Math.round(c.u*1e4)/1e4,v:Math.round(c.v*1e4)/1e4}]});break}default:return!1}return e.redraw(),!0}function u2([n,e],t,i){let{store:r,stage:s}=i;if(!r.state.selected){t?s.orbit.pan(-.03*n,.03*e):s.orbit.turn(-12*n,-12*e);return}let a=s.orbit.axes(),o=n?a.right:a.up,l=n||e,c=[o.x,o.y,o.z],h=c.map(Math.abs).indexOf(Math.max(...c.map(Math.abs))),d=r.state.settings.snapStep*(t?10:1)*l*Math.sign(c[h]);O1(r,[0,1,2].map(u=>u===h?d:0)),r.settle()}function d2(n,e){let t=De(n.state),i=bn(t).filter(s=>!s.mirrored);if(!i.length)return;let r=i.findIndex(s=>s.id===n.state.selected);n.set({selected:i[(r+e+i.length)%i.length].id})}function eb(n,e){let{planes:t,stride:i,count:r,nu:s,nv:a}=e.grid,o=0,l=-1;for(let p=0;p<r;p++){let f=Math.abs(t[Oe.mean*i+p])+t[Oe.halfDifference*i+p];f>o&&f<1/0&&e.covered[p]&&(o=f,l=p)}if(l<0||!(o*e.grid.size>1e-9))return null;let c=e.grid.u[Math.floor(l/a)],h=e.grid.v[l%a],d=[],u=p=>Math.min(1,Math.max(0,p));for(let p=.5/(s-1);p>1e-6;p*=.5){let f=[-1,0,1].map(y=>y*p),b=f.map(y=>u(c+y)),m=f.map(y=>u(h+y)),g=Zn(n,b,m,!1,["k1","k2","point"]);for(let y=0;y<9;y++){if(!_s(n,b[Math.floor(y/3)],m[y%3]))continue;let _=Math.max(Math.abs(g.k1[y]),Math.abs(g.k2[y]));(_>=o||y===4&&!d.length)&&(o=Math.max(o,_),c=b[Math.floor(y/3)],h=m[y%3],d=Array.from(g.point.subarray(3*y,3*y+3)))}}return{u:c,v:h,point:d,radius:1/o}}var p2=9,f2=20,m2=40,Hh=36,g2=361,b2=[1,.7,.5,.35,.25],Gh=class{constructor(e,t){this.stage=e;this.fail=t}stage;fail;cost=0;side=0;seams=[];coarse=75;drawable=1/0;tooth=0;get meshes(){return this.stage.cells.flatMap(e=>e.pieces.filter(t=>t.surface).map(t=>t.mesh))}evaluate(e,{settings:t,moving:i},r){this.side=this.points(t,i,e.length);let s=performance.now(),a=0;e.forEach(({model:l},c)=>{let h=this.stage.cells[c];h.resizePieces(l.patches.length),l.patches.forEach((d,u)=>a+=this.piece(h.pieces[u],d,t,r))});let o=performance.now()-s;return a&&this.pace(o,a,t.resolution),o}waited(e){e>m2?this.drawable=Math.max(Hh,.75*this.side):e<f2&&(this.drawable*=1.06)}decorate(e,t,i){let r=t.settings.combs==="off"?0:C1(this.meshes,t.settings,i),s=this.stage.cells.flatMap(a=>a.pieces.map(o=>o.curve)).filter(a=>a.length);this.tooth=t.settings.comb&&s.length?R1(s,t.settings.combScale,i):0,e.forEach(({editable:a},o)=>this.overlay(this.stage.cells[o],t,i,a,r)),this.sew(t,i),this.target(t,i)}target(e,t){let i=Vr(e,this.stage.cells.length),{beside:r}=e;this.stage.cells.forEach(({pieces:s},a)=>s.forEach((o,l)=>{let c=a===i&&l===0?r:null;o.beside===c&&(!c||o.besideFrame===t)||(o.beside=c,o.besideFrame=t,m0(o.overlays.target,c,t))}))}sew(e,t){let i=Vr(e,this.stage.cells.length),{unit:r}=e.model;this.stage.cells.forEach(({pieces:s},a)=>{let o=e.settings.seams&&s.length>1?_p(s.map(l=>l.surface),r):[];a===i&&(this.seams=o),s.forEach((l,c)=>{let h=o.filter(d=>d.first.patch===c);!h.length&&!l.seams.length||l.seams.length===h.length&&l.frame===l.seamsFrame&&h.every((d,u)=>d.points===l.seams[u].points&&d.order===l.seams[u].order)||(l.seams=h,l.seamsFrame=t,l.overlays.seams(h,t))})})}sharpest(){return this.stage.cells.flatMap(({pieces:e},t)=>{let r=e.map(s=>s.surface?eb(s.surface,s.mesh):null).filter(s=>s!==null).sort((s,a)=>s.radius-a.radius)[0];return r?[{cell:t,at:r}]:[]})}piece(e,t,i,r){let{side:s}=this,a=e.patch===t&&e.side===s&&e.frame===r;if(a&&e.quantity!==i.quantity&&e.mesh.paint(i.quantity),e.quantity=i.quantity,a)return 0;try{if(Qe(t))return this.curve(e,t,r);e.patch!==t&&(e.surface=Xt(t)),e.curve.length&&e.overlays.curve(e.curve=[],r,0)}catch(o){return this.fail(o.message),0}return e.patch=t,e.side=s,e.frame=r,e.lines=e.net="",e.mesh.update(e.surface,s,i.quantity,r),s*s}curve(e,t,i){return e.curve=St(t).sample(g2),Object.assign(e,{surface:null,patch:t,side:this.side,frame:i,lines:"",net:""}),e.mesh.clear(),e.overlays.edge([],i),0}overlay(e,t,i,r,s){e.pieces.forEach((a,o)=>{if(!a.surface&&!a.curve.length||!a.patch)return;let l=t.settings.net,c=l&&r&&o===t.patch,h=a.surface?y2(t.settings,s):`curve ${this.tooth}`;a.lines!==h&&!a.surface?a.overlays.curve(a.curve,i,this.tooth):a.lines!==h&&a.overlays.update(a.mesh,t.settings,i,s),a.lines=h;let d=`${l} ${c} ${c?t.selected:""} ${t.moving}`;if(a.net!==d){if(a.net=d,!a.surface)return a.overlays.net(l?Xm(a.patch):[],c?bn(a.patch):[],t.selected,i);a.overlays.net(l?Ym(a.patch,a.surface):[],c?Uu(a.patch,a.surface):[],t.selected,i),a.overlays.edge(t.moving?[]:v2(a.patch,a.surface),i)}})}points(e,t,i){if(t){let r=Math.min(this.coarse,this.drawable),s=b2.map(a=>Math.max(Hh,Math.round(a*e.resolution)));return Math.min(e.resolution,s.find(a=>a<=r)??Hh)}return lt[e.quantity]?.colour==="classes"&&i===1?2*e.resolution:e.resolution}pace(e,t,i){this.cost=e;let r=e/t,s=this.stage.cells.reduce((o,l)=>o+l.pieces.length,0),a=Math.sqrt(p2/r/Math.max(1,s));this.coarse=a>=i?i:Math.max(Hh,Math.min(i,Math.round(a)))}},y2=(n,e)=>JSON.stringify([e,n.directions,n.normals,n.combs,n.zeroK,n.zeroH,n.section,n.section&&[n.sectionAzimuth,n.sectionTilt,n.sectionAt]]),tb=new WeakMap;function v2(n,e){if(n.kind!=="developable")return[];let t=tb.get(e);if(t)return t;let i=Bo(e).map(({u:r,v:s})=>{let{point:a}=Zn(e,r,s,!0,["point"]);return r.map((o,l)=>Array.from(a.subarray(3*l,3*l+3)))});return tb.set(e,i),i}var Wh=class{constructor(e,t){this.stage=e;this.redraw=t}stage;redraw;down=new Map;busy=!1;touch(e,t){return this.down.set(e,t),this.busy||=this.down.size>1,this.busy}move(e,t){if(!this.busy||!this.down.has(e))return!1;let i=this.span();this.down.set(e,t);let r=this.span();return i&&r&&(this.stage.zoomAt(i.apart/r.apart,i.middle.x,i.middle.y),this.stage.pan(r.middle.x-i.middle.x,r.middle.y-i.middle.y),this.redraw()),!0}lift(e){let t=this.down.delete(e)&&this.busy;return this.down.size||(this.busy=!1),t}span(){let[e,t]=[...this.down.values()];return!e||!t?null:{apart:Math.max(8,Math.hypot(e.x-t.x,e.y-t.y)),middle:{x:.5*(e.x+t.x),y:.5*(e.y+t.y)}}}};var wo=11,x2=24;function nb(n,e){let{store:t,stage:i}=e,r=null,s=!1,a=new Wh(i,()=>e.redraw()),o=y=>{let _=n.getBoundingClientRect();return{x:y.clientX-_.left,y:y.clientY-_.top}},l=()=>bn(De(t.state)),c=(y,_,x)=>{let E=i.cellAt(y,_),w=t.state.settings.net&&l().find(A=>A.id===t.state.selected);if(!w||w.along||E!==Vr(t.state,i.cells.length))return null;let v=x0(vl(i,E,wt(e.frame(),w.position),h(w)),y,_,x);return v&&{handle:w,axes:v.axes}},h=y=>y.free.map((_,x)=>_&&!t.state.settings.locks[x]),d=(y,_,x)=>{let E=i.cellAt(y,_),{settings:w}=t.state;if(E<0||!w.section)return null;let v=is(w,e.frame()),A=L=>{let R=i.project(E,v[L]);return Math.hypot(R.x-y,R.y-_)};return A("tilt")<x?"tilt":A("move")<x?"move":null},u=(y,_,x)=>{let E=i.cellAt(y,_);if(E<0||!t.state.settings.net||!e.editable(E))return null;let w=null,v=x;for(let A of l()){let L=i.project(E,wt(e.frame(),A.position)),R=Math.hypot(L.x-y,L.y-_)-(A.id===t.state.selected?2:0);R<v&&(v=R,w=A)}return w};n.addEventListener("pointerdown",y=>{let{x:_,y:x}=o(y),E=y.pointerType==="touch",w=y.button!==0||y.shiftKey,v=E?x2:wo;if(M2(n,y.pointerId),n.focus({preventScroll:!0,focusVisible:!1}),y.preventDefault(),E&&a.touch(y.pointerId,{x:_,y:x}))return r=null,t.settle();let A=w?null:d(_,x,v),L=w||A?null:u(_,x,v),R=w||A||L?null:c(_,x,.6*v),N=L??R?.handle??null,z=i.cellAt(_,x);r={kind:w?"pan":A?"section":N?"move":"turn",cell:z,handle:N,grip:A,axes:R?.axes??null,settings:t.state.settings,from:z<0?null:i.ray(z,_,x),x:_,y:x,far:0},N&&t.set({selected:N.id,hover:null})}),n.addEventListener("pointermove",y=>{let{x:_,y:x}=o(y);if(a.move(y.pointerId,{x:_,y:x}))return;if(!r){if(n.classList.toggle("grab",u(_,x,wo)!==null||d(_,x,wo)!==null||c(_,x,.6*wo)!==null),s||y.pointerType==="touch")return;s=!0,requestAnimationFrame(()=>{s=!1,r||b(_,x)});return}let E=_-r.x,w=x-r.y;r.far+=Math.abs(E)+Math.abs(w),r.kind==="turn"?i.orbit.turn(E,w):r.kind==="pan"?i.pan(E,w):r.kind==="section"?m(r,_,x):r.far>2&&g(r,_,x,y.altKey),r.x=_,r.y=x,(r.kind==="turn"||r.kind==="pan")&&e.redraw()});let p=y=>{if(a.lift(y.pointerId)||!r)return;let _=r;if(r=null,t.settle(),y.type==="pointercancel"||_.far>4||_.kind!=="turn"||y.button!==0)return;let x=f(_.x,_.y);if(x&&t.state.joining)z1(t,`${t.state.model.patches[x.piece].name}:${S2(x.u,x.v)}`);else if(x){let E=x.piece===t.state.patch?t.state.selected:null;t.set({hover:null,patch:x.piece,selected:E,pins:[...t.state.pins,{patch:x.piece,u:$h(x.u),v:$h(x.v)}]})}else t.set({selected:null})};n.addEventListener("pointerup",p),n.addEventListener("pointercancel",p),n.addEventListener("pointerleave",()=>{!r&&t.state.hover&&t.set({hover:null})}),n.addEventListener("contextmenu",y=>y.preventDefault()),n.addEventListener("dblclick",()=>{e.fit()}),n.addEventListener("wheel",y=>{if(!e.ownsWheel()&&!y.ctrlKey)return;y.preventDefault();let{x:_,y:x}=o(y);i.zoomAt(Math.exp(Math.max(-60,Math.min(60,y.deltaY*(y.deltaMode?16:1)))*.0022),_,x),e.redraw()},{passive:!1});function f(y,_){return i.pickCurve(y,_,e.frame(),wo)??i.pick(y,_,t.state.settings,e.frame())}function b(y,_){let x=f(y,_);x?t.set({hover:{patch:x.piece,u:$h(x.u),v:$h(x.v),x:y,y:_,cell:x.cell}}):t.state.hover&&t.set({hover:null})}function m({grip:y,settings:_,from:x,cell:E},w,v){let A=e.frame(),L=is(_,A)[y],R=i.ray(E,w,v),N=y==="move"?nl(L,oa(_),x,R):zm(Math.hypot(...L),R,L);t.setting(S1(y,N,_,A))}function g({handle:y,from:_,cell:x,axes:E},w,v,A){if(!y||!_||!l().some(Y=>Y.id===y.id))return;let{settings:L}=t.state,R=e.frame(),N=wt(R,y.position),z=i.ray(x,w,v),{towards:H}=i.orbit.axes(),P=E?[0,1,2].map(Y=>E.includes(Y)):h(y),W=[H.x,H.y,H.z],B=y.along?{line:y.along}:Om(P,A?W:y.plane,W),O=p0(R,km(B,N,_,z)),Q=L.snap?L.snapStep:10**Math.floor(Math.log10(Ju(i,x,N)/R.scale)),G=y.along?_2(y.along,O,Q):Um(B,y.position,O,Q,L.snap);t.editPatch(rl(De(t.state),y,G),`drag ${y.id}`)}}function _2(n,e,t){let i=s=>s.reduce((a,o,l)=>a+o*n[l],0),r=(-i(e)-Math.round(-i(e)/t)*t)/i(n);return e.map((s,a)=>s+r*n[a])}function S2(n,e){let t={u0:n,u1:1-n,v0:e,v1:1-e};return Object.entries(t).sort((i,r)=>i[1]-r[1])[0][0]}var $h=n=>Math.round(n*1e4)/1e4,ib=()=>matchMedia("(prefers-reduced-motion: reduce)").matches;function M2(n,e){try{n.setPointerCapture(e)}catch{}}function rb(n,e){let t=De(n);if(e&&di(e).size===0)return"A single point: it has no size, no tangent plane and no curvature";let i=mn(t),r=Ei(t).find((l,c)=>!us(l,i[c])),s=t.unchecked_basis===!0?If($n(t))[0]:void 0;if(s)return`The functions of the basis ${s.name} do not sum to 1 (off by ${Ce(s.offSum.by,3)} ${s.offSum.where}): the ${Qe(t)?"curve":"surface"} moves with the origin`;if(r)return`Shape parameters outside ${ds(r).replaceAll("-","−")}: the convex-hull property is lost`;if(t.trim?.length)return"A trimmed face: meshes and CAD files take the whole of its surface";if(t.kind!=="developable"||n.moving||!e)return"";let a=Bo(e);return a.length?`The edge of regression (magenta) lies inside the strip for u = ${a.map(({u:l})=>`${l[0].toFixed(3)} to ${l.at(-1).toFixed(3)}`).join(", ")}: the surface is singular there`:""}var sb=160,as=class{constructor(e,t,i){this.container=e;this.host=t;let r={...a0(),...i.quantity?{quantity:i.quantity}:{}};this.store=new hl({model:i.model,saved:i.model,source:i.source,patch:0,selected:null,settings:r,compare:"off",kept:[],pins:[],hover:null,canUndo:!1,canRedo:!1,moving:!1,joining:null,aims:ll,beside:null,lights:[],message:null,opened:1});let{store:s}=this;this.stage=new Bh(this.canvas),this.painter=new Gh(this.stage,l=>this.status.warn(l)),this.files=new Vh(s,t,()=>this.root,l=>this.picture(l),()=>[this.centre.clientWidth,this.centre.clientHeight],()=>this.range&&[this.range.low,this.range.high]),this.bar=new Lh(s,this.files,()=>this.switchTheme(),()=>{Ku(this.root)},()=>this.root.classList.toggle("with-left"),t.kind!=="live"),this.model=new Ih(s),this.inspector=new _h(s),t instanceof vs&&(this.aims=new bl(s,t),this.inspector.element.append(this.aims.element),new ol(s,t)),this.probe=new _l(s,()=>this.plan()),this.status=new Nh(s),this.hud=new Sl(s,this.stage,{fit:()=>this.fit(),view:l=>this.view(l)}),this.centre.append(this.hud.element,this.legend.element),this.root=T("div",{class:`studio ${t.kind}`},this.bar.element,this.model.element,T("main",{class:"centre"},this.status.banner,this.centre,this.probe.element),this.inspector.element,this.status.element),e.append(this.root),this.drafts=new qh(t.place),nb(this.canvas,{store:s,stage:this.stage,frame:()=>this.frame,fit:()=>this.fit(),editable:l=>yl(s.state)[l]?.editable??!1,redraw:()=>this.plan(),ownsWheel:()=>t.kind==="live"||this.canvas.matches(":focus")}),(t.kind==="live"?document:this.root).addEventListener("keydown",l=>{!(l instanceof KeyboardEvent)||this.root.querySelector("dialog[open]")||Q1(l,{store:s,stage:this.stage,files:this.files,frame:()=>this.frame,fit:()=>this.fit(),view:c=>this.view(c),redraw:()=>this.plan(),help:()=>{Ku(this.root)}})&&l.preventDefault()}),this.files.receive(this.root),this.canvas.addEventListener("webglcontextrestored",()=>this.plan(!0)),new ResizeObserver(()=>{this.resize(),this.hurry()}).observe(this.centre),new ResizeObserver(()=>{this.stage.covered=Math.max(0,this.probe.element.offsetHeight-(this.root.querySelector(".centre").clientHeight-this.centre.clientHeight)),this.centre.style.setProperty("--covered",`${this.stage.covered}px`)}).observe(this.probe.element),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>this.plan(!0)),s.subscribe((l,c)=>this.changed(l,c,i)),this.stage.works||this.status.warn("This browser has no WebGL: you see still pictures. Everything else works."),this.resize(),this.plan(!0),t.kind!=="notebook"&&this.drafts.watch(s,this.status),t.kind==="live"&&this.files.watch()}container;host;store;root;stage;canvas=T("canvas",{class:"view",tabindex:0,role:"application","aria-label":"The surface. Arrow keys turn it; ? lists all keys."});centre=T("div",{class:"picture"},this.canvas);legend=new wh;hud;bar;inspector;model;aims=null;probe;status;files;drafts;frame=ml;range=null;sharp=[];painter;surfaces=0;planned=0;shownAt=0;settling=0;dark=!1;stale=!0;refit=!0;fitAfter=!1;fresh=!0;flat=!1;from=null;changed(e,t,i){e.model!==t.model&&(i.onModel?.(e.model),(e.model.patches.some((s,a)=>s.kind!==t.model.patches[a]?.kind)||e.model.patches.length!==t.model.patches.length)&&(this.refit=this.fresh=!0)),e.opened!==t.opened&&(this.refit=this.fresh=!0);let r=t.compare!==e.compare;e.hover!==t.hover&&e.model===t.model&&e.settings===t.settings&&this.hud.refresh(e,this.frame,this.sharp),(e.model!==t.model||e.settings!==t.settings||e.patch!==t.patch||r||e.kept!==t.kept||e.saved!==t.saved||e.moving!==t.moving||e.selected!==t.selected)&&this.plan(!0),e.joining!==t.joining&&this.plan(!0),(e.aims!==t.aims||e.beside!==t.beside||e.lights!==t.lights)&&this.plan(!0),(e.message!==t.message||e.pins!==t.pins)&&this.plan()}plan(e=!1){if(this.stale||=e,this.planned)return;let t=performance.now();this.planned=requestAnimationFrame(i=>{this.planned=0,this.store.state.moving&&this.painter.waited(performance.now()-t),this.show(i)})}hurry(){this.planned&&(cancelAnimationFrame(this.planned),this.planned=0,this.show(performance.now()))}show(e){let t=this.store.state.moving||e-this.shownAt<sb;this.shownAt=e,this.stage.economy(t),clearTimeout(this.settling),t&&this.stage.software&&(this.settling=window.setTimeout(()=>this.plan(),sb+40));let i=this.stage.orbit.step(e),r=performance.now();this.surfaces=0,this.stale&&(this.stale=!1,this.work());let s=performance.now();this.stage.draw(),this.hud.refresh(this.store.state,this.frame,this.sharp),this.root.dispatchEvent(new CustomEvent("drawn",{detail:{start:r,surfaces:this.surfaces,evaluated:s-r,drawn:performance.now()-s}})),i&&this.plan()}work(){let{state:e}=this.store,{settings:t}=e;this.dark=t.theme==="dark"||t.theme==="auto"&&this.darkAround(),this.root.dataset.theme=this.dark?"dark":"light";let i=yl(this.store.state);this.stage.cells.length!==i.length&&(this.fitAfter=!0),this.stage.layout(i.length,this.margin()),this.refit&&this.reframe(i),this.surfaces=this.painter.evaluate(i,e,this.frame);let{meshes:r}=this.painter,s=lt[t.quantity];this.range=s&&r.length&&s.colour!=="classes"?V1(r,s,t):null;let a=De(e);e.model.patches.every(Qe)?this.legend.element.hidden=!0:s?this.range?this.legend.real(s.key,this.range,e.model.unit,this.dark):this.legend.classes(s.key,r.map(l=>l.counts)):this.legend.plain(t.stripes!=="none"),this.stage.style(t,this.range,this.dark,this.frame,e.patch),this.painter.decorate(i,e,this.frame),this.fitAfter&&this.from?this.stage.view(this.from,this.frame,!0,this.margin()):this.fitAfter&&this.stage.fit(this.frame,!0,this.margin()),this.from=null,this.fitAfter=!1,this.sharp=t.minRadius&&!e.moving?this.painter.sharpest():[],this.bar.refresh(e),this.inspector.refresh(e,this.dark),this.aims?.refresh(e),this.model.refresh(e),this.model.body.refresh(e,this.painter.seams,this.dark),this.hud.labels(i.map(l=>l.label),e);let o=this.stage.cells[0]?.pieces[e.patch]?.surface??null;this.status.refresh(e,{side:this.painter.side,cost:this.painter.cost,singular:r.reduce((l,c)=>l+c.singular,0),points:r.reduce((l,c)=>l+c.places,0),sharp:this.sharp[0]?.at??null,surface:o,curve:Qe(a)?St(a):null,warning:rb(e,o)})}reframe(e){this.refit=!1;let t=y0(e);if(!t)return;this.frame=d0(t.low,t.high);let i=e.every(({model:r})=>r.patches.every(s=>Qe(s)&&St(s).flat));this.fresh&&(i||this.flat)&&(this.from=i?"top":"iso"),[this.fresh,this.flat]=[!1,i],this.inspector.sectionBox(t),this.store.setting({sectionAt:0,snapStep:10**Math.round(Math.log10(Math.max(2/this.frame.scale,1e-30)/100))}),this.fitAfter=!0}margin(){return this.legend.element.offsetWidth+10}view(e){this.stage.view(e,this.frame,ib(),this.margin()),this.plan()}fit(){this.refit=!0,this.plan(!0)}resize(){let{clientWidth:e,clientHeight:t}=this.centre;!e||!t||(this.stage.resize(e,t,Math.min(2,devicePixelRatio||1)),this.fitAfter||=!this.stage.orbit.moved,this.plan(!0))}darkAround(){return this.host.kind==="notebook"&&document.body.dataset.jpThemeLight?document.body.dataset.jpThemeLight==="false":matchMedia("(prefers-color-scheme: dark)").matches&&(this.host.kind==="live"||getComputedStyle(document.documentElement).colorScheme.includes("dark"))}switchTheme(){this.store.setting({theme:this.dark?"light":"dark"})}async picture(e){let t=getComputedStyle(this.root),i=e.background==="white"?"#ffffff":e.background==="theme"?t.getPropertyValue("--ground-flat").trim():null,r=await this.stage.picture(e.width,e.height,i),{state:s}=this.store;return U1(r,e,s,this.range,this.stage.cells,yl(this.store.state).map(a=>a.label),this.dark&&e.background==="theme")}locate(e){let{state:t}=this.store,i=t.model.patches[t.patch],r=is(t.settings,this.frame),s=bn(i).find(l=>l.id===e);if(!s&&e!=="move"&&e!=="tilt")return null;let a=this.stage.project(0,s?wt(this.frame,s.position):r[e]),o=this.canvas.getBoundingClientRect();return{x:o.left+a.x,y:o.top+a.y}}receive(e){this.store.open(e,null)}dispose(){cancelAnimationFrame(this.planned),clearTimeout(this.settling),this.stage.dispose(),this.container.replaceChildren()}};function Xh(n){let{model:e,saved:t}=n.state;if(e.patches.every(Fr))return;let i={...e,patches:e.patches.map(r=>Fr(r)?r:{...r})};n.set({model:i,saved:t===e?i:t})}var ab=`/* One sheet for the whole studio, inside a shadow root. Lengths in px; colours as variables, one set a theme. */
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
.body-tools .row { display: flex; flex-wrap: wrap; gap: 4px; }
.seams { list-style: none; margin: 0; padding: 0; max-height: 168px; overflow: auto; }
.seams li { display: grid; grid-template-columns: 40px 1fr; gap: 0 6px; padding: 3px 0; }
.seams small { grid-column: 2; color: var(--ink-3); font-variant-numeric: tabular-nums; }
.distance-key { height: 8px; border-radius: 4px; }
textarea[aria-label^="Demands"] {
  width: 100%; resize: vertical; padding: 6px 8px; border: 1px solid var(--line); border-radius: 6px; background: var(--field, var(--ground-flat)); color: var(--ink);
  font: 11.5px/1.45 ui-monospace, "DejaVu Sans Mono", monospace;
}
.lights { list-style: none; margin: 0; padding: 0; }
.lights li { display: grid; grid-template-columns: 16px 1fr; gap: 0 6px; padding: 3px 0; align-items: center; overflow-wrap: anywhere; }
.lights small { grid-column: 2; color: var(--ink-3); font-variant-numeric: tabular-nums; }
.light { width: 12px; height: 12px; border-radius: 50%; border: 1px solid var(--line); }
.lights .met .light { background: #1a8f3c; }
.lights .missed .light { background: #c2102e; border-radius: 2px; }
.lights .none .light { background: transparent; }
`;function Ao(n){let e=n.shadowRoot??n.attachShadow({mode:"open"}),t=new CSSStyleSheet;t.replaceSync(ab),e.adoptedStyleSheets=[t];let i=document.createElement("div");return i.className="place",e.replaceChildren(i),i}function Eo(n,e){return Object.assign(n,{studio:e}).studio}var A2=60,Dp=240,ob=4e3;function E2(n){let e=new Map;return(t,i)=>{e.size||setTimeout(()=>{for(let[r,s]of e)n.set(r,s());e.clear(),n.save_changes()},A2),e.set(t,i)}}function T2(n,e){let t=null;return e("msg:custom",i=>{let{built:r}=i??{};r&&t?.(r)}),i=>new Promise(r=>{t=r,n.send?.({build:i})})}function lb({model:n,el:e}){let t=E2(n),i=[],r=(g,y)=>{i.push([g,y]),n.on(g,y)},s=(g,y)=>r(`change:${g}`,y),a=n.get("brought")??{};Nr(a),_a(a.built??[]);let o=null,l=Ho(T2(n,r),()=>o&&Xh(o.store)),c=g=>JSON.stringify(cn(g)),h=()=>String(n.get("quantity")),d="",u=Eo(e,new as(Ao(e),new ys("notebook","notebook"),{model:vt(n.get("model")),source:null,quantity:h(),onModel(g){let y=c(g);y!==d&&(d=y,t("model",()=>JSON.parse(d)))}}));o=u;let{store:p}=u;d=c(p.state.model),s("model",()=>{let g=vt(n.get("model")),y=c(g);y!==d&&(d=y,p.edit(g))}),p.subscribe(({settings:{quantity:g}},y)=>{g!==y.settings.quantity&&g!==h()&&t("quantity",()=>p.state.settings.quantity)}),s("quantity",()=>{let g=h(),{settings:y}=p.state;g!==y.quantity&&(g==="none"||lt[g])&&p.setting({quantity:g,range:y.range==="fixed"?"robust":y.range})}),Object.assign(e.style,{resize:"vertical",overflow:"hidden",minHeight:`${Dp}px`,maxHeight:`${ob}px`});let f=()=>Math.min(ob,Math.max(Dp,Math.round(parseFloat(e.style.height)||Dp))),b=()=>{e.style.height=`${Number(n.get("height"))}px`};b(),s("height",b);let m=new ResizeObserver(()=>{f()!==n.get("height")&&t("height",f)});return m.observe(e),()=>{for(let[g,y]of i)n.off(g,y);l(),m.disconnect(),u.dispose()}}function C2(n,e){Nr(e.installed??{});let t=new ys("embedded",e.place??location.pathname);return Eo(n,new as(Ao(n),t,{model:vt(e.model),source:null,...e.quantity?{quantity:e.quantity}:{}}))}async function R2(n,e){Nr(JSON.parse(document.getElementById("quintrig-installed")?.textContent??"{}"));let t=new vs(e),i=null;Ho(h=>t.build(h),()=>i&&Xh(i.store)),location.search&&history.replaceState(null,"",location.pathname);let r=await fm(t),s=await fetch("api/model"),{model:a,source:o}=r??(s.ok?Iu(await s.json()):{model:ul[0],source:null}),l=i=new as(Ao(n),t,{model:a,source:o});if(!r&&!s.ok&&s.status!==404){let{error:h}=await s.json().catch(()=>({}));l.store.set({message:{kind:"error",text:h??`the server answered ${s.status}`}})}let c=()=>{let{model:h,saved:d}=l.store.state;document.title=`${h===d?"":"● "}${h.name} – quintrig`};return l.store.subscribe(c),pm(t,l.store),c(),Eo(n,l)}var mF={render:lb};if(typeof document<"u"){let n=document.querySelector("[data-quintrig]");n?.dataset.quintrig==="live"&&R2(n,n.dataset.place??"").catch(e=>n.textContent=String(e));for(let e of document.querySelectorAll("[data-quintrig=embedded]")){let t=document.getElementById(e.dataset.model??"")?.textContent??"null";C2(e,JSON.parse(t))}}export{yu as BUILDERS,em as FAMILIES,fn as Formulas,it as KINDS,Wn as LIBRARY,pi as QUANTITIES,lt as QUANTITY,Zn as analyse,Zo as besl,Xt as build,Ep as converted,St as curveOf,mF as default,C2 as embed,ko as entry,cu as family,vt as fromDict,bs as fromToml,va as functionsOf,Nr as install,R2 as live,ru as parse,Nu as pointType,Sw as seams,Lu as shapeClass,Ei as shapeParameters,cn as toDict};
