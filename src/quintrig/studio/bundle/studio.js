/* quintrig studio; sources sha256 d9be657f73120d24d3f69784c4dc089a3d3da3b7a746f2d399d504a479f749a5; the licences of the packages in it follow */
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
var Be={version:"0.1.0",schema:1,units:["um","mm","cm","m","km","in","ft"],shapeRange:[-4,1],shapeSets:{"4":[[1,1,1,1],[1,1,-3,-3],[1,-3,1,-3],[1,0,-2,-3]],"2":[[1,1],[0,-4],[-2,0],[-2,-4]]},quantities:[{key:"point",symbol:"S(u, v)",latex:"\\mathbf{S}(u,v)",name:"point",meaning:"position",source:"thesis eq. 3.1",power:1,parity:"even",colour:"vector",partner:"",components:3,classes:[]},{key:"normal",symbol:"n",latex:"\\mathbf{n}",name:"unit normal",meaning:"S_u × S_v, normalised",source:"do Carmo 1976, §2.5-3.3",power:0,parity:"odd",colour:"vector",partner:"",components:3,classes:[]},{key:"E",symbol:"E",latex:"E",name:"first form E",meaning:"S_u · S_u",source:"do Carmo 1976, §2.5-3.3",power:2,parity:"even",colour:"sequential",partner:"",components:1,classes:[]},{key:"F",symbol:"F",latex:"F",name:"first form F",meaning:"S_u · S_v",source:"do Carmo 1976, §2.5-3.3",power:2,parity:"even",colour:"diverging",partner:"",components:1,classes:[]},{key:"G",symbol:"G",latex:"G",name:"first form G",meaning:"S_v · S_v",source:"do Carmo 1976, §2.5-3.3",power:2,parity:"even",colour:"sequential",partner:"",components:1,classes:[]},{key:"L",symbol:"L",latex:"L",name:"second form L",meaning:"S_uu · n",source:"do Carmo 1976, §2.5-3.3",power:1,parity:"odd",colour:"diverging",partner:"",components:1,classes:[]},{key:"M",symbol:"M",latex:"M",name:"second form M",meaning:"S_uv · n",source:"do Carmo 1976, §2.5-3.3",power:1,parity:"odd",colour:"diverging",partner:"",components:1,classes:[]},{key:"N",symbol:"N",latex:"N",name:"second form N",meaning:"S_vv · n",source:"do Carmo 1976, §2.5-3.3",power:1,parity:"odd",colour:"diverging",partner:"",components:1,classes:[]},{key:"gaussian",symbol:"K",latex:"K",name:"Gaussian curvature",meaning:"dome or bowl (+), developable (0), saddle (-)",source:"do Carmo 1976, §2.5-3.3",power:-2,parity:"even",colour:"diverging",partner:"",components:1,classes:[]},{key:"mean",symbol:"H",latex:"H",name:"mean curvature",meaning:"bends towards the normal (+) or away from it (-)",source:"do Carmo 1976, §2.5-3.3",power:-1,parity:"odd",colour:"diverging",partner:"",components:1,classes:[]},{key:"k1",symbol:"κ1",latex:"\\kappa_1",name:"larger principal curvature",meaning:"the most that the surface bends towards the normal: H + R, R = (κ1 - κ2)/2",source:"do Carmo 1976, §2.5-3.3",power:-1,parity:"swap",colour:"diverging",partner:"k2",components:1,classes:[]},{key:"k2",symbol:"κ2",latex:"\\kappa_2",name:"smaller principal curvature",meaning:"the least that it bends towards the normal, or the most away from it: H - R, R = (κ1 - κ2)/2",source:"do Carmo 1976, §2.5-3.3",power:-1,parity:"swap",colour:"diverging",partner:"k1",components:1,classes:[]},{key:"direction1",symbol:"d1",latex:"\\mathbf{d}_1",name:"direction of κ1",meaning:"unit tangent, NaN at umbilics",source:"do Carmo 1976, §2.5-3.3",power:0,parity:"swap",colour:"vector",partner:"direction2",components:3,classes:[]},{key:"direction2",symbol:"d2",latex:"\\mathbf{d}_2",name:"direction of κ2",meaning:"unit tangent, NaN at umbilics",source:"do Carmo 1976, §2.5-3.3",power:0,parity:"swap",colour:"vector",partner:"direction1",components:3,classes:[]},{key:"shape_index",symbol:"S",latex:"S",name:"shape index",meaning:"cup -1, rut -1/2, saddle 0, ridge +1/2, cap +1 (n towards the viewer)",source:"Koenderink and van Doorn 1992",power:0,parity:"odd",colour:"diverging",partner:"",components:1,classes:[]},{key:"curvedness",symbol:"C",latex:"C",name:"curvedness",meaning:"how strongly it bends, whatever the shape",source:"Koenderink and van Doorn 1992",power:-1,parity:"even",colour:"sequential",partner:"",components:1,classes:[]},{key:"beta0",symbol:"β0",latex:"\\beta_0",name:"squared slope",meaning:"square of the slope, in the metric of the horizontal plane (the definition for a height field)",source:"Fujita and Ohsaki 2009; Iri et al. 2001",power:0,parity:"even",colour:"sequential",partner:"",components:1,classes:[]},{key:"beta1",symbol:"β1",latex:"\\beta_1",name:"Laplacian of the height",meaning:"bowl-like (+) or roof-like (-), in the metric of the horizontal plane (the definition for a height field)",source:"Fujita and Ohsaki 2009; Iri et al. 2001",power:-1,parity:"even",colour:"diverging",partner:"",components:1,classes:[]},{key:"beta2",symbol:"β2",latex:"\\beta_2",name:"Hessian determinant",meaning:"dome or bowl (+), developable (0), saddle (-), in the metric of the horizontal plane (the definition for a height field)",source:"Fujita and Ohsaki 2009; Iri et al. 2001",power:-2,parity:"even",colour:"diverging",partner:"",components:1,classes:[]},{key:"gamma1",symbol:"γ1",latex:"\\gamma_1",name:"bending along steepest descent",meaning:"slope eases (+) or steepens (-) downhill; weighted by slope², in the metric of the horizontal plane (the definition for a height field)",source:"Fujita and Ohsaki 2009; Iri et al. 2001",power:-1,parity:"even",colour:"diverging",partner:"",components:1,classes:[]},{key:"gamma2",symbol:"γ2",latex:"\\gamma_2",name:"twist of steepest descent",meaning:"0 on crest and trough lines; weighted by slope², in the metric of the horizontal plane (the definition for a height field)",source:"Fujita and Ohsaki 2009; Iri et al. 2001",power:-1,parity:"even",colour:"diverging",partner:"",components:1,classes:[]},{key:"gamma3",symbol:"γ3",latex:"\\gamma_3",name:"bending along the contour",meaning:"hollow (+) or spur (-): rises or falls to both sides along the contour; weighted by slope², in the metric of the horizontal plane (the definition for a height field)",source:"Fujita and Ohsaki 2009; Iri et al. 2001",power:-1,parity:"even",colour:"diverging",partner:"",components:1,classes:[]},{key:"beta0_surface",symbol:"β0ˢ",latex:"\\beta_0^{S}",name:"squared slope",meaning:"square of the slope, in the metric of the surface",source:"Fujita and Ohsaki 2009; Iri et al. 2001",power:0,parity:"even",colour:"sequential",partner:"",components:1,classes:[]},{key:"beta1_surface",symbol:"β1ˢ",latex:"\\beta_1^{S}",name:"Laplacian of the height",meaning:"bowl-like (+) or roof-like (-), in the metric of the surface",source:"Fujita and Ohsaki 2009; Iri et al. 2001",power:-1,parity:"even",colour:"diverging",partner:"",components:1,classes:[]},{key:"beta2_surface",symbol:"β2ˢ",latex:"\\beta_2^{S}",name:"Hessian determinant",meaning:"dome or bowl (+), developable (0), saddle (-), in the metric of the surface",source:"Fujita and Ohsaki 2009; Iri et al. 2001",power:-2,parity:"even",colour:"diverging",partner:"",components:1,classes:[]},{key:"gamma1_surface",symbol:"γ1ˢ",latex:"\\gamma_1^{S}",name:"bending along steepest descent",meaning:"slope eases (+) or steepens (-) downhill; weighted by slope², in the metric of the surface",source:"Fujita and Ohsaki 2009; Iri et al. 2001",power:-1,parity:"even",colour:"diverging",partner:"",components:1,classes:[]},{key:"gamma2_surface",symbol:"γ2ˢ",latex:"\\gamma_2^{S}",name:"twist of steepest descent",meaning:"0 on crest and trough lines; weighted by slope², in the metric of the surface",source:"Fujita and Ohsaki 2009; Iri et al. 2001",power:-1,parity:"even",colour:"diverging",partner:"",components:1,classes:[]},{key:"gamma3_surface",symbol:"γ3ˢ",latex:"\\gamma_3^{S}",name:"bending along the contour",meaning:"hollow (+) or spur (-): rises or falls to both sides along the contour; weighted by slope², in the metric of the surface",source:"Fujita and Ohsaki 2009; Iri et al. 2001",power:-1,parity:"even",colour:"diverging",partner:"",components:1,classes:[]},{key:"point_type",symbol:"point type",latex:"\\mathrm{type}",name:"point type",meaning:"signs of κ1 and κ2",source:"thesis table 3.1",power:0,parity:"even",colour:"classes",partner:"",components:1,classes:["undefined","elliptic","hyperbolic","parabolic","planar","umbilic"]},{key:"hk_type",symbol:"HK type",latex:"HK",name:"HK type",meaning:"signs of K and H, n towards the viewer",source:"Besl and Jain 1986; thesis table 3.2",power:0,parity:"mirror",colour:"classes",partner:"",components:1,classes:["undefined","peak","ridge","saddle ridge","impossible","flat","minimal","pit","valley","saddle valley"]},{key:"shape_class",symbol:"shape class",latex:"S\\,\\mathrm{class}",name:"shape class",meaning:"nine ranges of the shape index",source:"Koenderink and van Doorn 1992; thesis table 3.3",power:0,parity:"mirror",colour:"classes",partner:"",components:1,classes:["undefined","spherical cup","trough","rut","saddle rut","saddle","saddle ridge","ridge","dome","spherical cap","planar"]},{key:"invariant_type",symbol:"invariant type",latex:"\\beta\\,\\mathrm{type}",name:"invariant type",meaning:"signs of β1 and β2, seen from above",source:"Fujita and Ohsaki 2009; thesis table 3.4",power:0,parity:"even",colour:"classes",partner:"",components:1,classes:["undefined","dome","roof","saddle roof","impossible","level or tilted plane","balanced saddle","bowl","trough","saddle trough"]}],limits:{relative:1e-6,flat:1e-6,noise:1e-12,sameColour:1e-9,rounding:14210854715202004e-30,singular:9094947017729282e-28,stepsForSize:17,farOff:1e6,samePoint:7105427357601002e-30,vertical:1e-9,largest:1e50,largestPolygon:64},shapeBreaks:[.125,.375,.625,.875],families:["trigonometric","bernstein","bspline","circular","hyperbolic","powers","joined","chebyshev"],bases:["trigonometric","bernstein"],words:{point_type:["","lies on one side of the tangent plane, like an egg","crosses the tangent plane, like a saddle","bends in one direction only, like a cylinder","is flat to second order, like a plane","bends alike in all directions, like a sphere"],hk_type:["","bulges towards the normal in all directions","bulges towards the normal in one direction, straight in the other","saddle that mostly bulges towards the normal","cannot occur, since H² >= K","plane","saddle, equally bent both ways","hollow in all directions","hollow in one direction, straight in the other","saddle that is mostly hollow"],shape_class:["","hollow of a sphere, S = -1","hollow, more bent one way","gutter, S = -1/2","gutter with a sagging axis","symmetric saddle, S = 0","crest with a sagging axis","crest, S = +1/2","bulge, more bent one way","bulge of a sphere, S = +1","plane, κ1 = κ2 = 0"]},kinds:{tensor:{title:"Tensor-product surface",construction:!0,shapeNames:["alpha1","zeta1","alpha2","zeta2"],fields:{flip:{description:"Turn the normal to the other side",required:!1,default:!1,type:"boolean"},shape:{description:"Shape parameters of the basis, those in u, then those in v; for the quintic basis (α1, ζ1, α2, ζ2), or (α, ζ) for a developable, each in [-4, 1]",required:!1,default:[0,0,0,0],type:"shape"},basis:{description:"Basis, by name, or two for u and v, such as ['cubic', 'quintic']; 'bernstein' gives the classical surface on the same points",required:!1,default:"trigonometric",type:"basis"},bases:{description:"Bases of your own by name: [bases.NAME] with functions = [...] and parameters = { NAME = [low, high] }, or the name of a file of [basis.NAME] tables beside the model",required:!1,default:{},type:"raw"},unchecked_shape:{description:"Allow shape parameters outside their range, [-4, 1] for the quintic basis; the convex-hull property is then lost",required:!1,default:!1,type:"boolean"},unchecked_basis:{description:"Allow a basis whose functions do not sum to 1; the surface moves with the origin",required:!1,default:!1,type:"boolean"},points:{description:"6 x 6 control points [x, y, z]; points[i][j] with i along u, j along v",required:!0,type:"points",counts:[6,6],dimension:3}}},symmetric:{title:"Tensor-product surface that is its own mirror image",construction:!0,shapeNames:["alpha1","zeta1","alpha2","zeta2"],fields:{flip:{description:"Turn the normal to the other side",required:!1,default:!1,type:"boolean"},shape:{description:"Shape parameters of the basis, those in u, then those in v; for the quintic basis (α1, ζ1, α2, ζ2), or (α, ζ) for a developable, each in [-4, 1]",required:!1,default:[0,0,0,0],type:"shape"},basis:{description:"Basis, by name, or two for u and v, such as ['cubic', 'quintic']; 'bernstein' gives the classical surface on the same points",required:!1,default:"trigonometric",type:"basis"},bases:{description:"Bases of your own by name: [bases.NAME] with functions = [...] and parameters = { NAME = [low, high] }, or the name of a file of [basis.NAME] tables beside the model",required:!1,default:{},type:"raw"},unchecked_shape:{description:"Allow shape parameters outside their range, [-4, 1] for the quintic basis; the convex-hull property is then lost",required:!1,default:!1,type:"boolean"},unchecked_basis:{description:"Allow a basis whose functions do not sum to 1; the surface moves with the origin",required:!1,default:!1,type:"boolean"},points:{description:"3 x 6 control points, half of the net; the other three rows are mirrored",required:!0,type:"points",counts:[3,6],dimension:3},mirror:{description:"Mirror plane [a, b, c, d]: a x + b y + c z + d = 0",required:!0,type:"plane"}}},swept:{title:"Translational sweep of a section along a trajectory",construction:!0,shapeNames:["alpha1","zeta1","alpha2","zeta2"],fields:{flip:{description:"Turn the normal to the other side",required:!1,default:!1,type:"boolean"},shape:{description:"Shape parameters of the basis, those in u, then those in v; for the quintic basis (α1, ζ1, α2, ζ2), or (α, ζ) for a developable, each in [-4, 1]",required:!1,default:[0,0,0,0],type:"shape"},basis:{description:"Basis, by name, or two for u and v, such as ['cubic', 'quintic']; 'bernstein' gives the classical surface on the same points",required:!1,default:"trigonometric",type:"basis"},bases:{description:"Bases of your own by name: [bases.NAME] with functions = [...] and parameters = { NAME = [low, high] }, or the name of a file of [basis.NAME] tables beside the model",required:!1,default:{},type:"raw"},unchecked_shape:{description:"Allow shape parameters outside their range, [-4, 1] for the quintic basis; the convex-hull property is then lost",required:!1,default:!1,type:"boolean"},unchecked_basis:{description:"Allow a basis whose functions do not sum to 1; the surface moves with the origin",required:!1,default:!1,type:"boolean"},section:{description:"6 points [x, y, z] of the section curve, along u",required:!0,type:"points",counts:[6],dimension:3},trajectory:{description:"6 points [x, y, z] of the trajectory curve, along v",required:!0,type:"points",counts:[6],dimension:3}}},swung:{title:"Profile swung along a plane trajectory",construction:!0,shapeNames:["alpha1","zeta1","alpha2","zeta2"],fields:{flip:{description:"Turn the normal to the other side",required:!1,default:!1,type:"boolean"},shape:{description:"Shape parameters of the basis, those in u, then those in v; for the quintic basis (α1, ζ1, α2, ζ2), or (α, ζ) for a developable, each in [-4, 1]",required:!1,default:[0,0,0,0],type:"shape"},basis:{description:"Basis, by name, or two for u and v, such as ['cubic', 'quintic']; 'bernstein' gives the classical surface on the same points",required:!1,default:"trigonometric",type:"basis"},bases:{description:"Bases of your own by name: [bases.NAME] with functions = [...] and parameters = { NAME = [low, high] }, or the name of a file of [basis.NAME] tables beside the model",required:!1,default:{},type:"raw"},unchecked_shape:{description:"Allow shape parameters outside their range, [-4, 1] for the quintic basis; the convex-hull property is then lost",required:!1,default:!1,type:"boolean"},unchecked_basis:{description:"Allow a basis whose functions do not sum to 1; the surface moves with the origin",required:!1,default:!1,type:"boolean"},profile:{description:"6 pairs [r, z] of the profile curve, along u",required:!0,type:"points",counts:[6],dimension:2},trajectory:{description:"6 pairs [x, y] of the trajectory curve, along v",required:!0,type:"points",counts:[6],dimension:2},scale:{description:"Scale factor λ of the trajectory",required:!1,default:1,type:"number"}}},ruled:{title:"Straight lines between two curves",construction:!0,shapeNames:["alpha1","zeta1","alpha2","zeta2"],fields:{flip:{description:"Turn the normal to the other side",required:!1,default:!1,type:"boolean"},shape:{description:"Shape parameters of the basis, those in u, then those in v; for the quintic basis (α1, ζ1, α2, ζ2), or (α, ζ) for a developable, each in [-4, 1]",required:!1,default:[0,0,0,0],type:"shape"},basis:{description:"Basis, by name, or two for u and v, such as ['cubic', 'quintic']; 'bernstein' gives the classical surface on the same points",required:!1,default:"trigonometric",type:"basis"},bases:{description:"Bases of your own by name: [bases.NAME] with functions = [...] and parameters = { NAME = [low, high] }, or the name of a file of [basis.NAME] tables beside the model",required:!1,default:{},type:"raw"},unchecked_shape:{description:"Allow shape parameters outside their range, [-4, 1] for the quintic basis; the convex-hull property is then lost",required:!1,default:!1,type:"boolean"},unchecked_basis:{description:"Allow a basis whose functions do not sum to 1; the surface moves with the origin",required:!1,default:!1,type:"boolean"},first:{description:"6 points [x, y, z] of the curve at v = 0, with (α1, ζ1)",required:!0,type:"points",counts:[6],dimension:3},second:{description:"6 points [x, y, z] of the curve at v = 1, with (α2, ζ2)",required:!0,type:"points",counts:[6],dimension:3}}},developable:{title:"Strip enveloped by a family of planes",construction:!0,shapeNames:["alpha","zeta"],fields:{flip:{description:"Turn the normal to the other side",required:!1,default:!1,type:"boolean"},shape:{description:"Shape parameters of the basis, those in u, then those in v; for the quintic basis (α1, ζ1, α2, ζ2), or (α, ζ) for a developable, each in [-4, 1]",required:!1,default:[0,0],type:"shape"},basis:{description:"Basis, by name, or two for u and v, such as ['cubic', 'quintic']; 'bernstein' gives the classical surface on the same points",required:!1,default:"trigonometric",type:"basis"},bases:{description:"Bases of your own by name: [bases.NAME] with functions = [...] and parameters = { NAME = [low, high] }, or the name of a file of [basis.NAME] tables beside the model",required:!1,default:{},type:"raw"},unchecked_shape:{description:"Allow shape parameters outside their range, [-4, 1] for the quintic basis; the convex-hull property is then lost",required:!1,default:!1,type:"boolean"},unchecked_basis:{description:"Allow a basis whose functions do not sum to 1; the surface moves with the origin",required:!1,default:!1,type:"boolean"},planes:{description:"6 control planes [a, b, c, d]: a x + b y + c z + d = 0",required:!0,type:"points",counts:[6],dimension:4},bounds:{description:"2 planes [a, b, c, d] that cut the rulings at v = 0 and v = 1",required:!0,type:"points",counts:[2],dimension:4}}},nurbs:{title:"Rational B-spline surface (NURBS), such as a face read from a CAD file",construction:!1,shapeNames:[],fields:{flip:{description:"Turn the normal to the other side",required:!1,default:!1,type:"boolean"},degrees:{description:"Degrees (p, q) in u and v",required:!0,type:"raw"},knots:{description:"Full knot vectors in u and v: control points + degree + 1 numbers each; u, v in [0, 1] span them",required:!0,type:"raw"},points:{description:"Control points [x, y, z]; points[i][j] with i along u, j along v",required:!0,type:"raw"},weights:{description:"Weights of the control points, all 1 when left out",required:!1,default:null,type:"raw"},trim:{description:"Closed loops of [u, v] that bound the face on its surface",required:!1,default:[],type:"raw"}}},sphere:{title:"Sphere",construction:!1,shapeNames:[],fields:{flip:{description:"Turn the normal to the other side",required:!1,default:!1,type:"boolean"},radius:{description:"Radius",required:!1,default:1,type:"positive"}}},ellipsoid:{title:"Ellipsoid x²/a² + y²/b² + z²/c² = 1",construction:!1,shapeNames:[],fields:{flip:{description:"Turn the normal to the other side",required:!1,default:!1,type:"boolean"},a:{description:"Half axis along x",required:!1,default:3,type:"positive"},b:{description:"Half axis along y",required:!1,default:2,type:"positive"},c:{description:"Half axis along z",required:!1,default:1,type:"positive"}}},cylinder:{title:"Circular cylinder",construction:!1,shapeNames:[],fields:{flip:{description:"Turn the normal to the other side",required:!1,default:!1,type:"boolean"},radius:{description:"Radius",required:!1,default:1,type:"positive"},height:{description:"Height along z",required:!1,default:2,type:"positive"}}},cone:{title:"Cone with its apex up",construction:!1,shapeNames:[],fields:{flip:{description:"Turn the normal to the other side",required:!1,default:!1,type:"boolean"},radius:{description:"Radius of the base",required:!1,default:1,type:"positive"},height:{description:"Height along z",required:!1,default:2,type:"positive"}}},torus:{title:"Torus",construction:!1,shapeNames:[],fields:{flip:{description:"Turn the normal to the other side",required:!1,default:!1,type:"boolean"},major:{description:"Radius of the circle of centres",required:!1,default:3,type:"positive"},minor:{description:"Radius of the tube",required:!1,default:1,type:"positive"}}},catenoid:{title:"Catenoid, a minimal surface",construction:!1,shapeNames:[],fields:{flip:{description:"Turn the normal to the other side",required:!1,default:!1,type:"boolean"},waist:{description:"Radius of the waist",required:!1,default:1,type:"positive"},height:{description:"Height along z",required:!1,default:2,type:"positive"}}},helicoid:{title:"One turn of a helicoid, a minimal surface",construction:!1,shapeNames:[],fields:{flip:{description:"Turn the normal to the other side",required:!1,default:!1,type:"boolean"},radius:{description:"Half length of the rulings",required:!1,default:1,type:"positive"},pitch:{description:"Rise in one turn",required:!1,default:2,type:"number"}}},hyperbolic_paraboloid:{title:"z = x y",construction:!1,shapeNames:[],fields:{flip:{description:"Turn the normal to the other side",required:!1,default:!1,type:"boolean"},size:{description:"Half side of the square of parameters",required:!1,default:1,type:"positive"}}},monkey_saddle:{title:"z = x³ - 3 x y²",construction:!1,shapeNames:[],fields:{flip:{description:"Turn the normal to the other side",required:!1,default:!1,type:"boolean"},size:{description:"Half side of the square of parameters",required:!1,default:1,type:"positive"}}},enneper:{title:"Enneper's minimal surface",construction:!1,shapeNames:[],fields:{flip:{description:"Turn the normal to the other side",required:!1,default:!1,type:"boolean"},size:{description:"Half side of the square of parameters",required:!1,default:1,type:"positive"}}}},palette:{undefined:"#7d7d7d",front:"#9dc3e0",back:"#e8c793",series:["#0072b2","#d55e00","#009e73","#cc79a7","#e69f00","#56b4e9","#000000","#a6761d"],classes:{point_type:["#7d7d7d","#d9541e","#5fd99a","#f5a623","#f2f0ea","#7f1d0f"],hk_type:["#7d7d7d","#d9541e","#f5a623","#fbe26a","#000000","#f2f0ea","#5fd99a","#2166ac","#56a0d3","#a6d8f0"],shape_class:["#7d7d7d","#08306b","#2166ac","#56a0d3","#a6d8f0","#5fd99a","#fbe26a","#f5a623","#d9541e","#7f1d0f","#f2f0ea"],invariant_type:["#7d7d7d","#d9541e","#f5a623","#fbe26a","#000000","#f2f0ea","#5fd99a","#2166ac","#56a0d3","#a6d8f0"]},diverging:["#12406f","#194e80","#215c91","#286aa2","#2f78b3","#4387bc","#5796c5","#6ca5cd","#80b4d6","#92bfdc","#a5cae1","#b7d5e7","#cadfec","#d5e5ed","#e0eaee","#ebefee","#f6f3ee","#f7ebe2","#f7e3d6","#f8dbca","#f8d2be","#f4c4ac","#f1b59a","#eda789","#e99878","#e18369","#d96f5b","#d05a4c","#c7473e","#b53938","#a32b32","#921e2b","#821226"],sequential:["#f3f1d8","#ebeed0","#e3eac8","#dbe7c0","#d3e3b8","#cbe0b0","#c0dcac","#b4d6a9","#a7d1a5","#9acca2","#8ec79f","#82c29d","#76bb9c","#6bb59c","#60ae9b","#55a89b","#4aa29a","#459b98","#409497","#3a8d95","#358694","#307f92","#2f7890","#2e708d","#2d698b","#2d6288","#2c5b85","#2c5481","#2d4c7b","#2d4575","#2d3d6f","#2e3668","#2e2f63"]},presets:[{schema:1,name:"Car boot lid",unit:"mm",kind:"swept",shape:[1,1,0,0],section:[[0,0,30],[240,0,-14],[590,0,36],[606,0,-2],[505,0,-190],[560,0,-390]],trajectory:[[-150,-700,-90],[-55,-610,-24],[0,-260,0],[0,260,0],[-55,610,-24],[-150,700,-90]]},{schema:1,name:"Classical quintic swung vase",unit:"cm",kind:"swung",flip:!0,basis:"bernstein",profile:[[1,0],[3,1],[4,3],[3,5],[2,7],[2,8]],trajectory:[[1,0],[1,.6],[.7,1],[0,1.2],[-.6,1.1],[-1,.9]],scale:1.5},{schema:1,name:"Cylinder",unit:"mm",kind:"cylinder",radius:10,height:40},{schema:1,name:"Developable vault",unit:"m",kind:"developable",shape:[1,1],planes:[[-1,.22,1,-11],[-.8,.1,1,-9],[-.35,-.04,1,-6],[.35,-.1,1,-6],[.8,-.04,1,-9],[1,.04,1,-11]],bounds:[[0,1,0,0],[0,1,0,-10]]},{schema:1,name:"Saddle roof from a CSV net",unit:"m",kind:"tensor",shape:[0,0,0,0],points:[[[0,0,3],[0,2,4.92],[0,4,5.88],[0,6,5.88],[0,8,4.92],[0,10,3]],[[2,0,1.08],[2,2,3],[2,4,3.96],[2,6,3.96],[2,8,3],[2,10,1.08]],[[4,0,.12],[4,2,2.04],[4,4,3],[4,6,3],[4,8,2.04],[4,10,.12]],[[6,0,.12],[6,2,2.04],[6,4,3],[6,6,3],[6,8,2.04],[6,10,.12]],[[8,0,1.08],[8,2,3],[8,4,3.96],[8,6,3.96],[8,8,3],[8,10,1.08]],[[10,0,3],[10,2,4.92],[10,4,5.88],[10,6,5.88],[10,8,4.92],[10,10,3]]]},{schema:1,name:"Rear of a car",unit:"mm",patch:[{name:"rear window",kind:"swept",shape:[1,1,0,0],section:[[-720,0,470],[-600,0,452],[-430,0,390],[-300,0,290],[-150,0,160],[0,0,30]],trajectory:[[-150,-700,-90],[-55,-610,-24],[0,-260,0],[0,260,0],[-55,610,-24],[-150,700,-90]]},{name:"boot lid",kind:"swept",shape:[1,1,0,0],section:[[0,0,30],[240,0,-14],[590,0,36],[606,0,-2],[505,0,-190],[560,0,-390]],trajectory:[[-150,-700,-90],[-55,-610,-24],[0,-260,0],[0,260,0],[-55,610,-24],[-150,700,-90]]}]},{schema:1,name:"Ruled roof",unit:"m",kind:"ruled",shape:[1,1,1,1],first:[[0,0,0],[1,2,4],[3,3,5],[5,3,5],[7,2,4],[8,0,0]],second:[[0,10,2],[1,9,0],[3,8,-2],[5,8,3],[7,9,5],[8,10,1]]},{schema:1,name:"Sphere",unit:"mm",kind:"sphere",radius:20},{schema:1,name:"Swept canopy",unit:"m",kind:"swept",shape:[1,1,1,1],section:[[0,0,0],[2,0,1],[4,0,3],[6,0,3],[8,0,1],[10,0,0]],trajectory:[[0,0,0],[0,1,3],[0,3,5],[0,5,5],[0,7,3],[0,8,0]]},{schema:1,name:"Swung vase",unit:"cm",kind:"swung",flip:!0,shape:[1,1,1,1],profile:[[1,0],[3,1],[4,3],[3,5],[2,7],[2,8]],trajectory:[[1,0],[1,.6],[.7,1],[0,1.2],[-.6,1.1],[-1,.9]],scale:1.5},{schema:1,name:"Symmetric shell",unit:"m",kind:"symmetric",shape:[1,1,1,1],points:[[[0,0,0],[0,2,2],[0,4,3],[0,6,3],[0,8,2],[0,10,0]],[[2,0,1.5],[2,2,3],[2,4,4.5],[2,6,4.5],[2,8,3],[2,10,1.5]],[[4,0,3],[4,2,3.5],[4,4,5],[4,6,5],[4,8,3.5],[4,10,3]]],mirror:[1,0,0,-5]},{schema:1,name:"Thesis net of section 2.5.2",kind:"tensor",flip:!0,shape:[1,1,1,1],points:[[[0,0,0],[0,0,10],[4,0,10],[6,0,10],[10,0,10],[10,0,0]],[[0,2,0],[0,2,10],[4,2,10],[6,2,10],[10,2,10],[10,2,0]],[[0,4,0],[0,4,10],[4,4,10],[6,4,10],[10,4,10],[10,4,0]],[[0,6,0],[0,6,10],[4,6,10],[6,6,10],[10,6,10],[10,6,0]],[[0,8,0],[0,8,10],[4,8,10],[6,8,10],[10,8,10],[10,8,0]],[[0,10,0],[0,10,10],[4,10,10],[6,10,10],[10,10,10],[10,10,0]]]},{schema:1,name:"Wavy surface",unit:"cm",kind:"tensor",shape:[1,1,1,1],points:[[[0,0,0],[0,2,1],[0,4,2],[0,6,2],[0,8,1],[0,10,0]],[[2,0,1],[2,2,3],[2,4,5],[2,6,4],[2,8,2],[2,10,1]],[[4,0,2],[4,2,5],[4,4,8],[4,6,7],[4,8,4],[4,10,2]],[[6,0,2],[6,2,4],[6,4,7],[6,6,6],[6,8,3],[6,10,1]],[[8,0,1],[8,2,2],[8,4,4],[8,6,3],[8,8,1],[8,10,-1]],[[10,0,0],[10,2,1],[10,4,2],[10,6,1],[10,8,-1],[10,10,-3]]]}],starters:{tensor:{schema:1,name:"My tensor surface",unit:"mm",kind:"tensor",points:[[[0,0,0],[0,20,0],[0,40,0],[0,60,0],[0,80,0],[0,100,0]],[[20,0,0],[20,20,5],[20,40,15],[20,60,16],[20,80,7],[20,100,2]],[[40,0,0],[40,20,15],[40,40,40],[40,60,44],[40,80,19],[40,100,4]],[[60,0,0],[60,20,16],[60,40,44],[60,60,49],[60,80,21],[60,100,5]],[[80,0,0],[80,20,7],[80,40,19],[80,60,21],[80,80,9],[80,100,2]],[[100,0,0],[100,20,2],[100,40,4],[100,60,5],[100,80,2],[100,100,0]]],shape:[0,0,0,0]},symmetric:{schema:1,name:"My symmetric surface",unit:"mm",kind:"symmetric",points:[[[0,0,0],[0,20,8],[0,40,23],[0,60,25],[0,80,11],[0,100,2]],[[20,0,10],[20,20,18],[20,40,33],[20,60,35],[20,80,21],[20,100,12]],[[40,0,30],[40,20,38],[40,40,53],[40,60,55],[40,80,41],[40,100,32]]],mirror:[1,0,0,-50],shape:[0,0,0,0]},swept:{schema:1,name:"My swept surface",unit:"mm",kind:"swept",section:[[0,0,0],[20,0,10],[40,0,30],[60,0,30],[80,0,10],[100,0,0]],trajectory:[[0,0,0],[0,20,11],[0,40,30],[0,60,34],[0,80,14],[0,100,3]],shape:[0,0,0,0]},swung:{schema:1,name:"My swung surface",unit:"mm",kind:"swung",profile:[[20,0],[60,10],[80,40],[50,70],[30,100],[40,120]],trajectory:[[1,0],[1,.6],[.7,1],[-.7,1],[-1,.6],[-1,0]],shape:[0,0,0,0],flip:!0,scale:1},ruled:{schema:1,name:"My ruled surface",unit:"mm",kind:"ruled",first:[[0,0,0],[20,0,10],[40,0,30],[60,0,30],[80,0,10],[100,0,0]],second:[[0,100,0],[20,100,5],[40,100,13],[60,100,14],[80,100,6],[100,100,1]],shape:[0,0,0,0]},developable:{schema:1,name:"My developable surface",unit:"mm",kind:"developable",planes:[[-1,.2,1,-110],[-.8,.1,1,-90],[-.35,-.05,1,-60],[.35,-.05,1,-60],[.8,.1,1,-90],[1,.2,1,-110]],bounds:[[0,1,0,0],[0,1,0,-100]],shape:[0,0]},nurbs:{schema:1,name:"My nurbs",unit:"mm",kind:"nurbs",degrees:[2,2],knots:[[0,0,0,1,1,1],[0,0,0,1,1,1]],points:[[[0,0,0],[0,50,50],[0,100,0]],[[50,0,30],[50,50,80],[50,100,30]],[[100,0,0],[100,50,50],[100,100,0]]],weights:[[1,.7,1],[1,.7,1],[1,.7,1]]},sphere:{schema:1,name:"My sphere",unit:"mm",kind:"sphere",radius:20},ellipsoid:{schema:1,name:"My ellipsoid",unit:"mm",kind:"ellipsoid",a:30,b:20,c:10},cylinder:{schema:1,name:"My cylinder",unit:"mm",kind:"cylinder",radius:10,height:40},cone:{schema:1,name:"My cone",unit:"mm",kind:"cone",radius:10,height:20},torus:{schema:1,name:"My torus",unit:"mm",kind:"torus",major:30,minor:10},catenoid:{schema:1,name:"My catenoid",unit:"mm",kind:"catenoid",waist:10,height:20},helicoid:{schema:1,name:"My helicoid",unit:"mm",kind:"helicoid",radius:10,pitch:20},hyperbolic_paraboloid:{schema:1,name:"My hyperbolic paraboloid",unit:"mm",kind:"hyperbolic_paraboloid"},monkey_saddle:{schema:1,name:"My monkey saddle",unit:"mm",kind:"monkey_saddle"},enneper:{schema:1,name:"My enneper",unit:"mm",kind:"enneper"}}};var kt=()=>new Float64Array(3);function Bt(i,e,t){let n=i[0],r=i[1],s=i[2],o=e[0],a=e[1],l=e[2];return t[0]=n*o,t[1]=n*a+r*o,t[2]=n*l+r*a+s*o,t}function Ln(i,e,t,n,r,s){return s[0]=i*e[0]+t*n[0]+r,s[1]=i*e[1]+t*n[1],s[2]=i*e[2]+t*n[2],s}function Sd(i,e,t){let n=e[0],r=e[1],s=e[2],o=i[0]/n,a=(i[1]-o*r)/n,l=(i[2]-(o*s+a*r))/n;return t[0]=o,t[1]=a,t[2]=l,t}function Rs(i,e,t){t[0].fill(0),t[0][0]=1;for(let n=1;n<=e;n++)Bt(t[n-1],i,t[n])}var ui=i=>Array.from({length:i},kt);var Md=.5*Math.PI,di=class{constructor(e,t){this.start=e;this.end=t}start;end;size=2;derivatives(e,t,n){let r=this.end-this.start,s=Md*r;for(let o=0;o<t;o++){Jc(this.start+r*e[o]);let a=Ps,l=Is;n[2*o]=l,n[2*o+1]=a,n[2*(t+o)]=s*-a,n[2*(t+o)+1]=s*l,n[2*(2*t+o)]=s*s*-l,n[2*(2*t+o)+1]=s*s*-a}}},Fr=class{constructor(e,t){this.start=e;this.end=t}start;end;size=2;derivatives(e,t,n){let r=this.end-this.start;for(let s=0;s<t;s++){let o=this.start+r*e[s],a=Math.cosh(o),l=Math.sinh(o);for(let c=0,h=1;c<3;c++,h*=r)n[2*(c*t+s)]=h*(c===1?l:a),n[2*(c*t+s)+1]=h*(c===1?a:l)}}},on=class{constructor(e,t,n){this.start=e;this.end=t;this.degree=n;this.size=n+1}start;end;degree;size;derivatives(e,t,n){let r=kt(),s=ui(this.size),o=this.size;r[1]=this.end-this.start;for(let a=0;a<t;a++){r[0]=this.start+(this.end-this.start)*e[a],Rs(r,this.degree,s);for(let l=0;l<o;l++)Yc(s[l],n,t,a,o,l)}}},Nn=class{constructor(e){this.parts=e;this.size=e.reduce((t,n)=>t+n.size,0)}parts;size;scratch=new Float64Array(0);derivatives(e,t,n){let r=0;for(let s of this.parts){let o=s.size;this.scratch.length<3*t*o&&(this.scratch=new Float64Array(3*t*o)),s.derivatives(e,t,this.scratch);for(let a=0;a<3*t;a++)for(let l=0;l<o;l++)n[a*this.size+r+l]=this.scratch[a*o+l];r+=o}}};function Yc(i,e,t,n,r,s){e[n*r+s]=i[0],e[(t+n)*r+s]=i[1],e[(2*t+n)*r+s]=2*i[2]}var Ps=0,Is=1;function Jc(i){let e=Wg(i),t=Md*(i-e),n=Math.sin(t),r=Math.cos(t),s=(e%4+4)%4;Ps=(s===0?n:s===1?r:s===2?-n:-r)+0,Is=(s===0?r:s===1?-n:s===2?-r:n)+0}function Wg(i){let e=Math.floor(i);return i-e!==.5?Math.round(i):e%2===0?e:e+1}var Ni=kt(),Di=kt(),Fi=kt(),Ui=kt(),fi=kt(),Zc=kt(),Kc=kt(),$o=kt(),Ls=kt(),qn=kt(),Ur=ui(5),wd=ui(5);fi[0]=1;var Or=[!1,!1],Xn=class{constructor(e,t,n=Or){this.alpha=e;this.zeta=t;this.still=n}alpha;zeta;still;size=6;derivatives(e,t,n){let{alpha:r,zeta:s}=this;for(let o=0;o<t;o++){let[a,l]=this.still;if(this.slopes(e[o],!1,!1,Ur),a||l){this.slopes(e[o],a,l,wd);let v=(a?Ni[0]:1)*(l?Di[0]:1);for(let g=0;g<5;g++)Ur[g][1]=v*wd[g][1]}let c=Ni[0],h=Di[0],d=Fi[0],u=Ui[0],f=e[o]<.5,p=6*o;n[p]=d**4*(f?1-r*c:1-r+r*d),n[p+1]=c*d**3*(f?4+r-r*c:4+r*d),n[p+2]=d**2*u*(8*c+3*h+9),n[p+3]=u**2*d*(8*h+3*c+9),n[p+4]=h*u**3*(f?4+s*u:4+s-s*h),n[p+5]=u**4*(f?1-s+s*u:1-s*h);for(let v=0;v<2;v++){let g=6*((v+1)*t+o);n[g]=-Ur[0][v];for(let m=1;m<5;m++)n[g+m]=Ur[m-1][v]-Ur[m][v];n[g+5]=Ur[4][v]}}}slopes(e,t,n,r){Jc(e),Td(Ps,Is,Ni),Td(Is,-Ps,Di),Ln(-1,Ni,0,Ni,0,Fi),Ln(-1,Di,0,Di,0,Ui),Fi[0]=2*Math.sin(.25*Math.PI*(1-e))**2,Ui[0]=2*Math.sin(.25*Math.PI*e)**2;let s=e<.5,o=t?fi:Ni,a=n?fi:Di;Bt(o,a,$o),Bt(Fi,Fi,Zc),Bt(Ui,Ui,Kc),Ad(this.alpha,Ni,Fi,s,t,Ls),Bt(a,Bt(Bt(Zc,Fi,qn),Ls,qn),r[0]),Bt(Zc,$o,r[1]),Ln(12,r[1],0,fi,0,r[1]),Sd(fi,Ln(1,Ni,1,Di,1,qn),qn),Ln(4,qn,32,fi,0,qn),Bt(Bt(Fi,Ui,Ls),Bt($o,qn,qn),r[2]),Bt(Kc,$o,r[3]),Ln(12,r[3],0,fi,0,r[3]),Ad(this.zeta,Di,Ui,!s,n,Ls),Bt(o,Bt(Bt(Kc,Ui,qn),Ls,qn),r[4]);for(let l=0;l<5;l++)Ln(.5*Math.PI,r[l],0,fi,0,r[l])}},pi=class{constructor(e){this.degree=e;this.size=e+1}degree;size;derivatives(e,t,n){let r=kt(),s=kt(),o=Xg(this.degree);r[1]=1,s[1]=-1;for(let a=0;a<t;a++)r[0]=e[a],s[0]=1-e[a],o(r,s,n,t,a)}},Yo={trigonometric:(i,e,t,n)=>new Xn(e,t,n),bernstein:i=>new pi(i-1)};function Ns(i,e,t,n,r=Or){return Yo[i](e,t,n,r)}function Ds(i,e,t){let n=(r,s)=>t[r].every((o,a)=>o.every((l,c)=>l===t[s][a][c]));return[i===-4||n(0,1),e===-4||n(t.length-1,t.length-2)]}function qg(i,e){let t=1;for(let n=1;n<=e;n++)t=t*(i-e+n)/n;return t}function Ad(i,e,t,n,r,s){if(r)return void Ln(-5*i,fi,0,e,0,s);Ln(-5*i,e,0,e,0,s),s[0]=n?4+i-5*i*e[0]:4-4*i+5*i*t[0]}function Td(i,e,t){let n=.5*Math.PI;t[0]=i,t[1]=n*e,t[2]=n*n*-i/2}function Xg(i){let e=ui(i+1),t=ui(i+1),n=kt(),r=e.map((s,o)=>qg(i,o));return(s,o,a,l,c)=>{Rs(s,i,e),Rs(o,i,t);for(let h=0;h<=i;h++)Bt(e[h],t[i-h],n),Ln(r[h],n,0,n,0,n),Yc(n,a,l,c,i+1,h)}}function $n(i,e=3){let t=new Array(e).fill(1/0),n=new Array(e).fill(-1/0);for(let a of i)if(a.every(Number.isFinite))for(let l=0;l<e;l++)t[l]=Math.min(t[l],a[l]),n[l]=Math.max(n[l],a[l]);let r=Math.max(...t.map((a,l)=>n[l]-a));if(!Number.isFinite(r))return t.map(()=>0);let s=t.map((a,l)=>.5*a+.5*n[l]),o=2**(Math.floor(Math.log2(r))+3);return r>0&&o>0&&Number.isFinite(o)?s.map(a=>Math.round(a/o)*o+0):s}var mi=(i,e)=>i.map((t,n)=>t-e[n]);function kr(i,e){if(e.every(r=>r===0))return[...i];let t=i[3],n=0;for(let r=0;r<3;r++){let s=i[r]*e[r],[o,a]=Ed(i[r]),[l,c]=Ed(e[r]),h=a*c-(s-o*l-a*l-o*c),d=t+s,u=d-t;n+=t-(d-u)+(s-u)+h,t=d}return[i[0],i[1],i[2],t+n]}function Ed(i){let e=134217729*i,t=e-(e-i);return[t,i-t]}var tn=class{constructor(e,t){this.points=e;this.functions=t;this.size=e.m,this.dimension=e.dimension}points;functions;size;dimension;scratch=new Float64Array(0);derivatives(e,t,n){let r=this.functions.size,s=this.size*this.dimension,o=this.points.values;this.scratch.length<3*t*r&&(this.scratch=new Float64Array(3*t*r));let a=this.scratch;this.functions.derivatives(e,t,a);for(let l=0;l<3*t;l++)for(let c=0;c<s;c++){let h=0;for(let d=0;d<r;d++)h+=a[l*r+d]*o[d*s+c];n[l*s+c]=h}}},Br=i=>i.flip?"against":"along",{stepsForSize:Sn,farOff:$g,samePoint:Yg}=Be.limits,Cd=Float64Array.from({length:Sn},(i,e)=>e/(Sn-1)),Yn=new Float64Array(3*Sn*Sn),Fs=new Float64Array(Sn*Sn);function zr(i){let{rows:e,blend:t,origin:n=[0,0,0]}=i,r=e.size,s=e.dimension,o=new Float64Array(3*Sn*r*s),a=new Float64Array(3*Sn*r);e.derivatives(Cd,Sn,o),t.derivatives(Cd,Sn,a);let l=0,c=[0,0,0,1];for(let x=0;x<Sn;x++)for(let w=0;w<Sn;w++){for(let T=0;T<s;T++){c[T]=0;for(let A=0;A<r;A++)c[T]+=o[(x*r+A)*s+T]*a[w*r+A]}let _=s===4?c[3]:1;for(let T=0;T<3;T++)Yn[3*l+T]=c[T]/_;Number.isFinite(Yn[3*l]+Yn[3*l+1]+Yn[3*l+2])&&l++}let h=[1/0,1/0,1/0],d=[-1/0,-1/0,-1/0],[u,f,p]=[0,1,2].map(x=>{for(let w=0;w<l;w++)Fs[w]=Yn[3*w+x];return Rd(Fs.subarray(0,l))});for(let x=0;x<l;x++)Fs[x]=Math.max(Math.abs(Yn[3*x]-u),Math.abs(Yn[3*x+1]-f),Math.abs(Yn[3*x+2]-p));let v=$g*Rd(Fs.slice(0,l))||1/0;for(let x=0;x<l;x++)if(!(Fs[x]>v))for(let w=0;w<3;w++)h[w]=Math.min(h[w],Yn[3*x+w]),d[w]=Math.max(d[w],Yn[3*x+w]);let g=l?Math.sqrt(h.reduce((x,w,_)=>x+(d[_]-w)**2,0)):0;for(let x=0;x<3;x++)h[x]+=n[x],d[x]+=n[x];let m=Math.max(...h.map(Math.abs),...d.map(Math.abs));return{low:h,high:d,size:g>Yg*m?g:0}}function Rd(i){i.sort();let e=i.length>>1;return i.length%2?i[e]:.5*(i[e-1]+i[e])}function Ht(i){let e=i.length,t=i[0].length,n=i[0][0].length,r=new Float64Array(e*t*n);return i.forEach((s,o)=>s.forEach((a,l)=>r.set(a,(o*t+l)*n))),{values:r,n:e,m:t,dimension:n}}function jc(i,e,t){let n=$n(i.flat());return Qc(i.map(r=>r.map(s=>mi(s,n))),n,e,t,Ht(i))}function Qc(i,e,t,n,r){let s=Ht(i),[o,a,l,c]=t,h=i[0].map((f,p)=>i.map(v=>v[p])),d=Ns(n.basis,s.n,o,a,Ds(o,a,i)),u=Ns(n.basis,s.m,l,c,Ds(l,c,h));return r??=Ht(i.map(f=>f.map(p=>p.map((v,g)=>v+e[g])))),{rows:new tn(s,d),blend:u,flip:n.flip,net:r,origin:e}}function Pd(i,e,t,n){let r=$n(i.flat()),s=kr(e,r),o=i.map(l=>l.map(c=>mi(c,r))),a=o.map(l=>l.map(c=>Vr(c,s))).reverse();return Qc([...o,...a],r,t,n)}function Id(i,e,t,n){let[r,s]=[$n(i),$n(e)],o=i.map(h=>mi(h,r)),a=e.map(h=>mi(h,s)),l=(h,d)=>h.map(u=>d.map(f=>u.map((p,v)=>p+f[v]))),c=r.map((h,d)=>h+s[d]);return Qc(l(o,a),c,t,n,Ht(l(i,e)))}function Ld(i,e,t,n,r){let s=i.map(([o,a])=>e.map(([l,c])=>[n*o*l,n*o*c,a]));return jc(s,t,r)}function Nd(i,e,t,n){let r=[0,0,0],s=$n([...i,...e]),o=Ht([...i.map(g=>[mi(g,s),r]),...e.map(g=>[r,mi(g,s)])]),[a,l,c,h]=t,d=Ds(a,l,i.map(g=>[g])),u=Ds(c,h,e.map(g=>[g])),f=[d[0]&&u[0],d[1]&&u[1]],p=new Nn([Ns(n.basis,i.length,a,l,f),Ns(n.basis,e.length,c,h,f)]),v=i.length===e.length?Ht(i.map((g,m)=>[g,e[m]])):null;return{rows:new tn(o,p),blend:new pi(1),flip:n.flip,net:v,origin:s}}function Vr(i,e){let[t,n,r,s]=e,o=(i[0]*t+i[1]*n+i[2]*r+s)/(t*t+n*n+r*r);return[i[0]-2*o*t,i[1]-2*o*n,i[2]-2*o*r]}var{noise:Dd,rounding:Jg}=Be.limits;function Fd(i,e,t,n){let r=new Xn(t[0],t[1]),s=Zg(new Hr(i,e,r)),o=l=>kr(l,s),a=new Hr(i.map(o),e.map(o),r);if(!a.meets())throw new Error("planes: the control planes envelop no strip that the bounding planes cut (they are equal, parallel, or all contain one line that a bounding plane contains too); change the planes or the bounds");return{rows:a,blend:new pi(1),flip:n,net:null,origin:s}}function Zg(i){let t=Float64Array.from({length:17},(l,c)=>c/16),n=new Float64Array(306);i.derivatives(t,17,n);let s=Array.from({length:34},(l,c)=>Array.from(n.subarray(3*c,3*c+3))).filter(l=>l.every(Number.isFinite)),o=[0,1,2].map(l=>s.map(c=>c[l]).sort((c,h)=>c-h)),a=l=>o.map(c=>c[Math.floor(l*(c.length-1))]);return s.length?$n([a(.25),a(.75)]):[0,0,0]}var Hr=class{constructor(e,t,n){this.planes=e;this.bounds=t;this.functions=n;this.edges=e.slice(1).map((r,s)=>r.map((o,a)=>o-e[s][a])),this.start=n.alpha===-4||this.edges[0].every(r=>r===0),this.end=n.zeta===-4||this.edges[4].every(r=>r===0)}planes;bounds;functions;size=2;dimension=3;edges;start;end;scratch=new Float64Array(0);hodograph=ui(5);derivatives(e,t,n){this.scratch.length<18*t&&(this.scratch=new Float64Array(18*t)),this.functions.derivatives(e,t,this.scratch);for(let r=0;r<t;r++){let{plane:s,slope:o}=this.dual(e[r],t,r);this.bounds.forEach((a,l)=>{Kg(s,o,a).forEach((c,h)=>{for(let d=0;d<3;d++)n[((h*t+r)*2+l)*3+d]=(h===2?2:1)*c[d]})})}}meets(){let t=Float64Array.from({length:33},(s,o)=>o/32);this.scratch=new Float64Array(594),this.functions.derivatives(t,33,this.scratch);let n=this.bounds.map(()=>0),r=[0,0];for(let s=0;s<33;s++){let{plane:o,slope:a}=this.dual(t[s],33,s),[l,c]=[o[0].slice(0,3),a[0].slice(0,3)];Number.isNaN(c[0])||(r[0]=Math.max(r[0],Math.hypot(...l)),r[1]=Math.max(r[1],Math.hypot(...c)),this.bounds.forEach((h,d)=>n[d]=Math.max(n[d],Math.abs(Mn(Us(l,c),h)))))}return n.every((s,o)=>s>Dd*r[0]*r[1]*Math.hypot(...this.bounds[o].slice(0,3)))}dual(e,t,n){this.functions.slopes(e,this.start,this.end,this.hodograph);let r=[0,1,2],s=[0,1,2,3],o=r.map(c=>s.map(h=>{let d=0;for(let u=0;u<6;u++)d+=this.scratch[6*(c*t+n)+u]*this.planes[u][h];return c===2?d/2:d})),a=r.map(c=>s.map(h=>this.hodograph.reduce((d,u,f)=>d+u[c]*this.edges[f][h],0))),l=s.map(c=>this.hodograph.reduce((h,d,u)=>h+Math.abs(d[0]*this.edges[u][c]),0));return s.every(c=>Math.abs(a[0][c])<=Jg*l[c])&&a[0].fill(NaN),{plane:o,slope:a}}};function Kg(i,e,t){let n=i.map(g=>Us(t,g)),[r,s,o]=e,a=i[0],l=Mn(r,n[0]),c=Mn(r,n[1])+Mn(s,n[0]),h=Us(r,t),d=Us(a,r),u=[0,1,2].map(g=>-(a[3]*h[g]+r[3]*n[0][g]+t[3]*d[g])/l),f=(-s[3]-Mn(s,u))/l,p=n[0].map(g=>f*g),v=(-2*o[3]-Mn(s,p)-2*Mn(o,u)-f*c)/l;return[u,p,n[0].map((g,m)=>.5*(f*n[1][m]+v*g))]}function Jo(i,e=257){let t=Float64Array.from({length:e},(h,d)=>d/(e-1)),n=new Float64Array(3*e*6);i.rows.derivatives(t,e,n);let r=Array.from(t,(h,d)=>jg(n,e,d)),s=r.map(([h,d])=>Math.max(Math.abs(h),Math.abs(d))),o=s.filter(h=>!Number.isNaN(h)).sort((h,d)=>h-d),a=Dd*(o[o.length>>1]??0),l=[],c=!1;return r.forEach(([h,d],u)=>{let f=h*d<=0&&s[u]>a;f&&!c&&l.push({u:[],v:[]}),f&&(l.at(-1).u.push(t[u]),l.at(-1).v.push(h/(h-d))),c=f}),l}function jg(i,e,t){let n=(c,h,d)=>i[((c*e+t)*2+h)*3+d],r=[0,1,2].map(c=>n(0,1,c)-n(0,0,c)),[s,o]=[0,1].map(c=>Us([n(1,c,0),n(1,c,1),n(1,c,2)],r)),a=Mn(s,s)>Mn(o,o)?s:o,l=Math.sqrt(Mn(a,a))||1;return[Mn(s,a)/l,Mn(o,a)/l]}var Mn=(i,e)=>i[0]*e[0]+i[1]*e[1]+i[2]*e[2],Us=(i,e)=>[i[1]*e[2]-i[2]*e[1],i[2]*e[0]-i[0]*e[2],i[0]*e[1]-i[1]*e[0]];var tt=class extends Error{},Ud={...Be.kinds},Od={...Be.starters},At=Ud,eh=Od;function lr(i){for(let[e,t]of Object.entries(i.kinds??{}))Ud[e]??=t;for(let[e,t]of Object.entries(i.starters??{}))Od[e]??=t}var Jn=i=>i===void 0||typeof i=="string"&&Object.hasOwn(Yo,i);function an(i){return Jn($e(i,"basis"))?$e(i,"shape")??[]:[]}function $e(i,e){return i[e]??At[i.kind]?.fields[e]?.default}var cr=class{constructor(e,t){this.degree=t;this.size=e.length-t-1;let n=e[t],r=e[this.size];if(!(r>n))throw new Error(`knots: expected them to rise from ${n} over the domain, found them to end at ${r}`);this.knots=e.map(s=>s===r?1:(s-n)/(r-n))}degree;size;knots;derivatives(e,t,n){let{knots:r,degree:s,size:o}=this,a=Array.from({length:s+1},()=>new Float64Array(r.length-1));for(let l=0;l<t;l++){let c=s;for(;c<o-1&&r[c+1]<=e[l];)c++;a[0].fill(0),a[0][c]=1;for(let h=1;h<=s;h++){let d=a[h-1],u=f=>(e[l]-r[f])*kd(r[f+h]-r[f])*d[f];for(let f=0;f<r.length-1-h;f++)a[h][f]=u(f)+d[f+1]-u(f+1)}for(let h=0;h<3;h++){let d=h<=s?a[s-h]:new Float64Array(r.length-1);for(let u=s-h+1;h<=s&&u<=s;u++){let f=d,p=v=>u*kd(r[v+u]-r[v])*f[v];d=Float64Array.from({length:r.length-1-u},(v,g)=>p(g)-p(g+1))}for(let u=0;u<o;u++)n[(h*t+l)*o+u]=d[u]}}}},kd=i=>i>0?1/i:0;function Bd(i,e,t,n,r,s=[]){let o=Ht(i),a=new cr(n[0],t[0]),l=new cr(n[1],t[1]);if(a.size!==o.n||l.size!==o.m)throw new Error(`knots: expected ${o.n+t[0]+1} and ${o.m+t[1]+1}, found ${n[0].length} and ${n[1].length}`);let c=$n(i.flat()),h=i.map(f=>f.map(p=>mi(p,c))),d=e?.[0]?.[0];if(!e||e.every(f=>f.every(p=>p===d)))return{rows:new tn(Ht(h),a),blend:l,flip:r,net:o,origin:c,trim:s};let u=h.map((f,p)=>f.map((v,g)=>[...v.map(m=>m*e[p][g]),e[p][g]]));return{rows:new tn(Ht(u),a),blend:l,flip:r,net:o,origin:c,trim:s}}var zd=new on(0,1,0),Vd=(i,e)=>th(i,i,i,e);function th(i,e,t,n){return Os(new di(-1,1),[[i,e,0],[0,0,t]],!n)}function Hd(i,e,t){return Os(new on(0,1,1),[[i,i,0],[0,0,e]],!t)}function Gd(i,e,t){return Os(new on(0,1,1),[[i,i,0],[-i,-i,e]],!t)}function Wd(i,e,t){return Os(new Nn([new di(0,4),zd]),[[e,e,0],[0,0,e],[i,i,0]],!t)}function qd(i,e,t){let n=.5*e/i,r=new Nn([new Fr(-n,n),new on(-n,n,1)]);return Os(r,[[i,i,0],[0,0,0],[0,0,0],[0,0,i]],!t)}function Xd(i,e,t){let n=Ht([[[0,0,0],[0,0,0],[0,0,0],[0,0,e/(2*Math.PI)]],[[1,0,0],[0,1,0],[0,0,0],[0,0,0]]]),r=new Nn([new di(0,4),new on(0,2*Math.PI,1)]);return{rows:new tn(n,new on(-i,i,1)),blend:r,flip:t,net:null}}var $d=(i,e)=>nh(i,[[1,0,1,0,0],[0,1,0,1,0],[1,1,0,0,1]],e),Yd=(i,e)=>nh(i,[[1,0,1,0,0],[0,1,0,1,0],[3,0,0,0,1],[1,2,0,0,-3]],e);function Jd(i,e){let t=.3333333333333333,n=[[1,0,1,0,0],[3,0,-t,0,0],[1,2,1,0,0],[0,1,0,1,0],[0,3,0,-t,0],[2,1,0,1,0],[2,0,0,0,1],[0,2,0,0,-1]];return nh(i,n,e)}function Os(i,e,t){let n=Ht(e.map(([r,s,o])=>[[r,0,0],[0,s,0],[0,0,o]]));return{rows:new tn(n,i),blend:new Nn([new di(0,4),zd]),flip:t,net:null}}function nh(i,e,t){let n=Math.max(...e.map(o=>o[0]))+1,r=Math.max(...e.map(o=>o[1]))+1,s={values:new Float64Array(n*r*3),n,m:r,dimension:3};for(let[o,a,...l]of e)s.values.set(l,(o*r+a)*3);return{rows:new tn(s,new on(-i,i,n-1)),blend:new on(-i,i,r-1),flip:t,net:null}}var ih=class{constructor(e){this.patch=e;this.flip=this.get("flip"),this.bezier={basis:this.get("basis"),flip:this.flip},this.shape=this.get("shape")}patch;flip;bezier;shape;get(e){return $e(this.patch,e)}size(e){return this.get(e)}curve(e){return this.get(e)}net(e){return this.get(e)}},rh={tensor:i=>jc(i.net("points"),i.shape,i.bezier),symmetric:i=>Pd(i.net("points"),i.get("mirror"),i.shape,i.bezier),swept:i=>Id(i.curve("section"),i.curve("trajectory"),i.shape,i.bezier),swung:i=>Ld(i.curve("profile"),i.curve("trajectory"),i.shape,i.size("scale"),i.bezier),ruled:i=>Nd(i.curve("first"),i.curve("second"),i.shape,i.bezier),developable:i=>Fd(i.curve("planes"),i.curve("bounds"),i.shape,i.flip),nurbs:i=>Bd(i.net("points"),i.get("weights"),i.get("degrees"),i.curve("knots"),i.flip,i.net("trim")),sphere:i=>Vd(i.size("radius"),i.flip),ellipsoid:i=>th(i.size("a"),i.size("b"),i.size("c"),i.flip),cylinder:i=>Hd(i.size("radius"),i.size("height"),i.flip),cone:i=>Gd(i.size("radius"),i.size("height"),i.flip),torus:i=>Wd(i.size("major"),i.size("minor"),i.flip),catenoid:i=>qd(i.size("waist"),i.size("height"),i.flip),helicoid:i=>Xd(i.size("radius"),i.size("pitch"),i.flip),hyperbolic_paraboloid:i=>$d(i.size("size"),i.flip),monkey_saddle:i=>Yd(i.size("size"),i.flip),enneper:i=>Jd(i.size("size"),i.flip)};function hr(i){return Object.hasOwn(rh,i.kind)&&Jn($e(i,"basis"))}var Zd=i=>rh[i.kind](new ih(i));var Zo=class{constructor(e,t){this.breaks=e;this.series=t;this.size=t[0][0][0].length}breaks;series;size;derivatives(e,t,n){let{breaks:r,series:s,size:o}=this;for(let a=0;a<t;a++){let l=0;for(;l<s.length-1&&r[l+1]<=e[a];)l++;let c=r[l],h=r[l+1],d=(e[a]-c-(h-e[a]))/(h-c);s[l].forEach((u,f)=>{for(let p=0;p<o;p++){let v=0,g=0;for(let m=u.length-1;m>0;m--)[v,g]=[2*d*v-g+u[m][p],v];n[(f*t+a)*o+p]=d*v-g+u[0][p]}})}}};var Kd={trigonometric:(i,e)=>new Xn(i("alpha"),i("zeta"),e),bernstein:i=>new pi(i("degree")),bspline:i=>new cr(i("knots"),i("degree")),circular:i=>new di(i("start"),i("end")),hyperbolic:i=>new Fr(i("start"),i("end")),powers:i=>new on(i("start"),i("end"),i("degree")),joined:i=>new Nn(i("parts").map(ks)),chebyshev:i=>new Zo(i("breaks"),i("series"))};function ks(i){let e=Kd[i.family];if(!e)throw new Error(`functions: the page does not know ${i.family} functions`);return e(t=>i[t],i.still??Or)}var Bs=class extends tt{},e0=512,t0=8,Oi=new Map,jd=new Map,Ko=new Map,ki=[],sh=!1;function jo(i,e){let t={ask:i,arrived:e};return ki.push(t),()=>{ki.splice(ki.indexOf(t),1)}}function zs(i){for(let{keys:e,surface:t,error:n}of i)oh(lh(e),t?i0(t):new tt(n??"there is no surface"))}function Qd(i){let e=lh(i),t=Oi.get(e),n=`${i.kind} ${i.name}`;if(t instanceof tt)throw t;if(t)return jd.set(n,t),t;if(!ki.length)throw new tt(`patch "${i.name}": ${ef(i)}`);Ko.set(e,i),n0();let r=jd.get(n);if(!r)throw new Bs(`patch "${i.name}": is being built by Python`);return r}var ah=i=>ki.length||Oi.has(lh(i))?"":`patch "${i.name}": ${ef(i)}`,ef=({kind:i})=>`a ${i} is built by Python, which a page from disk lacks; change it with: quintrig view MODEL`;async function n0(){if(!sh){for(sh=!0,await Promise.resolve();Ko.size&&ki.length;){let i=[...Ko].slice(-t0);Ko.clear();try{zs(await ki.at(-1).ask(i.map(([,e])=>e)))}catch(e){for(let[t]of i)oh(t,new tt(e.message))}for(let[e]of i)Oi.has(e)||oh(e,new tt("Python did not build this patch"));for(let{arrived:e}of ki)e()}sh=!1}}function oh(i,e){Oi.delete(i),Oi.set(i,e),Oi.size>e0&&Oi.delete(Oi.keys().next().value)}function lh(i){let e=Object.keys(At[i.kind]?.fields??{}).sort();return JSON.stringify([i.kind,...e.map(t=>$e(i,t)??null)])}function i0({origin:i,flip:e,net:t,blend:n,...r}){return{rows:r0(r,i),blend:ks(n),flip:e,net:t&&Ht(t),origin:i}}function r0({points:i,planes:e,bounds:t,functions:n,dimension:r},s){let o=ks(n);if(i)return new tn(Ht(i),o);if(e&&t&&o instanceof Xn){let a=l=>kr(l,s);return new Hr(e.map(a),t.map(a),new Xn(o.alpha,o.zeta,Or))}return{size:o.size/r,dimension:r,derivatives:(a,l,c)=>o.derivatives(a,l,c)}}var Qo=Be.units,gi=Be.shapeRange,{largest:sf,largestPolygon:tf}=Be.limits;function Tt(i){if(!rf(i))throw new tt(`model: expected keys and values, got ${nn(i)}`);let{schema:e=Be.schema,name:t="",unit:n="",patch:r,join:s,built:o,...a}=i;if(o&&zs(o),e!==Be.schema)throw new tt(`schema: expected ${Be.schema}, got ${nn(e)}; this quintrig reads version 1`);if(n!==""&&!Qo.includes(n))throw new tt(`unit: expected one of ${Qo.join(", ")}, got ${nn(n)}; leave it out for plain numbers`);if(typeof t!="string"||t.length>200)throw new tt(`name: expected a short text, got ${nn(t)}`);if(r===void 0){let h=nf({...a,name:t||String(a.kind??"surface")});return{name:t||h.name,unit:n,patches:[h]}}if(!Array.isArray(r)||!r.length)throw new tt(`patch: expected one or more [[patch]] tables, got ${nn(r)}`);let l=Object.keys(a)[0];if(l)throw new tt(`unknown key '${l}' beside [[patch]] tables; move it into a patch`);let c=r.map((h,d)=>{if(!rf(h))throw new tt(`patch ${d+1}: expected a table of keys, got ${nn(h)}`);return nf({...h,name:h.name??`patch ${d+1}`})});if(s!==void 0&&!Array.isArray(s))throw new tt(`join: expected one or more [[join]] tables, got ${nn(s)}`);return{name:t||c[0].name,unit:n,patches:c,...s?{join:s}:{}}}function wn(i){let e={schema:Be.schema,name:i.name};if(i.unit&&(e.unit=i.unit),i.patches.length===1){let{name:t,...n}=i.patches[0];return{...e,...n}}return{...e,patch:i.patches,...i.join?{join:i.join}:{}}}function Et(i){if(!hr(i))return Qd(i);try{return Zd(i)}catch(e){throw new tt(`patch "${i.name}": ${e.message}`)}}function nf(i){let e=`patch "${String(i.name)}"`,t=Object.hasOwn(At,String(i.kind)),n=At[String(i.kind)];if(!t||!n)throw new tt(`${e}: kind: expected one of ${Object.keys(At).join(", ")}, got ${nn(i.kind)}`);let r=l=>{throw new tt(`${e}: ${l}`)};for(let l of Object.keys(i))l!=="kind"&&l!=="name"&&!Object.hasOwn(n.fields,l)&&r(`unknown key '${l}'`);let s=Jn(i.basis),o=i.basis==="bernstein"||!s;for(let[l,c]of Object.entries(n.fields)){let h=i[l];if(h===void 0){c.required&&r(`missing key '${l}': expected ${c.description}`);continue}c.type==="number"||c.type==="positive"?af(h,l,r,c.type==="positive"):c.type==="boolean"&&typeof h!="boolean"?r(`${l}: expected true or false, got ${nn(h)}`):c.type==="choice"&&!c.choices.includes(h)?r(`${l}: expected one of ${c.choices.join(", ")}, got ${nn(h)}`):c.type==="plane"?ch(h,l,4,r):c.type==="basis"&&!s0(h)?r(`${l}: expected the name of a basis, or two, got ${nn(h)}`):c.type==="shape"&&s?o0(h,l,n.shapeNames,i.unchecked_shape===!0,r):c.type==="points"&&of(h,l,o?c.counts.map(()=>0):c.counts,c.dimension,r)}let a=i;try{Et(a)}catch(l){if(!(l instanceof Bs))throw l}return a}var s0=i=>[i].flat().every(e=>typeof e=="string"&&e!=="");function o0(i,e,t,n,r){ch(i,e,t.length,r).forEach((s,o)=>{!n&&!(s>=gi[0]&&s<=gi[1])&&r(`shape[${o}] (${t[o]}) = ${s} is outside [${gi.join(", ")}], where the basis is non-negative; choose a value in the range, or set unchecked_shape = true and lose the convex-hull property`)})}function of(i,e,t,n,r){if(!t.length)return void ch(i,e,n,r);if(!Array.isArray(i))return r(`${e}: expected a list, got ${nn(i)}`);let s=t[0],o=t.length===2;(s?i.length!==s:i.length<2||i.length>tf)&&r(`${e}: expected ${s||`2 to ${tf}`} ${o?"rows":"points"}, got ${i.length}`),i.forEach((a,l)=>of(a,`${e}[${l}]`,t.slice(1),n,r)),o&&i.some(a=>a.length!==i[0].length)&&r(`${e}: expected rows of equal length`)}function ch(i,e,t,n){return Array.isArray(i)?(i.length!==t&&n(`${e}: expected ${t} numbers, got ${i.length}`),i.forEach((r,s)=>af(r,`${e}[${s}]`,n,!1)),i):n(`${e}: expected a list, got ${nn(i)}`)}var a0=sf.toExponential().replace("e+","e");function af(i,e,t,n){typeof i!="number"&&t(`${e}: expected a number, got ${nn(i)}`),Number.isFinite(i)||t(`${e}: expected a finite number, got ${String(i)}`),Math.abs(i)>sf&&t(`${e}: expected a number of size at most ${a0}, got ${String(i)}`),n&&!(i>0)&&t(`${e}: expected a number greater than 0, got ${String(i)}`)}var rf=i=>typeof i=="object"&&i!==null&&!Array.isArray(i);function nn(i){let e=i===void 0?"nothing":JSON.stringify(i)??String(i);return e.length<=60?e:`${e.slice(0,57)}...`}var hh="quintrig:here:";function lf(i,e){let t=()=>{let{source:n,saved:r}=e.state;try{sessionStorage.setItem(hh+i.place,JSON.stringify(n?{name:n.name}:{model:wn(r)}))}catch{sessionStorage.removeItem(hh+i.place)}};e.subscribe((n,r)=>{(n.opened!==r.opened||n.source!==r.source)&&t()})}async function cf(i){try{let e=JSON.parse(sessionStorage.getItem(hh+i.place)??"null");return e?e.name?await i.load(e.name):{model:Tt(e.model),source:null}:null}catch{return null}}function l0(i,e){let t=i.slice(0,e).split(/\r?\n/);return[t.length,t.pop().length+1]}function c0(i,e,t){let n=i.split(/\r?\n/),r="",s=(Math.log10(e+1)|0)+1;for(let o=e-1;o<=e+1;o++){let a=n[o-1];a&&(r+=o.toString().padEnd(s," "),r+=":  ",r+=a,r+=`
`,o===e&&(r+=" ".repeat(s+t+2),r+=`^
`))}return r}var Pe=class i extends Error{line;column;codeblock;constructor(e,t){let[n,r]=l0(t.toml,t.ptr),s=c0(t.toml,n,r);super(`Invalid TOML document: ${e}

${s}`,t),this.line=n,this.column=r,this.codeblock=s}static x(e,t,n){throw new i(e,{toml:t.s,ptr:n??t.p})}};function ea(i){let e=i.p,t=i.s.charCodeAt(i.p++),n=t,r=t===39,s=t===i.s.charCodeAt(i.p)&&t===i.s.charCodeAt(i.p+1);s&&((t=i.s.charCodeAt(i.p+=2))===10?i.p++:t===13&&i.s.charCodeAt(i.p+1)===10&&(i.p+=2));let o="",a=i.p,l=0;for(;i.p<i.s.length;i.p++)if(t=i.s.charCodeAt(i.p),s&&(t===10||t===13&&i.s.charCodeAt(i.p+1)===10))l=l&&3;else if(t<32&&t!==9||t===127)Pe.x("control characters are not allowed in strings",i);else if((!l||l===3)&&t===n&&(!s||i.s.charCodeAt(i.p+1)===n&&i.s.charCodeAt(i.p+2)===n)){if(s&&(i.s.charCodeAt(i.p+3)===n&&i.p++,i.s.charCodeAt(i.p+3)===n&&i.p++),!l){let c=i.s.slice(a,i.p);o=o?o+c:c}return i.p+=s?3:1,o}else if(!l)!r&&t===92&&(o+=i.s.slice(a,a=i.p),l=1);else if(l===1)if(t===120||t===117||t===85){let c=i.p++-1,h=0,d=t===120?2:t===117?4:8;for(let u=0;u<d;u++,i.p++){let f=i.s.charCodeAt(i.p),p=f>=48&&f<=57?f-48:f>=65&&f<=70?f-65+10:f>=97&&f<=102?f-97+10:-1;p<0&&Pe.x("invalid non-hex character in unicode escape",i),h=h<<4|p}(h<0||h>1114111||h>=55296&&h<=57343)&&Pe.x("invalid unicode escape",i,c),o+=String.fromCodePoint(h),a=i.p--,l=0}else s&&(t===32||t===9)?l=2:(t===98?o+="\b":t===116?o+="	":t===110?o+=`
`:t===102?o+="\f":t===114?o+="\r":t===101?o+="\x1B":t===34?o+='"':t===92?o+="\\":Pe.x("unrecognised escape sequence",i),a=i.p+1,l=0);else t!==32&&t!==9&&(l===2&&Pe.x("invalid escape: only line-ending whitespace may be escaped",i,a),l=!r&&t===92?1:0,a=i.p);Pe.x("unfinished string",i,e)}var h0=/^(\d{4}-\d{2}-\d{2})?[Tt ]?(?:(\d{2}):\d{2}(?::\d{2}(?:\.\d+)?)?)?(Z|z|[-+]\d{2}:\d{2})?$/i,Vs=class i extends Date{#t=!1;#n=!1;#e=null;constructor(e,t,n){let r=!0,s=!0,o="Z",a;if(typeof e=="string")if(t)e:{if(t<3){if(+e.slice(11,13)>23){e="";break e}t===2?(o=null,e+="Z"):(a=e.charCodeAt(e.length-1))!==90&&a!==122&&(o=e.slice(e.length-6)),n&&(e=e.slice(0,10)+"T"+e.slice(11))}else t===4&&(e=+e.slice(0,2)>23?"":`0000-01-01T${e}Z`);r=t!==4,s=t!==3}else{let l=e.match(h0);l?(l[1]||(r=!1,e=`0000-01-01T${e}`),s=!!l[2],s&&e[10]===" "&&(e=e.replace(" ","T")),l[2]&&+l[2]>23?e="":(o=l[3]||null,!o&&s&&(e+="Z"))):e=""}super(e),isNaN(this.getTime())||(this.#t=r,this.#n=s,this.#e=o)}isDateTime(){return this.#t&&this.#n}isLocal(){return!this.#t||!this.#n||!this.#e}isDate(){return this.#t&&!this.#n}isTime(){return this.#n&&!this.#t}isValid(){return this.#t||this.#n}toISOString(){let e=super.toISOString();if(this.isDate())return e.slice(0,10);if(this.isTime())return e.slice(11,23);if(this.#e===null)return e.slice(0,-1);if(this.#e==="Z"||this.#e==="z")return e;let t=+this.#e.slice(1,3)*60+ +this.#e.slice(4,6);return t=this.#e[0]==="-"?t:-t,new Date(this.getTime()-t*6e4).toISOString().slice(0,-1)+this.#e}static wrapAsOffsetDateTime(e,t="Z"){let n=new i(e);return n.#e=t,n}static wrapAsLocalDateTime(e){let t=new i(e);return t.#e=null,t}static wrapAsLocalDate(e){let t=new i(e);return t.#n=!1,t.#e=null,t}static wrapAsLocalTime(e){let t=new i(e);return t.#t=!1,t.#e=null,t}};function ln(i,e=10){return e===16?i>47&&i<58||i>64&&i<71||i>96&&i<103:i>47&&i<48+e}function dh(i,e){return i===32||i===9||i===10||i===13||e&&(i===e||i===44)||i===35}function Gs(i,e){let t=i.p,n=i.s.charCodeAt(i.p);if(n===91||n===123){i.d--||Pe.x("document contains excessively nested structures. aborting.",i);let r=n===91?df(i):uf(i);return i.d++,r}return n===34||n===39?ea(i):n===116?((i.s.charCodeAt(++i.p)!==114||i.s.charCodeAt(++i.p)!==117||i.s.charCodeAt(++i.p)!==101)&&Pe.x("invalid value",i,t),i.p++,!0):n===102?((i.s.charCodeAt(++i.p)!==97||i.s.charCodeAt(++i.p)!==108||i.s.charCodeAt(++i.p)!==115||i.s.charCodeAt(++i.p)!==101)&&Pe.x("invalid value",i,t),i.p++,!1):n===43||n===45?ta(i,i.p,i.s.charCodeAt(++i.p),44-n,e):i.s.charCodeAt(i.p+4)===45&&i.s.charCodeAt(i.p+7)===45?u0(i,n,e):i.s.charCodeAt(i.p+2)===58?d0(i,n,e):ta(i,i.p,n,0,e)}function ta(i,e,t,n,r){let s=t,o=0,a=!1;if(s===105)return(i.s.charCodeAt(++i.p)!==110||i.s.charCodeAt(++i.p)!==102)&&Pe.x("invalid value",i,e),i.p++,(n||1)/0;if(s===110)return(i.s.charCodeAt(++i.p)!==97||i.s.charCodeAt(++i.p)!==110)&&Pe.x("invalid value",i,e),i.p++,NaN;if(s===48){if(++i.p>=i.s.length||dh(s=i.s.charCodeAt(i.p),r))return i.bi===!0?0n:0;if(!n){if(s===120)return uh(i,e,16,r);if(s===98)return uh(i,e,2,r);if(s===111)return uh(i,e,8,r)}s===46?o=2:s===101||s===69?o=4:Pe.x("illegal leading zero",i,e)}else ln(s)||Pe.x("invalid value",i,e);for(;++i.p<i.s.length&&(s=i.s.charCodeAt(i.p),!dh(s,r));)o||(o=1),s===95?(o&1||Pe.x("illegal underscore",i),o+=11,a=!0):o===1&&s===46?o=2:(o===1||o===3)&&(s===101||s===69)?o=4:o===4&&(s===43||s===45)?o=6:ln(s)?o>9?o-=11:o&1||o++:Pe.x("illegal character in numeric literal",i);if(!o){let c=(t-48)*(n||1);return i.bi===!0?BigInt(c):c}o&1||Pe.x("unfinished numeric value",i,e);let l=i.s.slice(e,i.p);return a&&(l=l.replaceAll("_","")),o>1?parseFloat(l):hf(i,l,10,e)}function uh(i,e,t,n){let r,s=1;for(;++i.p<i.s.length&&(r=i.s.charCodeAt(i.p),!dh(r,n));)r===95?(s&1&&Pe.x("illegal underscore",i),s=3):ln(r,t)?s&1&&s--:Pe.x("illegal character in numeric literal",i);s&1&&Pe.x("unfinished numeric value",i);let o=i.s.slice(e+2,i.p);return s&&(o=o.replaceAll("_","")),hf(i,o,t,e)}function hf(i,e,t,n){if(i.bi!==!0)e:{let r=parseInt(e,t);if(!Number.isSafeInteger(r)){if(i.bi)break e;Pe.x("integer value cannot be represented losslessly",i,n)}return r}return BigInt(t===10?e:(t===2?"0b":t===8?"0o":"0x")+e)}function u0(i,e,t){let n=i.p++,r;if(!ln(e)||!ln(i.s.charCodeAt(i.p++))||!ln(i.s.charCodeAt(i.p++))||!ln(i.s.charCodeAt(i.p++)))return ta(i,i.p=n,e,0,t);if(i.p+=5,ln(i.s.charCodeAt(i.p++))||Pe.x("invalid date-time: date part is malformed",i,n),i.p>=i.s.length||((e=i.s.charCodeAt(i.p))!==32||(r=!0,!ln(i.s.charCodeAt(i.p+1))))&&e!==84&&e!==116){let o=i.s.slice(n,i.p);return Hs(i,o,3,!1,n)}if(i.s.charCodeAt(i.p+=3)!==58&&Pe.x("invalid date-time: time part is malformed",i,n),i.s.charCodeAt(i.p+=3)===58&&(i.p+=3),i.s.charCodeAt(i.p)===46)for(;ln(i.s.charCodeAt(++i.p)););if(e=i.s.charCodeAt(i.p)){if(e===90||e===122){let o=i.s.slice(n,++i.p);return Hs(i,o,1,r,n,"[+00:00]")}if(e===43||e===45){let o=i.s.slice(n,i.p+=6);return Hs(i,o,1,r,n,!i.ld&&"["+i.s.slice(i.p-6,i.p)+"]")}}let s=i.s.slice(n,i.p);return Hs(i,s,2,r,n)}function d0(i,e,t){let n=i.p;if(!ln(e)||!ln(i.s.charCodeAt(++i.p)))return ta(i,--i.p,e,0,t);if(i.s.charCodeAt(i.p+=4)===58&&(i.p+=3),i.s.charCodeAt(i.p)===46)for(;ln(i.s.charCodeAt(++i.p)););let r=i.s.slice(n,i.p);return Hs(i,r,4,!1,n)}function Hs(i,e,t,n,r,s){if(i.ld){let o=new Vs(e,t,n);return o.isValid()||Pe.x("invalid date",i,r),o}try{switch(s&&(e+=s),t){case 1:return Temporal.ZonedDateTime.from(e);case 2:return Temporal.PlainDateTime.from(e);case 3:return Temporal.PlainDate.from(e);case 4:return Temporal.PlainTime.from(e)}}catch(o){Pe.x(o instanceof Error?o.message:""+o,i,r)}}function f0(i){for(;i.p<i.s.length;i.p++){let e=i.s.charCodeAt(i.p);if(e===10)break;if(e===13&&i.s.charCodeAt(i.p+1)===10){i.p++;break}(e<32&&e!==9||e===127)&&Pe.x("control characters are not allowed in comments",i)}}function Dn(i,e,t){let n;for(;i.p<i.s.length;){for(;i.p<i.s.length&&((n=i.s.charCodeAt(i.p))===32||n===9||!e&&(n===10||n===13&&i.s.charCodeAt(i.p+1)===10));)i.p++;if(t||n!==35)break;f0(i)}}function na(i,e=61){let t,n=0,r=[],s,o=i.s.charCodeAt(t=i.p);do{if(o===e)return n||Pe.x("unexpected end of key",i),n===1&&r.push(i.s.slice(s,i.p)),i.p++,r;o===46?(n||Pe.x("illegal empty bare key",i),n===1&&r.push(i.s.slice(s,i.p)),n=0):!n&&(o===34||o===39)?(o===i.s.charCodeAt(i.p+1)&&o===i.s.charCodeAt(i.p+2)&&Pe.x("illegal quoted key: multiline strings are not allowed",i),r.push(ea(i)),n=2,i.p--):o===32||o===9?n===1&&(r.push(i.s.slice(s,i.p)),n=2):n===2||o<48&&o!==45||o>57&&o<65||o>90&&o<97&&o!==95||o>122?Pe.x("illegal character in key",i):n||(n=1,s=i.p)}while(o=i.s.charCodeAt(++i.p));Pe.x("incomplete key-value: cannot find end of key",i,t)}function uf(i){let e=i.p++,t=Object.create(null),n=new Set,r;for(;i.p<i.s.length;){if(Dn(i),(r=i.s.charCodeAt(i.p))===125)return i.p++,t;let s,o=t,a=!1,l=i.p,c=na(i);for(let d=0;d<c.length;d++){d&&(o=a?o[s]:o[s]=Object.create(null)),s=c[d],(a=Object.hasOwn(o,s))&&(typeof o[s]!="object"||n.has(o[s]))&&Pe.x("trying to redefine an already defined value",i,l);let u=s==="__proto__";if(i.uk&&(u||s==="constructor")){o=i.uk!==1&&Pe.x("document contains an unsafe property",i,l);break}!a&&u&&Object.defineProperty(o,s,{enumerable:!0,configurable:!0,writable:!0})}a&&Pe.x("trying to redefine an already defined value",i,l),Dn(i,!0,!0);let h=Gs(i,125);if(o&&typeof(o[s]=h)=="object"&&n.add(h),Dn(i),(r=i.s.charCodeAt(i.p++))===125)return t;r!==44&&Pe.x("expected comma or end of structure",i,i.p-1)}Pe.x("unfinished table",i,e)}function df(i){let e=i.p++,t=[],n;for(;i.p<i.s.length;){if(Dn(i),(n=i.s.charCodeAt(i.p))===93)return i.p++,t;if(t.push(Gs(i,93)),Dn(i),(n=i.s.charCodeAt(i.p++))===93)return t;n!==44&&Pe.x("expected comma or end of structure",i,i.p-1)}Pe.x("unfinished array",i,e)}function ff(i,e,t,n,r){let s=t,o=n,a,l=!1,c;for(let h=0;h<e.length;h++){if(h){if(s=l?s[a]:s[a]=Object.create(null),o=(c=o[a]).c,r===0&&(c.t===1||c.t===2))return null;if(c.t===2){let d=s.length-1;s=s[d],o=o[d].c}}if(a=e[h],(l=Object.hasOwn(s,a))&&o[a]?.t===0&&o[a]?.d)return null;if(!l){let d=a==="__proto__";if(i.uk&&(d||a==="constructor"))return!1;d&&(Object.defineProperty(s,a,{enumerable:!0,configurable:!0,writable:!0}),Object.defineProperty(o,a,{enumerable:!0,configurable:!0,writable:!0})),o[a]={t:h<e.length-1&&r===2?3:r,d:!1,i:0,c:Object.create(null)}}}if(c=o[a],c.t!==r&&!(r===1&&c.t===3)||(r===2&&(c.d||(c.d=!0,s[a]=[]),s[a].push(s=Object.create(null)),c.c[c.i++]=c={t:1,d:!1,i:0,c:Object.create(null)}),c.d))return null;if(c.d=!0,r===1)s=l?s[a]:s[a]=Object.create(null);else if(r===0&&l)return null;return[a,s,c.c]}function pf(i,e,t){(e===null||i.uk===2)&&Pe.x(e===null?"trying to redefine an already defined table or value":"document contains an unsafe property",i,t)}function fh(i,e={}){let t={s:i,p:0,d:e.maxDepth??1e3,bi:e.integersAsBigInt??!1,ld:e.useLegacyDate??!0,uk:e.unsafeKeyBehaviour==="throw"?2:e.unsafeKeyBehaviour==="drop"?1:0},n=Object.create(null),r=Object.create(null),s,o=!1,a=n,l=r;for(i.charCodeAt(0)===65279&&t.p++,Dn(t);t.p<i.length;){if(i.charCodeAt(t.p)===91){let c=i.charCodeAt(++t.p)===91;s=t.p+=+c,o=!1;let h=na(t,93);c&&(i.charCodeAt(t.p)!==93&&Pe.x("expected end of table array declaration",t),t.p++);let d=ff(t,h,n,r,c?2:1);d?(l=d[2],a=d[1]):(pf(t,d,s),o=!0)}else{s=t.p;let c=na(t),h=ff(t,c,a,l,0);!h&&!o&&pf(t,h,s),Dn(t,!0,!0);let d=Gs(t,void 0);h&&!o&&(h[1][h[0]]=d)}Dn(t,!0),t.p<i.length&&(s=i.charCodeAt(t.p))!==10&&(s!==13||i.charCodeAt(t.p+1)!==10)&&Pe.x("each key-value declaration must be followed by an end-of-line",t),Dn(t)}return n}var U1=!!"".isWellFormed;function gf(i){let e=[],t=!1,n=!1,r=0,s=a=>(a.lastIndex=r,a.exec(i)?.[0]??""),o=(a,l=r)=>{let c=i.slice(0,l).split(`
`);return{what:a,line:c.length,column:c.at(-1).length+1}};for(;r<i.length;){let a=i[r],l=e.at(-1)==="table";if(a==='"'||a==="'"){let c=s(p0),h=a==='"'?/^(?:[^\\]|\\[^ex])*?\\([ex])/.exec(c):null;if(h)return o(`unknown escape sequence \\${h[1]}`,r+h[0].length-2);r+=c.length||1,t=n=!1}else if(a==="#")r+=s(/[^\n]*/y).length;else if(a===`
`){if(l)return o("a line break in an inline table");e.length||(t=!1),r++}else if(a==="["||a==="{")e.push(a==="{"?"table":t?"list":"header"),t=e.at(-1)==="list",n=!1,r++;else if(a==="]"||a==="}"){if(n&&l)return o("a comma at the end of an inline table");e.pop(),t=n=!1,r++}else if(a===","||a==="=")t=a==="="||e.at(-1)==="list",n=a===",",r++;else if(/\s/.test(a))r++;else{let c=t?s(m0):"",h=c||s(/[^\s,=\]}#]+/y);if(c&&!g0(c))return o(`the date or time ${c} does not exist or lacks its seconds`);r+=h.length,t=n=!1}}return null}var p0=/"""(?:[^\\]|\\.)*?"{3,5}|'''.*?'{3,5}|"(?:[^"\\]|\\.)*"|'[^']*'/sy,m0=/\d{4}-\d\d-\d\d(?:[Tt ]\d[\d:.]*(?:[Zz]|[+-]\d\d:\d\d)?)?|\d\d:[\d:.]*/y,mf=/^([01]\d|2[0-3]):[0-5]\d:[0-5]\d(?:\.\d+)?(?:[Zz]|[+-]([01]\d|2[0-3]):[0-5]\d)?$/;function g0(i){if(i[2]===":")return mf.test(i);let[e,t,n]=i.slice(0,10).split("-").map(Number),r=new Date(0);return r.setUTCFullYear(e,t-1,n),e>0&&r.getUTCMonth()===t-1&&r.getUTCDate()===n&&(i.length===10||mf.test(i.slice(11)))}var y0=20;function yi(i){let e=wn(i),t=[],n=a=>{for(let[l,c]of Object.entries(a))c!=null&&t.push(`${l} = ${ph(c)}`)},{patch:r,join:s,...o}=e;n(o);for(let[a,l]of Object.entries({patch:r,join:s}))for(let c of l??[])t.push("",`[[${a}]]`),n(c);return`${t.join(`
`)}
`}function ph(i,e=""){return Array.isArray(i)?i.every(t=>!Array.isArray(t))?`[${i.map(t=>ph(t)).join(", ")}]`:`[
${i.map(t=>`${e}    ${ph(t,`${e}    `)},
`).join("")}${e}]`:typeof i=="string"?JSON.stringify(i):String(i)}function gh(i){try{let e=i.replace(/^\uFEFF/,""),{...t}=fh(e,{integersAsBigInt:"asNeeded",maxDepth:y0}),n=gf(e);if(n)throw new tt(`not valid TOML: ${n.what} (at line ${n.line}, column ${n.column})`);return mh(t)}catch(e){if(!(e instanceof Pe))throw e;let[t]=e.message.replace(/^Invalid TOML document: /,"").split(`
`);throw new tt(`not valid TOML: ${t} (at line ${e.line}, column ${e.column})`)}}function mh(i){return typeof i=="bigint"?Number(i):Array.isArray(i)?i.map(mh):typeof i!="object"||i===null||i instanceof Date?i:Object.fromEntries(Object.entries(i).map(([e,t])=>[e,mh(t)]))}function C(i,e={},...t){let n=document.createElement(i);for(let[r,s]of Object.entries(e))if(r==="on")for(let[o,a]of Object.entries(s))n.addEventListener(o,a);else r==="class"?n.className=String(s):r.startsWith("aria-")&&typeof s=="boolean"?n.setAttribute(r,String(s)):s===!0?n.setAttribute(r,""):s!==!1&&s!==null&&s!==void 0&&n.setAttribute(r,String(s));return n.append(...t.filter(r=>r!=null&&r!==!1).map(r=>typeof r=="number"?String(r):r)),n}var yf="http://www.w3.org/2000/svg";function yt(i){let e=document.createElementNS(yf,"svg");e.setAttribute("viewBox","0 0 16 16"),e.setAttribute("class","icon"),e.setAttribute("aria-hidden","true");let t=document.createElementNS(yf,"path");return t.setAttribute("d",i),e.append(t),e}var vt={undo:"M3 6h7a3.5 3.5 0 0 1 0 7H6M3 6l3-3M3 6l3 3",redo:"M13 6H6a3.5 3.5 0 0 0 0 7h4M13 6l-3-3M13 6l-3 3",open:"M2 4.5h4l1.5 1.5H14v7H2zM2 8h12",save:"M3 3h8l2 2v8H3zM5.5 3v3.5h4V3M5 13V9h6v4",picture:"M2 4h3l1-1.5h4L11 4h3v9H2zM8 6.2a2.4 2.4 0 1 0 0 4.8 2.4 2.4 0 0 0 0-4.8z",export:"M8 10V2.5M5 5l3-3 3 3M3 9v4.5h10V9",sun:"M8 5.2a2.8 2.8 0 1 0 0 5.6 2.8 2.8 0 0 0 0-5.6zM8 1v1.6M8 13.4V15M1 8h1.6M13.4 8H15M3 3l1.2 1.2M11.8 11.8 13 13M13 3l-1.2 1.2M4.2 11.8 3 13",moon:"M13 9.5A5.5 5.5 0 1 1 6.5 3 4.4 4.4 0 0 0 13 9.5z",help:"M8 2a6 6 0 1 0 0 12A6 6 0 0 0 8 2zM6.2 6.2a1.9 1.9 0 1 1 2.6 1.8c-.6.3-.8.6-.8 1.2M8 11.2v.3",down:"M4.5 6.5 8 10l3.5-3.5",fit:"M2.5 6V2.5H6M10 2.5h3.5V6M13.5 10v3.5H10M6 13.5H2.5V10",pin:"M8 14V9.5M5 9.5h6L9.8 7V3.5H11v-1H5v1h1.2V7z",close:"M4 4l8 8M12 4l-8 8",flip:"M8 2v12M5 5 2 8l3 3M11 5l3 3-3 3",wire:"M2 12 6 3l8 2-3 9zM4 7.5l8.6 2M9.5 4 6.5 13",side:"M2.5 3h11v10h-11zM6 3v10"},yh=i=>i.value.trim()===""?NaN:Number(i.value.replace(",","."));function Zn(i,e,t="text/plain"){let n=typeof e=="string"?new Blob([e],{type:t}):e,r=C("a",{href:URL.createObjectURL(n),download:i});r.click(),setTimeout(()=>URL.revokeObjectURL(r.href),1e4)}var Kn=i=>i.normalize("NFKD").replace(/[^\w-]+/g,"_").replace(/^_+|_+$/g,"").toLowerCase()||"surface";var Ws=class extends Error{},ur=class extends Error{constructor(t){super(`${t?"The studio's server has stopped: it does not answer.":"The studio's server was started anew, and does not know this tab."} Your work is still here, and unsaved changes are kept in this browser.`);this.stopped=t}stopped},Gr=class{constructor(e,t){this.kind=e;this.place=t}kind;place;list(){return Promise.resolve([])}load(e){return Promise.reject(new tt(`${e}: a page from disk has no folder to open files from`))}read(e,t){return new Promise(n=>n(x0(e,t)))}save(e,t){return Zn(`${Kn(e.replace(/\.(toml|json)$/i,""))}.toml`,yi(t)),Promise.resolve(null)}formats(){return Promise.resolve([])}export(){return Promise.reject(new Error("exports need the live studio: quintrig view MODEL"))}},ia=class{constructor(e){this.place=e}place;kind="live";async list(){return(await this.ask("GET","api/files")).files}async load(e){return xh(await this.ask("GET",`api/files/${encodeURIComponent(e)}`))}async read(e,t){let n=await this.ask("POST","api/check",JSON.stringify({name:e,text:t}));return Tt(n.model)}async save(e,t,n){let r=JSON.stringify({text:yi(t),tag:n});return await this.ask("PUT",`api/files/${encodeURIComponent(e)}`,r)}async formats(e,t){return(await this.ask("POST","api/formats",JSON.stringify({text:yi(e),patch:t}))).formats}async export({model:e,...t},{suffix:n}){let r=JSON.stringify({text:yi(e),suffix:n,...t}),{name:s,notes:o,content:a}=await this.ask("POST","api/export",r);return Zn(s,new Blob([Uint8Array.from(atob(a),l=>l.charCodeAt(0))])),{name:s,notes:o}}async build(e){return(await this.ask("POST","api/build",JSON.stringify({patches:JSON.stringify(e)}))).built}async ask(e,t,n){return(await this.send(e,t,n)).json()}async send(e,t,n){let r;try{r=await fetch(t,{method:e,body:n??null,...n?{headers:{"Content-Type":"application/json"}}:{}})}catch{throw new ur(!0)}if(r.ok)return r;let s=await r.json().catch(()=>null);if(r.status===403&&!s)throw new ur(!1);let o=s?.error??`the server answered ${r.status}`;throw r.status===409?new Ws(o):r.status===422?new tt(o):new Error(o)}};function xh(i){let{model:e,name:t,tag:n}=i;return{model:Tt(e),source:t?{name:t,tag:n}:null}}function x0(i,e){try{if(/\.toml$/i.test(i))return Tt(gh(e));if(!/\.json$/i.test(i))throw new tt("expected a file ending in .toml or .json");let t;try{t=JSON.parse(e)}catch(n){throw new tt(`not valid JSON: ${n.message}`)}return Tt(t)}catch(t){throw new tt(`${i}: ${t.message}`)}}var Wr=Be.limits;function ra(i,e,t,n,r){if(!(Math.abs(t)<1e300))return 0;if(t<=r)return 5;let s=Math.abs(i)<=n*t*t?0:i>0?1:-1;return 1+3*(1+(Math.abs(e)<=n*t?0:e>0?1:-1))+(1-s)}function vh(i,e,t,n){if(i===0)return 0;if(i===5)return 4;let r=(i-1)%3;return r===0?e<=n*t?5:1:r===1?3:2}function bh(i,e){if(e===0)return 0;if(e===5)return 10;let t=1;for(let n of Be.shapeBreaks)i>=-n&&t++,i>n&&t++;return t}function xf(i,e,t){let n=.5*(i-t);return Math.sqrt(n*n+e*e)}function vf(i,e,t,n){return t>n?-2/Math.PI*Math.atan2(i,e):NaN}var dr=1,fr=0;function sa(i,e,t,n){let r=.5*(i-t),s=r>=0?n+r:e,o=r>=0?e:n-r,a=Math.sqrt(s*s+o*o);dr=s/a,fr=o/a}var v0=Be.limits.vertical;function bf(i,e,t,n,r,s,o){o[0]=i*n*n+2*e*n*r+t*r*r,o[1]=s*((t-i)*n*r+e*(n*n-r*r)),o[2]=i*r*r-2*e*n*r+t*n*n}function _f(i,e,t,n,r,s){let o=1/(Math.abs(r)>v0?r:0),a=o*o,l=a*o;s[0]=e*a,s[1]=(i[0]+2*t*r*r)*l,s[2]=n*a*a,s[3]=i[0]*l*a,s[4]=i[1]*a*a,s[5]=i[2]*l}function Sf(i,e,t,n,r,s){s[0]=e,s[1]=2*r*t,s[2]=r*r*n,s[3]=r*i[0],s[4]=Math.abs(r)*i[1],s[5]=r*i[2]}var jn=Be.quantities,st=Object.fromEntries(jn.map(i=>[i.key,i])),oa=(i,e)=>Be.words[i]?.[e]??"";function aa(i,e){if(!e||i.power===0)return"";let t=e+["","","²","³"][Math.abs(i.power)];return i.power>0?t:`1/${t}`}function qr({trim:i=[]},e,t){return!i.length||Mf(i,e).filter(n=>n>t).length%2===1||_0(i,e,t)}function la({trim:i=[]},e,t){let n=t.length,r=new Uint8Array(e.length*n).fill(i.length?0:1);if(!i.length)return r;for(let s=0;s<e.length;s++){let o=Mf(i,e[s]).sort((a,l)=>a-l);for(let a=0,l=0;a<n;a++){for(;l<o.length&&o[l]<=t[a];)l++;r[s*n+a]=l%2}}return r}function Bi({trim:i=[]}){if(!i.length)return[0,0,1,1];let e=[1,1],t=[0,0];for(let n of i.flat())for(let r of[0,1])e[r]=Math.min(e[r],n[r]),t[r]=Math.max(t[r],n[r]);return[e[0],e[1],t[0],t[1]]}function Mf(i,e){let t=[];for(let n of i){let[r,s]=n.at(-1);for(let o of n){let[a,l]=o;r>e!=a>e&&t.push(s+(e-r)/(a-r)*(l-s)),[r,s]=[a,l]}}return t}var b0=1e-9;function _0(i,e,t){return i.some(n=>n.some(([r,s],o)=>{let[a,l]=n.at(o-1),c=r-a,h=s-l,d=Math.hypot(c,h),u=(e-a)*c+(t-l)*h,f=(e-a)*h-(t-l)*c;return d>0&&Math.abs(f)<=b0*d&&u>=0&&u<=d*d}))}var S0=Be.limits.singular,_h=Be.limits.noise,De={a:0,b:1,c:2,normal:3,e1:6,e2:9,point:12,forms:15,mean:21,radius:22,gaussian:23,curvedness:24},M0=25,$r=class{nu=0;nv=0;count=0;size=0;sign=1;stride=0;planes=new Float64Array(0);low=[0,0,0];high=[0,0,0];u=new Float64Array(0);v=new Float64Array(0);rows=new Float64Array(0);blend=new Float64Array(0);origin=[0,0,0];partials=new Float64Array(18);evaluate(e,t,n){let[r,s,o,a]=Bi(e);this.u=Tf(t,r,o),this.v=Tf(n,s,a),this.evaluateAt(e,this.u,this.v,!0)}evaluateAt(e,t,n,r){let s=zr(e);this.low=s.low,this.high=s.high,this.size=s.size,this.sign=e.flip?-1:1,this.nu=r?t.length:1,this.nv=n.length,this.count=this.nu*this.nv,this.origin=e.origin??[0,0,0];let o=e.rows.size,a=e.rows.dimension;this.rows.length<3*t.length*o*a&&(this.rows=new Float64Array(3*t.length*o*a)),this.blend.length<3*n.length*o&&(this.blend=new Float64Array(3*n.length*o)),this.stride<this.count&&(this.stride=this.count,this.planes=new Float64Array(M0*this.stride)),e.rows.derivatives(t,t.length,this.rows),e.blend.derivatives(n,n.length,this.blend);let l=this.size>0?S0*this.size*this.size:1/0;a===4?this.driveRational(o,t.length,n.length,r,l):this.drive(o,t.length,n.length,r,l)}quantity(e,t,n){T0(this,e,t,n)}drive(e,t,n,r,s){let{rows:o,blend:a,partials:l}=this,c=3*e*t,h=e*n;for(let d=0;d<this.count;d++){let u=r?d/n|0:d,f=r?d-u*n:d,p=0,v=0,g=0,m=0,x=0,w=0,_=0,T=0,A=0,y=0,M=0,D=0,I=0,L=0,U=0,q=0,R=0,G=0;for(let W=0,O=3*e*u,ee=e*f;W<e;W++,O+=3,ee++){let H=a[ee],J=a[ee+h],te=a[ee+2*h],ve=o[O],Te=o[O+1],$=o[O+2],re=o[O+c],me=o[O+c+1],Me=o[O+c+2];p+=ve*H,v+=Te*H,g+=$*H,m+=re*H,x+=me*H,w+=Me*H,_+=ve*J,T+=Te*J,A+=$*J,y+=o[O+2*c]*H,M+=o[O+2*c+1]*H,D+=o[O+2*c+2]*H,I+=re*J,L+=me*J,U+=Me*J,q+=ve*te,R+=Te*te,G+=$*te}l[0]=p,l[1]=v,l[2]=g,l[3]=m,l[4]=x,l[5]=w,l[6]=_,l[7]=T,l[8]=A,l[9]=y,l[10]=M,l[11]=D,l[12]=I,l[13]=L,l[14]=U,l[15]=q,l[16]=R,l[17]=G,this.reduce(d,s)}}driveRational(e,t,n,r,s){let{rows:o,blend:a,partials:l}=this,c=4*e*t,h=e*n,d=new Float64Array(24);for(let u=0;u<this.count;u++){let f=r?u/n|0:u,p=r?u-f*n:u;d.fill(0);for(let T=0,A=4*e*f,y=e*p;T<e;T++,A+=4,y++){let M=a[y],D=a[y+h],I=a[y+2*h];for(let L=0;L<4;L++){let U=o[A+L],q=o[A+c+L];d[L]+=U*M,d[4+L]+=q*M,d[8+L]+=U*D,d[12+L]+=o[A+2*c+L]*M,d[16+L]+=q*D,d[20+L]+=U*I}}let v=d[3],g=d[7],m=d[11],x=d[15],w=d[19],_=d[23];for(let T=0;T<3;T++){let A=d[T]/v,y=(d[4+T]-g*A)/v,M=(d[8+T]-m*A)/v;l[T]=A,l[3+T]=y,l[6+T]=M,l[9+T]=(d[12+T]-2*g*y-x*A)/v,l[12+T]=(d[16+T]-g*M-m*y-w*A)/v,l[15+T]=(d[20+T]-2*m*M-_*A)/v}this.reduce(u,s)}}reduce(e,t){let n=this.partials,r=n[0],s=n[1],o=n[2],a=n[3],l=n[4],c=n[5],h=n[6],d=n[7],u=n[8],f=n[9],p=n[10],v=n[11],g=n[12],m=n[13],x=n[14],w=n[15],_=n[16],T=n[17],A=this.planes,y=this.stride,M=this.sign,D=a*a+l*l+c*c,I=a*h+l*d+c*u,L=h*h+d*d+u*u,U=l*u-c*d,q=c*h-a*u,R=a*d-l*h,G=Math.sqrt(U*U+q*q+R*R),W=G>t?1/G:NaN,O=M*W,ee=U*O,H=q*O,J=R*O,te=f*ee+p*H+v*J,ve=g*ee+m*H+x*J,Te=w*ee+_*H+T*J,$=I/D,re=te/D,me=(ve-$*te)*W,Me=(Te-2*$*ve+$*$*te)*(D*W)*W,fe=.5*(re+Me),Le=xf(re,me,Me),dt=1/Math.sqrt(D),Ce=a*dt,Ze=l*dt,Qe=c*dt;A[e]=re,A[y+e]=me,A[2*y+e]=Me,A[3*y+e]=ee,A[4*y+e]=H,A[5*y+e]=J,A[6*y+e]=Ce,A[7*y+e]=Ze,A[8*y+e]=Qe,A[9*y+e]=M*(H*Qe-J*Ze),A[10*y+e]=M*(J*Ce-ee*Qe),A[11*y+e]=M*(ee*Ze-H*Ce),A[12*y+e]=r+this.origin[0],A[13*y+e]=s+this.origin[1],A[14*y+e]=o+this.origin[2],A[15*y+e]=D,A[16*y+e]=I,A[17*y+e]=L,A[18*y+e]=te,A[19*y+e]=ve,A[20*y+e]=Te,A[21*y+e]=fe,A[22*y+e]=Le,A[23*y+e]=re*Me-me*me,A[24*y+e]=Math.sqrt(fe*fe+Le*Le)}},w0=["E","F","G","L","M","N"],A0=["beta0","beta1","beta2","gamma1","gamma2","gamma3"],Sh=new Float64Array(3),Xr=new Float64Array(6);function T0(i,e,t,n){let{planes:r,stride:s,count:o}=i,a=(p,v=1)=>{for(let g=0;g<v;g++)for(let m=0,x=(p+g)*s;m<o;m++,x++)t[v*m+g]=r[x]},l=i.size>0?1/i.size:1/0,c=n.flat*l,h=n.relative;switch(e){case"point":return a(De.point,3);case"normal":return a(De.normal,3);case"gaussian":return a(De.gaussian);case"mean":return a(De.mean);case"curvedness":return a(De.curvedness);case"k1":case"k2":{let p=e==="k1"?1:-1;for(let v=0;v<o;v++)t[v]=r[De.mean*s+v]+p*r[De.radius*s+v];return}case"direction1":case"direction2":return E0(i,e==="direction2",h,_h*l,t);case"shape_index":for(let p=0;p<o;p++)t[p]=wf(r,s,p,_h*l);return;case"hk_type":for(let p=0;p<o;p++)t[p]=Mh(r,s,p,h,c);return;case"point_type":for(let p=0;p<o;p++){let v=Mh(r,s,p,h,c);t[p]=vh(v,r[De.radius*s+p],r[De.curvedness*s+p],h)}return;case"shape_class":for(let p=0;p<o;p++)t[p]=bh(wf(r,s,p,_h*l),Mh(r,s,p,h,c));return;case"invariant_type":for(let p=0;p<o;p++){Af(i,p,!0);let v=.5*Xr[1],g=2*v*v-Xr[2];t[p]=ra(Xr[2],v,Math.sqrt(Math.max(g,0)),h,c)}return}let d=w0.indexOf(e);if(d>=0)return a(De.forms+d);let u=e.endsWith("_surface"),f=A0.indexOf(u?e.slice(0,-8):e);if(f<0)throw new Error(`unknown quantity '${e}'; known are ${Object.keys(st).join(", ")}`);for(let p=0;p<o;p++)Af(i,p,!u),t[p]=Xr[f]}function Mh(i,e,t,n,r){return ra(i[De.gaussian*e+t],i[De.mean*e+t],i[De.curvedness*e+t],n,r)}function wf(i,e,t,n){return vf(i[De.mean*e+t],i[De.radius*e+t],i[De.curvedness*e+t],n)}function Af(i,e,t){let{planes:n,stride:r}=i,s=n[(De.e1+2)*r+e],o=n[(De.e2+2)*r+e],a=n[(De.normal+2)*r+e];bf(n[e],n[r+e],n[2*r+e],s,o,i.sign,Sh);let l=s*s+o*o,c=n[De.mean*r+e],h=n[De.gaussian*r+e];t?_f(Sh,l,c,h,a,Xr):Sf(Sh,l,c,h,a,Xr)}function E0(i,e,t,n,r){let{planes:s,stride:o,count:a}=i;for(let l=0;l<a;l++){let c=s[De.radius*o+l],h=s[De.curvedness*o+l],d=c>t*h&&h>n;sa(s[l],s[o+l],s[2*o+l],c);for(let u=0;u<3;u++){let f=s[(De.e1+u)*o+l],p=s[(De.e2+u)*o+l],v=e?dr*p-fr*f:dr*f+fr*p;r[3*l+u]=d?v:NaN}}}var Tf=(i,e,t)=>Float64Array.from({length:i},(n,r)=>r===i-1?t:e+(t-e)*(r/(i-1)));function Fn(i,e,t,n=!1,r=jn.map(o=>o.key),s=Wr){for(let a of[...Array.from(e),...Array.from(t)])if(!(a>=0&&a<=1))throw new Error(`parameter ${a} is outside the domain [0, 1]`);let o=new $r;return o.evaluateAt(i,Float64Array.from(e),Float64Array.from(t),!n),Object.fromEntries(r.map(a=>{let l=new Float64Array(o.count*(st[a]?.components??1));return o.quantity(a,l,s),[a,l]}))}function Cf(i,e,t,n){let r=Ef(i,e,t),s=Ef(i,e,n);return i.map((o,a)=>o+s[a]-r[a])}function ca(i,e,t,n){let r=Math.hypot(...e),s=e.map(l=>l/r),o=l=>{let c=i.map((u,f)=>u-l.origin[f]),h=zi(s,l.direction),d=1-h*h;return d>1e-4?(h*zi(c,l.direction)-zi(c,s))/d:0},a=o(n)-o(t);return i.map((l,c)=>l+a*s[c])}function Rf(i,{origin:e,direction:t},n){let r=zi(e,t),s=r*r-zi(e,e)+i*i,o=h=>e.map((d,u)=>d+h*t[u]);if(s<=0){let h=o(-r),d=Math.hypot(...h)||1;return h.map(u=>i*u/d)}let[a,l]=[o(-r-Math.sqrt(s)),o(-r+Math.sqrt(s))],c=h=>Math.hypot(...h.map((d,u)=>d-n[u]));return c(a)<=c(l)?a:l}function Ef(i,e,t){let n=zi(e,i)-zi(e,t.origin),r=zi(e,t.direction),s=Math.abs(r)>1e-9?n/r:0;return t.origin.map((o,a)=>o+s*t.direction[a])}var zi=(i,e)=>i[0]*e[0]+i[1]*e[1]+i[2]*e[2];var C0=.1,wh=[[1,0,0],[0,1,0],[0,0,1]];function Pf(i,e,t){let n=[0,1,2].filter(c=>i[c]);if(n.length===0)return null;if(n.length===1)return{line:wh[n[0]]};let r=t.map(Math.abs),s=r.indexOf(Math.max(...r)),o=n.length===2?wh[i.indexOf(!1)]:e??wh[s];if(Math.abs(Df(o,t))>C0)return{normal:o};let a=Ff(o,t),l=Math.hypot(...a);return{line:a.map(c=>Math.abs(c)<1e-9*l?0:c/l)}}function If(i,e,t,n){return i===null?e:"line"in i?ca(e,i.line,t,n):Cf(e,i.normal,t,n)}function Lf(i,e,t,n,r=!1){let s=u=>Math.round(u/n)*n;if(i===null)return[...e];if("line"in i){let u=i.line.map(Math.abs),f=u.indexOf(Math.max(...u)),p=i.line,v=(s(t[f])-e[f])/p[f];return e.map((g,m)=>m===f?s(t[m]):p[m]?g+v*p[m]:g)}let o=i.normal,a=o.map(Math.abs),l=a.indexOf(Math.max(...a)),c=[0,1,2].filter(u=>u!==l),h=[...e];for(let u of c)h[u]=s(t[u]);let d=c.reduce((u,f)=>u+o[f]*(h[f]-e[f]),0);return d!==0&&(h[l]=r?s(e[l]-d/o[l]):e[l]-d/o[l]),h}function Nf(i){let[e,...t]=i,n=t.map(c=>c.map((h,d)=>h-e[d])),r=Math.max(0,...n.map(c=>Math.hypot(...c))),s=n.find(c=>Math.hypot(...c)===r);if(!s||!(r>0))return;let o=n.map(c=>Ff(s,c)),a=Math.max(...o.map(c=>Math.hypot(...c))),l=o.find(c=>Math.hypot(...c)===a).map(c=>c/a);if(!(!(a>1e-9*r*r)||n.some(c=>Math.abs(Df(c,l))>1e-9*r)))return l.map(c=>Math.abs(c)<1e-12?0:c)}var Df=(i,e)=>i[0]*e[0]+i[1]*e[1]+i[2]*e[2],Ff=(i,e)=>[i[1]*e[2]-i[2]*e[1],i[2]*e[0]-i[0]*e[2],i[0]*e[1]-i[1]*e[0]];var Yr=[.11,.36,.66],qs=[0,.47,.42],mr=[!0,!0,!0],zf=400,Uf=new WeakMap;function da(i){let e=Uf.get(i);if(!e){try{e=Qn(i,Et(i))}catch{e=[]}Uf.set(i,e)}return e}function Qn(i,e){let t=n=>$e(i,n)??[];switch(i.kind){case"tensor":case"nurbs":return ha(t("points"));case"symmetric":{let n=t("points"),r=$e(i,"mirror"),s=ha(n).map(o=>({...o,id:`${o.id}′`,label:`${o.label}′`,position:Vr(o.position,r),mirrored:!0}));return[...ha(n),...s]}case"swept":return[...pr("section",t("section"),mr,Yr),...pr("trajectory",t("trajectory"),mr,qs)];case"ruled":return[...pr("first",t("first"),mr,Yr),...pr("second",t("second"),mr,qs)];case"swung":return[...pr("profile",t("profile").map(([n,r])=>[n,0,r]),[!0,!1,!0],Yr),...pr("trajectory",t("trajectory").map(([n,r])=>[n,r,0]),[!0,!0,!1],qs)];case"developable":return[...Bf("planes",t("planes"),e,n=>[n/5,.5],Yr),...Bf("bounds",t("bounds"),e,n=>[.5,n],qs)];default:return R0(i).flatMap(([n,r],s)=>r===2?ha(t(n),n):pr(n,t(n),mr,s?qs:Yr))}}var R0=i=>Object.entries(At[i.kind]?.fields??{}).flatMap(([e,t])=>t.type==="points"&&t.dimension===3?[[e,t.counts.length]]:[]);function fa(i,e,t){if(e.along){let s=$e(i,e.key)[e.index[0]],o=-(s[0]*t[0]+s[1]*t[1]+s[2]*t[2]);return ua(i,e.key,e.index,[s[0],s[1],s[2],Of(o)])}let n=e.position.map((s,o)=>e.free[o]?t[o]:s);e.mirrored&&(n=Vr(n,$e(i,"mirror")));let r=i.kind!=="swung"?n:e.key==="profile"?[n[0],n[2]]:[n[0],n[1]];return ua(i,e.key,e.index,r.map(Of))}function ua(i,e,t,n){let r=(s,o)=>o.length?s.map((a,l)=>l===o[0]?r(a,o.slice(1)):a):n;return{...i,[e]:r($e(i,e),t)}}function Vf(i,e){let t=o=>$e(i,o);switch(i.kind){case"swept":return[t("section").slice(),t("trajectory").slice()];case"swung":return[t("profile").map(([o,a])=>[o,0,a]),t("trajectory").map(([o,a])=>[o,a,0])];case"ruled":return[t("first").slice(),t("second").slice()]}let n=e.net;if(!n||n.n*n.m>zf)return[];let r=(o,a)=>Array.from(n.values.subarray(3*(o*n.m+a),3*(o*n.m+a)+3)),s=o=>Array.from({length:o},(a,l)=>l);return[...s(n.n).map(o=>s(n.m).map(a=>r(o,a))),...s(n.m).map(o=>s(n.n).map(a=>r(a,o)))]}var Of=i=>Number(i.toPrecision(12))+0,kf=i=>String(i).replace(/\d/g,e=>"₀₁₂₃₄₅₆₇₈₉"[Number(e)]);function ha(i,e="points"){return i.length*(i[0]?.length??0)>zf?[]:i.flatMap((t,n)=>t.map((r,s)=>({id:`${e}[${n}][${s}]`,key:e,index:[n,s],label:`P${kf(n)}${n>9||s>9?",":""}${kf(s)}`,position:r,free:mr,tint:Yr})))}function pr(i,e,t,n){let r=Nf(e);return e.map((s,o)=>({id:`${i}[${o}]`,key:i,index:[o],label:`${i} ${o}`,position:s,free:t,tint:n,...r&&{plane:r}}))}function Bf(i,e,t,n,r){return e.map((s,o)=>{let[a,l]=n(o),c=Array.from(Fn(t,[a],[l],!0,["point"]).point),[h,d,u,f]=s,p=(c[0]*h+c[1]*d+c[2]*u+f)/(h*h+d*d+u*u),v=[c[0]-p*h,c[1]-p*d,c[2]-p*u];return{id:`${i}[${o}]`,key:i,index:[o],label:`${i==="planes"?"plane":"bound"} ${o}`,position:v,free:mr,along:[h,d,u],tint:r}})}var Ah={quantity:"gaussian",range:"robust",percentile:2,low:-1,high:1,contours:!1,net:!0,curves:!0,directions:!1,normals:!1,combs:"off",combScale:1,zeroK:!1,zeroH:!1,minRadius:!1,stripes:"none",density:24,lightAzimuth:30,lightElevation:60,section:!1,sectionAzimuth:0,sectionTilt:0,sectionAt:0,clip:!1,wireframe:!1,projection:"perspective",theme:"auto",snap:!1,snapStep:1,locks:[!1,!1,!1],resolution:150},Hf=["theme","projection","curves","net","resolution"],Gf="quintrig:settings";function Wf(){try{let i=JSON.parse(localStorage.getItem(Gf)??"{}"),e=Hf.filter(t=>typeof i[t]==typeof Ah[t]);return{...Ah,...Object.fromEntries(e.map(t=>[t,i[t]]))}}catch{return Ah}}function qf(i){try{localStorage.setItem(Gf,JSON.stringify(Object.fromEntries(Hf.map(e=>[e,i[e]]))))}catch{}}var ma=class{constructor(e){this.state=e}state;past=[];future=[];openings=1;gesture=null;listeners=[];subscribe(e){this.listeners.push(e)}set(e){let t=this.state;this.state={...t,...e},this.state.settings!==t.settings&&qf(this.state.settings);for(let n of this.listeners)n(this.state,t)}setting(e){this.set({settings:{...this.state.settings,...e}})}edit(e,t=null){if(e===this.state.model)return;let n=e.patches.find(r=>!hr(r)&&ah(r));if(n)return this.set({message:{kind:"error",text:ah(n)}});(t===null||t!==this.gesture)&&this.remember(),this.gesture=t,this.future=[],this.replace({...pa(this.state),model:e},t!==null)}resume(e){this.remember(),this.gesture=null,this.future=[],this.replace({...e,opened:++this.openings},!1)}written(e,t,n){let r=s=>s.opened===e?{...s,saved:t,source:n??s.source}:s;this.past=this.past.map(r),this.future=this.future.map(r),this.set(r(this.state))}editPatch(e,t=null){let{model:n,patch:r}=this.state;this.edit({...n,patches:n.patches.map((s,o)=>o===r?e:s)},t)}settle(){this.gesture=null,this.state.moving&&this.set({moving:!1})}undo(){let e=this.past.pop();e&&(this.future.push(pa(this.state)),this.gesture=null,this.replace(e,!1))}redo(){let e=this.future.pop();e&&(this.past.push(pa(this.state)),this.gesture=null,this.replace(e,!1))}open(e,t,n=e){this.past=[],this.future=[],this.gesture=null,this.set({model:e,saved:n,source:t,patch:0,selected:null,pins:[],hover:null,kept:[],compare:"off",canUndo:!1,canRedo:!1,moving:!1,message:null,opened:++this.openings})}remember(){this.past.push(pa(this.state)),this.past.length>500&&this.past.shift()}replace(e,t){let n=Math.min(this.state.patch,e.model.patches.length-1);this.set({...e,patch:n,moving:t,canUndo:this.past.length>0,canRedo:this.future.length>0})}},pa=({model:i,saved:e,source:t,opened:n})=>({model:i,saved:e,source:t,opened:n}),ga=Be.presets.map(Tt),Xs=i=>Be.shapeSets[String(i)]??[],ya=i=>Tt(eh[i]),at=i=>i.model.patches[i.patch];var Xf=new WeakMap;function xa(i){let{model:e,saved:t,compare:n,kept:r,patch:s}=i,o={label:"",model:e,editable:!0};if(n==="before")return[{label:"before",model:t,editable:!1},{...o,label:"now"}];if(n==="kept"&&r.length)return[{...o,label:"now"},...r.map(c=>({...c,editable:!1}))];let a=an(e.patches[s]).length,l=Xs(a);return n==="sets"&&l.length?l.map(c=>({label:`(${c.join(", ").replaceAll("-","−")})`,model:P0(e,c),editable:!0})):[o]}var va=({compare:i},e)=>i==="before"?Math.min(1,e-1):0;function P0(i,e){let t=n=>{if(an(n).length!==e.length||String(an(n))===String(e))return n;let r=Xf.get(n)??new Map;Xf.set(n,r);let s=r.get(String(e))??{...n,shape:e};return r.set(String(e),s),s};return{...i,patches:i.patches.map(t)}}var $f=41,Yf=Array.from({length:$f},(i,e)=>e/($f-1));function I0(i){let e=zr(i),t=[0,1,2];if(!(e.size>0))return{low:e.low,high:e.low};let[n,r,s,o]=Bi(i),a=Yf.map(_=>n+_*(s-n)),l=Yf.map(_=>r+_*(o-r)),{point:c}=Fn(i,a,l,!1,["point"]),h=la(i,a,l),d=!h.includes(1),u=t.map(_=>c.filter((T,A)=>A%3===_&&Number.isFinite(T)&&(d||h[(A-_)/3])).sort()),f=(_,T)=>u[_][Math.round(T*(u[_].length-1))],p=t.map(_=>f(_,0)),v=t.map(_=>f(_,1)),g=t.map(_=>f(_,.1)),m=t.map(_=>f(_,.9)),x=(_,T)=>Math.hypot(...t.map(A=>T[A]-_[A]));if(x(p,v)<=8*x(g,m))return{low:p,high:v};let w=t.map(_=>.5*(m[_]-g[_]));return{low:t.map(_=>Math.max(p[_],g[_]-w[_])),high:t.map(_=>Math.min(v[_],m[_]+w[_]))}}function Jf(i){let e=[1/0,1/0,1/0],t=[-1/0,-1/0,-1/0];for(let n of i.flatMap(({model:r})=>r.patches))try{let r=I0(Et(n));for(let s=0;s<3;s++)e[s]=Math.min(e[s],r.low[s]),t[s]=Math.max(t[s],r.high[s])}catch{}return e[0]<=t[0]?{low:e,high:t}:null}var Zf={centre:[0,0,0],scale:1,half:[1,1,1]};function Kf(i,e){let t=.5*Math.hypot(e[0]-i[0],e[1]-i[1],e[2]-i[2]),n=t>0&&Number.isFinite(t)?1/t:1,r=o=>.5*(i[o]+e[o]),s=o=>.5*n*(e[o]-i[o]);return{centre:[r(0),r(1),r(2)],scale:n,half:[s(0),s(1),s(2)]}}var rn=(i,e)=>[(e[0]-i.centre[0])*i.scale,(e[1]-i.centre[1])*i.scale,(e[2]-i.centre[2])*i.scale],jf=(i,e)=>[e[0]/i.scale+i.centre[0],e[1]/i.scale+i.centre[1],e[2]/i.scale+i.centre[2]];var Qf=[.38,.62],L0=2,N0=16,D0=50;function Th(i,e,t){let{x:n,y:r}=i.project(e,t),s=i.ray(e,n,r),o=i.ray(e,n+1,r),a=Math.hypot(...t.map((l,c)=>l-s.origin[c]));return Math.hypot(...t.map((l,c)=>s.origin[c]+a*s.direction[c]-o.origin[c]-a*o.direction[c]))}function ba(i,e,t,n){let r=58*Th(i,e,t),s=h=>{let{x:d,y:u}=i.project(e,t.map((f,p)=>f+r*h[p]));return[d,u]},o=(h,d)=>[0,1,2].map(u=>u===h?d:0),l=[0,1,2].filter(h=>n[h]).map(h=>({axes:[h],outline:[s(o(h,18/58)),s(o(h,1))]}));return[...[[1,2],[2,0],[0,1]].filter(h=>h.every(d=>n[d])).map(([h,d])=>({axes:[h,d],outline:[[0,0],[1,0],[1,1],[0,1]].map(([u,f])=>s([0,1,2].map(p=>p===h?Qf[u]:p===d?Qf[f]:0)))})).filter(({outline:h})=>Math.abs(F0(h))>D0),...l.filter(({outline:[h,d]})=>Math.hypot(d[0]-h[0],d[1]-h[1])>N0)]}function ep(i,e,t,n){let r=s=>i.findLast(({outline:[o,a,...l]})=>!l.length&&U0(o,a,e,t)<s);return r(L0)??i.findLast(({outline:s})=>s.length>2&&O0(s,e,t))??r(n)??null}var F0=i=>.5*i.reduce((e,[t,n],r)=>e+t*i[(r+1)%i.length][1]-n*i[(r+1)%i.length][0],0);function U0([i,e],[t,n],r,s){let o=t-i,a=n-e,l=Math.min(1,Math.max(0,((r-i)*o+(s-e)*a)/(o*o+a*a)));return Math.hypot(r-i-l*o,s-e-l*a)}function O0(i,e,t){let n=i.map(([r,s],o)=>{let[a,l]=i[(o+1)%i.length];return Math.sign((a-r)*(t-s)-(l-s)*(e-r))});return n.every(r=>r>=0)||n.every(r=>r<=0)}var k0=0,B0=i=>`${i}-${++k0}`,_a=new WeakSet,gr=i=>_a.has(i);function Sa(i,e){i.addEventListener("input",()=>_a.add(i)),i.addEventListener("change",()=>_a.delete(i));let t=()=>{_a.delete(i),e()};i.addEventListener("blur",t),i.addEventListener("keydown",n=>{n.key!=="Escape"||!gr(i)||(n.stopPropagation(),t())})}function tp(i,e,t){i.classList.toggle("wrong",!e),i.title=e?"":`${i.value||"That"} was not taken: expected ${t}`}function Un(i){let{min:e,max:t}=i,{step:n}=i,r=B0("slider"),s=p=>`${100*(Math.min(t,Math.max(e,p))-e)/(t-e)}%`,o=C("input",{type:"range",id:r,min:e,max:t,step:n,"aria-label":i.name}),a=C("input",{type:"number",class:"number",step:n,"aria-label":`${i.name}, number`,...i.hard?{min:e,max:t}:{}}),l=C("div",{class:"track"}),c=NaN,h=()=>{a.value=Number.isNaN(c)?"":String(Number(c.toPrecision(8)))};Sa(a,h),o.addEventListener("input",()=>{u(Number(o.value)),i.onInput(Number(o.value))}),o.addEventListener("change",()=>i.onSettle?.()),a.addEventListener("change",()=>{let p=yh(a),v=Number.isFinite(p)&&(!i.hard||p>=e&&p<=t);if(tp(a,v,i.hard?`a number from ${e} to ${t}`:"a number"),!v||p===c)return h();c=p,h(),i.onInput(p),i.onSettle?.()});let d=(i.marks??[]).map(p=>{let v=C("span",{class:"mark"},String(p).replace("-","−"));return v.style.left=s(p),v}),u=p=>{l.style.setProperty("--share",s(p)),l.style.setProperty("--zero",s(0))};return{element:C("div",{class:"slider"},C("label",{for:r,class:"symbol"},i.label),C("div",{class:"range"},l,o,C("div",{class:"marks","aria-hidden":"true"},...d)),a),update(p){o.value=String(p),c=p,u(p),!gr(a)&&(h(),a.classList.remove("wrong"))},bounds(p,v,g){e=p,t=v,Object.assign(o,{min:String(p),max:String(v),step:String(g)}),a.step=String(g)}}}function ei(i){let e=C("input",{type:"number",class:"number",step:i.step??"any","aria-label":i.name}),t=NaN,n=()=>{e.value=Number.isNaN(t)?"":String(Number(t.toPrecision(10)))};return Sa(e,n),e.addEventListener("change",()=>{let s=yh(e),o=Number.isFinite(s)&&Math.abs(s)<=1e50&&(!i.positive||s>0);if(tp(e,o,i.positive?"a number greater than 0":"a number"),!o||s===t)return n();t=s,n(),i.onChange(s)}),{element:C("label",{class:"field"},C("span",{},i.label),e),update(s){t=s,!gr(e)&&(e.disabled=Number.isNaN(s),n(),e.classList.remove("wrong"))}}}function cn(i,e,t,n=""){let r=C("input",{type:"checkbox",class:"switch"});return r.addEventListener("change",()=>e(r.checked)),{element:C("label",{class:"toggle",title:n||!1},r,C("span",{},i),t),update:o=>{r.checked=o}}}function An(i,e,t){let n=e.map(s=>{let o=C("button",{type:"button",role:"radio",class:"segment",title:s.title??!1,"data-value":s.value},s.label);return o.addEventListener("click",()=>t(s.value)),o}),r=C("div",{class:"segmented",role:"radiogroup","aria-label":i},...n);return r.addEventListener("keydown",s=>{let o={ArrowRight:1,ArrowDown:1,ArrowLeft:-1,ArrowUp:-1}[s.key],a=n.indexOf(s.target);if(!o||a<0)return;s.preventDefault(),s.stopPropagation();let l=(a+o+n.length)%n.length;n[l].focus(),t(e[l].value)}),{element:r,update(s){n.forEach((o,a)=>{let l=e[a].value===s;o.setAttribute("aria-checked",String(l)),o.tabIndex=l||a===0&&!e.some(c=>c.value===s)?0:-1})}}}function $s(i,e,t){let n=s=>s.options.map(o=>C("option",{value:o.value},o.label)),r=C("select",{"aria-label":i},...e.flatMap(s=>s.label?[C("optgroup",{label:s.label},...n(s))]:n(s)));return r.addEventListener("change",()=>t(r.value)),{element:r,update:s=>{r.value=s}}}function je(i,e,t,n="button"){return C("button",{type:"button",class:n,title:e,"aria-label":e,on:{click:t}},i)}function Ys(i,e,t,n="button",r){let s=C("div",{class:"menu",role:"menu","aria-label":e,hidden:!0}),o=C("button",{type:"button",class:n,title:e,"aria-label":e,"aria-haspopup":"menu","aria-expanded":"false"},i),a=C("div",{class:"menu-box"},o,s),l=d=>{s.hidden=!0,o.setAttribute("aria-expanded","false"),d&&o.focus()},c=()=>{s.replaceChildren(...t().map(d=>{if(typeof d=="string")return C("div",{class:"menu-title",role:"presentation"},d);let u=d.reason?C("small",{class:"reason"},d.reason.split(/[:;]\s/)[0]):d.hint?C("small",{},d.hint):null,f=C("button",{type:"button",role:"menuitem",class:"menu-item",title:d.reason??"",disabled:d.disabled??!1},C("span",{},d.label),u);return f.addEventListener("click",()=>{l(!0),d.act()}),f}))},h=()=>{s.hidden=!1,o.setAttribute("aria-expanded","true"),c(),r?.().then(f=>{if(!f||s.hidden)return;let p=[...s.children].indexOf(s.querySelector(":focus"));o.focus(),c(),s.children[p]?.focus()});let d=s.getBoundingClientRect().right,u=a.closest(".studio").getBoundingClientRect().right;s.classList.toggle("to-left",d>u-8),s.querySelector("[role=menuitem]:not([disabled])")?.focus()};return o.addEventListener("click",()=>s.hidden?h():l(!1)),a.addEventListener("focusout",d=>{a.contains(d.relatedTarget)||l(!1)}),a.addEventListener("keydown",d=>{if(s.hidden)return;let u=[...s.querySelectorAll("[role=menuitem]:not([disabled])")],f=u.indexOf(d.target);d.stopPropagation(),d.key==="Escape"?l(!0):(d.key==="ArrowDown"||d.key==="ArrowUp")&&(d.preventDefault(),u[(f+(d.key==="ArrowDown"?1:-1)+u.length)%u.length]?.focus())}),a}function Vi(i,e,...t){return C("details",{class:"section",open:e},C("summary",{},i),C("div",{class:"section-body"},...t))}function rt(i,e=4){if(Number.isNaN(i))return"undefined";if(!Number.isFinite(i))return i>0?"∞":"−∞";if(i===0)return"0";let t=Math.abs(i);return(t>=1e5||t<.001?z0(i,e):String(Number(i.toPrecision(e)))).replace("-","−")}function z0(i,e){let[t,n]=i.toExponential(e-1).split("e");return`${Number(t)}·10${Eh(Number(n))}`}var np=i=>!(i>0)||!Number.isFinite(i)||i>=.01&&i<1e4?0:3*Math.floor(Math.log10(i)/3),Eh=i=>String(i).replace(/[-\d]/g,e=>e==="-"?"⁻":"⁰¹²³⁴⁵⁶⁷⁸⁹"[Number(e)]),Ch=i=>i>0&&i<.001?"<0.1 %":`${rt(100*i,i<.1?2:3)} %`,Ct=i=>i.charAt(0).toUpperCase()+i.slice(1),V0={kappa:"κ",beta:"β",gamma:"γ",alpha:"α",zeta:"ζ",lambda:"λ"};function ti(i){let e=document.createElement("span");e.className="math";let t=i.replace(/\\mathrm\{([^}]*)\}/g,"«$1»").replace(/\\mathbf\{([^}]*)\}/g,"‹$1›").replace(/\\,/g," "),n=/«([^»]*)»|‹([^›]*)›|\\([a-z]+)|([_^])(?:\{([^}]*)\}|(.))|([^\\_^])/g;for(let[,r,s,o,a,l,c,h]of t.matchAll(n))r!==void 0?e.append(Js("span",r,"roman")):s!==void 0?e.append(Js("b",s)):o!==void 0?e.append(Js("i",V0[o]??o)):a?e.append(Js(a==="_"?"sub":"sup",l??c??"")):h&&e.append(/[A-Za-z]/.test(h)?Js("i",h):h);return e}function Js(i,e,t=""){let n=document.createElement(i);return n.textContent=e,t&&(n.className=t),n}function Ma(i,e,t=5){return i.colour==="classes"?i.classes[e]??"undefined":rt(e,t)}var ni=(i,e)=>aa(i,e);var H0={4:["α1","ζ1","α2","ζ2"],2:["α","ζ"]},G0=new Set(["name","kind","shape"]);function Ph(i,e){let t=e.patches.length>1,n=[];return i.unit!==e.unit&&n.push(`unit ${i.unit||"none"} → ${e.unit||"none"}`),i.patches.length!==e.patches.length&&n.push(`${i.patches.length} → ${e.patches.length} patches`),e.patches.forEach((r,s)=>{let o=i.patches[s];!o||o===r||n.push(...W0(o,r,e.unit).map(a=>t?`${r.name}: ${a}`:a))}),n}function W0(i,e,t){if(i.kind!==e.kind)return[`${i.kind} → ${e.kind}`.replaceAll("_"," ")];let n=an(i),r=an(e).flatMap((s,o)=>s===n[o]?[]:[`${H0[n.length]?.[o]??`shape ${o}`} ${rt(n[o]??NaN)} → ${rt(s)}`]);for(let s of new Set([...Object.keys(i),...Object.keys(e)])){let o=$e(i,s),a=$e(e,s);G0.has(s)||JSON.stringify(o)===JSON.stringify(a)||(typeof o=="number"&&typeof a=="number"?r.push(`${s} ${rt(o)} → ${rt(a)}`):Array.isArray(o)&&Array.isArray(a)?r.push(q0(s,Rh(o),Rh(a),t)):r.push(`${s} ${String(o)} → ${String(a)}`))}return r}function q0(i,e,t,n){if(e.length!==t.length)return`${i}: ${e.length} → ${t.length} points`;let r=t.map((l,c)=>Math.hypot(...l.map((h,d)=>h-(e[c][d]??0)))),s=r.filter(l=>l>0).length,o=rt(Math.max(...r)),a=i==="planes"||i==="bounds"?"":n&&` ${n}`;return`${i}: ${s} of ${t.length} moved, by ${s>1?"up to ":""}${o}${a}`}var Rh=i=>i.every(e=>typeof e=="number")?[i]:i.flatMap(e=>Array.isArray(e)?Rh(e):[]);function On(i,e,t,n){return new Promise(r=>{let s=C("dialog",{"aria-label":e}),o=l=>{s.close(),s.remove(),r(l)},a=C("form",{method:"dialog"},C("h2",{},e),C("div",{class:"dialog-body"},...t),C("div",{class:"dialog-buttons"},...n.map(([l,c],h)=>je(c,c,()=>o(l),h===0?"button primary":"button"))));a.addEventListener("submit",l=>{l.preventDefault(),o(n[0]?.[0]??null)}),s.addEventListener("cancel",l=>{l.preventDefault(),o(null)}),s.addEventListener("keydown",l=>l.stopPropagation()),s.append(a),i.append(s),s.showModal(),(a.querySelector("input")??a.querySelector(".primary"))?.focus()})}async function ip(i,e,t){let n=C("input",{type:"text",value:t,"aria-label":"File name",spellcheck:"false"});return await On(i,e,[C("label",{class:"field wide"},C("span",{},"File name"),n),C("p",{class:"hint"},"Ends in .toml or .json; saved in the folder that the studio was opened on.")],[["save","Save"],["cancel","Cancel"]])==="save"?n.value.trim():null}async function rp(i,e,t,n){let r=C("input",{type:"number",class:"number",min:0,step:"any",placeholder:"usual","aria-label":`Tolerance${t?` in ${t}`:""}`}),s=[C("label",{class:"field wide"},C("span",{},`Tolerance${t?` (${t})`:""}`),r),C("p",{class:"hint"},"How far the file may be from the surface. Left empty: a mesh keeps to a thousandth of its size, a flat pattern to what a cutter can do."),...n?[C("p",{class:"hint"},`Colours as shown: ${n}, where the format has colours.`)]:[]];for(;;){if(await On(i,`Export ${e}`,s,[["export","Export"],["cancel","Cancel"]])!=="export")return null;if(!r.value&&r.validity.valid)return{tolerance:null};let a=Number(r.value);if(r.validity.valid&&a>0&&a<1/0)return{tolerance:a};s.some(l=>l.classList.contains("error"))||s.push(C("p",{class:"hint error",role:"alert"},"Expected a length greater than 0, or nothing."))}}async function sp(i,e,t){let n=(f,p)=>C("input",{type:"number",class:"number",min:64,max:8192,step:1,value:p,"aria-label":f}),r=n("Width in pixels",Math.round(e)),s=n("Height in pixels",Math.round(t)),o=(f,p)=>{r.value=String(f),s.value=String(p)},a=C("div",{class:"chips"},je("1920 × 1080","1920 × 1080",()=>o(1920,1080),"chip"),je("3840 × 2160","3840 × 2160",()=>o(3840,2160),"chip"),je("2000 × 2000","2000 × 2000",()=>o(2e3,2e3),"chip")),l=C("select",{"aria-label":"Background"},C("option",{value:"theme"},"As shown"),C("option",{value:"white"},"White"),C("option",{value:"none"},"Transparent")),c=!0,h=cn("With legend",f=>c=f);if(h.update(!0),await On(i,"Save a picture",[C("div",{class:"pair"},C("label",{class:"field"},C("span",{},"Width"),r),C("label",{class:"field"},C("span",{},"Height"),s)),a,C("label",{class:"row"},C("span",{class:"caption"},"Background"),l),h.element],[["save","Save PNG"],["cancel","Cancel"]])!=="save")return null;let u=(f,p)=>Math.min(8192,Math.max(64,Math.round(Number(f.value))||p));return{width:u(r,e),height:u(s,t),background:l.value,legend:c}}var X0=[["Ctrl Z, Ctrl Shift Z","undo, redo"],["Ctrl S, Ctrl O","save, open"],["1 to 6","views: oblique, top, side, back, front, bottom"],["P","perspective or parallel"],["F","fit"],["N","control net"],["I","iso-curves"],["W","wireframe"],["Z","zebra"],["C","compare: next arrangement"],["arrows","turn the view, or move the chosen point by the snap step"],["Shift arrows","pan, or move by ten steps"],["+ −","zoom"],["[ ]","choose the control point before or after"],["Esc","let go of the point"],["Enter","pin the point in the middle of the picture"]],Ih=i=>On(i,"Keys and pointer",[C("p",{},"Drag to turn, with Shift or the right button to pan, wheel to zoom; on a screen to touch, two fingers pan and zoom. Drag a control point to move it. Click the surface to pin a point."),C("dl",{class:"keys-list"},...X0.flatMap(([e,t])=>[C("dt",{},e),C("dd",{},t)])),C("p",{class:"hint"},"Grey is where a quantity has no value. The signs of H, κ1, κ2 and S follow the normal; the bar at the bottom says which way it points.")],[["close","Close"]]);var Lh=5,Nh=2;function Dh(i){let{model:e,kept:t}=i.state;if(t.length>=Lh)return i.set({compare:"kept",message:{kind:"note",text:`${Lh} are kept already: delete one first`}});let n=new Set(t.map(s=>s.label)),r=Array.from({length:Lh+1},(s,o)=>o+1).find(s=>!n.has(`kept ${s}`));i.set({kept:[...t,{label:`kept ${r}`,model:e}],compare:"kept"})}function Fh(i,e){let t=Ph(i.kept[e].model,i.model);return t.length?`now: ${t.slice(0,Nh).join("; ")}${t.length>Nh?`; ${t.length-Nh} more`:""}`:"same as now"}function op(i,e){let{label:t,model:n}=i.state.kept[e],r=Ph(n,i.state.model).join(`
`),s=()=>i.state.kept.findIndex(l=>l.model===n&&l.label===t),o=l=>i.set({kept:i.state.kept.flatMap((c,h)=>h===s()?l(c):[c])}),a=C("div",{class:"kept"},C("div",{class:"kept-tools"},je("Restore",`Restore ${t}`,()=>i.edit(n),"button"),je("Rename",`Rename ${t}`,()=>{$0(a.closest(".studio"),t).then(l=>l&&o(c=>[{...c,label:l}]))},"button"),je("Delete",`Delete ${t}`,()=>{o(()=>[]),i.state.kept.length||i.set({compare:"off"})},"button")),C("div",{class:"differs",title:r||!1},Fh(i.state,e)));return a}async function $0(i,e){let t=C("input",{type:"text",value:e,maxlength:60,"aria-label":"Name of the variant"});return await On(i,"Rename",[C("label",{class:"field wide"},C("span",{},"Name"),t)],[["rename","Rename"],["cancel","Cancel"]])==="rename"?t.value.trim():""}var Y0=["gaussian","mean","k1","k2","shape_index","curvedness","hk_type","shape_class","point_type"];function Zs(i,e){return Fn(Et(i.patches[e.patch]),[e.u],[e.v],!0)}var ap=(i,{patch:e,u:t,v:n})=>qr(Et(i.patches[e]),t,n);function Uh(i,e,t=0){let n=i[e.key][t];return e.colour==="classes"||e.power>=0?n:Math.abs(n)<=Be.limits.noise*i.curvedness[0]**-e.power?0:n}var J0=(i,e)=>`normal ${Br(Et(i))} S_u x S_v${e?` on ${i.name.replaceAll(`
`," ")}`:""}`,wa=class{constructor(e,t){this.store=e;this.unfolded=t;let n=ei({label:C("i",{class:"math"},"u"),name:"u to pin",step:.05,onChange:a=>this.u=Math.min(1,Math.max(0,a))}),r=ei({label:C("i",{class:"math"},"v"),name:"v to pin",step:.05,onChange:a=>this.v=Math.min(1,Math.max(0,a))});n.update(this.u),r.update(this.v);let s=cn("All quantities",a=>{this.all=a,this.refresh(e.state)}),o=C("div",{class:"probe-tools"},n.element,r.element,je("Pin","Pin the point at these parameters",()=>this.add()),s.element,C("span",{class:"spacer"}),je("CSV","Save the table as CSV",()=>this.save()),je("Clear","Clear: remove all pins",()=>e.set({pins:[]})));this.element=C("details",{class:"probe"},C("summary",{},yt(vt.pin),"Probe",this.count,C("span",{class:"hint"},"click the surface to pin a point")),o,this.body),this.element.addEventListener("toggle",()=>this.unfolded()),e.subscribe((a,l)=>{a.pins.length>l.pins.length&&(this.element.open=!0),(a.pins!==l.pins||a.model!==l.model&&a.pins.length)&&this.refresh(a)})}store;unfolded;element;body=C("div",{class:"probe-body"});count=C("span",{class:"badge"});all=!1;u=.5;v=.5;add(){let{pins:e,patch:t}=this.store.state;this.store.set({pins:[...e,{patch:t,u:this.u,v:this.v}]})}columns(){return(this.all?jn.map(t=>t.key):["point",...Y0]).flatMap(t=>{let n=st[t];return n.components===1?[{q:n,part:0,head:n.symbol}]:["x","y","z"].map((r,s)=>({q:n,part:s,head:t==="point"?r:`${n.symbol} ${r}`}))})}refresh(e){if(this.count.textContent=e.pins.length?String(e.pins.length):"",!e.pins.length){this.body.replaceChildren();return}let t=e.model.patches.length>1,n=this.columns(),r=C("tr",{},C("th",{},"#"),t?C("th",{},"patch"):null,C("th",{},C("i",{class:"math"},"u")),C("th",{},C("i",{class:"math"},"v")),...n.map(({q:o,head:a})=>C("th",{title:Ct(o.name)},o.components===1?o.colour==="classes"?Ct(o.name):ti(o.latex):C("i",{class:"math"},a),ni(o,e.model.unit)?C("span",{class:"unit"},ni(o,e.model.unit)):null)),C("th",{})),s=e.pins.map((o,a)=>{let l=Zs(e.model,o),c=je(yt(vt.close),`Remove pin ${a+1}`,()=>this.store.set({pins:e.pins.filter(h=>h!==o)}),"tiny");return C("tr",{},C("td",{},C("span",{class:"pin-number"},a+1)),t?C("td",{},e.model.patches[o.patch].name):null,C("td",{},rt(o.u)),C("td",{},rt(o.v)),...ap(e.model,o)?n.map(({q:h,part:d})=>C("td",{class:h.colour==="classes"?"word":""},Ma(h,Uh(l,h,d)))):[C("td",{class:"word",colspan:n.length},"outside the trimmed face")],C("td",{},c))});this.body.replaceChildren(C("table",{},C("thead",{},r),C("tbody",{},...s)))}save(){let{model:e,pins:t}=this.store.state,n=jn.flatMap(c=>Array.from({length:c.components},(h,d)=>({q:c,part:d}))),r=({q:c,part:h})=>c.components===1?c.key:`${c.key}_${"xyz"[h]}`,s=n.map(({q:c})=>[c.key,ni(c,e.unit)]).filter(([,c])=>c),o=c=>c.replaceAll(/(^|[,;])(\s*)(?=[=+\-@])/g,"$1$2'"),a=c=>/[",\n]/.test(c)?`"${c.replaceAll('"','""')}"`:c,l=[`# ${o(e.name.replaceAll(`
`," "))}: ${[...new Set(t.map(c=>c.patch))].map(c=>J0(e.patches[c],e.patches.length>1)).join(", ")}`,...s.length?[`# Units: ${[...new Map(s)].map(([c,h])=>`${c} in ${h}`).join(", ")}`]:[],["patch","u","v",...n.map(r)].join(","),...t.map(c=>{let h=Zs(e,c),d=ap(e,c),u=({q:f,part:p})=>{let v=h[f.key][p];return d?f.colour==="classes"?a(f.classes[v]):Number.isNaN(v)?"":String(v):""};return[a(o(e.patches[c.patch].name)),c.u,c.v,...n.map(u)].join(",")})];Zn(`${Kn(e.name)}_probe.csv`,`${l.join(`
`)}
`,"text/csv")}};var Ks="http://www.w3.org/2000/svg",Oh=["x","y","z"],Aa=class{constructor(e,t,n){this.store=e;this.stage=t;let r=(s,o,a)=>je(o,a,()=>n.view(s),"button view-button");this.projection=An("Projection",[{value:"perspective",label:"Perspective"},{value:"orthographic",label:"Parallel",title:"Orthographic: lengths in the plane of the picture are true"}],s=>{this.stage.orbit.straight=!1,e.setting({projection:s})}),this.triad.setAttribute("viewBox","-32 -32 64 64"),this.triad.setAttribute("class","triad"),this.triad.setAttribute("aria-hidden","true"),this.gizmo.setAttribute("class","gizmo"),this.gizmo.setAttribute("aria-hidden","true"),this.element.append(this.cells,this.gizmo,this.marks,this.tip,this.triad,C("div",{class:"view-tools",role:"toolbar","aria-label":"View"},r("iso","Oblique","Oblique view (1)"),r("top","Top","Top view, along −z (2)"),r("side","Side","Side view, along +y (3)"),r("back","Back","Back view, along −x (4)"),r("front","Front","Front view, along +x (5)"),r("bottom","Bottom","Bottom view, along +z (6)"),je(yt(vt.fit),"Fit (F)",n.fit,"button square"),this.projection.element))}store;stage;element=C("div",{class:"hud"});cells=C("div",{class:"cells"});marks=C("div",{class:"marks-layer"});tip=C("div",{class:"tip",hidden:!0,role:"status"});triad=document.createElementNS(Ks,"svg");gizmo=document.createElementNS(Ks,"svg");projection;named="";labels(e,t){let n=t.compare==="kept"&&e.length>1?1:e.length,{cells:r}=this.stage,s=JSON.stringify(r.map((o,a)=>[e[a],o.x,o.y,o.width,o.height,a>=n&&Fh(t,a-n)]));s!==this.named&&(this.named=s,this.cells.replaceChildren(...r.map((o,a)=>{let l=C("div",{class:"cell"},e[a]?C("span",{class:"cell-label"},e[a]):null,a>=n?op(this.store,a-n):null);return Object.assign(l.style,{left:`${o.x}px`,top:`${o.y}px`,width:`${o.width}px`,height:`${o.height}px`}),l})))}refresh(e,t,n){this.projection.update(this.stage.orbit.projection),this.drawTriad();let r=[],s=(l,c,h)=>{let d=this.stage.project(l,rn(t,c)),u=this.stage.cells[l];d.x<u.x||d.x>u.x+u.width||d.y<u.y||d.y>u.y+u.height||(r.length<8&&!e.moving&&h.classList.toggle("behind",this.stage.hides(l,rn(t,c),e.settings,t)),h.style.transform=`translate(${d.x.toFixed(1)}px, ${d.y.toFixed(1)}px)`,r.push(h))},o=va(e,this.stage.cells.length);this.drawGizmo(e,t,o),e.pins.forEach((l,c)=>{l.patch<e.model.patches.length&&s(o,Array.from(Zs(e.model,l).point),C("span",{class:"pin"},C("b",{},c+1)))});let a=e.model.unit?` ${e.model.unit}`:"";for(let{cell:l,at:c}of n)s(l,c.point,C("span",{class:"sharpest"},C("b",{},"r",C("sub",{},"min"),` = ${rt(c.radius)}${a}`)));this.marks.replaceChildren(...r),this.showTip(e)}drawGizmo(e,t,n){let r=e.settings.net&&da(at(e)).find(o=>o.id===e.selected),s=r&&!r.along?ba(this.stage,n,rn(t,r.position),r.free.map((o,a)=>o&&!e.settings.locks[a])):[];this.gizmo.replaceChildren(...s.map(({axes:o,outline:a})=>{let l=document.createElementNS(Ks,"polygon");return l.setAttribute("points",a.map(c=>c.map(h=>h.toFixed(1)).join(",")).join(" ")),l.setAttribute("class",o.length===1?`arm axis-${Oh[o[0]]}`:`square axis-${Oh[3-o[0]-o[1]]}`),l}))}showTip(e){let{hover:t}=e;if(!t||t.patch>=e.model.patches.length)return void(this.tip.hidden=!0);let n=this.stage.cells[t.cell]?.pieces[t.patch];if(!n?.patch)return void(this.tip.hidden=!0);let r=Zs({...e.model,patches:[n.patch]},{...t,patch:0}),s=[...new Set([e.settings.quantity==="none"?"gaussian":e.settings.quantity,"gaussian","mean","hk_type","shape_class"])],o=(u,f,p="")=>C("tr",{},C("th",{},u),C("td",{},f,p?C("span",{class:"unit"},p):null)),a=r.point;this.tip.replaceChildren(C("div",{class:"tip-title"},`u = ${rt(t.u)}, v = ${rt(t.v)}`),C("div",{class:"tip-point"},`(${Array.from(a,u=>rt(u)).join(", ")})${e.model.unit?` ${e.model.unit}`:""}`),C("table",{},...s.map(u=>{let f=st[u];return o(f.colour==="classes"?f.name:ti(f.latex),Ma(f,Uh(r,f)),ni(f,e.model.unit))})),C("div",{class:"tip-words"},oa("hk_type",r.hk_type[0]))),this.tip.hidden=!1;let l=this.element.getBoundingClientRect(),c=this.tip.getBoundingClientRect(),h=t.x+18+c.width>l.width?t.x-18-c.width:t.x+18,d=Math.min(Math.max(6,t.y+14),l.height-c.height-6);this.tip.style.transform=`translate(${Math.round(h)}px, ${Math.round(d)}px)`}drawTriad(){let{right:e,up:t,towards:n}=this.stage.orbit.axes(),r=Oh.map((s,o)=>{let a=l=>[l.x,l.y,l.z][o];return{name:s,x:20*a(e),y:-20*a(t),depth:a(n)}}).sort((s,o)=>s.depth-o.depth);this.triad.replaceChildren(...r.flatMap(({name:s,x:o,y:a})=>{let l=document.createElementNS(Ks,"line"),c=document.createElementNS(Ks,"text");return l.setAttribute("x2",String(o)),l.setAttribute("y2",String(a)),l.setAttribute("class",`axis-${s}`),c.setAttribute("x",String(o*1.32)),c.setAttribute("y",String(a*1.32)),c.textContent=s,[l,c]}))}};var Lp=0,du=1,Np=2;var Ao=1,Dp=2,vs=3,er=0,jt=1,Rn=2,wr=0,bs=1,fu=2,pu=3,mu=4,Fp=5;var Ar=100,Up=101,Op=102,kp=103,Bp=104,zp=200,Vp=201,Hp=202,Gp=203,gu=204,yu=205,Wp=206,qp=207,Xp=208,$p=209,Yp=210,Jp=211,Zp=212,Kp=213,jp=214,Za=0,Ka=1,ja=2,cs=3,Qa=4,el=5,hs=6,tl=7,xu=0,Qp=1,em=2,ai=0,vu=1,bu=2,_u=3,Su=4,Mu=5,wu=6,Au=7;var Tu=300,Tr=301,_s=302,El=303,Cl=304,nl=1e3,ri=1001,il=1002,St=1003,tm=1004;var To=1005;var Ft=1006,Rl=1007;var Ei=1008;var Qt=1009,Eu=1010,Cu=1011,Ss=1012,Pl=1013,Hn=1014,gn=1015,Gn=1016,Il=1017,Ll=1018,Er=1020,Ru=35902,Pu=35899,Iu=1021,Lu=1022,yn=1023,Ai=1026,Ci=1027,Eo=1028,Nl=1029,tr=1030,Dl=1031;var Fl=1033,Co=33776,Ro=33777,Po=33778,Io=33779,Ul=35840,Ol=35841,kl=35842,Bl=35843,zl=36196,Vl=37492,Hl=37496,Gl=37488,Wl=37489,Lo=37490,ql=37491,Xl=37808,$l=37809,Yl=37810,Jl=37811,Zl=37812,Kl=37813,jl=37814,Ql=37815,ec=37816,tc=37817,nc=37818,ic=37819,rc=37820,sc=37821,oc=36492,ac=36494,lc=36495,cc=36283,hc=36284,No=36285,uc=36286;var io=2300,rl=2301,Ya=2302,su=2303,ou=2400,au=2401,lu=2402;var nm=3200;var Nu=0,im=1,Ri="",dn="srgb",ro="srgb-linear",so="linear",nt="srgb";var Ja=7680;var rm=519,sm=512,om=513,am=514,Du=515,lm=516,cm=517,Fu=518,Uu=519,Ou=35044,Ms=35048;var Pi="300 es",En=2e3,oo=2001;function Z0(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function K0(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function ao(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function hm(){let i=ao("canvas");return i.style.display="block",i}var lp={},us=null;function lo(...i){let e="THREE."+i.shift();us?us("log",e,...i):console.log(e,...i)}function um(i){let e=i[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=i[1];t&&t.isStackTrace?i[0]+=" "+t.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function Ie(...i){i=um(i);let e="THREE."+i.shift();if(us)us("warn",e,...i);else{let t=i[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...i)}}function Ne(...i){i=um(i);let e="THREE."+i.shift();if(us)us("error",e,...i);else{let t=i[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...i)}}function no(...i){let e=i.join(" ");e in lp||(lp[e]=!0,Ie(...i))}function dm(i,e,t){return new Promise(function(n,r){function s(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:r();break;case i.TIMEOUT_EXPIRED:setTimeout(s,t);break;default:n()}}setTimeout(s,t)})}var fm={[Za]:Za,[ja]:hs,[Qa]:Qa,[cs]:el,[Ka]:Ka,[hs]:ja,[tl]:tl,[el]:cs},si=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let r=n[e];if(r!==void 0){let s=r.indexOf(t);s!==-1&&r.splice(s,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let r=n.slice(0);for(let s=0,o=r.length;s<o;s++)r[s].call(this,e);e.target=null}}},Gt=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var kh=Math.PI/180,sl=180/Math.PI;function Cr(){let i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(Gt[i&255]+Gt[i>>8&255]+Gt[i>>16&255]+Gt[i>>24&255]+"-"+Gt[e&255]+Gt[e>>8&255]+"-"+Gt[e>>16&15|64]+Gt[e>>24&255]+"-"+Gt[t&63|128]+Gt[t>>8&255]+"-"+Gt[t>>16&255]+Gt[t>>24&255]+Gt[n&255]+Gt[n>>8&255]+Gt[n>>16&255]+Gt[n>>24&255]).toLowerCase()}function Je(i,e,t){return Math.max(e,Math.min(t,i))}function j0(i,e){return(i%e+e)%e}function Bh(i,e,t){return(1-t)*i+t*e}function pm(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function dc(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function mm(i,e){if(e.constructor===Float32Array)return i;let t=dc(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/t,-1)}function gm(i,e){if(e.constructor===Float32Array)return i;let t=dc(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*t)}var Ge=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6],this.y=r[1]*t+r[4]*n+r[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=Je(this.x,e.x,t.x),this.y=Je(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=Je(this.x,e,t),this.y=Je(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Je(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(Je(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),r=Math.sin(t),s=this.x-e.x,o=this.y-e.y;return this.x=s*n-o*r+e.x,this.y=s*r+o*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},oi=class{constructor(e=0,t=0,n=0,r=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=r}static slerpFlat(e,t,n,r,s,o,a){let l=n[r+0],c=n[r+1],h=n[r+2],d=n[r+3],u=s[o+0],f=s[o+1],p=s[o+2],v=s[o+3];if(d!==v||l!==u||c!==f||h!==p){let g=l*u+c*f+h*p+d*v;g<0&&(u=-u,f=-f,p=-p,v=-v,g=-g);let m=1-a;if(g<.9995){let x=Math.acos(g),w=Math.sin(x);m=Math.sin(m*x)/w,a=Math.sin(a*x)/w,l=l*m+u*a,c=c*m+f*a,h=h*m+p*a,d=d*m+v*a}else{l=l*m+u*a,c=c*m+f*a,h=h*m+p*a,d=d*m+v*a;let x=1/Math.sqrt(l*l+c*c+h*h+d*d);l*=x,c*=x,h*=x,d*=x}}e[t]=l,e[t+1]=c,e[t+2]=h,e[t+3]=d}static multiplyQuaternionsFlat(e,t,n,r,s,o){let a=n[r],l=n[r+1],c=n[r+2],h=n[r+3],d=s[o],u=s[o+1],f=s[o+2],p=s[o+3];return e[t]=a*p+h*d+l*f-c*u,e[t+1]=l*p+h*u+c*d-a*f,e[t+2]=c*p+h*f+a*u-l*d,e[t+3]=h*p-a*d-l*u-c*f,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,r){return this._x=e,this._y=t,this._z=n,this._w=r,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,r=e._y,s=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(n/2),h=a(r/2),d=a(s/2),u=l(n/2),f=l(r/2),p=l(s/2);switch(o){case"XYZ":this._x=u*h*d+c*f*p,this._y=c*f*d-u*h*p,this._z=c*h*p+u*f*d,this._w=c*h*d-u*f*p;break;case"YXZ":this._x=u*h*d+c*f*p,this._y=c*f*d-u*h*p,this._z=c*h*p-u*f*d,this._w=c*h*d+u*f*p;break;case"ZXY":this._x=u*h*d-c*f*p,this._y=c*f*d+u*h*p,this._z=c*h*p+u*f*d,this._w=c*h*d-u*f*p;break;case"ZYX":this._x=u*h*d-c*f*p,this._y=c*f*d+u*h*p,this._z=c*h*p-u*f*d,this._w=c*h*d+u*f*p;break;case"YZX":this._x=u*h*d+c*f*p,this._y=c*f*d+u*h*p,this._z=c*h*p-u*f*d,this._w=c*h*d-u*f*p;break;case"XZY":this._x=u*h*d-c*f*p,this._y=c*f*d-u*h*p,this._z=c*h*p+u*f*d,this._w=c*h*d+u*f*p;break;default:Ie("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,r=Math.sin(n);return this._x=e.x*r,this._y=e.y*r,this._z=e.z*r,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],r=t[4],s=t[8],o=t[1],a=t[5],l=t[9],c=t[2],h=t[6],d=t[10],u=n+a+d;if(u>0){let f=.5/Math.sqrt(u+1);this._w=.25/f,this._x=(h-l)*f,this._y=(s-c)*f,this._z=(o-r)*f}else if(n>a&&n>d){let f=2*Math.sqrt(1+n-a-d);this._w=(h-l)/f,this._x=.25*f,this._y=(r+o)/f,this._z=(s+c)/f}else if(a>d){let f=2*Math.sqrt(1+a-n-d);this._w=(s-c)/f,this._x=(r+o)/f,this._y=.25*f,this._z=(l+h)/f}else{let f=2*Math.sqrt(1+d-n-a);this._w=(o-r)/f,this._x=(s+c)/f,this._y=(l+h)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(Je(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let r=Math.min(1,t/n);return this.slerp(e,r),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,r=e._y,s=e._z,o=e._w,a=t._x,l=t._y,c=t._z,h=t._w;return this._x=n*h+o*a+r*c-s*l,this._y=r*h+o*l+s*a-n*c,this._z=s*h+o*c+n*l-r*a,this._w=o*h-n*a-r*l-s*c,this._onChangeCallback(),this}slerp(e,t){let n=e._x,r=e._y,s=e._z,o=e._w,a=this.dot(e);a<0&&(n=-n,r=-r,s=-s,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),h=Math.sin(c);l=Math.sin(l*c)/h,t=Math.sin(t*c)/h,this._x=this._x*l+n*t,this._y=this._y*l+r*t,this._z=this._z*l+s*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+n*t,this._y=this._y*l+r*t,this._z=this._z*l+s*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),r=Math.sqrt(1-n),s=Math.sqrt(n);return this.set(r*Math.sin(e),r*Math.cos(e),s*Math.sin(t),s*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},B=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,n=0){this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(cp.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(cp.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,r=this.z,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6]*r,this.y=s[1]*t+s[4]*n+s[7]*r,this.z=s[2]*t+s[5]*n+s[8]*r,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,r=this.z,s=e.elements,o=1/(s[3]*t+s[7]*n+s[11]*r+s[15]);return this.x=(s[0]*t+s[4]*n+s[8]*r+s[12])*o,this.y=(s[1]*t+s[5]*n+s[9]*r+s[13])*o,this.z=(s[2]*t+s[6]*n+s[10]*r+s[14])*o,this}applyQuaternion(e){let t=this.x,n=this.y,r=this.z,s=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*r-a*n),h=2*(a*t-s*r),d=2*(s*n-o*t);return this.x=t+l*c+o*d-a*h,this.y=n+l*h+a*c-s*d,this.z=r+l*d+s*h-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,r=this.z,s=e.elements;return this.x=s[0]*t+s[4]*n+s[8]*r,this.y=s[1]*t+s[5]*n+s[9]*r,this.z=s[2]*t+s[6]*n+s[10]*r,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=Je(this.x,e.x,t.x),this.y=Je(this.y,e.y,t.y),this.z=Je(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=Je(this.x,e,t),this.y=Je(this.y,e,t),this.z=Je(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Je(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,r=e.y,s=e.z,o=t.x,a=t.y,l=t.z;return this.x=r*l-s*a,this.y=s*o-n*l,this.z=n*a-r*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return zh.copy(this).projectOnVector(e),this.sub(zh)}reflect(e){return this.sub(zh.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(Je(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,r=this.z-e.z;return t*t+n*n+r*r}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let r=Math.sin(t)*e;return this.x=r*Math.sin(n),this.y=Math.cos(t)*e,this.z=r*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),r=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=r,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},zh=new B,cp=new oi,Fe=class{static{this.prototype.isMatrix3=!0}constructor(e,t,n,r,s,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,r,s,o,a,l,c)}set(e,t,n,r,s,o,a,l,c){let h=this.elements;return h[0]=e,h[1]=r,h[2]=a,h[3]=t,h[4]=s,h[5]=l,h[6]=n,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,r=t.elements,s=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],h=n[4],d=n[7],u=n[2],f=n[5],p=n[8],v=r[0],g=r[3],m=r[6],x=r[1],w=r[4],_=r[7],T=r[2],A=r[5],y=r[8];return s[0]=o*v+a*x+l*T,s[3]=o*g+a*w+l*A,s[6]=o*m+a*_+l*y,s[1]=c*v+h*x+d*T,s[4]=c*g+h*w+d*A,s[7]=c*m+h*_+d*y,s[2]=u*v+f*x+p*T,s[5]=u*g+f*w+p*A,s[8]=u*m+f*_+p*y,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],r=e[2],s=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8];return t*o*h-t*a*c-n*s*h+n*a*l+r*s*c-r*o*l}invert(){let e=this.elements,t=e[0],n=e[1],r=e[2],s=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],d=h*o-a*c,u=a*l-h*s,f=c*s-o*l,p=t*d+n*u+r*f;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let v=1/p;return e[0]=d*v,e[1]=(r*c-h*n)*v,e[2]=(a*n-r*o)*v,e[3]=u*v,e[4]=(h*t-r*l)*v,e[5]=(r*s-a*t)*v,e[6]=f*v,e[7]=(n*l-c*t)*v,e[8]=(o*t-n*s)*v,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,r,s,o,a){let l=Math.cos(s),c=Math.sin(s);return this.set(n*l,n*c,-n*(l*o+c*a)+o+e,-r*c,r*l,-r*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return no("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Vh.makeScale(e,t)),this}rotate(e){return no("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Vh.makeRotation(-e)),this}translate(e,t){return no("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Vh.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let r=0;r<9;r++)if(t[r]!==n[r])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}},Vh=new Fe,hp=new Fe().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),up=new Fe().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Q0(){let i={enabled:!0,workingColorSpace:ro,spaces:{},convert:function(r,s,o){return this.enabled===!1||s===o||!s||!o||(this.spaces[s].transfer===nt&&(r.r=wi(r.r),r.g=wi(r.g),r.b=wi(r.b)),this.spaces[s].primaries!==this.spaces[o].primaries&&(r.applyMatrix3(this.spaces[s].toXYZ),r.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===nt&&(r.r=ls(r.r),r.g=ls(r.g),r.b=ls(r.b))),r},workingToColorSpace:function(r,s){return this.convert(r,this.workingColorSpace,s)},colorSpaceToWorking:function(r,s){return this.convert(r,s,this.workingColorSpace)},getPrimaries:function(r){return this.spaces[r].primaries},getTransfer:function(r){return r===Ri?so:this.spaces[r].transfer},getToneMappingMode:function(r){return this.spaces[r].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(r,s=this.workingColorSpace){return r.fromArray(this.spaces[s].luminanceCoefficients)},define:function(r){Object.assign(this.spaces,r)},_getMatrix:function(r,s,o){return r.copy(this.spaces[o].fromXYZ).multiply(this.spaces[s].toXYZ)},_getDrawingBufferColorSpace:function(r){return this.spaces[r].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(r=this.workingColorSpace){return this.spaces[r].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[ro]:{primaries:e,whitePoint:n,transfer:so,toXYZ:hp,fromXYZ:up,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:dn},outputColorSpaceConfig:{drawingBufferColorSpace:dn}},[dn]:{primaries:e,whitePoint:n,transfer:nt,toXYZ:hp,fromXYZ:up,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:dn}}}),i}var Ye=Q0();function wi(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function ls(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var Jr,ol=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{Jr===void 0&&(Jr=ao("canvas")),Jr.width=e.width,Jr.height=e.height;let r=Jr.getContext("2d");e instanceof ImageData?r.putImageData(e,0,0):r.drawImage(e,0,0,e.width,e.height),n=Jr}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=ao("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let r=n.getImageData(0,0,e.width,e.height),s=r.data;for(let o=0;o<s.length;o++)s[o]=wi(s[o]/255)*255;return n.putImageData(r,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(wi(t[n]/255)*255):t[n]=wi(t[n]);return{data:t,width:e.width,height:e.height}}else return Ie("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},ey=0,ds=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:ey++}),this.uuid=Cr(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},r=this.data;if(r!==null){let s;if(Array.isArray(r)){s=[];for(let o=0,a=r.length;o<a;o++)r[o].isDataTexture?s.push(Hh(r[o].image)):s.push(Hh(r[o]))}else s=Hh(r);n.url=s}return t||(e.images[this.uuid]=n),n}};function Hh(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?ol.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(Ie("Texture: Unable to serialize Texture."),{})}var ty=0,Gh=new B,Kt=class i extends si{constructor(e=i.DEFAULT_IMAGE,t=i.DEFAULT_MAPPING,n=ri,r=ri,s=Ft,o=Ei,a=yn,l=Qt,c=i.DEFAULT_ANISOTROPY,h=Ri){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:ty++}),this.uuid=Cr(),this.name="",this.source=new ds(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=r,this.magFilter=s,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Ge(0,0),this.repeat=new Ge(1,1),this.center=new Ge(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new Fe,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Gh).x}get height(){return this.source.getSize(Gh).y}get depth(){return this.source.getSize(Gh).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){Ie(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let r=this[t];if(r===void 0){Ie(`Texture.setValues(): property '${t}' does not exist.`);continue}r&&n&&r.isVector2&&n.isVector2||r&&n&&r.isVector3&&n.isVector3||r&&n&&r.isMatrix3&&n.isMatrix3?r.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Tu)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case nl:e.x=e.x-Math.floor(e.x);break;case ri:e.x=e.x<0?0:1;break;case il:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case nl:e.y=e.y-Math.floor(e.y);break;case ri:e.y=e.y<0?0:1;break;case il:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};Kt.DEFAULT_IMAGE=null;Kt.DEFAULT_MAPPING=Tu;Kt.DEFAULT_ANISOTROPY=1;var lt=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,n=0,r=1){this.x=e,this.y=t,this.z=n,this.w=r}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,r){return this.x=e,this.y=t,this.z=n,this.w=r,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,r=this.z,s=this.w,o=e.elements;return this.x=o[0]*t+o[4]*n+o[8]*r+o[12]*s,this.y=o[1]*t+o[5]*n+o[9]*r+o[13]*s,this.z=o[2]*t+o[6]*n+o[10]*r+o[14]*s,this.w=o[3]*t+o[7]*n+o[11]*r+o[15]*s,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,r,s,l=e.elements,c=l[0],h=l[4],d=l[8],u=l[1],f=l[5],p=l[9],v=l[2],g=l[6],m=l[10];if(Math.abs(h-u)<.01&&Math.abs(d-v)<.01&&Math.abs(p-g)<.01){if(Math.abs(h+u)<.1&&Math.abs(d+v)<.1&&Math.abs(p+g)<.1&&Math.abs(c+f+m-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let w=(c+1)/2,_=(f+1)/2,T=(m+1)/2,A=(h+u)/4,y=(d+v)/4,M=(p+g)/4;return w>_&&w>T?w<.01?(n=0,r=.707106781,s=.707106781):(n=Math.sqrt(w),r=A/n,s=y/n):_>T?_<.01?(n=.707106781,r=0,s=.707106781):(r=Math.sqrt(_),n=A/r,s=M/r):T<.01?(n=.707106781,r=.707106781,s=0):(s=Math.sqrt(T),n=y/s,r=M/s),this.set(n,r,s,t),this}let x=Math.sqrt((g-p)*(g-p)+(d-v)*(d-v)+(u-h)*(u-h));return Math.abs(x)<.001&&(x=1),this.x=(g-p)/x,this.y=(d-v)/x,this.z=(u-h)/x,this.w=Math.acos((c+f+m-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=Je(this.x,e.x,t.x),this.y=Je(this.y,e.y,t.y),this.z=Je(this.z,e.z,t.z),this.w=Je(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=Je(this.x,e,t),this.y=Je(this.y,e,t),this.z=Je(this.z,e,t),this.w=Je(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Je(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},al=class extends si{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Ft,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new lt(0,0,e,t),this.scissorTest=!1,this.viewport=new lt(0,0,e,t),this.textures=[];let r=n.count;for(let s=0;s<r;s++)this.textures[s]=new Kt({width:e,height:t,depth:n.depth}),this.textures[s].isRenderTargetTexture=!0,this.textures[s].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:Ft,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let r=0,s=this.textures.length;r<s;r++)this.textures[r].image.width=e,this.textures[r].image.height=t,this.textures[r].image.depth=n,this.textures[r].isData3DTexture!==!0&&(this.textures[r].isArrayTexture=this.textures[r].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let r=Object.assign({},e.textures[t].image);this.textures[t].source=new ds(r)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},fn=class extends al{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}},co=class extends Kt{constructor(e=null,t=1,n=1,r=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:r},this.magFilter=St,this.minFilter=St,this.wrapR=ri,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var ll=class extends Kt{constructor(e=null,t=1,n=1,r=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:r},this.magFilter=St,this.minFilter=St,this.wrapR=ri,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var ut=class i{static{this.prototype.isMatrix4=!0}constructor(e,t,n,r,s,o,a,l,c,h,d,u,f,p,v,g){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,r,s,o,a,l,c,h,d,u,f,p,v,g)}set(e,t,n,r,s,o,a,l,c,h,d,u,f,p,v,g){let m=this.elements;return m[0]=e,m[4]=t,m[8]=n,m[12]=r,m[1]=s,m[5]=o,m[9]=a,m[13]=l,m[2]=c,m[6]=h,m[10]=d,m[14]=u,m[3]=f,m[7]=p,m[11]=v,m[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),n.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,n=e.elements,r=1/Zr.setFromMatrixColumn(e,0).length(),s=1/Zr.setFromMatrixColumn(e,1).length(),o=1/Zr.setFromMatrixColumn(e,2).length();return t[0]=n[0]*r,t[1]=n[1]*r,t[2]=n[2]*r,t[3]=0,t[4]=n[4]*s,t[5]=n[5]*s,t[6]=n[6]*s,t[7]=0,t[8]=n[8]*o,t[9]=n[9]*o,t[10]=n[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,r=e.y,s=e.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(r),c=Math.sin(r),h=Math.cos(s),d=Math.sin(s);if(e.order==="XYZ"){let u=o*h,f=o*d,p=a*h,v=a*d;t[0]=l*h,t[4]=-l*d,t[8]=c,t[1]=f+p*c,t[5]=u-v*c,t[9]=-a*l,t[2]=v-u*c,t[6]=p+f*c,t[10]=o*l}else if(e.order==="YXZ"){let u=l*h,f=l*d,p=c*h,v=c*d;t[0]=u+v*a,t[4]=p*a-f,t[8]=o*c,t[1]=o*d,t[5]=o*h,t[9]=-a,t[2]=f*a-p,t[6]=v+u*a,t[10]=o*l}else if(e.order==="ZXY"){let u=l*h,f=l*d,p=c*h,v=c*d;t[0]=u-v*a,t[4]=-o*d,t[8]=p+f*a,t[1]=f+p*a,t[5]=o*h,t[9]=v-u*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let u=o*h,f=o*d,p=a*h,v=a*d;t[0]=l*h,t[4]=p*c-f,t[8]=u*c+v,t[1]=l*d,t[5]=v*c+u,t[9]=f*c-p,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let u=o*l,f=o*c,p=a*l,v=a*c;t[0]=l*h,t[4]=v-u*d,t[8]=p*d+f,t[1]=d,t[5]=o*h,t[9]=-a*h,t[2]=-c*h,t[6]=f*d+p,t[10]=u-v*d}else if(e.order==="XZY"){let u=o*l,f=o*c,p=a*l,v=a*c;t[0]=l*h,t[4]=-d,t[8]=c*h,t[1]=u*d+v,t[5]=o*h,t[9]=f*d-p,t[2]=p*d-f,t[6]=a*h,t[10]=v*d+u}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(ny,e,iy)}lookAt(e,t,n){let r=this.elements;return hn.subVectors(e,t),hn.lengthSq()===0&&(hn.z=1),hn.normalize(),Hi.crossVectors(n,hn),Hi.lengthSq()===0&&(Math.abs(n.z)===1?hn.x+=1e-4:hn.z+=1e-4,hn.normalize(),Hi.crossVectors(n,hn)),Hi.normalize(),Ta.crossVectors(hn,Hi),r[0]=Hi.x,r[4]=Ta.x,r[8]=hn.x,r[1]=Hi.y,r[5]=Ta.y,r[9]=hn.y,r[2]=Hi.z,r[6]=Ta.z,r[10]=hn.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,r=t.elements,s=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],h=n[1],d=n[5],u=n[9],f=n[13],p=n[2],v=n[6],g=n[10],m=n[14],x=n[3],w=n[7],_=n[11],T=n[15],A=r[0],y=r[4],M=r[8],D=r[12],I=r[1],L=r[5],U=r[9],q=r[13],R=r[2],G=r[6],W=r[10],O=r[14],ee=r[3],H=r[7],J=r[11],te=r[15];return s[0]=o*A+a*I+l*R+c*ee,s[4]=o*y+a*L+l*G+c*H,s[8]=o*M+a*U+l*W+c*J,s[12]=o*D+a*q+l*O+c*te,s[1]=h*A+d*I+u*R+f*ee,s[5]=h*y+d*L+u*G+f*H,s[9]=h*M+d*U+u*W+f*J,s[13]=h*D+d*q+u*O+f*te,s[2]=p*A+v*I+g*R+m*ee,s[6]=p*y+v*L+g*G+m*H,s[10]=p*M+v*U+g*W+m*J,s[14]=p*D+v*q+g*O+m*te,s[3]=x*A+w*I+_*R+T*ee,s[7]=x*y+w*L+_*G+T*H,s[11]=x*M+w*U+_*W+T*J,s[15]=x*D+w*q+_*O+T*te,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],r=e[8],s=e[12],o=e[1],a=e[5],l=e[9],c=e[13],h=e[2],d=e[6],u=e[10],f=e[14],p=e[3],v=e[7],g=e[11],m=e[15],x=l*f-c*u,w=a*f-c*d,_=a*u-l*d,T=o*f-c*h,A=o*u-l*h,y=o*d-a*h;return t*(v*x-g*w+m*_)-n*(p*x-g*T+m*A)+r*(p*w-v*T+m*y)-s*(p*_-v*A+g*y)}determinantAffine(){let e=this.elements,t=e[0],n=e[4],r=e[8],s=e[1],o=e[5],a=e[9],l=e[2],c=e[6],h=e[10];return t*(o*h-a*c)-n*(s*h-a*l)+r*(s*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let r=this.elements;return e.isVector3?(r[12]=e.x,r[13]=e.y,r[14]=e.z):(r[12]=e,r[13]=t,r[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],r=e[2],s=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],d=e[9],u=e[10],f=e[11],p=e[12],v=e[13],g=e[14],m=e[15],x=t*a-n*o,w=t*l-r*o,_=t*c-s*o,T=n*l-r*a,A=n*c-s*a,y=r*c-s*l,M=h*v-d*p,D=h*g-u*p,I=h*m-f*p,L=d*g-u*v,U=d*m-f*v,q=u*m-f*g,R=x*q-w*U+_*L+T*I-A*D+y*M;if(R===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let G=1/R;return e[0]=(a*q-l*U+c*L)*G,e[1]=(r*U-n*q-s*L)*G,e[2]=(v*y-g*A+m*T)*G,e[3]=(u*A-d*y-f*T)*G,e[4]=(l*I-o*q-c*D)*G,e[5]=(t*q-r*I+s*D)*G,e[6]=(g*_-p*y-m*w)*G,e[7]=(h*y-u*_+f*w)*G,e[8]=(o*U-a*I+c*M)*G,e[9]=(n*I-t*U-s*M)*G,e[10]=(p*A-v*_+m*x)*G,e[11]=(d*_-h*A-f*x)*G,e[12]=(a*D-o*L-l*M)*G,e[13]=(t*L-n*D+r*M)*G,e[14]=(v*w-p*T-g*x)*G,e[15]=(h*T-d*w+u*x)*G,this}scale(e){let t=this.elements,n=e.x,r=e.y,s=e.z;return t[0]*=n,t[4]*=r,t[8]*=s,t[1]*=n,t[5]*=r,t[9]*=s,t[2]*=n,t[6]*=r,t[10]*=s,t[3]*=n,t[7]*=r,t[11]*=s,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],r=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,r))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),r=Math.sin(t),s=1-n,o=e.x,a=e.y,l=e.z,c=s*o,h=s*a;return this.set(c*o+n,c*a-r*l,c*l+r*a,0,c*a+r*l,h*a+n,h*l-r*o,0,c*l-r*a,h*l+r*o,s*l*l+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,r,s,o){return this.set(1,n,s,0,e,1,o,0,t,r,1,0,0,0,0,1),this}compose(e,t,n){let r=this.elements,s=t._x,o=t._y,a=t._z,l=t._w,c=s+s,h=o+o,d=a+a,u=s*c,f=s*h,p=s*d,v=o*h,g=o*d,m=a*d,x=l*c,w=l*h,_=l*d,T=n.x,A=n.y,y=n.z;return r[0]=(1-(v+m))*T,r[1]=(f+_)*T,r[2]=(p-w)*T,r[3]=0,r[4]=(f-_)*A,r[5]=(1-(u+m))*A,r[6]=(g+x)*A,r[7]=0,r[8]=(p+w)*y,r[9]=(g-x)*y,r[10]=(1-(u+v))*y,r[11]=0,r[12]=e.x,r[13]=e.y,r[14]=e.z,r[15]=1,this}decompose(e,t,n){let r=this.elements;e.x=r[12],e.y=r[13],e.z=r[14];let s=this.determinantAffine();if(s===0)return n.set(1,1,1),t.identity(),this;let o=Zr.set(r[0],r[1],r[2]).length(),a=Zr.set(r[4],r[5],r[6]).length(),l=Zr.set(r[8],r[9],r[10]).length();s<0&&(o=-o),kn.copy(this);let c=1/o,h=1/a,d=1/l;return kn.elements[0]*=c,kn.elements[1]*=c,kn.elements[2]*=c,kn.elements[4]*=h,kn.elements[5]*=h,kn.elements[6]*=h,kn.elements[8]*=d,kn.elements[9]*=d,kn.elements[10]*=d,t.setFromRotationMatrix(kn),n.x=o,n.y=a,n.z=l,this}makePerspective(e,t,n,r,s,o,a=En,l=!1){let c=this.elements,h=2*s/(t-e),d=2*s/(n-r),u=(t+e)/(t-e),f=(n+r)/(n-r),p,v;if(l)p=s/(o-s),v=o*s/(o-s);else if(a===En)p=-(o+s)/(o-s),v=-2*o*s/(o-s);else if(a===oo)p=-o/(o-s),v=-o*s/(o-s);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=u,c[12]=0,c[1]=0,c[5]=d,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=v,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,n,r,s,o,a=En,l=!1){let c=this.elements,h=2/(t-e),d=2/(n-r),u=-(t+e)/(t-e),f=-(n+r)/(n-r),p,v;if(l)p=1/(o-s),v=o/(o-s);else if(a===En)p=-2/(o-s),v=-(o+s)/(o-s);else if(a===oo)p=-1/(o-s),v=-s/(o-s);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=u,c[1]=0,c[5]=d,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=p,c[14]=v,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let r=0;r<16;r++)if(t[r]!==n[r])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}},Zr=new B,kn=new ut,ny=new B(0,0,0),iy=new B(1,1,1),Hi=new B,Ta=new B,hn=new B,dp=new ut,fp=new oi,Yi=class i{constructor(e=0,t=0,n=0,r=i.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=r}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,r=this._order){return this._x=e,this._y=t,this._z=n,this._order=r,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let r=e.elements,s=r[0],o=r[4],a=r[8],l=r[1],c=r[5],h=r[9],d=r[2],u=r[6],f=r[10];switch(t){case"XYZ":this._y=Math.asin(Je(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,f),this._z=Math.atan2(-o,s)):(this._x=Math.atan2(u,c),this._z=0);break;case"YXZ":this._x=Math.asin(-Je(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-d,s),this._z=0);break;case"ZXY":this._x=Math.asin(Je(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(-d,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,s));break;case"ZYX":this._y=Math.asin(-Je(d,-1,1)),Math.abs(d)<.9999999?(this._x=Math.atan2(u,f),this._z=Math.atan2(l,s)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(Je(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-d,s)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-Je(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(u,c),this._y=Math.atan2(a,s)):(this._x=Math.atan2(-h,f),this._y=0);break;default:Ie("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return dp.makeRotationFromQuaternion(e),this.setFromRotationMatrix(dp,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return fp.setFromEuler(this),this.setFromQuaternion(fp,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Yi.DEFAULT_ORDER="XYZ";var ho=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},ry=0,pp=new B,Kr=new oi,xi=new ut,Ea=new B,js=new B,sy=new B,oy=new oi,mp=new B(1,0,0),gp=new B(0,1,0),yp=new B(0,0,1),xp={type:"added"},ay={type:"removed"},jr={type:"childadded",child:null},Wh={type:"childremoved",child:null},pn=class i extends si{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:ry++}),this.uuid=Cr(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let e=new B,t=new Yi,n=new oi,r=new B(1,1,1);function s(){n.setFromEuler(t,!1)}function o(){t.setFromQuaternion(n,void 0,!1)}t._onChange(s),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:r},modelViewMatrix:{value:new ut},normalMatrix:{value:new Fe}}),this.matrix=new ut,this.matrixWorld=new ut,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new ho,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Kr.setFromAxisAngle(e,t),this.quaternion.multiply(Kr),this}rotateOnWorldAxis(e,t){return Kr.setFromAxisAngle(e,t),this.quaternion.premultiply(Kr),this}rotateX(e){return this.rotateOnAxis(mp,e)}rotateY(e){return this.rotateOnAxis(gp,e)}rotateZ(e){return this.rotateOnAxis(yp,e)}translateOnAxis(e,t){return pp.copy(e).applyQuaternion(this.quaternion),this.position.add(pp.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(mp,e)}translateY(e){return this.translateOnAxis(gp,e)}translateZ(e){return this.translateOnAxis(yp,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(xi.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?Ea.copy(e):Ea.set(e,t,n);let r=this.parent;this.updateWorldMatrix(!0,!1),js.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?xi.lookAt(js,Ea,this.up):xi.lookAt(Ea,js,this.up),this.quaternion.setFromRotationMatrix(xi),r&&(xi.extractRotation(r.matrixWorld),Kr.setFromRotationMatrix(xi),this.quaternion.premultiply(Kr.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(Ne("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(xp),jr.child=e,this.dispatchEvent(jr),jr.child=null):Ne("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(ay),Wh.child=e,this.dispatchEvent(Wh),Wh.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),xi.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),xi.multiply(e.parent.matrixWorld)),e.applyMatrix4(xi),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(xp),jr.child=e,this.dispatchEvent(jr),jr.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,r=this.children.length;n<r;n++){let o=this.children[n].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let r=this.children;for(let s=0,o=r.length;s<o;s++)r[s].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(js,e,sy),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(js,oy,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let n=0,r=t.length;n<r;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,r=t.length;n<r;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,n=e.y,r=e.z,s=this.matrix.elements;s[12]+=t-s[0]*t-s[4]*n-s[8]*r,s[13]+=n-s[1]*t-s[5]*n-s[9]*r,s[14]+=r-s[2]*t-s[6]*n-s[10]*r}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,r=t.length;n<r;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t,n=!1){let r=this.parent;if(e===!0&&r!==null&&r.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),t===!0){let s=this.children;for(let o=0,a=s.length;o<a;o++)s[o].updateWorldMatrix(!1,!0,n)}}toJSON(e){let t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let r={};r.uuid=this.uuid,r.type=this.type,r.name=this.name,r.castShadow=this.castShadow,r.receiveShadow=this.receiveShadow,r.visible=this.visible,r.frustumCulled=this.frustumCulled,r.renderOrder=this.renderOrder,r.static=this.static,r.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(r.userData=this.userData),r.layers=this.layers.mask,r.matrix=this.matrix.toArray(),r.up=this.up.toArray(),this.pivot!==null&&(r.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(r.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(r.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(r.type="InstancedMesh",r.count=this.count,r.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(r.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(r.type="BatchedMesh",r.perObjectFrustumCulled=this.perObjectFrustumCulled,r.sortObjects=this.sortObjects,r.drawRanges=this._drawRanges,r.reservedRanges=this._reservedRanges,r.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),r.instanceInfo=this._instanceInfo.map(a=>({...a})),r.availableInstanceIds=this._availableInstanceIds.slice(),r.availableGeometryIds=this._availableGeometryIds.slice(),r.nextIndexStart=this._nextIndexStart,r.nextVertexStart=this._nextVertexStart,r.geometryCount=this._geometryCount,r.maxInstanceCount=this._maxInstanceCount,r.maxVertexCount=this._maxVertexCount,r.maxIndexCount=this._maxIndexCount,r.geometryInitialized=this._geometryInitialized,r.matricesTexture=this._matricesTexture.toJSON(e),r.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(r.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(r.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(r.boundingBox=this.boundingBox.toJSON()));function s(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?r.background=this.background.toJSON():this.background.isTexture&&(r.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(r.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){r.geometry=s(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let d=l[c];s(e.shapes,d)}else s(e.shapes,l)}}if(this.isSkinnedMesh&&(r.bindMode=this.bindMode,r.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(s(e.skeletons,this.skeleton),r.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(s(e.materials,this.material[l]));r.material=a}else r.material=s(e.materials,this.material);if(this.children.length>0){r.children=[];for(let a=0;a<this.children.length;a++)r.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){r.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];r.animations.push(s(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),h=o(e.images),d=o(e.shapes),u=o(e.skeletons),f=o(e.animations),p=o(e.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),d.length>0&&(n.shapes=d),u.length>0&&(n.skeletons=u),f.length>0&&(n.animations=f),p.length>0&&(n.nodes=p)}return n.object=r,n;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let r=e.children[n];this.add(r.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};pn.DEFAULT_UP=new B(0,1,0);pn.DEFAULT_MATRIX_AUTO_UPDATE=!0;pn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Mi=class extends pn{constructor(){super(),this.isGroup=!0,this.type="Group"}},ly={type:"move"},fs=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Mi,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Mi,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new B,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new B),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Mi,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new B,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new B,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let r=null,s=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let v of e.hand.values()){let g=t.getJointPose(v,n),m=this._getHandJoint(c,v);g!==null&&(m.matrix.fromArray(g.transform.matrix),m.matrix.decompose(m.position,m.quaternion,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=g.radius),m.visible=g!==null}let h=c.joints["index-finger-tip"],d=c.joints["thumb-tip"],u=h.position.distanceTo(d.position),f=.02,p=.005;c.inputState.pinching&&u>f+p?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&u<=f-p&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(s=t.getPose(e.gripSpace,n),s!==null&&(l.matrix.fromArray(s.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,s.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(s.linearVelocity)):l.hasLinearVelocity=!1,s.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(s.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(r=t.getPose(e.targetRaySpace,n),r===null&&s!==null&&(r=s),r!==null&&(a.matrix.fromArray(r.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,r.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(r.linearVelocity)):a.hasLinearVelocity=!1,r.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(r.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(ly)))}return a!==null&&(a.visible=r!==null),l!==null&&(l.visible=s!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let n=new Mi;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}},ym={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Gi={h:0,s:0,l:0},Ca={h:0,s:0,l:0};function qh(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}var Ve=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let r=e;r&&r.isColor?this.copy(r):typeof r=="number"?this.setHex(r):typeof r=="string"&&this.setStyle(r)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=dn){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,Ye.colorSpaceToWorking(this,t),this}setRGB(e,t,n,r=Ye.workingColorSpace){return this.r=e,this.g=t,this.b=n,Ye.colorSpaceToWorking(this,r),this}setHSL(e,t,n,r=Ye.workingColorSpace){if(e=j0(e,1),t=Je(t,0,1),n=Je(n,0,1),t===0)this.r=this.g=this.b=n;else{let s=n<=.5?n*(1+t):n+t-n*t,o=2*n-s;this.r=qh(o,s,e+1/3),this.g=qh(o,s,e),this.b=qh(o,s,e-1/3)}return Ye.colorSpaceToWorking(this,r),this}setStyle(e,t=dn){function n(s){s!==void 0&&parseFloat(s)<1&&Ie("Color: Alpha component of "+e+" will be ignored.")}let r;if(r=/^(\w+)\(([^\)]*)\)/.exec(e)){let s,o=r[1],a=r[2];switch(o){case"rgb":case"rgba":if(s=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(s[4]),this.setRGB(Math.min(255,parseInt(s[1],10))/255,Math.min(255,parseInt(s[2],10))/255,Math.min(255,parseInt(s[3],10))/255,t);if(s=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(s[4]),this.setRGB(Math.min(100,parseFloat(s[1]))/100,Math.min(100,parseFloat(s[2]))/100,Math.min(100,parseFloat(s[3]))/100,t);break;case"hsl":case"hsla":if(s=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(s[4]),this.setHSL(parseFloat(s[1])/360,parseFloat(s[2])/100,parseFloat(s[3])/100,t);break;default:Ie("Color: Unknown color model "+e)}}else if(r=/^\#([A-Fa-f\d]+)$/.exec(e)){let s=r[1],o=s.length;if(o===3)return this.setRGB(parseInt(s.charAt(0),16)/15,parseInt(s.charAt(1),16)/15,parseInt(s.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(s,16),t);Ie("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=dn){let n=ym[e.toLowerCase()];return n!==void 0?this.setHex(n,t):Ie("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=wi(e.r),this.g=wi(e.g),this.b=wi(e.b),this}copyLinearToSRGB(e){return this.r=ls(e.r),this.g=ls(e.g),this.b=ls(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=dn){return Ye.workingToColorSpace(Wt.copy(this),e),Math.round(Je(Wt.r*255,0,255))*65536+Math.round(Je(Wt.g*255,0,255))*256+Math.round(Je(Wt.b*255,0,255))}getHexString(e=dn){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=Ye.workingColorSpace){Ye.workingToColorSpace(Wt.copy(this),t);let n=Wt.r,r=Wt.g,s=Wt.b,o=Math.max(n,r,s),a=Math.min(n,r,s),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let d=o-a;switch(c=h<=.5?d/(o+a):d/(2-o-a),o){case n:l=(r-s)/d+(r<s?6:0);break;case r:l=(s-n)/d+2;break;case s:l=(n-r)/d+4;break}l/=6}return e.h=l,e.s=c,e.l=h,e}getRGB(e,t=Ye.workingColorSpace){return Ye.workingToColorSpace(Wt.copy(this),t),e.r=Wt.r,e.g=Wt.g,e.b=Wt.b,e}getStyle(e=dn){Ye.workingToColorSpace(Wt.copy(this),e);let t=Wt.r,n=Wt.g,r=Wt.b;return e!==dn?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${r.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(r*255)})`}offsetHSL(e,t,n){return this.getHSL(Gi),this.setHSL(Gi.h+e,Gi.s+t,Gi.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(Gi),e.getHSL(Ca);let n=Bh(Gi.h,Ca.h,t),r=Bh(Gi.s,Ca.s,t),s=Bh(Gi.l,Ca.l,t);return this.setHSL(n,r,s),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,r=this.b,s=e.elements;return this.r=s[0]*t+s[3]*n+s[6]*r,this.g=s[1]*t+s[4]*n+s[7]*r,this.b=s[2]*t+s[5]*n+s[8]*r,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Wt=new Ve;Ve.NAMES=ym;var uo=class extends pn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Yi,this.environmentIntensity=1,this.environmentRotation=new Yi,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Bn=new B,vi=new B,Xh=new B,bi=new B,Qr=new B,es=new B,vp=new B,$h=new B,Yh=new B,Jh=new B,Zh=new lt,Kh=new lt,jh=new lt,$i=class i{constructor(e=new B,t=new B,n=new B){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,r){r.subVectors(n,t),Bn.subVectors(e,t),r.cross(Bn);let s=r.lengthSq();return s>0?r.multiplyScalar(1/Math.sqrt(s)):r.set(0,0,0)}static getBarycoord(e,t,n,r,s){Bn.subVectors(r,t),vi.subVectors(n,t),Xh.subVectors(e,t);let o=Bn.dot(Bn),a=Bn.dot(vi),l=Bn.dot(Xh),c=vi.dot(vi),h=vi.dot(Xh),d=o*c-a*a;if(d===0)return s.set(0,0,0),null;let u=1/d,f=(c*l-a*h)*u,p=(o*h-a*l)*u;return s.set(1-f-p,p,f)}static containsPoint(e,t,n,r){return this.getBarycoord(e,t,n,r,bi)===null?!1:bi.x>=0&&bi.y>=0&&bi.x+bi.y<=1}static getInterpolation(e,t,n,r,s,o,a,l){return this.getBarycoord(e,t,n,r,bi)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(s,bi.x),l.addScaledVector(o,bi.y),l.addScaledVector(a,bi.z),l)}static getInterpolatedAttribute(e,t,n,r,s,o){return Zh.setScalar(0),Kh.setScalar(0),jh.setScalar(0),Zh.fromBufferAttribute(e,t),Kh.fromBufferAttribute(e,n),jh.fromBufferAttribute(e,r),o.setScalar(0),o.addScaledVector(Zh,s.x),o.addScaledVector(Kh,s.y),o.addScaledVector(jh,s.z),o}static isFrontFacing(e,t,n,r){return Bn.subVectors(n,t),vi.subVectors(e,t),Bn.cross(vi).dot(r)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,r){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[r]),this}setFromAttributeAndIndices(e,t,n,r){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,r),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Bn.subVectors(this.c,this.b),vi.subVectors(this.a,this.b),Bn.cross(vi).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return i.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return i.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,r,s){return i.getInterpolation(e,this.a,this.b,this.c,t,n,r,s)}containsPoint(e){return i.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return i.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,r=this.b,s=this.c,o,a;Qr.subVectors(r,n),es.subVectors(s,n),$h.subVectors(e,n);let l=Qr.dot($h),c=es.dot($h);if(l<=0&&c<=0)return t.copy(n);Yh.subVectors(e,r);let h=Qr.dot(Yh),d=es.dot(Yh);if(h>=0&&d<=h)return t.copy(r);let u=l*d-h*c;if(u<=0&&l>=0&&h<=0&&l-h>0)return o=l/(l-h),t.copy(n).addScaledVector(Qr,o);Jh.subVectors(e,s);let f=Qr.dot(Jh),p=es.dot(Jh);if(p>=0&&f<=p)return t.copy(s);let v=f*c-l*p;if(v<=0&&c>=0&&p<=0)return a=c/(c-p),t.copy(n).addScaledVector(es,a);let g=h*p-f*d;if(g<=0&&d-h>=0&&f-p>=0)return vp.subVectors(s,r),a=(d-h)/(d-h+(f-p)),t.copy(r).addScaledVector(vp,a);let m=1/(g+v+u);return o=v*m,a=u*m,t.copy(n).addScaledVector(Qr,o).addScaledVector(es,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},Ji=class{constructor(e=new B(1/0,1/0,1/0),t=new B(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(zn.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(zn.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=zn.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let s=n.getAttribute("position");if(t===!0&&s!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=s.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,zn):zn.fromBufferAttribute(s,o),zn.applyMatrix4(e.matrixWorld),this.expandByPoint(zn);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Ra.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),Ra.copy(n.boundingBox)),Ra.applyMatrix4(e.matrixWorld),this.union(Ra)}let r=e.children;for(let s=0,o=r.length;s<o;s++)this.expandByObject(r[s],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,zn),zn.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Qs),Pa.subVectors(this.max,Qs),ts.subVectors(e.a,Qs),ns.subVectors(e.b,Qs),is.subVectors(e.c,Qs),Wi.subVectors(ns,ts),qi.subVectors(is,ns),yr.subVectors(ts,is);let t=[0,-Wi.z,Wi.y,0,-qi.z,qi.y,0,-yr.z,yr.y,Wi.z,0,-Wi.x,qi.z,0,-qi.x,yr.z,0,-yr.x,-Wi.y,Wi.x,0,-qi.y,qi.x,0,-yr.y,yr.x,0];return!Qh(t,ts,ns,is,Pa)||(t=[1,0,0,0,1,0,0,0,1],!Qh(t,ts,ns,is,Pa))?!1:(Ia.crossVectors(Wi,qi),t=[Ia.x,Ia.y,Ia.z],Qh(t,ts,ns,is,Pa))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,zn).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(zn).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(_i[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),_i[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),_i[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),_i[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),_i[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),_i[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),_i[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),_i[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(_i),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},_i=[new B,new B,new B,new B,new B,new B,new B,new B],zn=new B,Ra=new Ji,ts=new B,ns=new B,is=new B,Wi=new B,qi=new B,yr=new B,Qs=new B,Pa=new B,Ia=new B,xr=new B;function Qh(i,e,t,n,r){for(let s=0,o=i.length-3;s<=o;s+=3){xr.fromArray(i,s);let a=r.x*Math.abs(xr.x)+r.y*Math.abs(xr.y)+r.z*Math.abs(xr.z),l=e.dot(xr),c=t.dot(xr),h=n.dot(xr);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var bt=new B,La=new Ge,cy=0,_t=class extends si{constructor(e,t,n=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:cy++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=Ou,this.updateRanges=[],this.gpuType=gn,this.version=0,this._normalizationScale=e!==void 0?dc(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let r=0,s=this.itemSize;r<s;r++)this.array[e+r]=t.array[n+r];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)La.fromBufferAttribute(this,t),La.applyMatrix3(e),this.setXY(t,La.x,La.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)bt.fromBufferAttribute(this,t),bt.applyMatrix3(e),this.setXYZ(t,bt.x,bt.y,bt.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)bt.fromBufferAttribute(this,t),bt.applyMatrix4(e),this.setXYZ(t,bt.x,bt.y,bt.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)bt.fromBufferAttribute(this,t),bt.applyNormalMatrix(e),this.setXYZ(t,bt.x,bt.y,bt.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)bt.fromBufferAttribute(this,t),bt.transformDirection(e),this.setXYZ(t,bt.x,bt.y,bt.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=r,this}setXYZW(e,t,n,r,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),r=this._normalize(r),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=r,this.array[e+3]=s,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):mm(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):gm(e,this.array)}};var fo=class extends _t{constructor(e,t,n){super(new Uint16Array(e),t,n)}};var po=class extends _t{constructor(e,t,n){super(new Uint32Array(e),t,n)}};var Cn=class extends _t{constructor(e,t,n){super(new Float32Array(e),t,n)}},hy=new Ji,eo=new B,eu=new B,_r=class{constructor(e=new B,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):hy.setFromPoints(e).getCenter(n);let r=0;for(let s=0,o=e.length;s<o;s++)r=Math.max(r,n.distanceToSquared(e[s]));return this.radius=Math.sqrt(r),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;eo.subVectors(e,this.center);let t=eo.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),r=(n-this.radius)*.5;this.center.addScaledVector(eo,r/n),this.radius+=r}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(eu.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(eo.copy(e.center).add(eu)),this.expandByPoint(eo.copy(e.center).sub(eu))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},uy=0,Tn=new ut,tu=new pn,rs=new B,un=new Ji,to=new Ji,Dt=new B,sn=class i extends si{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:uy++}),this.uuid=Cr(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(Z0(e)?po:fo)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let s=new Fe().getNormalMatrix(e);n.applyNormalMatrix(s),n.needsUpdate=!0}let r=this.attributes.tangent;return r!==void 0&&(r.transformDirection(e),r.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Tn.makeRotationFromQuaternion(e),this.applyMatrix4(Tn),this}rotateX(e){return Tn.makeRotationX(e),this.applyMatrix4(Tn),this}rotateY(e){return Tn.makeRotationY(e),this.applyMatrix4(Tn),this}rotateZ(e){return Tn.makeRotationZ(e),this.applyMatrix4(Tn),this}translate(e,t,n){return Tn.makeTranslation(e,t,n),this.applyMatrix4(Tn),this}scale(e,t,n){return Tn.makeScale(e,t,n),this.applyMatrix4(Tn),this}lookAt(e){return tu.lookAt(e),tu.updateMatrix(),this.applyMatrix4(tu.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(rs).negate(),this.translate(rs.x,rs.y,rs.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let n=[];for(let r=0,s=e.length;r<s;r++){let o=e[r];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Cn(n,3))}else{let n=Math.min(e.length,t.count);for(let r=0;r<n;r++){let s=e[r];t.setXYZ(r,s.x,s.y,s.z||0)}e.length>t.count&&Ie("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Ji);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Ne("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new B(-1/0,-1/0,-1/0),new B(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,r=t.length;n<r;n++){let s=t[n];un.setFromBufferAttribute(s),this.morphTargetsRelative?(Dt.addVectors(this.boundingBox.min,un.min),this.boundingBox.expandByPoint(Dt),Dt.addVectors(this.boundingBox.max,un.max),this.boundingBox.expandByPoint(Dt)):(this.boundingBox.expandByPoint(un.min),this.boundingBox.expandByPoint(un.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&Ne('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new _r);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Ne("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new B,1/0);return}if(e){let n=this.boundingSphere.center;if(un.setFromBufferAttribute(e),t)for(let s=0,o=t.length;s<o;s++){let a=t[s];to.setFromBufferAttribute(a),this.morphTargetsRelative?(Dt.addVectors(un.min,to.min),un.expandByPoint(Dt),Dt.addVectors(un.max,to.max),un.expandByPoint(Dt)):(un.expandByPoint(to.min),un.expandByPoint(to.max))}un.getCenter(n);let r=0;for(let s=0,o=e.count;s<o;s++)Dt.fromBufferAttribute(e,s),r=Math.max(r,n.distanceToSquared(Dt));if(t)for(let s=0,o=t.length;s<o;s++){let a=t[s],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)Dt.fromBufferAttribute(a,c),l&&(rs.fromBufferAttribute(e,c),Dt.add(rs)),r=Math.max(r,n.distanceToSquared(Dt))}this.boundingSphere.radius=Math.sqrt(r),isNaN(this.boundingSphere.radius)&&Ne('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){Ne("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=t.position,r=t.normal,s=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new _t(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(n.count);for(let D=0;D<n.count;D++)a[D]=new B,l[D]=new B;let h=new B,d=new B,u=new B,f=new Ge,p=new Ge,v=new Ge,g=new B,m=new B;function x(D,I,L){c[D]=c[I]=c[L]=1,h.fromBufferAttribute(n,D),d.fromBufferAttribute(n,I),u.fromBufferAttribute(n,L),f.fromBufferAttribute(s,D),p.fromBufferAttribute(s,I),v.fromBufferAttribute(s,L),d.sub(h),u.sub(h),p.sub(f),v.sub(f);let U=1/(p.x*v.y-v.x*p.y);isFinite(U)&&(g.copy(d).multiplyScalar(v.y).addScaledVector(u,-p.y).multiplyScalar(U),m.copy(u).multiplyScalar(p.x).addScaledVector(d,-v.x).multiplyScalar(U),a[D].add(g),a[I].add(g),a[L].add(g),l[D].add(m),l[I].add(m),l[L].add(m))}let w=this.groups;w.length===0&&(w=[{start:0,count:e.count}]);for(let D=0,I=w.length;D<I;++D){let L=w[D],U=L.start,q=L.count;for(let R=U,G=U+q;R<G;R+=3)x(e.getX(R+0),e.getX(R+1),e.getX(R+2))}let _=new B,T=new B,A=new B,y=new B;function M(D){A.fromBufferAttribute(r,D),y.copy(A);let I=a[D];_.copy(I),_.sub(A.multiplyScalar(A.dot(I))).normalize(),T.crossVectors(y,I);let U=T.dot(l[D])<0?-1:1;o.setXYZW(D,_.x,_.y,_.z,U)}for(let D=0,I=n.count;D<I;++D)c[D]&&M(D);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==t.count)n=new _t(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let u=0,f=n.count;u<f;u++)n.setXYZ(u,0,0,0);let r=new B,s=new B,o=new B,a=new B,l=new B,c=new B,h=new B,d=new B;if(e)for(let u=0,f=e.count;u<f;u+=3){let p=e.getX(u+0),v=e.getX(u+1),g=e.getX(u+2);r.fromBufferAttribute(t,p),s.fromBufferAttribute(t,v),o.fromBufferAttribute(t,g),h.subVectors(o,s),d.subVectors(r,s),h.cross(d),a.fromBufferAttribute(n,p),l.fromBufferAttribute(n,v),c.fromBufferAttribute(n,g),a.add(h),l.add(h),c.add(h),n.setXYZ(p,a.x,a.y,a.z),n.setXYZ(v,l.x,l.y,l.z),n.setXYZ(g,c.x,c.y,c.z)}else for(let u=0,f=t.count;u<f;u+=3)r.fromBufferAttribute(t,u+0),s.fromBufferAttribute(t,u+1),o.fromBufferAttribute(t,u+2),h.subVectors(o,s),d.subVectors(r,s),h.cross(d),n.setXYZ(u+0,h.x,h.y,h.z),n.setXYZ(u+1,h.x,h.y,h.z),n.setXYZ(u+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)Dt.fromBufferAttribute(e,t),Dt.normalize(),e.setXYZ(t,Dt.x,Dt.y,Dt.z)}toNonIndexed(){function e(a,l){let c=a.array,h=a.itemSize,d=a.normalized,u=new c.constructor(l.length*h),f=0,p=0;for(let v=0,g=l.length;v<g;v++){a.isInterleavedBufferAttribute?f=l[v]*a.data.stride+a.offset:f=l[v]*h;for(let m=0;m<h;m++)u[p++]=c[f++]}return new _t(u,h,d)}if(this.index===null)return Ie("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new i,n=this.index.array,r=this.attributes;for(let a in r){let l=r[a],c=e(l,n);t.setAttribute(a,c)}let s=this.morphAttributes;for(let a in s){let l=[],c=s[a];for(let h=0,d=c.length;h<d;h++){let u=c[h],f=e(u,n);l.push(f)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let l in n){let c=n[l];e.data.attributes[l]=c.toJSON(e.data)}let r={},s=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let d=0,u=c.length;d<u;d++){let f=c[d];h.push(f.toJSON(e.data))}h.length>0&&(r[l]=h,s=!0)}s&&(e.data.morphAttributes=r,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let r=e.attributes;for(let c in r){let h=r[c];this.setAttribute(c,h.clone(t))}let s=e.morphAttributes;for(let c in s){let h=[],d=s[c];for(let u=0,f=d.length;u<f;u++)h.push(d[u].clone(t));this.morphAttributes[c]=h}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,h=o.length;c<h;c++){let d=o[c];this.addGroup(d.start,d.count,d.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},cl=class{constructor(e,t){this.isInterleavedBuffer=!0,this.array=e,this.stride=t,this.count=e!==void 0?e.length/t:0,this.usage=Ou,this.updateRanges=[],this.version=0,this.uuid=Cr()}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.array=new e.array.constructor(e.array),this.count=e.count,this.stride=e.stride,this.usage=e.usage,this}copyAt(e,t,n){e*=this.stride,n*=t.stride;for(let r=0,s=this.stride;r<s;r++)this.array[e+r]=t.array[n+r];return this}set(e,t=0){return this.array.set(e,t),this}clone(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=bp(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=this.array.slice(0).buffer);let n=new this.array.constructor(e.arrayBuffers[t]),r=new this.constructor(n,this.stride);return r.setUsage(this.usage),r}onUpload(e){return this.onUploadCallback=e,this}toJSON(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=bp(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let n={uuid:this.uuid,buffer:t,type:this.array.constructor.name,stride:this.stride};return n.usage=this.usage,n}};function bp(i){return i.buffer._uuid===void 0&&(i.buffer._uuid=Cr()),i.byteOffset===0&&i.byteLength===i.buffer.byteLength?i.buffer._uuid:i.buffer._uuid+":"+i.byteOffset+":"+i.byteLength}var Zt=new B,ps=class i{constructor(e,t,n,r=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=e,this.itemSize=t,this.offset=n,this.normalized=r,this._normalizationScale=e!==void 0?dc(e.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(e){this.data.needsUpdate=e}applyMatrix4(e){for(let t=0,n=this.data.count;t<n;t++)Zt.fromBufferAttribute(this,t),Zt.applyMatrix4(e),this.setXYZ(t,Zt.x,Zt.y,Zt.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)Zt.fromBufferAttribute(this,t),Zt.applyNormalMatrix(e),this.setXYZ(t,Zt.x,Zt.y,Zt.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)Zt.fromBufferAttribute(this,t),Zt.transformDirection(e),this.setXYZ(t,Zt.x,Zt.y,Zt.z);return this}getComponent(e,t){let n=this.array[e*this.data.stride+this.offset+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.data.array[e*this.data.stride+this.offset+t]=n,this}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset]=t,this}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+1]=t,this}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+2]=t,this}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+3]=t,this}getX(e){let t=this.data.array[e*this.data.stride+this.offset];return this.normalized&&(t=this._denormalize(t)),t}getY(e){let t=this.data.array[e*this.data.stride+this.offset+1];return this.normalized&&(t=this._denormalize(t)),t}getZ(e){let t=this.data.array[e*this.data.stride+this.offset+2];return this.normalized&&(t=this._denormalize(t)),t}getW(e){let t=this.data.array[e*this.data.stride+this.offset+3];return this.normalized&&(t=this._denormalize(t)),t}setXY(e,t,n){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.data.array[e+0]=t,this.data.array[e+1]=n,this}setXYZ(e,t,n,r){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n),r=this._normalize(r)),this.data.array[e+0]=t,this.data.array[e+1]=n,this.data.array[e+2]=r,this}setXYZW(e,t,n,r,s){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n),r=this._normalize(r),s=this._normalize(s)),this.data.array[e+0]=t,this.data.array[e+1]=n,this.data.array[e+2]=r,this.data.array[e+3]=s,this}clone(e){if(e===void 0){lo("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let n=0;n<this.count;n++){let r=n*this.data.stride+this.offset;for(let s=0;s<this.itemSize;s++)t.push(this.data.array[r+s])}return new _t(new this.array.constructor(t),this.itemSize,this.normalized)}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.clone(e)),new i(e.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(e){if(e===void 0){lo("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let n=0;n<this.count;n++){let r=n*this.data.stride+this.offset;for(let s=0;s<this.itemSize;s++)t.push(this.data.array[r+s])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:t,normalized:this.normalized}}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.toJSON(e)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):mm(e,this.data.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):gm(e,this.data.array)}},nu=new B,dy=new B,fy=new Fe,Vn=class{constructor(e=new B(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,r){return this.normal.set(e,t,n),this.constant=r,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let r=nu.subVectors(n,t).cross(dy.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(r,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,n=!0){let r=e.delta(nu),s=this.normal.dot(r);if(s===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/s;return n===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(r,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let n=t||fy.getNormalMatrix(e),r=this.coplanarPoint(nu).applyMatrix4(e),s=this.normal.applyMatrix3(n).normalize();return this.constant=-r.dot(s),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},py=0,Zi=class extends si{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:py++}),this.uuid=Cr(),this.name="",this.type="Material",this.blending=bs,this.side=er,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=gu,this.blendDst=yu,this.blendEquation=Ar,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Ve(0,0,0),this.blendAlpha=0,this.depthFunc=cs,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=rm,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Ja,this.stencilZFail=Ja,this.stencilZPass=Ja,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){Ie(`Material: parameter '${t}' has value of undefined.`);continue}let r=this[t];if(r===void 0){Ie(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}r&&r.isColor?r.set(n):r&&r.isVector2&&n&&n.isVector2||r&&r.isEuler&&n&&n.isEuler||r&&r.isVector3&&n&&n.isVector3?r.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(s=>s.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function r(s){let o=[];for(let a in s){let l=s[a];delete l.metadata,o.push(l)}return o}if(t){let s=r(e.textures),o=r(e.images);s.length>0&&(n.textures=s),o.length>0&&(n.images=o)}return n}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new Ve().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(n=>new Vn().fromJSON(n))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let n=e.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new Ge().fromArray(n)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Ge().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;if(t!==null){let r=t.length;n=new Array(r);for(let s=0;s!==r;++s)n[s]=t[s].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var Si=new B,iu=new B,Na=new B,Da=new B,mo=class{constructor(e=new B,t=new B(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Si)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=Si.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Si.copy(this.origin).addScaledVector(this.direction,t),Si.distanceToSquared(e))}distanceSqToSegment(e,t,n,r){iu.copy(e).add(t).multiplyScalar(.5),Na.copy(t).sub(e).normalize(),Da.copy(this.origin).sub(iu);let s=e.distanceTo(t)*.5,o=-this.direction.dot(Na),a=Da.dot(this.direction),l=-Da.dot(Na),c=Da.lengthSq(),h=Math.abs(1-o*o),d,u,f,p;if(h>0)if(d=o*l-a,u=o*a-l,p=s*h,d>=0)if(u>=-p)if(u<=p){let v=1/h;d*=v,u*=v,f=d*(d+o*u+2*a)+u*(o*d+u+2*l)+c}else u=s,d=Math.max(0,-(o*u+a)),f=-d*d+u*(u+2*l)+c;else u=-s,d=Math.max(0,-(o*u+a)),f=-d*d+u*(u+2*l)+c;else u<=-p?(d=Math.max(0,-(-o*s+a)),u=d>0?-s:Math.min(Math.max(-s,-l),s),f=-d*d+u*(u+2*l)+c):u<=p?(d=0,u=Math.min(Math.max(-s,-l),s),f=u*(u+2*l)+c):(d=Math.max(0,-(o*s+a)),u=d>0?s:Math.min(Math.max(-s,-l),s),f=-d*d+u*(u+2*l)+c);else u=o>0?-s:s,d=Math.max(0,-(o*u+a)),f=-d*d+u*(u+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,d),r&&r.copy(iu).addScaledVector(Na,u),f}intersectSphere(e,t){if(e.radius<0)return null;Si.subVectors(e.center,this.origin);let n=Si.dot(this.direction),r=Si.dot(Si)-n*n,s=e.radius*e.radius;if(r>s)return null;let o=Math.sqrt(s-r),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,r,s,o,a,l,c=1/this.direction.x,h=1/this.direction.y,d=1/this.direction.z,u=this.origin;return c>=0?(n=(e.min.x-u.x)*c,r=(e.max.x-u.x)*c):(n=(e.max.x-u.x)*c,r=(e.min.x-u.x)*c),h>=0?(s=(e.min.y-u.y)*h,o=(e.max.y-u.y)*h):(s=(e.max.y-u.y)*h,o=(e.min.y-u.y)*h),n>o||s>r||((s>n||isNaN(n))&&(n=s),(o<r||isNaN(r))&&(r=o),d>=0?(a=(e.min.z-u.z)*d,l=(e.max.z-u.z)*d):(a=(e.max.z-u.z)*d,l=(e.min.z-u.z)*d),n>l||a>r)||((a>n||n!==n)&&(n=a),(l<r||r!==r)&&(r=l),r<0)?null:this.at(n>=0?n:r,t)}intersectsBox(e){return this.intersectBox(e,Si)!==null}intersectTriangle(e,t,n,r,s){let o=this.origin,a=this.direction,l=a.x,c=a.y,h=a.z,d=e.x-o.x,u=e.y-o.y,f=e.z-o.z,p=t.x-o.x,v=t.y-o.y,g=t.z-o.z,m=n.x-o.x,x=n.y-o.y,w=n.z-o.z,_=Math.abs(l),T=Math.abs(c),A=Math.abs(h),y,M,D,I,L,U,q,R,G,W,O,ee;if(_>=T&&_>=A?(D=l,U=d,G=p,ee=m,l>=0?(y=c,M=h,I=u,L=f,q=v,R=g,W=x,O=w):(y=h,M=c,I=f,L=u,q=g,R=v,W=w,O=x)):T>=A?(D=c,U=u,G=v,ee=x,c>=0?(y=h,M=l,I=f,L=d,q=g,R=p,W=w,O=m):(y=l,M=h,I=d,L=f,q=p,R=g,W=m,O=w)):(D=h,U=f,G=g,ee=w,h>=0?(y=l,M=c,I=d,L=u,q=p,R=v,W=m,O=x):(y=c,M=l,I=u,L=d,q=v,R=p,W=x,O=m)),D===0)return null;let H=y/D,J=M/D,te=1/D,ve=I-H*U,Te=L-J*U,$=q-H*G,re=R-J*G,me=W-H*ee,Me=O-J*ee,fe=me*re-Me*$,Le=ve*Me-Te*me,dt=$*Te-re*ve;if(r){if(fe<0||Le<0||dt<0)return null}else if((fe<0||Le<0||dt<0)&&(fe>0||Le>0||dt>0))return null;let Ce=fe+Le+dt;if(Ce===0)return null;let Ze=te*(fe*U+Le*G+dt*ee);return(Ce>0?Ze<0:Ze>0)?null:this.at(Ze/Ce,s)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},hl=class extends Zi{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Ve(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Yi,this.combine=xu,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},_p=new ut,vr=new mo,Fa=new _r,Sp=new B,Ua=new B,Oa=new B,ka=new B,ru=new B,Ba=new B,Mp=new B,za=new B,Xt=class extends pn{constructor(e=new sn,t=new hl){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let r=t[n[0]];if(r!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let s=0,o=r.length;s<o;s++){let a=r[s].name||String(s);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=s}}}}getVertexPosition(e,t){let n=this.geometry,r=n.attributes.position,s=n.morphAttributes.position,o=n.morphTargetsRelative;t.fromBufferAttribute(r,e);let a=this.morphTargetInfluences;if(s&&a){Ba.set(0,0,0);for(let l=0,c=s.length;l<c;l++){let h=a[l],d=s[l];h!==0&&(ru.fromBufferAttribute(d,e),o?Ba.addScaledVector(ru,h):Ba.addScaledVector(ru.sub(t),h))}t.add(Ba)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,r=this.material,s=this.matrixWorld;r!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Fa.copy(n.boundingSphere),Fa.applyMatrix4(s),vr.copy(e.ray).recast(e.near),!(Fa.containsPoint(vr.origin)===!1&&(vr.intersectSphere(Fa,Sp)===null||vr.origin.distanceToSquared(Sp)>(e.far-e.near)**2))&&(_p.copy(s).invert(),vr.copy(e.ray).applyMatrix4(_p),!(n.boundingBox!==null&&vr.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,vr)))}_computeIntersections(e,t,n){let r,s=this.geometry,o=this.material,a=s.index,l=s.attributes.position,c=s.attributes.uv,h=s.attributes.uv1,d=s.attributes.normal,u=s.groups,f=s.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,v=u.length;p<v;p++){let g=u[p],m=o[g.materialIndex],x=Math.max(g.start,f.start),w=Math.min(a.count,Math.min(g.start+g.count,f.start+f.count));for(let _=x,T=w;_<T;_+=3){let A=a.getX(_),y=a.getX(_+1),M=a.getX(_+2);r=Va(this,m,e,n,c,h,d,A,y,M),r&&(r.faceIndex=Math.floor(_/3),r.face.materialIndex=g.materialIndex,t.push(r))}}else{let p=Math.max(0,f.start),v=Math.min(a.count,f.start+f.count);for(let g=p,m=v;g<m;g+=3){let x=a.getX(g),w=a.getX(g+1),_=a.getX(g+2);r=Va(this,o,e,n,c,h,d,x,w,_),r&&(r.faceIndex=Math.floor(g/3),t.push(r))}}else if(l!==void 0)if(Array.isArray(o))for(let p=0,v=u.length;p<v;p++){let g=u[p],m=o[g.materialIndex],x=Math.max(g.start,f.start),w=Math.min(l.count,Math.min(g.start+g.count,f.start+f.count));for(let _=x,T=w;_<T;_+=3){let A=_,y=_+1,M=_+2;r=Va(this,m,e,n,c,h,d,A,y,M),r&&(r.faceIndex=Math.floor(_/3),r.face.materialIndex=g.materialIndex,t.push(r))}}else{let p=Math.max(0,f.start),v=Math.min(l.count,f.start+f.count);for(let g=p,m=v;g<m;g+=3){let x=g,w=g+1,_=g+2;r=Va(this,o,e,n,c,h,d,x,w,_),r&&(r.faceIndex=Math.floor(g/3),t.push(r))}}}};function my(i,e,t,n,r,s,o,a){let l;if(e.side===jt?l=n.intersectTriangle(o,s,r,!0,a):l=n.intersectTriangle(r,s,o,e.side===er,a),l===null)return null;za.copy(a),za.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(za);return c<t.near||c>t.far?null:{distance:c,point:za.clone(),object:i}}function Va(i,e,t,n,r,s,o,a,l,c){i.getVertexPosition(a,Ua),i.getVertexPosition(l,Oa),i.getVertexPosition(c,ka);let h=my(i,e,t,n,Ua,Oa,ka,Mp);if(h){let d=new B;$i.getBarycoord(Mp,Ua,Oa,ka,d),r&&(h.uv=$i.getInterpolatedAttribute(r,a,l,c,d,new Ge)),s&&(h.uv1=$i.getInterpolatedAttribute(s,a,l,c,d,new Ge)),o&&(h.normal=$i.getInterpolatedAttribute(o,a,l,c,d,new B),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let u={a,b:l,c,normal:new B,materialIndex:0};$i.getNormal(Ua,Oa,ka,u.normal),h.face=u,h.barycoord=d}return h}var Sr=class extends Kt{constructor(e=null,t=1,n=1,r,s,o,a,l,c=St,h=St,d,u){super(null,o,a,l,c,h,r,s,d,u),this.isDataTexture=!0,this.image={data:e,width:t,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var br=new _r,gy=new Ge(.5,.5),Ha=new B,Mr=class{constructor(e=new Vn,t=new Vn,n=new Vn,r=new Vn,s=new Vn,o=new Vn){this.planes=[e,t,n,r,s,o]}set(e,t,n,r,s,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(n),a[3].copy(r),a[4].copy(s),a[5].copy(o),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=En,n=!1){let r=this.planes,s=e.elements,o=s[0],a=s[1],l=s[2],c=s[3],h=s[4],d=s[5],u=s[6],f=s[7],p=s[8],v=s[9],g=s[10],m=s[11],x=s[12],w=s[13],_=s[14],T=s[15];if(r[0].setComponents(c-o,f-h,m-p,T-x).normalize(),r[1].setComponents(c+o,f+h,m+p,T+x).normalize(),r[2].setComponents(c+a,f+d,m+v,T+w).normalize(),r[3].setComponents(c-a,f-d,m-v,T-w).normalize(),n)r[4].setComponents(l,u,g,_).normalize(),r[5].setComponents(c-l,f-u,m-g,T-_).normalize();else if(r[4].setComponents(c-l,f-u,m-g,T-_).normalize(),t===En)r[5].setComponents(c+l,f+u,m+g,T+_).normalize();else if(t===oo)r[5].setComponents(l,u,g,_).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),br.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),br.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(br)}intersectsSprite(e){br.center.set(0,0,0);let t=gy.distanceTo(e.center);return br.radius=.7071067811865476+t,br.applyMatrix4(e.matrixWorld),this.intersectsSphere(br)}intersectsSphere(e){let t=this.planes,n=e.center,r=-e.radius;for(let s=0;s<6;s++)if(t[s].distanceToPoint(n)<r)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let r=t[n];if(Ha.x=r.normal.x>0?e.max.x:e.min.x,Ha.y=r.normal.y>0?e.max.y:e.min.y,Ha.z=r.normal.z>0?e.max.z:e.min.z,r.distanceToPoint(Ha)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},wp=new ut,ul=class i{constructor(){this.coordinateSystem=En,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,n=this._frustums;for(let r=0;r<t.length;r++){let s=t[r];wp.multiplyMatrices(s.projectionMatrix,s.matrixWorldInverse),n[r]===void 0&&(n[r]=new Mr),n[r].setFromProjectionMatrix(wp,s.coordinateSystem,s.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,n=e._frustums;for(let r=0;r<e._count;r++)t[r]===void 0&&(t[r]=new Mr),t[r].copy(n[r]);return this._count=e._count,this}clone(){return new i().copy(this)}};var dl=class extends Zi{constructor(e){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new Ve(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.alphaMap=e.alphaMap,this.size=e.size,this.sizeAttenuation=e.sizeAttenuation,this.fog=e.fog,this}},Ap=new ut,cu=new mo,Ga=new _r,Wa=new B,ms=class extends pn{constructor(e=new sn,t=new dl){super(),this.isPoints=!0,this.type="Points",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,r=this.matrixWorld,s=e.params.Points.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Ga.copy(n.boundingSphere),Ga.applyMatrix4(r),Ga.radius+=s,e.ray.intersectsSphere(Ga)===!1)return;Ap.copy(r).invert(),cu.copy(e.ray).applyMatrix4(Ap);let a=s/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=n.index,d=n.attributes.position;if(c!==null){let u=Math.max(0,o.start),f=Math.min(c.count,o.start+o.count);for(let p=u,v=f;p<v;p++){let g=c.getX(p);Wa.fromBufferAttribute(d,g),Tp(Wa,g,l,r,e,t,this)}}else{let u=Math.max(0,o.start),f=Math.min(d.count,o.start+o.count);for(let p=u,v=f;p<v;p++)Wa.fromBufferAttribute(d,p),Tp(Wa,p,l,r,e,t,this)}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let r=t[n[0]];if(r!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let s=0,o=r.length;s<o;s++){let a=r[s].name||String(s);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=s}}}}};function Tp(i,e,t,n,r,s,o){let a=cu.distanceSqToPoint(i);if(a<t){let l=new B;cu.closestPointToPoint(i,l),l.applyMatrix4(n);let c=r.ray.origin.distanceTo(l);if(c<r.near||c>r.far)return;s.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:e,face:null,faceIndex:null,barycoord:null,object:o})}}var go=class extends Kt{constructor(e=[],t=Tr,n,r,s,o,a,l,c,h){super(e,t,n,r,s,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}},yo=class extends Kt{constructor(e,t,n,r,s,o,a,l,c){super(e,t,n,r,s,o,a,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}};var Ti=class extends Kt{constructor(e,t,n=Hn,r,s,o,a=St,l=St,c,h=Ai,d=1){if(h!==Ai&&h!==Ci)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let u={width:e,height:t,depth:d};super(u,r,s,o,a,l,h,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new ds(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},xo=class extends Ti{constructor(e,t=Hn,n=Tr,r,s,o=St,a=St,l,c=Ai){let h={width:e,height:e,depth:1},d=[h,h,h,h,h,h];super(e,e,t,n,r,s,o,a,l,c),this.image=d,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},vo=class extends Kt{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},gs=class i extends sn{constructor(e=1,t=1,n=1,r=1,s=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:r,heightSegments:s,depthSegments:o};let a=this;r=Math.floor(r),s=Math.floor(s),o=Math.floor(o);let l=[],c=[],h=[],d=[],u=0,f=0;p("z","y","x",-1,-1,n,t,e,o,s,0),p("z","y","x",1,-1,n,t,-e,o,s,1),p("x","z","y",1,1,e,n,t,r,o,2),p("x","z","y",1,-1,e,n,-t,r,o,3),p("x","y","z",1,-1,e,t,n,r,s,4),p("x","y","z",-1,-1,e,t,-n,r,s,5),this.setIndex(l),this.setAttribute("position",new Cn(c,3)),this.setAttribute("normal",new Cn(h,3)),this.setAttribute("uv",new Cn(d,2));function p(v,g,m,x,w,_,T,A,y,M,D){let I=_/y,L=T/M,U=_/2,q=T/2,R=A/2,G=y+1,W=M+1,O=0,ee=0,H=new B;for(let J=0;J<W;J++){let te=J*L-q;for(let ve=0;ve<G;ve++){let Te=ve*I-U;H[v]=Te*x,H[g]=te*w,H[m]=R,c.push(H.x,H.y,H.z),H[v]=0,H[g]=0,H[m]=A>0?1:-1,h.push(H.x,H.y,H.z),d.push(ve/y),d.push(1-J/M),O+=1}}for(let J=0;J<M;J++)for(let te=0;te<y;te++){let ve=u+te+G*J,Te=u+te+G*(J+1),$=u+(te+1)+G*(J+1),re=u+(te+1)+G*J;l.push(ve,Te,re),l.push(Te,$,re),ee+=6}a.addGroup(f,ee,D),f+=ee,u+=O}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var bo=class i extends sn{constructor(e=1,t=1,n=1,r=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:r};let s=e/2,o=t/2,a=Math.floor(n),l=Math.floor(r),c=a+1,h=l+1,d=e/a,u=t/l,f=[],p=[],v=[],g=[];for(let m=0;m<h;m++){let x=m*u-o;for(let w=0;w<c;w++){let _=w*d-s;p.push(_,-x,0),v.push(0,0,1),g.push(w/a),g.push(1-m/l)}}for(let m=0;m<l;m++)for(let x=0;x<a;x++){let w=x+c*m,_=x+c*(m+1),T=x+1+c*(m+1),A=x+1+c*m;f.push(w,_,A),f.push(_,T,A)}this.setIndex(f),this.setAttribute("position",new Cn(p,3)),this.setAttribute("normal",new Cn(v,3)),this.setAttribute("uv",new Cn(g,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.widthSegments,e.heightSegments)}};function Rr(i){let e={};for(let t in i){e[t]={};for(let n in i[t]){let r=i[t][n];if(Ep(r))r.isRenderTargetTexture?(Ie("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=r.clone();else if(Array.isArray(r))if(Ep(r[0])){let s=[];for(let o=0,a=r.length;o<a;o++)s[o]=r[o].clone();e[t][n]=s}else e[t][n]=r.slice();else e[t][n]=r}}return e}function Yt(i){let e={};for(let t=0;t<i.length;t++){let n=Rr(i[t]);for(let r in n)e[r]=n[r]}return e}function Ep(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function yy(i){let e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function ku(i){let e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:Ye.workingColorSpace}var xm={clone:Rr,merge:Yt},xy=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,vy=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,$t=class extends Zi{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=xy,this.fragmentShader=vy,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Rr(e.uniforms),this.uniformsGroups=yy(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let r in this.uniforms){let o=this.uniforms[r].value;o&&o.isTexture?t.uniforms[r]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[r]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[r]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[r]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[r]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[r]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[r]={type:"m4",value:o.toArray()}:t.uniforms[r]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let n={};for(let r in this.extensions)this.extensions[r]===!0&&(n[r]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let n in e.uniforms){let r=e.uniforms[n];switch(this.uniforms[n]={},r.type){case"t":this.uniforms[n].value=t[r.value]||null;break;case"c":this.uniforms[n].value=new Ve().setHex(r.value);break;case"v2":this.uniforms[n].value=new Ge().fromArray(r.value);break;case"v3":this.uniforms[n].value=new B().fromArray(r.value);break;case"v4":this.uniforms[n].value=new lt().fromArray(r.value);break;case"m3":this.uniforms[n].value=new Fe().fromArray(r.value);break;case"m4":this.uniforms[n].value=new ut().fromArray(r.value);break;default:this.uniforms[n].value=r.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let n in e.extensions)this.extensions[n]=e.extensions[n];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},fl=class extends $t{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var pl=class extends Zi{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=nm,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},ml=class extends Zi{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function ss(i,e){return!i||i.constructor===e?i:typeof e.BYTES_PER_ELEMENT=="number"?new e(i):Array.prototype.slice.call(i)}function qa(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var Ki=class{constructor(e,t,n,r){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=r!==void 0?r:new t.constructor(n),this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,r=t[n],s=t[n-1];e:{t:{let o;n:{i:if(!(e<r)){for(let a=n+2;;){if(r===void 0){if(e<s)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(s=r,r=t[++n],e<r)break t}o=t.length;break n}if(!(e>=s)){let a=t[1];e<a&&(n=2,s=a);for(let l=n-2;;){if(s===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(r=s,s=t[--n-1],e>=s)break t}o=n,n=0;break n}break e}for(;n<o;){let a=n+o>>>1;e<t[a]?o=a:n=a+1}if(r=t[n],s=t[n-1],s===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(r===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,s,r)}return this.interpolate_(n,s,e,r)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,r=this.valueSize,s=e*r;for(let o=0;o!==r;++o)t[o]=n[s+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},gl=class extends Ki{constructor(e,t,n,r){super(e,t,n,r),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:ou,endingEnd:ou}}intervalChanged_(e,t,n){let r=this.parameterPositions,s=e-2,o=e+1,a=r[s],l=r[o];if(a===void 0)switch(this.getSettings_().endingStart){case au:s=e,a=2*t-n;break;case lu:s=r.length-2,a=t+r[s]-r[s+1];break;default:s=e,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case au:o=e,l=2*n-t;break;case lu:o=1,l=n+r[1]-r[0];break;default:o=e-1,l=t}let c=(n-t)*.5,h=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-n),this._offsetPrev=s*h,this._offsetNext=o*h}interpolate_(e,t,n,r){let s=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=this._offsetPrev,d=this._offsetNext,u=this._weightPrev,f=this._weightNext,p=(n-t)/(r-t),v=p*p,g=v*p,m=-u*g+2*u*v-u*p,x=(1+u)*g+(-1.5-2*u)*v+(-.5+u)*p+1,w=(-1-f)*g+(1.5+f)*v+.5*p,_=f*g-f*v;for(let T=0;T!==a;++T)s[T]=m*o[h+T]+x*o[c+T]+w*o[l+T]+_*o[d+T];return s}},yl=class extends Ki{constructor(e,t,n,r){super(e,t,n,r)}interpolate_(e,t,n,r){let s=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=(n-t)/(r-t),d=1-h;for(let u=0;u!==a;++u)s[u]=o[c+u]*d+o[l+u]*h;return s}},xl=class extends Ki{constructor(e,t,n,r){super(e,t,n,r)}interpolate_(e){return this.copySampleValue_(e-1)}},vl=class extends Ki{interpolate_(e,t,n,r){let s=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=this.inTangents,d=this.outTangents;if(!h||!d){let p=(n-t)/(r-t),v=1-p;for(let g=0;g!==a;++g)s[g]=o[c+g]*v+o[l+g]*p;return s}let u=a*2,f=e-1;for(let p=0;p!==a;++p){let v=o[c+p],g=o[l+p],m=f*u+p*2,x=d[m],w=d[m+1],_=e*u+p*2,T=h[_],A=h[_+1],y=_y(n,t,x,T,r);s[p]=vm(y,v,w,A,g)}return s}};function vm(i,e,t,n,r){let s=1-i;return s*s*s*e+3*s*s*i*t+3*s*i*i*n+i*i*i*r}function by(i,e,t,n,r){let s=1-i;return 3*s*s*(t-e)+6*s*i*(n-t)+3*i*i*(r-n)}function _y(i,e,t,n,r){let s=(i-e)/(r-e);for(let o=0;o<8;o++){let a=vm(s,e,t,n,r)-i;if(Math.abs(a)<1e-10)break;let l=by(s,e,t,n,r);if(Math.abs(l)<1e-10)break;s=Math.max(0,Math.min(1,s-a/l))}return s}var mn=class{constructor(e,t,n,r){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=ss(t,this.TimeBufferType),this.values=ss(n,this.ValueBufferType),this.setInterpolation(r||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:ss(e.times,Array),values:ss(e.values,Array)};let r=e.getInterpolation();r!==e.DefaultInterpolation&&(n.interpolation=r),qa(e.settings)&&(n.settings={inTangents:ss(e.settings.inTangents,Array),outTangents:ss(e.settings.outTangents,Array)})}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new xl(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new yl(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new gl(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new vl(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case io:t=this.InterpolantFactoryMethodDiscrete;break;case rl:t=this.InterpolantFactoryMethodLinear;break;case Ya:t=this.InterpolantFactoryMethodSmooth;break;case su:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return Ie("KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return io;case this.InterpolantFactoryMethodLinear:return rl;case this.InterpolantFactoryMethodSmooth:return Ya;case this.InterpolantFactoryMethodBezier:return su}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,r=t.length;n!==r;++n)t[n]+=e;qa(this.settings)&&(Cp(this.settings.inTangents,e),Cp(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,r=t.length;n!==r;++n)t[n]*=e;qa(this.settings)&&(Rp(this.settings.inTangents,e),Rp(this.settings.outTangents,e))}return this}trim(e,t){let n=this.times,r=n.length,s=0,o=r-1;for(;s!==r&&n[s]<e;)++s;for(;o!==-1&&n[o]>t;)--o;if(++o,s!==0||o!==r){s>=o&&(o=Math.max(o,1),s=o-1);let a=this.getValueSize();this.times=n.slice(s,o),this.values=this.values.slice(s*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(Ne("KeyframeTrack: Invalid value size in track.",this),e=!1);let n=this.times,r=this.values,s=n.length;s===0&&(Ne("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==s;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){Ne("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){Ne("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(r!==void 0&&K0(r))for(let a=0,l=r.length;a!==l;++a){let c=r[a];if(isNaN(c)){Ne("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),r=this.getInterpolation()===Ya,s=e.length-1,o=1;for(let a=1;a<s;++a){let l=!1,c=e[a],h=e[a+1];if(c!==h&&(a!==1||c!==e[0]))if(r)l=!0;else{let d=a*n,u=d-n,f=d+n;for(let p=0;p!==n;++p){let v=t[d+p];if(v!==t[u+p]||v!==t[f+p]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let d=a*n,u=o*n;for(let f=0;f!==n;++f)t[u+f]=t[d+f]}++o}}if(s>0){e[o]=e[s];for(let a=s*n,l=o*n,c=0;c!==n;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,r=new n(this.name,e,t);return r.createInterpolant=this.createInterpolant,qa(this.settings)&&(r.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),r}};function Cp(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]+=e}function Rp(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]*=e}mn.prototype.ValueTypeName="";mn.prototype.TimeBufferType=Float32Array;mn.prototype.ValueBufferType=Float32Array;mn.prototype.DefaultInterpolation=rl;var ji=class extends mn{constructor(e,t,n){super(e,t,n)}};ji.prototype.ValueTypeName="bool";ji.prototype.ValueBufferType=Array;ji.prototype.DefaultInterpolation=io;ji.prototype.InterpolantFactoryMethodLinear=void 0;ji.prototype.InterpolantFactoryMethodSmooth=void 0;var bl=class extends mn{constructor(e,t,n,r){super(e,t,n,r)}};bl.prototype.ValueTypeName="color";var _l=class extends mn{constructor(e,t,n,r){super(e,t,n,r)}};_l.prototype.ValueTypeName="number";var Sl=class extends Ki{constructor(e,t,n,r){super(e,t,n,r)}interpolate_(e,t,n,r){let s=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-t)/(r-t),c=e*a;for(let h=c+a;c!==h;c+=4)oi.slerpFlat(s,0,o,c-a,o,c,l);return s}},_o=class extends mn{constructor(e,t,n,r){super(e,t,n,r)}InterpolantFactoryMethodLinear(e){return new Sl(this.times,this.values,this.getValueSize(),e)}};_o.prototype.ValueTypeName="quaternion";_o.prototype.InterpolantFactoryMethodSmooth=void 0;var Qi=class extends mn{constructor(e,t,n){super(e,t,n)}};Qi.prototype.ValueTypeName="string";Qi.prototype.ValueBufferType=Array;Qi.prototype.DefaultInterpolation=io;Qi.prototype.InterpolantFactoryMethodLinear=void 0;Qi.prototype.InterpolantFactoryMethodSmooth=void 0;var Ml=class extends mn{constructor(e,t,n,r){super(e,t,n,r)}};Ml.prototype.ValueTypeName="vector";var wl=class{constructor(e,t,n){let r=this,s=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this._abortController=null,this.itemStart=function(h){a++,s===!1&&r.onStart!==void 0&&r.onStart(h,o,a),s=!0},this.itemEnd=function(h){o++,r.onProgress!==void 0&&r.onProgress(h,o,a),o===a&&(s=!1,r.onLoad!==void 0&&r.onLoad())},this.itemError=function(h){r.onError!==void 0&&r.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,d){return c.push(h,d),this},this.removeHandler=function(h){let d=c.indexOf(h);return d!==-1&&c.splice(d,2),this},this.getHandler=function(h){for(let d=0,u=c.length;d<u;d+=2){let f=c[d],p=c[d+1];if(f.global&&(f.lastIndex=0),f.test(h))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},bm=new wl,Al=class{constructor(e){this.manager=e!==void 0?e:bm,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let n=this;return new Promise(function(r,s){n.load(e,r,t,s)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};Al.DEFAULT_MATERIAL_NAME="__DEFAULT";var Xa=new B,$a=new oi,ii=new B,So=class extends pn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new ut,this.projectionMatrix=new ut,this.projectionMatrixInverse=new ut,this.coordinateSystem=En,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(Xa,$a,ii),ii.x===1&&ii.y===1&&ii.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Xa,$a,ii.set(1,1,1)).invert()}updateWorldMatrix(e,t,n=!1){super.updateWorldMatrix(e,t,n),this.matrixWorld.decompose(Xa,$a,ii),ii.x===1&&ii.y===1&&ii.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Xa,$a,ii.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Xi=new B,Pp=new Ge,Ip=new Ge,qt=class extends So{constructor(e=50,t=1,n=.1,r=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=r,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=sl*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(kh*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return sl*2*Math.atan(Math.tan(kh*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){Xi.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Xi.x,Xi.y).multiplyScalar(-e/Xi.z),Xi.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(Xi.x,Xi.y).multiplyScalar(-e/Xi.z)}getViewSize(e,t){return this.getViewBounds(e,Pp,Ip),t.subVectors(Ip,Pp)}setViewOffset(e,t,n,r,s,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=r,this.view.width=s,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(kh*.5*this.fov)/this.zoom,n=2*t,r=this.aspect*n,s=-.5*r,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;s+=o.offsetX*r/l,t-=o.offsetY*n/c,r*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(s+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(s,s+r,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var ys=class extends So{constructor(e=-1,t=1,n=1,r=-1,s=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=r,this.near=s,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,r,s,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=r,this.view.width=s,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,r=(this.top+this.bottom)/2,s=n-e,o=n+e,a=r+t,l=r-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;s+=c*this.view.offsetX,o=s+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(s,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}};var Mo=class extends sn{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(e){return super.copy(e),this.instanceCount=e.instanceCount,this}toJSON(){let e=super.toJSON();return e.instanceCount=this.instanceCount,e.isInstancedBufferGeometry=!0,e}};var os=-90,as=1,xs=class extends pn{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let r=new qt(os,as,e,t);r.layers=this.layers,this.add(r);let s=new qt(os,as,e,t);s.layers=this.layers,this.add(s);let o=new qt(os,as,e,t);o.layers=this.layers,this.add(o);let a=new qt(os,as,e,t);a.layers=this.layers,this.add(a);let l=new qt(os,as,e,t);l.layers=this.layers,this.add(l);let c=new qt(os,as,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[n,r,s,o,a,l]=t;for(let c of t)this.remove(c);if(e===En)n.up.set(0,1,0),n.lookAt(1,0,0),r.up.set(0,1,0),r.lookAt(-1,0,0),s.up.set(0,0,-1),s.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===oo)n.up.set(0,-1,0),n.lookAt(-1,0,0),r.up.set(0,-1,0),r.lookAt(1,0,0),s.up.set(0,0,1),s.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:r}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[s,o,a,l,c,h]=this.children,d=e.getRenderTarget(),u=e.getActiveCubeFace(),f=e.getActiveMipmapLevel(),p=e.xr.enabled;e.xr.enabled=!1;let v=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let g=!1;e.isWebGLRenderer===!0?g=e.state.buffers.depth.getReversed():g=e.reversedDepthBuffer,e.setRenderTarget(n,0,r),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,s),e.setRenderTarget(n,1,r),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(n,2,r),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(n,3,r),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(n,4,r),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),n.texture.mipmapsAutoUpdate=v,e.setRenderTarget(n,5,r),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,h),e.setRenderTarget(d,u,f),e.xr.enabled=p,n.texture.needsPMREMUpdate=!0}},Tl=class extends qt{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var Bu="\\[\\]\\.:\\/",Sy=new RegExp("["+Bu+"]","g"),zu="[^"+Bu+"]",My="[^"+Bu.replace("\\.","")+"]",wy=/((?:WC+[\/:])*)/.source.replace("WC",zu),Ay=/(WCOD+)?/.source.replace("WCOD",My),Ty=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",zu),Ey=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",zu),Cy=new RegExp("^"+wy+Ay+Ty+Ey+"$"),Ry=["material","materials","bones","map"],hu=class{constructor(e,t,n){let r=n||ht.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,r)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,r=this._bindings[n];r!==void 0&&r.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let r=this._targetGroup.nCachedObjects_,s=n.length;r!==s;++r)n[r].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},ht=class i{constructor(e,t,n){this.path=t,this.parsedPath=n||i.parseTrackName(t),this.node=i.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){return e&&e.isAnimationObjectGroup?new i.Composite(e,t,n):new i(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(Sy,"")}static parseTrackName(e){let t=Cy.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},r=n.nodeName&&n.nodeName.lastIndexOf(".");if(r!==void 0&&r!==-1){let s=n.nodeName.substring(r+1);Ry.indexOf(s)!==-1&&(n.nodeName=n.nodeName.substring(0,r),n.objectName=s)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=function(s){for(let o=0;o<s.length;o++){let a=s[o];if(a.name===t||a.uuid===t)return a;let l=n(a.children);if(l)return l}return null},r=n(e.children);if(r)return r}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let r=0,s=n.length;r!==s;++r)e[t++]=n[r]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let r=0,s=n.length;r!==s;++r)n[r]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let r=0,s=n.length;r!==s;++r)n[r]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let r=0,s=n.length;r!==s;++r)n[r]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,n=t.objectName,r=t.propertyName,s=t.propertyIndex;if(e||(e=i.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Ie("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=t.objectIndex;switch(n){case"materials":if(!e.material){Ne("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){Ne("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){Ne("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let h=0;h<e.length;h++)if(e[h].name===c){c=h;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){Ne("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){Ne("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){Ne("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(c!==void 0){if(e[c]===void 0){Ne("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[r];if(o===void 0){let c=t.nodeName;Ne("PropertyBinding: Trying to update property for track: "+c+"."+r+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(s!==void 0){if(r==="morphTargetInfluences"){if(!e.geometry){Ne("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){Ne("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[s]!==void 0&&(s=e.morphTargetDictionary[s])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=s}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=r;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};ht.Composite=hu;ht.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};ht.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};ht.prototype.GetterByBindingType=[ht.prototype._getValue_direct,ht.prototype._getValue_array,ht.prototype._getValue_arrayElement,ht.prototype._getValue_toArray];ht.prototype.SetterByBindingTypeAndVersioning=[[ht.prototype._setValue_direct,ht.prototype._setValue_direct_setNeedsUpdate,ht.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[ht.prototype._setValue_array,ht.prototype._setValue_array_setNeedsUpdate,ht.prototype._setValue_array_setMatrixWorldNeedsUpdate],[ht.prototype._setValue_arrayElement,ht.prototype._setValue_arrayElement_setNeedsUpdate,ht.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[ht.prototype._setValue_fromArray,ht.prototype._setValue_fromArray_setNeedsUpdate,ht.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var TA=new Float32Array(1);var wo=class extends cl{constructor(e,t,n=1){super(e,t),this.isInstancedInterleavedBuffer=!0,this.meshPerAttribute=n}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}clone(e){let t=super.clone(e);return t.meshPerAttribute=this.meshPerAttribute,t}toJSON(e){let t=super.toJSON(e);return t.isInstancedInterleavedBuffer=!0,t.meshPerAttribute=this.meshPerAttribute,t}};var uu=class{static{this.prototype.isMatrix2=!0}constructor(e,t,n,r){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,n,r)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let n=0;n<4;n++)this.elements[n]=e[n+t];return this}set(e,t,n,r){let s=this.elements;return s[0]=e,s[2]=t,s[1]=n,s[3]=r,this}};function Vu(i,e,t,n){let r=Py(n);switch(t){case Iu:return i*e;case Eo:return i*e/r.components*r.byteLength;case Nl:return i*e/r.components*r.byteLength;case tr:return i*e*2/r.components*r.byteLength;case Dl:return i*e*2/r.components*r.byteLength;case Lu:return i*e*3/r.components*r.byteLength;case yn:return i*e*4/r.components*r.byteLength;case Fl:return i*e*4/r.components*r.byteLength;case Co:case Ro:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Po:case Io:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Ol:case Bl:return Math.max(i,16)*Math.max(e,8)/4;case Ul:case kl:return Math.max(i,8)*Math.max(e,8)/2;case zl:case Vl:case Gl:case Wl:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Hl:case Lo:case ql:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Xl:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case $l:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case Yl:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case Jl:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case Zl:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case Kl:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case jl:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case Ql:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case ec:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case tc:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case nc:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case ic:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case rc:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case sc:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case oc:case ac:case lc:return Math.ceil(i/4)*Math.ceil(e/4)*16;case cc:case hc:return Math.ceil(i/4)*Math.ceil(e/4)*8;case No:case uc:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function Py(i){switch(i){case Qt:case Eu:return{byteLength:1,components:1};case Ss:case Cu:case Gn:return{byteLength:2,components:1};case Il:case Ll:return{byteLength:2,components:4};case Hn:case Pl:case gn:return{byteLength:4,components:1};case Ru:case Pu:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Ie("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Hm(){let i=null,e=!1,t=null,n=null;function r(s,o){n=i.requestAnimationFrame(r),t(s,o)}return{start:function(){e!==!0&&t!==null&&i!==null&&(n=i.requestAnimationFrame(r),e=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(s){t=s},setContext:function(s){i=s}}}function Ly(i){let e=new WeakMap;function t(a,l){let c=a.array,h=a.usage,d=c.byteLength,u=i.createBuffer();i.bindBuffer(l,u),i.bufferData(l,c,h),a.onUploadCallback();let f;if(c instanceof Float32Array)f=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=i.HALF_FLOAT:f=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=i.SHORT;else if(c instanceof Uint32Array)f=i.UNSIGNED_INT;else if(c instanceof Int32Array)f=i.INT;else if(c instanceof Int8Array)f=i.BYTE;else if(c instanceof Uint8Array)f=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:u,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:d}}function n(a,l,c){let h=l.array,d=l.updateRanges;if(i.bindBuffer(c,a),d.length===0)i.bufferSubData(c,0,h);else{d.sort((f,p)=>f.start-p.start);let u=0;for(let f=1;f<d.length;f++){let p=d[u],v=d[f];v.start<=p.start+p.count+1?p.count=Math.max(p.count,v.start+v.count-p.start):(++u,d[u]=v)}d.length=u+1;for(let f=0,p=d.length;f<p;f++){let v=d[f];i.bufferSubData(c,v.start*h.BYTES_PER_ELEMENT,h,v.start,v.count)}l.clearUpdateRanges()}l.onUploadCallback()}function r(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function s(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(i.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=e.get(a);(!h||h.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:r,remove:s,update:o}}var Ny=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,Dy=`#ifdef USE_ALPHAHASH
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
#endif`,Fy=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,Uy=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Oy=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,ky=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,By=`#ifdef USE_AOMAP
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
#endif`,zy=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,Vy=`#ifdef USE_BATCHING
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
#endif`,Hy=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,Gy=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,Wy=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,qy=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,Xy=`#ifdef USE_IRIDESCENCE
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
#endif`,$y=`#ifdef USE_BUMPMAP
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
#endif`,Yy=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,Jy=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,Zy=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Ky=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,jy=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,Qy=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
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
#endif`,ox=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,ax=`#ifdef USE_EMISSIVEMAP
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
#endif`,fx=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,px=`#ifdef USE_ENVMAP
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
#endif`,yx=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,xx=`#ifdef USE_FOG
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
}`,bx=`#ifdef USE_LIGHTMAP
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
material.diffuseColor = diffuseColor.rgb;`,Tx=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Ex=`BlinnPhongMaterial material;
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
#endif`,Lx=`#if defined( RE_IndirectDiffuse )
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
#endif`,Nx=`#if defined( RE_IndirectDiffuse )
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
#endif`,Ux=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Ox=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,kx=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Bx=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,zx=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Vx=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,Hx=`#if defined( USE_POINTS_UV )
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
#endif`,Gx=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Wx=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,qx=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Xx=`#if defined( USE_MORPHCOLORS )
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
#endif`,$x=`#ifdef USE_MORPHNORMALS
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
#endif`,Zx=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,Kx=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,jx=`#ifndef FLAT_SHADED
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
#endif`,ev=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,tv=`#ifdef USE_NORMALMAP
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
#endif`,nv=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,iv=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,rv=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,sv=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,ov=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,av=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,lv=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,cv=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,hv=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,uv=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,dv=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,fv=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,pv=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,mv=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,gv=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,yv=`float getShadowMask() {
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
}`,xv=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,vv=`#ifdef USE_SKINNING
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
#endif`,bv=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,_v=`#ifdef USE_SKINNING
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
#endif`,Sv=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,Mv=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,wv=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,Av=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,Tv=`#ifdef USE_TRANSMISSION
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
#endif`,Ev=`#ifdef USE_TRANSMISSION
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
#endif`,Cv=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,Rv=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,Pv=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,Iv=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,Lv=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,Nv=`uniform sampler2D t2D;
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
}`,Dv=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Fv=`uniform float backgroundBlurriness;
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
}`,Uv=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Ov=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,kv=`#include <common>
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
}`,Bv=`#if DEPTH_PACKING == 3200
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
}`,zv=`#define DISTANCE
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
}`,Vv=`#define DISTANCE
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
}`,Hv=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,Gv=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Wv=`uniform float scale;
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
}`,qv=`uniform vec3 diffuse;
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
}`,Xv=`#include <common>
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
}`,$v=`uniform vec3 diffuse;
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
}`,Yv=`#define LAMBERT
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
}`,Jv=`#define LAMBERT
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
}`,Zv=`#define MATCAP
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
}`,Kv=`#define MATCAP
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
}`,jv=`#define NORMAL
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
}`,Qv=`#define NORMAL
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
}`,eb=`#define PHONG
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
}`,tb=`#define PHONG
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
}`,nb=`#define STANDARD
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
}`,ib=`#define STANDARD
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
}`,rb=`#define TOON
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
}`,sb=`#define TOON
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
}`,ob=`uniform float size;
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
}`,ab=`uniform vec3 diffuse;
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
}`,lb=`#include <common>
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
}`,cb=`uniform vec3 color;
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
}`,hb=`uniform float rotation;
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
}`,ub=`uniform vec3 diffuse;
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
}`,He={alphahash_fragment:Ny,alphahash_pars_fragment:Dy,alphamap_fragment:Fy,alphamap_pars_fragment:Uy,alphatest_fragment:Oy,alphatest_pars_fragment:ky,aomap_fragment:By,aomap_pars_fragment:zy,batching_pars_vertex:Vy,batching_vertex:Hy,begin_vertex:Gy,beginnormal_vertex:Wy,bsdfs:qy,iridescence_fragment:Xy,bumpmap_pars_fragment:$y,clipping_planes_fragment:Yy,clipping_planes_pars_fragment:Jy,clipping_planes_pars_vertex:Zy,clipping_planes_vertex:Ky,color_fragment:jy,color_pars_fragment:Qy,color_pars_vertex:ex,color_vertex:tx,common:nx,defaultnormal_vertex:ix,displacementmap_pars_vertex:rx,displacementmap_vertex:sx,emissivemap_fragment:ox,emissivemap_pars_fragment:ax,colorspace_fragment:lx,colorspace_pars_fragment:cx,envmap_fragment:hx,envmap_common_pars_fragment:ux,envmap_pars_fragment:dx,envmap_pars_vertex:fx,envmap_physical_pars_fragment:wx,envmap_vertex:px,fog_vertex:mx,fog_pars_vertex:gx,fog_fragment:yx,fog_pars_fragment:xx,gradientmap_pars_fragment:vx,lightmap_pars_fragment:bx,lights_lambert_fragment:_x,lights_lambert_pars_fragment:Sx,lights_pars_begin:Mx,lights_toon_fragment:Ax,lights_toon_pars_fragment:Tx,lights_phong_fragment:Ex,lights_phong_pars_fragment:Cx,lights_physical_fragment:Rx,lights_physical_pars_fragment:Px,lights_fragment_begin:Ix,lights_fragment_maps:Lx,lights_fragment_end:Nx,lightprobes_pars_fragment:Dx,logdepthbuf_fragment:Fx,logdepthbuf_pars_fragment:Ux,logdepthbuf_pars_vertex:Ox,logdepthbuf_vertex:kx,map_fragment:Bx,map_pars_fragment:zx,map_particle_fragment:Vx,map_particle_pars_fragment:Hx,metalnessmap_fragment:Gx,metalnessmap_pars_fragment:Wx,morphinstance_vertex:qx,morphcolor_vertex:Xx,morphnormal_vertex:$x,morphtarget_pars_vertex:Yx,morphtarget_vertex:Jx,normal_fragment_begin:Zx,normal_fragment_maps:Kx,normal_pars_fragment:jx,normal_pars_vertex:Qx,normal_vertex:ev,normalmap_pars_fragment:tv,clearcoat_normal_fragment_begin:nv,clearcoat_normal_fragment_maps:iv,clearcoat_pars_fragment:rv,iridescence_pars_fragment:sv,opaque_fragment:ov,packing:av,premultiplied_alpha_fragment:lv,project_vertex:cv,dithering_fragment:hv,dithering_pars_fragment:uv,roughnessmap_fragment:dv,roughnessmap_pars_fragment:fv,shadowmap_pars_fragment:pv,shadowmap_pars_vertex:mv,shadowmap_vertex:gv,shadowmask_pars_fragment:yv,skinbase_vertex:xv,skinning_pars_vertex:vv,skinning_vertex:bv,skinnormal_vertex:_v,specularmap_fragment:Sv,specularmap_pars_fragment:Mv,tonemapping_fragment:wv,tonemapping_pars_fragment:Av,transmission_fragment:Tv,transmission_pars_fragment:Ev,uv_pars_fragment:Cv,uv_pars_vertex:Rv,uv_vertex:Pv,worldpos_vertex:Iv,background_vert:Lv,background_frag:Nv,backgroundCube_vert:Dv,backgroundCube_frag:Fv,cube_vert:Uv,cube_frag:Ov,depth_vert:kv,depth_frag:Bv,distance_vert:zv,distance_frag:Vv,equirect_vert:Hv,equirect_frag:Gv,linedashed_vert:Wv,linedashed_frag:qv,meshbasic_vert:Xv,meshbasic_frag:$v,meshlambert_vert:Yv,meshlambert_frag:Jv,meshmatcap_vert:Zv,meshmatcap_frag:Kv,meshnormal_vert:jv,meshnormal_frag:Qv,meshphong_vert:eb,meshphong_frag:tb,meshphysical_vert:nb,meshphysical_frag:ib,meshtoon_vert:rb,meshtoon_frag:sb,points_vert:ob,points_frag:ab,shadow_vert:lb,shadow_frag:cb,sprite_vert:hb,sprite_frag:ub},ye={common:{diffuse:{value:new Ve(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new Fe},alphaMap:{value:null},alphaMapTransform:{value:new Fe},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new Fe}},envmap:{envMap:{value:null},envMapRotation:{value:new Fe},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new Fe}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new Fe}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new Fe},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new Fe},normalScale:{value:new Ge(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new Fe},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new Fe}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new Fe}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new Fe}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Ve(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Ve(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new Fe},alphaTest:{value:0},uvTransform:{value:new Fe}},sprite:{diffuse:{value:new Ve(16777215)},opacity:{value:1},center:{value:new Ge(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new Fe},alphaMap:{value:null},alphaMapTransform:{value:new Fe},alphaTest:{value:0}}},ci={basic:{uniforms:Yt([ye.common,ye.specularmap,ye.envmap,ye.aomap,ye.lightmap,ye.fog]),vertexShader:He.meshbasic_vert,fragmentShader:He.meshbasic_frag},lambert:{uniforms:Yt([ye.common,ye.specularmap,ye.envmap,ye.aomap,ye.lightmap,ye.emissivemap,ye.bumpmap,ye.normalmap,ye.displacementmap,ye.fog,ye.lights,{emissive:{value:new Ve(0)},envMapIntensity:{value:1}}]),vertexShader:He.meshlambert_vert,fragmentShader:He.meshlambert_frag},phong:{uniforms:Yt([ye.common,ye.specularmap,ye.envmap,ye.aomap,ye.lightmap,ye.emissivemap,ye.bumpmap,ye.normalmap,ye.displacementmap,ye.fog,ye.lights,{emissive:{value:new Ve(0)},specular:{value:new Ve(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:He.meshphong_vert,fragmentShader:He.meshphong_frag},standard:{uniforms:Yt([ye.common,ye.envmap,ye.aomap,ye.lightmap,ye.emissivemap,ye.bumpmap,ye.normalmap,ye.displacementmap,ye.roughnessmap,ye.metalnessmap,ye.fog,ye.lights,{emissive:{value:new Ve(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:He.meshphysical_vert,fragmentShader:He.meshphysical_frag},toon:{uniforms:Yt([ye.common,ye.aomap,ye.lightmap,ye.emissivemap,ye.bumpmap,ye.normalmap,ye.displacementmap,ye.gradientmap,ye.fog,ye.lights,{emissive:{value:new Ve(0)}}]),vertexShader:He.meshtoon_vert,fragmentShader:He.meshtoon_frag},matcap:{uniforms:Yt([ye.common,ye.bumpmap,ye.normalmap,ye.displacementmap,ye.fog,{matcap:{value:null}}]),vertexShader:He.meshmatcap_vert,fragmentShader:He.meshmatcap_frag},points:{uniforms:Yt([ye.points,ye.fog]),vertexShader:He.points_vert,fragmentShader:He.points_frag},dashed:{uniforms:Yt([ye.common,ye.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:He.linedashed_vert,fragmentShader:He.linedashed_frag},depth:{uniforms:Yt([ye.common,ye.displacementmap]),vertexShader:He.depth_vert,fragmentShader:He.depth_frag},normal:{uniforms:Yt([ye.common,ye.bumpmap,ye.normalmap,ye.displacementmap,{opacity:{value:1}}]),vertexShader:He.meshnormal_vert,fragmentShader:He.meshnormal_frag},sprite:{uniforms:Yt([ye.sprite,ye.fog]),vertexShader:He.sprite_vert,fragmentShader:He.sprite_frag},background:{uniforms:{uvTransform:{value:new Fe},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:He.background_vert,fragmentShader:He.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new Fe}},vertexShader:He.backgroundCube_vert,fragmentShader:He.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:He.cube_vert,fragmentShader:He.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:He.equirect_vert,fragmentShader:He.equirect_frag},distance:{uniforms:Yt([ye.common,ye.displacementmap,{referencePosition:{value:new B},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:He.distance_vert,fragmentShader:He.distance_frag},shadow:{uniforms:Yt([ye.lights,ye.fog,{color:{value:new Ve(0)},opacity:{value:1}}]),vertexShader:He.shadow_vert,fragmentShader:He.shadow_frag}};ci.physical={uniforms:Yt([ci.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new Fe},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new Fe},clearcoatNormalScale:{value:new Ge(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new Fe},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new Fe},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new Fe},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new Fe},sheen:{value:0},sheenColor:{value:new Ve(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new Fe},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new Fe},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new Fe},transmissionSamplerSize:{value:new Ge},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new Fe},attenuationDistance:{value:0},attenuationColor:{value:new Ve(0)},specularColor:{value:new Ve(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new Fe},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new Fe},anisotropyVector:{value:new Ge},anisotropyMap:{value:null},anisotropyMapTransform:{value:new Fe}}]),vertexShader:He.meshphysical_vert,fragmentShader:He.meshphysical_frag};var fc={r:0,b:0,g:0},db=new ut,Gm=new Fe;Gm.set(-1,0,0,0,1,0,0,0,1);function fb(i,e,t,n,r,s){let o=new Ve(0),a=r===!0?0:1,l,c,h=null,d=0,u=null;function f(x){let w=x.isScene===!0?x.background:null;if(w&&w.isTexture){let _=x.backgroundBlurriness>0;w=e.get(w,_)}return w}function p(x){let w=!1,_=f(x);_===null?g(o,a):_&&_.isColor&&(g(_,1),w=!0);let T=i.xr.getEnvironmentBlendMode();T==="additive"?t.buffers.color.setClear(0,0,0,1,s):T==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,s),(i.autoClear||w)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function v(x,w){let _=f(w);_&&_.isCubeTexture?(c===void 0&&(c=new Xt(new gs(1,1,1),new $t({name:"BackgroundCubeMaterial",uniforms:Rr(ci.backgroundCube.uniforms),vertexShader:ci.backgroundCube.vertexShader,fragmentShader:ci.backgroundCube.fragmentShader,side:jt,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(T,A,y){this.matrixWorld.copyPosition(y.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=_,c.material.uniforms.backgroundBlurriness.value=w.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=w.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(db.makeRotationFromEuler(w.backgroundRotation)).transpose(),_.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Gm),c.material.toneMapped=Ye.getTransfer(_.colorSpace)!==nt,(h!==_||d!==_.version||u!==i.toneMapping)&&(c.material.needsUpdate=!0,h=_,d=_.version,u=i.toneMapping),c.layers.enableAll(),x.unshift(c,c.geometry,c.material,0,0,null)):_&&_.isTexture&&(l===void 0&&(l=new Xt(new bo(2,2),new $t({name:"BackgroundMaterial",uniforms:Rr(ci.background.uniforms),vertexShader:ci.background.vertexShader,fragmentShader:ci.background.fragmentShader,side:er,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=_,l.material.uniforms.backgroundIntensity.value=w.backgroundIntensity,l.material.toneMapped=Ye.getTransfer(_.colorSpace)!==nt,_.matrixAutoUpdate===!0&&_.updateMatrix(),l.material.uniforms.uvTransform.value.copy(_.matrix),(h!==_||d!==_.version||u!==i.toneMapping)&&(l.material.needsUpdate=!0,h=_,d=_.version,u=i.toneMapping),l.layers.enableAll(),x.unshift(l,l.geometry,l.material,0,0,null))}function g(x,w){x.getRGB(fc,ku(i)),t.buffers.color.setClear(fc.r,fc.g,fc.b,w,s)}function m(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(x,w=1){o.set(x),a=w,g(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(x){a=x,g(o,a)},render:p,addToRenderList:v,dispose:m}}function pb(i,e){let t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},r=u(null),s=r,o=!1;function a(L,U,q,R,G){let W=!1,O=d(L,R,q,U);s!==O&&(s=O,c(s.object)),W=f(L,R,q,G),W&&p(L,R,q,G),G!==null&&e.update(G,i.ELEMENT_ARRAY_BUFFER),(W||o)&&(o=!1,_(L,U,q,R),G!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get(G).buffer))}function l(){return i.createVertexArray()}function c(L){return i.bindVertexArray(L)}function h(L){return i.deleteVertexArray(L)}function d(L,U,q,R){let G=R.wireframe===!0,W=n[U.id];W===void 0&&(W={},n[U.id]=W);let O=L.isInstancedMesh===!0?L.id:0,ee=W[O];ee===void 0&&(ee={},W[O]=ee);let H=ee[q.id];H===void 0&&(H={},ee[q.id]=H);let J=H[G];return J===void 0&&(J=u(l()),H[G]=J),J}function u(L){let U=[],q=[],R=[];for(let G=0;G<t;G++)U[G]=0,q[G]=0,R[G]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:U,enabledAttributes:q,attributeDivisors:R,object:L,attributes:{},index:null}}function f(L,U,q,R){let G=s.attributes,W=U.attributes,O=0,ee=q.getAttributes();for(let H in ee)if(ee[H].location>=0){let te=G[H],ve=W[H];if(ve===void 0&&(H==="instanceMatrix"&&L.instanceMatrix&&(ve=L.instanceMatrix),H==="instanceColor"&&L.instanceColor&&(ve=L.instanceColor)),te===void 0||te.attribute!==ve||ve&&te.data!==ve.data)return!0;O++}return s.attributesNum!==O||s.index!==R}function p(L,U,q,R){let G={},W=U.attributes,O=0,ee=q.getAttributes();for(let H in ee)if(ee[H].location>=0){let te=W[H];te===void 0&&(H==="instanceMatrix"&&L.instanceMatrix&&(te=L.instanceMatrix),H==="instanceColor"&&L.instanceColor&&(te=L.instanceColor));let ve={};ve.attribute=te,te&&te.data&&(ve.data=te.data),G[H]=ve,O++}s.attributes=G,s.attributesNum=O,s.index=R}function v(){let L=s.newAttributes;for(let U=0,q=L.length;U<q;U++)L[U]=0}function g(L){m(L,0)}function m(L,U){let q=s.newAttributes,R=s.enabledAttributes,G=s.attributeDivisors;q[L]=1,R[L]===0&&(i.enableVertexAttribArray(L),R[L]=1),G[L]!==U&&(i.vertexAttribDivisor(L,U),G[L]=U)}function x(){let L=s.newAttributes,U=s.enabledAttributes;for(let q=0,R=U.length;q<R;q++)U[q]!==L[q]&&(i.disableVertexAttribArray(q),U[q]=0)}function w(L,U,q,R,G,W,O){O===!0?i.vertexAttribIPointer(L,U,q,G,W):i.vertexAttribPointer(L,U,q,R,G,W)}function _(L,U,q,R){v();let G=R.attributes,W=q.getAttributes(),O=U.defaultAttributeValues;for(let ee in W){let H=W[ee];if(H.location>=0){let J=G[ee];if(J===void 0&&(ee==="instanceMatrix"&&L.instanceMatrix&&(J=L.instanceMatrix),ee==="instanceColor"&&L.instanceColor&&(J=L.instanceColor)),J!==void 0){let te=J.normalized,ve=J.itemSize,Te=e.get(J);if(Te===void 0)continue;let $=Te.buffer,re=Te.type,me=Te.bytesPerElement,Me=re===i.INT||re===i.UNSIGNED_INT||J.gpuType===Pl;if(J.isInterleavedBufferAttribute){let fe=J.data,Le=fe.isInterleavedBuffer===!0?fe.stride:fe.itemSize,dt=J.offset;if(fe.isInstancedInterleavedBuffer||fe.isInstancedBufferAttribute){for(let Ce=0;Ce<H.locationSize;Ce++)m(H.location+Ce,fe.meshPerAttribute);L.isInstancedMesh!==!0&&R._maxInstanceCount===void 0&&(R._maxInstanceCount=fe.meshPerAttribute*fe.count)}else for(let Ce=0;Ce<H.locationSize;Ce++)g(H.location+Ce);i.bindBuffer(i.ARRAY_BUFFER,$);for(let Ce=0;Ce<H.locationSize;Ce++)w(H.location+Ce,ve/H.locationSize,re,te,Le*me,(dt+ve/H.locationSize*Ce)*me,Me)}else{if(J.isInstancedBufferAttribute){for(let fe=0;fe<H.locationSize;fe++)m(H.location+fe,J.meshPerAttribute);L.isInstancedMesh!==!0&&R._maxInstanceCount===void 0&&(R._maxInstanceCount=J.meshPerAttribute*J.count)}else for(let fe=0;fe<H.locationSize;fe++)g(H.location+fe);i.bindBuffer(i.ARRAY_BUFFER,$);for(let fe=0;fe<H.locationSize;fe++)w(H.location+fe,ve/H.locationSize,re,te,ve*me,ve/H.locationSize*fe*me,Me)}}else if(O!==void 0){let te=O[ee];if(te!==void 0)switch(te.length){case 2:i.vertexAttrib2fv(H.location,te);break;case 3:i.vertexAttrib3fv(H.location,te);break;case 4:i.vertexAttrib4fv(H.location,te);break;default:i.vertexAttrib1fv(H.location,te)}}}}x()}function T(){D();for(let L in n){let U=n[L];for(let q in U){let R=U[q];for(let G in R){let W=R[G];for(let O in W)h(W[O].object),delete W[O];delete R[G]}}delete n[L]}}function A(L){if(n[L.id]===void 0)return;let U=n[L.id];for(let q in U){let R=U[q];for(let G in R){let W=R[G];for(let O in W)h(W[O].object),delete W[O];delete R[G]}}delete n[L.id]}function y(L){for(let U in n){let q=n[U];for(let R in q){let G=q[R];if(G[L.id]===void 0)continue;let W=G[L.id];for(let O in W)h(W[O].object),delete W[O];delete G[L.id]}}}function M(L){for(let U in n){let q=n[U],R=L.isInstancedMesh===!0?L.id:0,G=q[R];if(G!==void 0){for(let W in G){let O=G[W];for(let ee in O)h(O[ee].object),delete O[ee];delete G[W]}delete q[R],Object.keys(q).length===0&&delete n[U]}}}function D(){I(),o=!0,s!==r&&(s=r,c(s.object))}function I(){r.geometry=null,r.program=null,r.wireframe=!1}return{setup:a,reset:D,resetDefaultState:I,dispose:T,releaseStatesOfGeometry:A,releaseStatesOfObject:M,releaseStatesOfProgram:y,initAttributes:v,enableAttribute:g,disableUnusedAttributes:x}}function mb(i,e,t){let n;function r(l){n=l}function s(l,c){i.drawArrays(n,l,c),t.update(c,n,1)}function o(l,c,h){h!==0&&(i.drawArraysInstanced(n,l,c,h),t.update(c,n,h))}function a(l,c,h){if(h===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,h);let u=0;for(let f=0;f<h;f++)u+=c[f];t.update(u,n,1)}this.setMode=r,this.render=s,this.renderInstances=o,this.renderMultiDraw=a}function gb(i,e,t,n){let r;function s(){if(r!==void 0)return r;if(e.has("EXT_texture_filter_anisotropic")===!0){let y=e.get("EXT_texture_filter_anisotropic");r=i.getParameter(y.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else r=0;return r}function o(y){return!(y!==yn&&n.convert(y)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(y){let M=y===Gn&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(y!==Qt&&y!==gn&&!M&&n.convert(y)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(y){if(y==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";y="mediump"}return y==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",h=l(c);h!==c&&(Ie("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let d=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),u=t.logarithmicDepthBuffer===!0&&d===!1;t.reversedDepthBuffer===!0&&d===!1&&Ie("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&d===!0&&Ie("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),p=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),v=i.getParameter(i.MAX_TEXTURE_SIZE),g=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),m=i.getParameter(i.MAX_VERTEX_ATTRIBS),x=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),w=i.getParameter(i.MAX_VARYING_VECTORS),_=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),T=i.getParameter(i.MAX_SAMPLES),A=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:s,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:u,reversedDepthBuffer:d,maxTextures:f,maxVertexTextures:p,maxTextureSize:v,maxCubemapSize:g,maxAttributes:m,maxVertexUniforms:x,maxVaryings:w,maxFragmentUniforms:_,maxSamples:T,samples:A}}function yb(i){let e=this,t=null,n=0,r=!1,s=!1,o=new Vn,a=new Fe,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(d,u){let f=d.length!==0||u||n!==0||r;return r=u,n=d.length,f},this.beginShadows=function(){s=!0,h(null)},this.endShadows=function(){s=!1},this.setGlobalState=function(d,u){t=h(d,u,0)},this.setState=function(d,u,f){let p=d.clippingPlanes,v=d.clipIntersection,g=d.clipShadows,m=i.get(d);if(!r||p===null||p.length===0||s&&!g)s?h(null):c();else{let x=s?0:n,w=x*4,_=m.clippingState||null;l.value=_,_=h(p,u,w,f);for(let T=0;T!==w;++T)_[T]=t[T];m.clippingState=_,this.numIntersection=v?this.numPlanes:0,this.numPlanes+=x}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function h(d,u,f,p){let v=d!==null?d.length:0,g=null;if(v!==0){if(g=l.value,p!==!0||g===null){let m=f+v*4,x=u.matrixWorldInverse;a.getNormalMatrix(x),(g===null||g.length<m)&&(g=new Float32Array(m));for(let w=0,_=f;w!==v;++w,_+=4)o.copy(d[w]).applyMatrix4(x,a),o.normal.toArray(g,_),g[_+3]=o.constant}l.value=g,l.needsUpdate=!0}return e.numPlanes=v,e.numIntersection=0,g}}var Uo=class extends fn{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},r=[n,n,n,n,n,n];this.texture=new go(r),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},r=new gs(5,5,5),s=new $t({name:"CubemapFromEquirect",uniforms:Rr(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:jt,blending:wr});s.uniforms.tEquirect.value=t;let o=new Xt(r,s),a=t.minFilter;return t.minFilter===Ei&&(t.minFilter=Ft),new xs(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,n=!0,r=!0){let s=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,n,r);e.setRenderTarget(s)}},_m=256,xb=3,vb=20,Wm=256,qm=16,bb=3,_b=new B,Sb=new Ve,mc=class i{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new xs(1,10,null),this._boxMesh=new Xt(new gs(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,n=.1,r=100,s={}){let{size:o=256,position:a=_b}=s,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),h=this._getSourceTarget(!0);t>0&&(h.texture.mipmapsAutoUpdate=!1);let d=l.autoClear,u=l.autoClearColor,f=l.autoClearDepth,p=l.autoClearStencil,v=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,v===null&&(e.background=l.getClearColor(Sb));let g=new xs(n,r,h);return g.position.copy(a),g.update(l,e),l.autoClear=d,l.autoClearColor=u,l.autoClearDepth=f,l.autoClearStencil=p,e.background=v,t>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=wm(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Mm(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(_m,pm(e))}_fromTexture(e,t){e.mapping===Tr||e.mapping===_s?this._setSize(e.image.length===0?_m:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let n=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(n),n}_allocateTarget(){let e=this._cubeSize,t=Sm(e,!1,!1),n=Math.log2(e)-xb;for(let r=0;r<=n;r++)t.texture.mipmaps.push({width:e>>r,height:e>>r});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==t||e&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=Sm(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,n){let r=this._boxMesh,s=this._cubeCamera;r.material=n,s.renderTarget=e,s.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),s.update(this._renderer,r),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===Tr||e.mapping===_s?(this._cubemapMaterial===null&&(this._cubemapMaterial=wm()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Mm()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=Mb(),this._integrationMaterial=wb());let t=this._cubeSize,n=e.texture.mipmaps.length-1,r=this._ggxMaterial.uniforms;r.envMap.value=this._sourceTarget.texture;let s=this._integrationMaterial.uniforms;s.envMap.value=this._sourceTarget.texture,s.sourceLod.value=Math.log2(t/qm);for(let o=0;o<=n;o++){let a=i.lodToRoughness(o,n);if(o>n-bb)s.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(Wm*Math.pow(a,4)))+.5:0;r.roughness.value=a,r.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=Ab());let n=this._blurMaterial,r=n.uniforms,s=this._sourceTarget;r.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,r.envMap.value=s.texture,this._renderCube(e,0,n),r.envMap.value=e.texture,this._renderCube(s,0,n)}};function Sm(i,e,t){return new Uo(i,{minFilter:Ei,generateMipmaps:e,type:Gn,colorSpace:ro,depthBuffer:t})}function Oo(i,e,t){return new $t({name:i,uniforms:e,vertexShader:He.cube_vert,fragmentShader:t,side:jt,blending:wr,depthTest:!1,depthWrite:!1})}function Mb(){return Oo("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Wm}u

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
	`)}function wb(){return Oo("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:qm}},`

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
	`)}function Ab(){return Oo("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${vb}
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
	`)}function Mm(){return Oo("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function wm(){return Oo("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function Tb(i){let e=new WeakMap,t=new WeakMap,n=null;function r(u,f=!1){return u==null?null:f?o(u):s(u)}function s(u){if(u&&u.isTexture){let f=u.mapping;if(f===El||f===Cl)if(e.has(u)){let p=e.get(u).texture;return a(p,u.mapping)}else{let p=u.image;if(p&&p.height>0){let v=new Uo(p.height);return v.fromEquirectangularTexture(i,u),e.set(u,v),u.addEventListener("dispose",c),a(v.texture,u.mapping)}else return null}}return u}function o(u){if(u&&u.isTexture&&u.isPMREMTexture!==!0){let f=u.mapping,p=f===El||f===Cl,v=f===Tr||f===_s;if(p||v){let g=t.get(u),m=g!==void 0?g.texture.pmremVersion:0;if(u.isRenderTargetTexture&&u.pmremVersion!==m)return n===null&&(n=new mc(i)),g=p?n.fromEquirectangular(u,g):n.fromCubemap(u,g),g.texture.pmremVersion=u.pmremVersion,t.set(u,g),g.texture;if(g!==void 0)return g.texture;{let x=u.image;return p&&x&&x.height>0||v&&x&&l(x)?(n===null&&(n=new mc(i)),g=p?n.fromEquirectangular(u):n.fromCubemap(u),g.texture.pmremVersion=u.pmremVersion,t.set(u,g),u.addEventListener("dispose",h),g.texture):null}}}return u}function a(u,f){return f===El?u.mapping=Tr:f===Cl&&(u.mapping=_s),u}function l(u){let f=0,p=6;for(let v=0;v<p;v++)u[v]!==void 0&&f++;return f===p}function c(u){let f=u.target;f.removeEventListener("dispose",c);let p=e.get(f);p!==void 0&&(e.delete(f),p.dispose())}function h(u){let f=u.target;f.removeEventListener("dispose",h);let p=t.get(f);p!==void 0&&(t.delete(f),p.dispose())}function d(){e=new WeakMap,t=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:r,dispose:d}}function Eb(i){let e={};function t(n){if(e[n]!==void 0)return e[n];let r=i.getExtension(n);return e[n]=r,r}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){let r=t(n);return r===null&&no("WebGLRenderer: "+n+" extension not supported."),r}}}function Cb(i,e,t,n){let r={},s=new WeakMap,o=new FinalizationRegistry(p=>delete r[p]);function a(p){l(p.target)}function l(p){p.index!==null&&e.remove(p.index);for(let g in p.attributes)e.remove(p.attributes[g]);p.removeEventListener("dispose",a),delete r[p.id],o.unregister(p);let v=s.get(p);v&&(e.remove(v),s.delete(p)),n.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,t.memory.geometries--}function c(p,v){return r[v.id]!==void 0||(v.addEventListener("dispose",a),r[v.id]=new WeakRef(v),o.register(v,v.id,v),t.memory.geometries++),v}function h(p){let v=p.attributes;for(let g in v)e.update(v[g],i.ARRAY_BUFFER)}function d(p){let v=p.index,g=p.attributes.position,m=0;if(g===void 0)return;let x=v!==null?v.array.length:g.array.length/3-1,w=g.count>=65535?po:fo,_=new w(Math.ceil(x/3)*6,1),T=_.array;if(v!==null){let y=v.array;m=v.version;for(let M=0,D=0;M<x;M+=3){let I=y[M+0],L=y[M+1],U=y[M+2];T[D++]=I,T[D++]=L,T[D++]=L,T[D++]=U,T[D++]=U,T[D++]=I}}else{m=g.version;for(let y=0,M=0;y<x;y+=3){let D=y+0,I=y+1,L=y+2;T[M++]=D,T[M++]=I,T[M++]=I,T[M++]=L,T[M++]=L,T[M++]=D}}_.version=m;let A=s.get(p);A&&e.remove(A),s.set(p,_)}function u(p){let v=s.get(p);if(v){let g=p.index;g!==null&&v.version<g.version&&d(p)}else d(p);return s.get(p)}function f(){for(let p in r){let v=r[p].deref();v!==void 0&&l(v)}}return{get:c,update:h,getWireframeAttribute:u,dispose:f}}function Rb(i,e,t){let n;function r(d){n=d}let s,o;function a(d){s=d.type,o=d.bytesPerElement}function l(d,u){i.drawElements(n,u,s,d*o),t.update(u,n,1)}function c(d,u,f){f!==0&&(i.drawElementsInstanced(n,u,s,d*o,f),t.update(u,n,f))}function h(d,u,f){if(f===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,u,0,s,d,0,f);let v=0;for(let g=0;g<f;g++)v+=u[g];t.update(v,n,1)}this.setMode=r,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function Pb(i){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(s,o,a){switch(t.calls++,o){case i.TRIANGLES:t.triangles+=a*(s/3);break;case i.LINES:t.lines+=a*(s/2);break;case i.LINE_STRIP:t.lines+=a*(s-1);break;case i.LINE_LOOP:t.lines+=a*s;break;case i.POINTS:t.points+=a*s;break;default:Ne("WebGLInfo: Unknown draw mode:",o);break}}function r(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:r,update:n}}function Ib(i,e,t){let n=new WeakMap,r=new lt;function s(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,d=h!==void 0?h.length:0,u=n.get(a);if(u===void 0||u.count!==d){let D=function(){y.dispose(),n.delete(a),a.removeEventListener("dispose",D)};u!==void 0&&u.texture.dispose();let f=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,v=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],m=a.morphAttributes.normal||[],x=a.morphAttributes.color||[],w=0;f===!0&&(w=1),p===!0&&(w=2),v===!0&&(w=3);let _=a.attributes.position.count*w,T=1;_>e.maxTextureSize&&(T=Math.ceil(_/e.maxTextureSize),_=e.maxTextureSize);let A=new Float32Array(_*T*4*d),y=new co(A,_,T,d);y.type=gn,y.needsUpdate=!0;let M=w*4;for(let I=0;I<d;I++){let L=g[I],U=m[I],q=x[I],R=_*T*4*I;for(let G=0;G<L.count;G++){let W=G*M;f===!0&&(r.fromBufferAttribute(L,G),A[R+W+0]=r.x,A[R+W+1]=r.y,A[R+W+2]=r.z,A[R+W+3]=0),p===!0&&(r.fromBufferAttribute(U,G),A[R+W+4]=r.x,A[R+W+5]=r.y,A[R+W+6]=r.z,A[R+W+7]=0),v===!0&&(r.fromBufferAttribute(q,G),A[R+W+8]=r.x,A[R+W+9]=r.y,A[R+W+10]=r.z,A[R+W+11]=q.itemSize===4?r.w:1)}}u={count:d,texture:y,size:new Ge(_,T)},n.set(a,u),a.addEventListener("dispose",D)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,t);else{let f=0;for(let v=0;v<c.length;v++)f+=c[v];let p=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(i,"morphTargetBaseInfluence",p),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",u.texture,t),l.getUniforms().setValue(i,"morphTargetsTextureSize",u.size)}return{update:s}}function Lb(i,e,t,n,r){let s=new WeakMap;function o(c){let h=r.render.frame,d=c.geometry,u=e.get(c,d);if(s.get(u)!==h&&(e.update(u),s.set(u,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),s.get(c)!==h&&(t.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,i.ARRAY_BUFFER),s.set(c,h))),c.isSkinnedMesh){let f=c.skeleton;s.get(f)!==h&&(f.update(),s.set(f,h))}return u}function a(){s=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),n.releaseStatesOfObject(h),t.remove(h.instanceMatrix),h.instanceColor!==null&&t.remove(h.instanceColor)}return{update:o,dispose:a}}var Nb={[vu]:"LINEAR_TONE_MAPPING",[bu]:"REINHARD_TONE_MAPPING",[_u]:"CINEON_TONE_MAPPING",[Su]:"ACES_FILMIC_TONE_MAPPING",[wu]:"AGX_TONE_MAPPING",[Au]:"NEUTRAL_TONE_MAPPING",[Mu]:"CUSTOM_TONE_MAPPING"};function Db(i,e,t,n,r,s){let o=new fn(e,t,{type:i,depthBuffer:r,stencilBuffer:s,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,h=new sn;h.setAttribute("position",new Cn([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new Cn([0,2,0,0,2,0],2));let d=new fl({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),u=new Xt(h,d),f=new ys(-1,1,1,-1,0,1),p=null,v=null,g=!1,m,x=null,w=[],_=!1;this.setSize=function(T,A){o.setSize(T,A),a!==null&&a.setSize(T,A),l!==null&&l.setSize(T,A);for(let y=0;y<w.length;y++){let M=w[y];M.setSize&&M.setSize(T,A)}},this.setEffects=function(T){w=T,_=w.length>0&&w[0].isRenderPass===!0;let A=o.width,y=o.height;w.length>0&&a===null&&(a=new fn(A,y,{type:Gn,depthBuffer:!1,stencilBuffer:!1}),l=new fn(A,y,{type:Gn,depthBuffer:!1,stencilBuffer:!1}));let M=r===!0&&w.some(D=>D.needsDepthTexture===!0);M!==(o.depthTexture!==null)&&(M===!0&&c===null&&(c=new Ti(A,y),s===!0&&(c.format=Ci,c.type=Er)),o.dispose(),o.depthTexture=M?c:null,o.resolveDepthBuffer=M,o.storeMultisampledDepthBuffer=M);for(let D=0;D<w.length;D++){let I=w[D];I.setSize&&I.setSize(A,y),M&&I.needsDepthTexture===!0&&I.setDepthTexture&&I.setDepthTexture(c)}},this.begin=function(T,A){if(g||T.toneMapping===ai&&w.length===0)return!1;if(x=A,A!==null){let y=A.width,M=A.height;(o.width!==y||o.height!==M)&&this.setSize(y,M)}return _===!1&&T.setRenderTarget(o),m=T.toneMapping,T.toneMapping=ai,!0},this.hasRenderPass=function(){return _},this.end=function(T,A){T.toneMapping=m,g=!0;let y=o,M=a;for(let D=0;D<w.length;D++){let I=w[D];I.enabled!==!1&&(I.render(T,M,y,A),I.needsSwap!==!1&&(y=M,M=M===a?l:a))}if(p!==T.outputColorSpace||v!==T.toneMapping){p=T.outputColorSpace,v=T.toneMapping,d.defines={},Ye.getTransfer(p)===nt&&(d.defines.SRGB_TRANSFER="");let D=Nb[v];D&&(d.defines[D]=""),d.needsUpdate=!0}d.uniforms.tDiffuse.value=y.texture,T.setRenderTarget(x),T.render(u,f),x=null,g=!1},this.isCompositing=function(){return g},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),h.dispose(),d.dispose()}}var Xm=new Kt,$m=new Ti(1,1),Ym=new xo(1),Jm=new co,Zm=new ll,Km=new go,Am=[],Tm=[],Em=new Float32Array(16),Cm=new Float32Array(9),Rm=new Float32Array(4);function As(i,e,t){let n=i[0];if(n<=0||n>0)return i;let r=e*t,s=Am[r];if(s===void 0&&(s=new Float32Array(r),Am[r]=s),e!==0){n.toArray(s,0);for(let o=1,a=0;o!==e;++o)a+=t,i[o].toArray(s,a)}return s}function Rt(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function Pt(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function yc(i,e){let t=Tm[e];t===void 0&&(t=new Int32Array(e),Tm[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function Fb(i,e){let t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function Ub(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Rt(t,e))return;i.uniform2fv(this.addr,e),Pt(t,e)}}function Ob(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Rt(t,e))return;i.uniform3fv(this.addr,e),Pt(t,e)}}function kb(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Rt(t,e))return;i.uniform4fv(this.addr,e),Pt(t,e)}}function Bb(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(Rt(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),Pt(t,e)}else{if(Rt(t,n))return;Rm.set(n),i.uniformMatrix2fv(this.addr,!1,Rm),Pt(t,n)}}function zb(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(Rt(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),Pt(t,e)}else{if(Rt(t,n))return;Cm.set(n),i.uniformMatrix3fv(this.addr,!1,Cm),Pt(t,n)}}function Vb(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(Rt(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),Pt(t,e)}else{if(Rt(t,n))return;Em.set(n),i.uniformMatrix4fv(this.addr,!1,Em),Pt(t,n)}}function Hb(i,e){let t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function Gb(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Rt(t,e))return;i.uniform2iv(this.addr,e),Pt(t,e)}}function Wb(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Rt(t,e))return;i.uniform3iv(this.addr,e),Pt(t,e)}}function qb(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Rt(t,e))return;i.uniform4iv(this.addr,e),Pt(t,e)}}function Xb(i,e){let t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function $b(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Rt(t,e))return;i.uniform2uiv(this.addr,e),Pt(t,e)}}function Yb(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Rt(t,e))return;i.uniform3uiv(this.addr,e),Pt(t,e)}}function Jb(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Rt(t,e))return;i.uniform4uiv(this.addr,e),Pt(t,e)}}function xc(i){return i.version===0&&(i.compareFunction=Uu,i.needsUpdate=!0),i}function Zb(i,e,t){let n=this.cache,r=t.allocateTextureUnit();n[0]!==r&&(i.uniform1i(this.addr,r),n[0]=r);let s;this.type===i.SAMPLER_2D_SHADOW?s=xc($m):s=Xm,t.setTexture2D(e||s,r)}function Kb(i,e,t){let n=this.cache,r=t.allocateTextureUnit();n[0]!==r&&(i.uniform1i(this.addr,r),n[0]=r),t.setTexture3D(e||Zm,r)}function jb(i,e,t){let n=this.cache,r=t.allocateTextureUnit();n[0]!==r&&(i.uniform1i(this.addr,r),n[0]=r);let s;this.type===i.SAMPLER_CUBE_SHADOW?s=xc(Ym):s=Km,t.setTextureCube(e||s,r)}function Qb(i,e,t){let n=this.cache,r=t.allocateTextureUnit();n[0]!==r&&(i.uniform1i(this.addr,r),n[0]=r),t.setTexture2DArray(e||Jm,r)}function e_(i){switch(i){case 5126:return Fb;case 35664:return Ub;case 35665:return Ob;case 35666:return kb;case 35674:return Bb;case 35675:return zb;case 35676:return Vb;case 5124:case 35670:return Hb;case 35667:case 35671:return Gb;case 35668:case 35672:return Wb;case 35669:case 35673:return qb;case 5125:return Xb;case 36294:return $b;case 36295:return Yb;case 36296:return Jb;case 35678:case 36198:case 36298:case 36306:case 35682:return Zb;case 35679:case 36299:case 36307:return Kb;case 35680:case 36300:case 36308:case 36293:return jb;case 36289:case 36303:case 36311:case 36292:return Qb}}function t_(i,e){i.uniform1fv(this.addr,e)}function n_(i,e){let t=As(e,this.size,2);i.uniform2fv(this.addr,t)}function i_(i,e){let t=As(e,this.size,3);i.uniform3fv(this.addr,t)}function r_(i,e){let t=As(e,this.size,4);i.uniform4fv(this.addr,t)}function s_(i,e){let t=As(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function o_(i,e){let t=As(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function a_(i,e){let t=As(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function l_(i,e){i.uniform1iv(this.addr,e)}function c_(i,e){i.uniform2iv(this.addr,e)}function h_(i,e){i.uniform3iv(this.addr,e)}function u_(i,e){i.uniform4iv(this.addr,e)}function d_(i,e){i.uniform1uiv(this.addr,e)}function f_(i,e){i.uniform2uiv(this.addr,e)}function p_(i,e){i.uniform3uiv(this.addr,e)}function m_(i,e){i.uniform4uiv(this.addr,e)}function g_(i,e,t){let n=this.cache,r=e.length,s=yc(t,r);Rt(n,s)||(i.uniform1iv(this.addr,s),Pt(n,s));let o;this.type===i.SAMPLER_2D_SHADOW?o=xc($m):o=Xm;for(let a=0;a!==r;++a)t.setTexture2D(e[a]||o,s[a])}function y_(i,e,t){let n=this.cache,r=e.length,s=yc(t,r);Rt(n,s)||(i.uniform1iv(this.addr,s),Pt(n,s));for(let o=0;o!==r;++o)t.setTexture3D(e[o]||Zm,s[o])}function x_(i,e,t){let n=this.cache,r=e.length,s=yc(t,r);Rt(n,s)||(i.uniform1iv(this.addr,s),Pt(n,s));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=xc(Ym):o=Km;for(let a=0;a!==r;++a)t.setTextureCube(e[a]||o,s[a])}function v_(i,e,t){let n=this.cache,r=e.length,s=yc(t,r);Rt(n,s)||(i.uniform1iv(this.addr,s),Pt(n,s));for(let o=0;o!==r;++o)t.setTexture2DArray(e[o]||Jm,s[o])}function b_(i){switch(i){case 5126:return t_;case 35664:return n_;case 35665:return i_;case 35666:return r_;case 35674:return s_;case 35675:return o_;case 35676:return a_;case 5124:case 35670:return l_;case 35667:case 35671:return c_;case 35668:case 35672:return h_;case 35669:case 35673:return u_;case 5125:return d_;case 36294:return f_;case 36295:return p_;case 36296:return m_;case 35678:case 36198:case 36298:case 36306:case 35682:return g_;case 35679:case 36299:case 36307:return y_;case 35680:case 36300:case 36308:case 36293:return x_;case 36289:case 36303:case 36311:case 36292:return v_}}var Wu=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=e_(t.type)}},qu=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=b_(t.type)}},Xu=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let r=this.seq;for(let s=0,o=r.length;s!==o;++s){let a=r[s];a.setValue(e,t[a.id],n)}}},Hu=/(\w+)(\])?(\[|\.)?/g;function Pm(i,e){i.seq.push(e),i.map[e.id]=e}function __(i,e,t){let n=i.name,r=n.length;for(Hu.lastIndex=0;;){let s=Hu.exec(n),o=Hu.lastIndex,a=s[1],l=s[2]==="]",c=s[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===r){Pm(t,c===void 0?new Wu(a,i,e):new qu(a,i,e));break}else{let d=t.map[a];d===void 0&&(d=new Xu(a),Pm(t,d)),t=d}}}var ws=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);__(a,l,this)}let r=[],s=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?r.push(o):s.push(o);r.length>0&&(this.seq=r.concat(s))}setValue(e,t,n,r){let s=this.map[t];s!==void 0&&s.setValue(e,n,r)}setOptional(e,t,n){let r=t[n];r!==void 0&&this.setValue(e,n,r)}static upload(e,t,n,r){for(let s=0,o=t.length;s!==o;++s){let a=t[s],l=n[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,r)}}static seqWithValue(e,t){let n=[];for(let r=0,s=e.length;r!==s;++r){let o=e[r];o.id in t&&n.push(o)}return n}};function Im(i,e,t){let n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}var S_=37297,M_=0;function w_(i,e){let t=i.split(`
`),n=[],r=Math.max(e-6,0),s=Math.min(e+6,t.length);for(let o=r;o<s;o++){let a=o+1;n.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return n.join(`
`)}var Lm=new Fe;function A_(i){Ye._getMatrix(Lm,Ye.workingColorSpace,i);let e=`mat3( ${Lm.elements.map(t=>t.toFixed(4))} )`;switch(Ye.getTransfer(i)){case so:return[e,"LinearTransferOETF"];case nt:return[e,"sRGBTransferOETF"];default:return Ie("WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function Nm(i,e,t){let n=i.getShaderParameter(e,i.COMPILE_STATUS),s=(i.getShaderInfoLog(e)||"").trim();if(n&&s==="")return"";let o=/ERROR: 0:(\d+)/.exec(s);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+s+`

`+w_(i.getShaderSource(e),a)}else return s}function T_(i,e){let t=A_(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var E_={[vu]:"Linear",[bu]:"Reinhard",[_u]:"Cineon",[Su]:"ACESFilmic",[wu]:"AgX",[Au]:"Neutral",[Mu]:"Custom"};function C_(i,e){let t=E_[e];return t===void 0?(Ie("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var pc=new B;function R_(){Ye.getLuminanceCoefficients(pc);let i=pc.x.toFixed(4),e=pc.y.toFixed(4),t=pc.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function P_(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Fo).join(`
`)}function I_(i){let e=[];for(let t in i){let n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function L_(i,e){let t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let r=0;r<n;r++){let s=i.getActiveAttrib(e,r),o=s.name,a=1;s.type===i.FLOAT_MAT2&&(a=2),s.type===i.FLOAT_MAT3&&(a=3),s.type===i.FLOAT_MAT4&&(a=4),t[o]={type:s.type,location:i.getAttribLocation(e,o),locationSize:a}}return t}function Fo(i){return i!==""}function Dm(i,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function Fm(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var N_=/^[ \t]*#include +<([\w\d./]+)>/gm;function $u(i){return i.replace(N_,D_)}function D_(i,e){let t=He[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return $u(t)}var F_=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Um(i){return i.replace(F_,U_)}function U_(i,e,t,n){let r="";for(let s=parseInt(e);s<parseInt(t);s++)r+=n.replace(/\[\s*i\s*\]/g,"[ "+s+" ]").replace(/UNROLLED_LOOP_INDEX/g,s);return r}function Om(i){let e=`precision ${i.precision} float;
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
#define LOW_PRECISION`),e}var O_={[Ao]:"SHADOWMAP_TYPE_PCF",[vs]:"SHADOWMAP_TYPE_VSM"};function k_(i){return O_[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var B_={[_s]:"ENVMAP_MODE_REFRACTION"};function z_(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":B_[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var V_={[xu]:"ENVMAP_BLENDING_MULTIPLY",[Qp]:"ENVMAP_BLENDING_MIX",[em]:"ENVMAP_BLENDING_ADD"};function H_(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":V_[i.combine]||"ENVMAP_BLENDING_NONE"}function G_(i,e,t,n){let r=i.getContext(),s=t.defines,o=t.vertexShader,a=t.fragmentShader,l=k_(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=z_(t),d=H_(t),u=P_(t),f=I_(s),p=r.createProgram(),v,g,m=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(v=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(Fo).join(`
`),v.length>0&&(v+=`
`),g=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(Fo).join(`
`),g.length>0&&(g+=`
`)):(v=[Om(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+h:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Fo).join(`
`),g=[Om(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+h:"",t.envMap?"#define "+d:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==ai?"#define TONE_MAPPING":"",t.toneMapping!==ai?He.tonemapping_pars_fragment:"",t.toneMapping!==ai?C_("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",He.colorspace_pars_fragment,T_("linearToOutputTexel",t.outputColorSpace),R_(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(Fo).join(`
`)),o=$u(o),o=Dm(o,t),o=Fm(o,t),a=$u(a),a=Dm(a,t),a=Fm(a,t),o=Um(o),a=Um(a),t.isRawShaderMaterial!==!0&&(m=`#version 300 es
`,v=[u,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+v,g=["#define varying in",t.glslVersion===Pi?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Pi?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+g);let x=m+v+o,w=m+g+a,_=Im(r,r.VERTEX_SHADER,x),T=Im(r,r.FRAGMENT_SHADER,w);r.attachShader(p,_),r.attachShader(p,T),t.index0AttributeName!==void 0?r.bindAttribLocation(p,0,t.index0AttributeName):t.hasPositionAttribute===!0&&r.bindAttribLocation(p,0,"position"),r.linkProgram(p);function A(I){if(i.debug.checkShaderErrors){let L=r.getProgramInfoLog(p)||"",U=r.getShaderInfoLog(_)||"",q=r.getShaderInfoLog(T)||"",R=L.trim(),G=U.trim(),W=q.trim(),O=!0,ee=!0;if(r.getProgramParameter(p,r.LINK_STATUS)===!1)if(O=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(r,p,_,T);else{let H=Nm(r,_,"vertex"),J=Nm(r,T,"fragment");Ne("WebGLProgram: Shader Error "+r.getError()+" - VALIDATE_STATUS "+r.getProgramParameter(p,r.VALIDATE_STATUS)+`

Material Name: `+I.name+`
Material Type: `+I.type+`

Program Info Log: `+R+`
`+H+`
`+J)}else R!==""?Ie("WebGLProgram: Program Info Log:",R):(G===""||W==="")&&(ee=!1);ee&&(I.diagnostics={runnable:O,programLog:R,vertexShader:{log:G,prefix:v},fragmentShader:{log:W,prefix:g}})}r.deleteShader(_),r.deleteShader(T),y=new ws(r,p),M=L_(r,p)}let y;this.getUniforms=function(){return y===void 0&&A(this),y};let M;this.getAttributes=function(){return M===void 0&&A(this),M};let D=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return D===!1&&(D=r.getProgramParameter(p,S_)),D},this.destroy=function(){n.releaseStatesOfProgram(this),r.deleteProgram(p),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=M_++,this.cacheKey=e,this.usedTimes=1,this.program=p,this.vertexShader=_,this.fragmentShader=T,this}var W_=0,Yu=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,n){let r=this._getShaderCacheForMaterial(e);return r.has(t)===!1&&(r.add(t),t.usedTimes++),r.has(n)===!1&&(r.add(n),n.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new Ju(e),t.set(e,n)),n}},Ju=class{constructor(e){this.id=W_++,this.code=e,this.usedTimes=0}};function q_(i){return i===tr||i===Lo||i===No}function X_(i,e,t,n,r,s){let o=new ho,a=new Yu,l=new Set,c=[],h=new Map,d=n.logarithmicDepthBuffer,u={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(y){return l.add(y),y===0?"uv":`uv${y}`}function p(y,M,D,I,L,U){let q=I.fog,R=L.geometry,G=y.isMeshStandardMaterial||y.isMeshLambertMaterial||y.isMeshPhongMaterial?I.environment:null,W=y.isMeshStandardMaterial||y.isMeshLambertMaterial&&!y.envMap||y.isMeshPhongMaterial&&!y.envMap,O=e.get(y.envMap||G,W),ee=u[y.type],H=n.precision;y.precision!==null&&(H=n.getMaxPrecision(y.precision),H!==y.precision&&Ie("WebGLProgram.getParameters:",y.precision,"not supported, using",H,"instead."));let J=R.morphAttributes.position||R.morphAttributes.normal||R.morphAttributes.color,te=J!==void 0?J.length:0,ve=0;R.morphAttributes.position!==void 0&&(ve=1),R.morphAttributes.normal!==void 0&&(ve=2),R.morphAttributes.color!==void 0&&(ve=3);let Te,$,re,me;if(ee){let ge=ci[ee];Te=ge.vertexShader,$=ge.fragmentShader}else{Te=y.vertexShader,$=y.fragmentShader;let ge=a.getVertexShaderStage(y),it=a.getFragmentShaderStage(y);a.update(y,ge,it),re=ge.id,me=it.id}let Me=i.getRenderTarget(),fe=i.state.buffers.depth.getReversed(),Le=L.isInstancedMesh===!0,dt=L.isBatchedMesh===!0,Ce=!!y.map,Ze=!!y.matcap,Qe=!!O,We=Qe&&O.isPMREMTexture===!0,Ut=!!y.aoMap,Mt=!!y.lightMap,en=!!y.bumpMap&&y.wireframe===!1,mt=!!y.normalMap,Wn=!!y.displacementMap,It=!!y.emissiveMap,xn=!!y.metalnessMap,vn=!!y.roughnessMap,bn=y.anisotropy>0,F=y.clearcoat>0,_n=y.diffuseRoughness>0,ft=y.dispersion>0,pt=y.retroreflectivity>0,pe=y.iridescence>0,wt=y.sheen>0,Re=y.transmission>0,Ue=bn&&!!y.anisotropyMap,E=F&&!!y.clearcoatMap,b=F&&!!y.clearcoatNormalMap,z=F&&!!y.clearcoatRoughnessMap,ne=_n&&!!y.diffuseRoughnessMap,Q=pe&&!!y.iridescenceMap,oe=pe&&!!y.iridescenceThicknessMap,ue=wt&&!!y.sheenColorMap,Z=wt&&!!y.sheenRoughnessMap,K=!!y.specularMap,le=!!y.specularColorMap,P=!!y.specularIntensityMap,j=Re&&!!y.transmissionMap,Y=Re&&!!y.thicknessMap,ce=!!y.gradientMap,se=!!y.alphaMap,ae=y.alphaTest>0,Ae=!!y.alphaHash,ze=!!y.extensions,ie=ai;y.toneMapped&&(Me===null||Me.isXRRenderTarget===!0)&&(ie=i.toneMapping);let Ee=We?O.isCompressedCubeTexture?O.image[0].mipmaps:O.mipmaps:null,ke={shaderID:ee,shaderType:y.type,shaderName:y.name,vertexShader:Te,fragmentShader:$,defines:y.defines,customVertexShaderID:re,customFragmentShaderID:me,isRawShaderMaterial:y.isRawShaderMaterial===!0,glslVersion:y.glslVersion,precision:H,batching:dt,batchingColor:dt&&L._colorsTexture!==null,instancing:Le,instancingColor:Le&&L.instanceColor!==null,instancingMorph:Le&&L.morphTexture!==null,outputColorSpace:Me===null?i.outputColorSpace:Me.isXRRenderTarget===!0?Me.texture.colorSpace:Ye.workingColorSpace,alphaToCoverage:!!y.alphaToCoverage,map:Ce,matcap:Ze,envMap:Qe,envMapMode:Qe&&O.mapping,envMapPMREM:We,envMapMaxLod:We?Ee.length-1:null,envMapSize:We?Ee[0].width:null,aoMap:Ut,lightMap:Mt,bumpMap:en,normalMap:mt,displacementMap:Wn,emissiveMap:It,normalMapObjectSpace:mt&&y.normalMapType===im,normalMapTangentSpace:mt&&y.normalMapType===Nu,packedNormalMap:mt&&y.normalMapType===Nu&&q_(y.normalMap.format),metalnessMap:xn,roughnessMap:vn,anisotropy:bn,anisotropyMap:Ue,clearcoat:F,clearcoatMap:E,clearcoatNormalMap:b,clearcoatRoughnessMap:z,diffuseRoughness:_n,diffuseRoughnessMap:ne,dispersion:ft,retroreflection:pt,iridescence:pe,iridescenceMap:Q,iridescenceThicknessMap:oe,sheen:wt,sheenColorMap:ue,sheenRoughnessMap:Z,specularMap:K,specularColorMap:le,specularIntensityMap:P,transmission:Re,transmissionMap:j,thicknessMap:Y,gradientMap:ce,opaque:y.transparent===!1&&y.blending===bs&&y.alphaToCoverage===!1,alphaMap:se,alphaTest:ae,alphaHash:Ae,combine:y.combine,mapUv:Ce&&f(y.map.channel),aoMapUv:Ut&&f(y.aoMap.channel),lightMapUv:Mt&&f(y.lightMap.channel),bumpMapUv:en&&f(y.bumpMap.channel),normalMapUv:mt&&f(y.normalMap.channel),displacementMapUv:Wn&&f(y.displacementMap.channel),emissiveMapUv:It&&f(y.emissiveMap.channel),metalnessMapUv:xn&&f(y.metalnessMap.channel),roughnessMapUv:vn&&f(y.roughnessMap.channel),anisotropyMapUv:Ue&&f(y.anisotropyMap.channel),clearcoatMapUv:E&&f(y.clearcoatMap.channel),clearcoatNormalMapUv:b&&f(y.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:z&&f(y.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ne&&f(y.diffuseRoughnessMap.channel),iridescenceMapUv:Q&&f(y.iridescenceMap.channel),iridescenceThicknessMapUv:oe&&f(y.iridescenceThicknessMap.channel),sheenColorMapUv:ue&&f(y.sheenColorMap.channel),sheenRoughnessMapUv:Z&&f(y.sheenRoughnessMap.channel),specularMapUv:K&&f(y.specularMap.channel),specularColorMapUv:le&&f(y.specularColorMap.channel),specularIntensityMapUv:P&&f(y.specularIntensityMap.channel),transmissionMapUv:j&&f(y.transmissionMap.channel),thicknessMapUv:Y&&f(y.thicknessMap.channel),alphaMapUv:se&&f(y.alphaMap.channel),vertexTangents:!!R.attributes.tangent&&(mt||bn),vertexNormals:!!R.attributes.normal,vertexColors:y.vertexColors,vertexAlphas:y.vertexColors===!0&&!!R.attributes.color&&R.attributes.color.itemSize===4,pointsUvs:L.isPoints===!0&&!!R.attributes.uv&&(Ce||se),fog:!!q,useFog:y.fog===!0,fogExp2:!!q&&q.isFogExp2,flatShading:y.wireframe===!1&&(y.flatShading===!0||R.attributes.normal===void 0&&mt===!1&&(y.isMeshLambertMaterial||y.isMeshPhongMaterial||y.isMeshStandardMaterial||y.isMeshPhysicalMaterial)),sizeAttenuation:y.sizeAttenuation===!0,logarithmicDepthBuffer:d,reversedDepthBuffer:fe,skinning:L.isSkinnedMesh===!0,hasPositionAttribute:R.attributes.position!==void 0,morphTargets:R.morphAttributes.position!==void 0,morphNormals:R.morphAttributes.normal!==void 0,morphColors:R.morphAttributes.color!==void 0,morphTargetsCount:te,morphTextureStride:ve,numSunLights:M.sun.length,numDirLights:M.directional.length,numPointLights:M.point.length,numSpotLights:M.spot.length,numSpotLightMaps:M.spotLightMap.length,numRectAreaLights:M.rectArea.length,numHemiLights:M.hemi.length,numSunLightShadows:M.sunShadowMap.length,numDirLightShadows:M.directionalShadowMap.length,numPointLightShadows:M.pointShadowMap.length,numSpotLightShadows:M.spotShadowMap.length,numSpotLightShadowsWithMaps:M.numSpotLightShadowsWithMaps,numLightProbes:M.numLightProbes,numLightProbeGrids:U.filter(ge=>ge.texture!==null).length,numClippingPlanes:s.numPlanes,numClipIntersection:s.numIntersection,dithering:y.dithering,shadowMapEnabled:i.shadowMap.enabled&&D.length>0,shadowMapType:i.shadowMap.type,toneMapping:ie,decodeVideoTexture:Ce&&y.map.isVideoTexture===!0&&Ye.getTransfer(y.map.colorSpace)===nt,decodeVideoTextureEmissive:It&&y.emissiveMap.isVideoTexture===!0&&Ye.getTransfer(y.emissiveMap.colorSpace)===nt,premultipliedAlpha:y.premultipliedAlpha,doubleSided:y.side===Rn,flipSided:y.side===jt,useDepthPacking:y.depthPacking>=0,depthPacking:y.depthPacking||0,index0AttributeName:y.index0AttributeName,extensionClipCullDistance:ze&&y.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(ze&&y.extensions.multiDraw===!0||dt)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:y.customProgramCacheKey()};return ke.vertexUv1s=l.has(1),ke.vertexUv2s=l.has(2),ke.vertexUv3s=l.has(3),l.clear(),ke}function v(y){let M=[];if(y.shaderID?M.push(y.shaderID):(M.push(y.customVertexShaderID),M.push(y.customFragmentShaderID)),y.defines!==void 0)for(let D in y.defines)M.push(D),M.push(y.defines[D]);return y.isRawShaderMaterial===!1&&(g(M,y),m(M,y),M.push(i.outputColorSpace)),M.push(y.customProgramCacheKey),M.join()}function g(y,M){y.push(M.precision),y.push(M.outputColorSpace),y.push(M.envMapMode),y.push(M.envMapPMREM),y.push(M.envMapMaxLod),y.push(M.envMapSize),y.push(M.mapUv),y.push(M.alphaMapUv),y.push(M.lightMapUv),y.push(M.aoMapUv),y.push(M.bumpMapUv),y.push(M.normalMapUv),y.push(M.displacementMapUv),y.push(M.emissiveMapUv),y.push(M.metalnessMapUv),y.push(M.roughnessMapUv),y.push(M.anisotropyMapUv),y.push(M.clearcoatMapUv),y.push(M.clearcoatNormalMapUv),y.push(M.clearcoatRoughnessMapUv),y.push(M.diffuseRoughnessMapUv),y.push(M.iridescenceMapUv),y.push(M.iridescenceThicknessMapUv),y.push(M.sheenColorMapUv),y.push(M.sheenRoughnessMapUv),y.push(M.specularMapUv),y.push(M.specularColorMapUv),y.push(M.specularIntensityMapUv),y.push(M.transmissionMapUv),y.push(M.thicknessMapUv),y.push(M.combine),y.push(M.fogExp2),y.push(M.sizeAttenuation),y.push(M.morphTargetsCount),y.push(M.numSunLights),y.push(M.numDirLights),y.push(M.numPointLights),y.push(M.numSpotLights),y.push(M.numSpotLightMaps),y.push(M.numHemiLights),y.push(M.numRectAreaLights),y.push(M.numSunLightShadows),y.push(M.numDirLightShadows),y.push(M.numPointLightShadows),y.push(M.numSpotLightShadows),y.push(M.numSpotLightShadowsWithMaps),y.push(M.numLightProbes),y.push(M.numLightProbeGrids),y.push(M.shadowMapType),y.push(M.toneMapping),y.push(M.numClippingPlanes),y.push(M.numClipIntersection),y.push(M.depthPacking)}function m(y,M){o.disableAll(),M.instancing&&o.enable(0),M.instancingColor&&o.enable(1),M.instancingMorph&&o.enable(2),M.matcap&&o.enable(3),M.envMap&&o.enable(4),M.normalMapObjectSpace&&o.enable(5),M.normalMapTangentSpace&&o.enable(6),M.clearcoat&&o.enable(7),M.iridescence&&o.enable(8),M.alphaTest&&o.enable(9),M.vertexColors&&o.enable(10),M.vertexAlphas&&o.enable(11),M.vertexUv1s&&o.enable(12),M.vertexUv2s&&o.enable(13),M.vertexUv3s&&o.enable(14),M.vertexTangents&&o.enable(15),M.anisotropy&&o.enable(16),M.alphaHash&&o.enable(17),M.batching&&o.enable(18),M.dispersion&&o.enable(19),M.retroreflection&&o.enable(24),M.diffuseRoughness&&o.enable(25),M.batchingColor&&o.enable(20),M.gradientMap&&o.enable(21),M.packedNormalMap&&o.enable(22),M.vertexNormals&&o.enable(23),y.push(o.mask),o.disableAll(),M.fog&&o.enable(0),M.useFog&&o.enable(1),M.flatShading&&o.enable(2),M.logarithmicDepthBuffer&&o.enable(3),M.reversedDepthBuffer&&o.enable(4),M.skinning&&o.enable(5),M.morphTargets&&o.enable(6),M.morphNormals&&o.enable(7),M.morphColors&&o.enable(8),M.premultipliedAlpha&&o.enable(9),M.shadowMapEnabled&&o.enable(10),M.doubleSided&&o.enable(11),M.flipSided&&o.enable(12),M.useDepthPacking&&o.enable(13),M.dithering&&o.enable(14),M.transmission&&o.enable(15),M.sheen&&o.enable(16),M.opaque&&o.enable(17),M.pointsUvs&&o.enable(18),M.decodeVideoTexture&&o.enable(19),M.decodeVideoTextureEmissive&&o.enable(20),M.alphaToCoverage&&o.enable(21),M.numLightProbeGrids>0&&o.enable(22),M.hasPositionAttribute&&o.enable(23),y.push(o.mask)}function x(y){let M=u[y.type],D;if(M){let I=ci[M];D=xm.clone(I.uniforms)}else D=y.uniforms;return D}function w(y,M){let D=h.get(M);return D!==void 0?++D.usedTimes:(D=new G_(i,M,y,r),c.push(D),h.set(M,D)),D}function _(y){if(--y.usedTimes===0){let M=c.indexOf(y);c[M]=c[c.length-1],c.pop(),h.delete(y.cacheKey),y.destroy()}}function T(y){a.remove(y)}function A(){a.dispose()}return{getParameters:p,getProgramCacheKey:v,getUniforms:x,acquireProgram:w,releaseProgram:_,releaseShaderCache:T,programs:c,dispose:A}}function $_(){let i=new WeakMap;function e(o){return i.has(o)}function t(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function r(o,a,l){i.get(o)[a]=l}function s(){i=new WeakMap}return{has:e,get:t,remove:n,update:r,dispose:s}}function Y_(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.materialVariant!==e.materialVariant?i.materialVariant-e.materialVariant:i.z!==e.z?i.z-e.z:i.id-e.id}function km(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function Bm(){let i=[],e=0,t=[],n=[],r=[];function s(){e=0,t.length=0,n.length=0,r.length=0}function o(u){let f=0;return u.isInstancedMesh&&(f+=2),u.isSkinnedMesh&&(f+=1),f}function a(u,f,p,v,g,m){let x=i[e];return x===void 0?(x={id:u.id,object:u,geometry:f,material:p,materialVariant:o(u),groupOrder:v,renderOrder:u.renderOrder,z:g,group:m},i[e]=x):(x.id=u.id,x.object=u,x.geometry=f,x.material=p,x.materialVariant=o(u),x.groupOrder=v,x.renderOrder=u.renderOrder,x.z=g,x.group=m),e++,x}function l(u,f,p,v,g,m,x){x.reversedDepth===!0&&(g=-g);let w=a(u,f,p,v,g,m);p.transmission>0?n.push(w):p.transparent===!0?r.push(w):t.push(w)}function c(u,f,p,v,g,m){let x=a(u,f,p,v,g,m);p.transmission>0?n.unshift(x):p.transparent===!0?r.unshift(x):t.unshift(x)}function h(u,f){t.length>1&&t.sort(u||Y_),n.length>1&&n.sort(f||km),r.length>1&&r.sort(f||km)}function d(){for(let u=e,f=i.length;u<f;u++){let p=i[u];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:t,transmissive:n,transparent:r,init:s,push:l,unshift:c,finish:d,sort:h}}function J_(){let i=new WeakMap;function e(n,r){let s=i.get(n),o;return s===void 0?(o=new Bm,i.set(n,[o])):r>=s.length?(o=new Bm,s.push(o)):o=s[r],o}function t(){i=new WeakMap}return{get:e,dispose:t}}function Z_(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new B,color:new Ve};break;case"SpotLight":t={position:new B,direction:new B,color:new Ve,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new B,color:new Ve,distance:0,decay:0};break;case"HemisphereLight":t={direction:new B,skyColor:new Ve,groundColor:new Ve};break;case"RectAreaLight":t={color:new Ve,position:new B,halfWidth:new B,halfHeight:new B};break}return i[e.id]=t,t}}}function K_(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ge};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ge};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ge,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}var j_=0;function Q_(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function eS(i){let e=new Z_,t=K_(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new B);let r=new B,s=new ut,o=new ut;function a(c){let h=0,d=0,u=0;for(let U=0;U<9;U++)n.probe[U].set(0,0,0);let f=0,p=0,v=0,g=0,m=0,x=0,w=0,_=0,T=0,A=0,y=0,M=0,D=0,I=0;c.sort(Q_);for(let U=0,q=c.length;U<q;U++){let R=c[U],G=R.color,W=R.intensity,O=R.distance,ee=null;if(R.shadow&&R.shadow.map&&(R.shadow.map.texture.format===tr?ee=R.shadow.map.texture:ee=R.shadow.map.depthTexture||R.shadow.map.texture),R.isAmbientLight)h+=G.r*W,d+=G.g*W,u+=G.b*W;else if(R.isLightProbe){for(let H=0;H<9;H++)n.probe[H].addScaledVector(R.sh.coefficients[H],W);I++}else if(R.isSunLight){let H=e.get(R);if(H.color.copy(R.color).multiplyScalar(R.intensity),R.castShadow){let J=R.shadow,te=t.get(R);te.shadowIntensity=J.intensity,te.shadowBias=J.bias,te.shadowNormalBias=J.normalBias,te.shadowRadius=J.radius,te.shadowMapSize.copy(J.mapSize).multiply(J.getFrameExtents()),n.sunShadow[p]=te,n.sunShadowMap[p]=ee;let ve=J.getViewportCount();for(let Te=0;Te<ve;Te++)n.sunShadowMatrix[v+Te]=J.getMatrix(Te),n.sunShadowCascade[v+Te]=J._cascadeData[Te];v+=ve,p++}n.sun[f]=H,f++}else if(R.isDirectionalLight){let H=e.get(R);if(H.color.copy(R.color).multiplyScalar(R.intensity),R.castShadow){let J=R.shadow,te=t.get(R);te.shadowIntensity=J.intensity,te.shadowBias=J.bias,te.shadowNormalBias=J.normalBias,te.shadowRadius=J.radius,te.shadowMapSize=J.mapSize,n.directionalShadow[g]=te,n.directionalShadowMap[g]=ee,n.directionalShadowMatrix[g]=R.shadow.matrix,T++}n.directional[g]=H,g++}else if(R.isSpotLight){let H=e.get(R);H.position.setFromMatrixPosition(R.matrixWorld),H.color.copy(G).multiplyScalar(W),H.distance=O,H.coneCos=Math.cos(R.angle),H.penumbraCos=Math.cos(R.angle*(1-R.penumbra)),H.decay=R.decay,n.spot[x]=H;let J=R.shadow;if(R.map&&(n.spotLightMap[M]=R.map,M++,J.updateMatrices(R),R.castShadow&&D++),n.spotLightMatrix[x]=J.matrix,R.castShadow){let te=t.get(R);te.shadowIntensity=J.intensity,te.shadowBias=J.bias,te.shadowNormalBias=J.normalBias,te.shadowRadius=J.radius,te.shadowMapSize=J.mapSize,n.spotShadow[x]=te,n.spotShadowMap[x]=ee,y++}x++}else if(R.isRectAreaLight){let H=e.get(R);H.color.copy(G).multiplyScalar(W),H.halfWidth.set(R.width*.5,0,0),H.halfHeight.set(0,R.height*.5,0),n.rectArea[w]=H,w++}else if(R.isPointLight){let H=e.get(R);if(H.color.copy(R.color).multiplyScalar(R.intensity),H.distance=R.distance,H.decay=R.decay,R.castShadow){let J=R.shadow,te=t.get(R);te.shadowIntensity=J.intensity,te.shadowBias=J.bias,te.shadowNormalBias=J.normalBias,te.shadowRadius=J.radius,te.shadowMapSize=J.mapSize,te.shadowCameraNear=J.camera.near,te.shadowCameraFar=J.camera.far,n.pointShadow[m]=te,n.pointShadowMap[m]=ee,n.pointShadowMatrix[m]=R.shadow.matrix,A++}n.point[m]=H,m++}else if(R.isHemisphereLight){let H=e.get(R);H.skyColor.copy(R.color).multiplyScalar(W),H.groundColor.copy(R.groundColor).multiplyScalar(W),n.hemi[_]=H,_++}}w>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=ye.LTC_FLOAT_1,n.rectAreaLTC2=ye.LTC_FLOAT_2):(n.rectAreaLTC1=ye.LTC_HALF_1,n.rectAreaLTC2=ye.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=d,n.ambient[2]=u;let L=n.hash;(L.sunLength!==f||L.directionalLength!==g||L.pointLength!==m||L.spotLength!==x||L.rectAreaLength!==w||L.hemiLength!==_||L.numSunShadows!==p||L.numDirectionalShadows!==T||L.numPointShadows!==A||L.numSpotShadows!==y||L.numSpotMaps!==M||L.numLightProbes!==I)&&(n.sun.length=f,n.directional.length=g,n.spot.length=x,n.rectArea.length=w,n.point.length=m,n.hemi.length=_,n.sunShadow.length=p,n.sunShadowMap.length=p,n.sunShadowMatrix.length=v,n.sunShadowCascade.length=v,n.directionalShadow.length=T,n.directionalShadowMap.length=T,n.directionalShadowMatrix.length=T,n.pointShadow.length=A,n.pointShadowMap.length=A,n.pointShadowMatrix.length=A,n.spotShadow.length=y,n.spotShadowMap.length=y,n.spotLightMatrix.length=y+M-D,n.spotLightMap.length=M,n.numSpotLightShadowsWithMaps=D,n.numLightProbes=I,L.sunLength=f,L.directionalLength=g,L.pointLength=m,L.spotLength=x,L.rectAreaLength=w,L.hemiLength=_,L.numSunShadows=p,L.numDirectionalShadows=T,L.numPointShadows=A,L.numSpotShadows=y,L.numSpotMaps=M,L.numLightProbes=I,n.version=j_++)}function l(c,h){let d=0,u=0,f=0,p=0,v=0,g=0,m=h.matrixWorldInverse;for(let x=0,w=c.length;x<w;x++){let _=c[x];if(_.isSunLight){let T=n.sun[d];T.direction.setFromMatrixPosition(_.matrixWorld),T.direction.transformDirection(m),d++}else if(_.isDirectionalLight){let T=n.directional[u];T.direction.setFromMatrixPosition(_.matrixWorld),r.setFromMatrixPosition(_.target.matrixWorld),T.direction.sub(r),T.direction.transformDirection(m),u++}else if(_.isSpotLight){let T=n.spot[p];T.position.setFromMatrixPosition(_.matrixWorld),T.position.applyMatrix4(m),T.direction.setFromMatrixPosition(_.matrixWorld),r.setFromMatrixPosition(_.target.matrixWorld),T.direction.sub(r),T.direction.transformDirection(m),p++}else if(_.isRectAreaLight){let T=n.rectArea[v];T.position.setFromMatrixPosition(_.matrixWorld),T.position.applyMatrix4(m),o.identity(),s.copy(_.matrixWorld),s.premultiply(m),o.extractRotation(s),T.halfWidth.set(_.width*.5,0,0),T.halfHeight.set(0,_.height*.5,0),T.halfWidth.applyMatrix4(o),T.halfHeight.applyMatrix4(o),v++}else if(_.isPointLight){let T=n.point[f];T.position.setFromMatrixPosition(_.matrixWorld),T.position.applyMatrix4(m),f++}else if(_.isHemisphereLight){let T=n.hemi[g];T.direction.setFromMatrixPosition(_.matrixWorld),T.direction.transformDirection(m),g++}}}return{setup:a,setupView:l,state:n}}function zm(i){let e=new eS(i),t=[],n=[],r=[];function s(d){h.camera=d,t.length=0,n.length=0,r.length=0}function o(d){d.isLightProbeGrid?r.push(d):t.push(d)}function a(d){n.push(d)}function l(){e.setup(t),r.sort((d,u)=>d.priority-u.priority||d.id-u.id)}function c(d){e.setupView(t,d)}let h={lightsArray:t,shadowsArray:n,lightProbeGridArray:r,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:s,state:h,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function tS(i){let e=new WeakMap;function t(r,s=0){let o=e.get(r),a;return o===void 0?(a=new zm(i),e.set(r,[a])):s>=o.length?(a=new zm(i),o.push(a)):a=o[s],a}function n(){e=new WeakMap}return{get:t,dispose:n}}var nS=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,iS=`uniform sampler2D shadow_pass;
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
}`,rS=[new B(1,0,0),new B(-1,0,0),new B(0,1,0),new B(0,-1,0),new B(0,0,1),new B(0,0,-1)],sS=[new B(0,-1,0),new B(0,-1,0),new B(0,0,1),new B(0,0,-1),new B(0,-1,0),new B(0,-1,0)],Vm=new ut,Do=new B,Gu=new B;function oS(i,e,t){let n=new Mr,r=new Ge,s=new Ge,o=new lt,a=new pl,l=new ml,c={},h=t.maxTextureSize,d={[er]:jt,[jt]:er,[Rn]:Rn},u=new $t({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Ge},radius:{value:4}},vertexShader:nS,fragmentShader:iS}),f=u.clone();f.defines.HORIZONTAL_PASS=1;let p=new sn;p.setAttribute("position",new _t(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let v=new Xt(p,u),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Ao;let m=this.type;this.render=function(A,y,M){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||A.length===0)return;this.type===Dp&&(Ie("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Ao);let D=i.getRenderTarget(),I=i.getActiveCubeFace(),L=i.getActiveMipmapLevel(),U=i.state;U.setBlending(wr),U.buffers.depth.getReversed()===!0?U.buffers.color.setClear(0,0,0,0):U.buffers.color.setClear(1,1,1,1),U.buffers.depth.setTest(!0),U.setScissorTest(!1);let q=m!==this.type;q&&y.traverse(function(R){R.material&&(Array.isArray(R.material)?R.material.forEach(G=>G.needsUpdate=!0):R.material.needsUpdate=!0)});for(let R=0,G=A.length;R<G;R++){let W=A[R],O=W.shadow;if(O===void 0){Ie("WebGLShadowMap:",W,"has no shadow.");continue}if(O.autoUpdate===!1&&O.needsUpdate===!1)continue;r.copy(O.mapSize);let ee=O.getFrameExtents();r.multiply(ee),s.copy(O.mapSize),(r.x>h||r.y>h)&&(r.x>h&&(s.x=Math.floor(h/ee.x),r.x=s.x*ee.x,O.mapSize.x=s.x),r.y>h&&(s.y=Math.floor(h/ee.y),r.y=s.y*ee.y,O.mapSize.y=s.y));let H=i.state.buffers.depth.getReversed();if(O.camera._reversedDepth=H,O.map===null||q===!0){if(O.map!==null&&(O.map.depthTexture!==null&&(O.map.depthTexture.dispose(),O.map.depthTexture=null),O.map.dispose()),this.type===vs){if(W.isPointLight){Ie("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}O.map=new fn(r.x,r.y,{format:tr,type:Gn,minFilter:Ft,magFilter:Ft,generateMipmaps:!1}),O.map.texture.name=W.name+".shadowMap",O.map.depthTexture=new Ti(r.x,r.y,gn),O.map.depthTexture.name=W.name+".shadowMapDepth",O.map.depthTexture.format=Ai,O.map.depthTexture.compareFunction=null,O.map.depthTexture.minFilter=St,O.map.depthTexture.magFilter=St}else W.isPointLight?(O.map=new Uo(r.x),O.map.depthTexture=new xo(r.x,Hn)):(O.map=new fn(r.x,r.y),O.map.depthTexture=new Ti(r.x,r.y,Hn)),O.map.depthTexture.name=W.name+".shadowMap",O.map.depthTexture.format=Ai,this.type===Ao?(O.map.depthTexture.compareFunction=H?Fu:Du,O.map.depthTexture.minFilter=Ft,O.map.depthTexture.magFilter=Ft):(O.map.depthTexture.compareFunction=null,O.map.depthTexture.minFilter=St,O.map.depthTexture.magFilter=St);O.camera.updateProjectionMatrix()}O.map.isWebGLCubeRenderTarget!==!0&&(O.map.width!==r.x||O.map.height!==r.y)&&O.map.setSize(r.x,r.y);let J=O.map.isWebGLCubeRenderTarget?6:O.getViewportCount();W.isPointLight!==!0&&O.updateMatrices(W,M);let te=(O.camera.layers.mask&4294967294)!==0?O.camera.layers:M.layers;for(let ve=0;ve<J;ve++){let Te=O.getCamera(ve);if(W.isPointLight){let $=O.camera,re=O.matrix,me=W.distance||$.far;me!==$.far&&($.far=me,$.updateProjectionMatrix()),Do.setFromMatrixPosition(W.matrixWorld),$.position.copy(Do),Gu.copy($.position),Gu.add(rS[ve]),$.up.copy(sS[ve]),$.lookAt(Gu),$.updateMatrixWorld(),re.makeTranslation(-Do.x,-Do.y,-Do.z),Vm.multiplyMatrices($.projectionMatrix,$.matrixWorldInverse),O._frustum.setFromProjectionMatrix(Vm,$.coordinateSystem,$.reversedDepth)}if(O.map.isWebGLCubeRenderTarget)i.setRenderTarget(O.map,ve),i.clear();else{ve===0&&(i.setRenderTarget(O.map),i.clear());let $=O.getViewport(ve);o.set(s.x*$.x,s.y*$.y,s.x*$.z,s.y*$.w),U.viewport(o)}n=O.getFrustum(ve),_(y,M,Te,W,te,this.type)}O.isPointLightShadow!==!0&&this.type===vs&&x(O,M),O.needsUpdate=!1}m=this.type,g.needsUpdate=!1,i.setRenderTarget(D,I,L)};function x(A,y){let M=e.update(v);u.defines.VSM_SAMPLES!==A.blurSamples&&(u.defines.VSM_SAMPLES=A.blurSamples,f.defines.VSM_SAMPLES=A.blurSamples,u.needsUpdate=!0,f.needsUpdate=!0),A.mapPass===null?A.mapPass=new fn(r.x,r.y,{format:tr,type:Gn}):(A.mapPass.width!==A.map.width||A.mapPass.height!==A.map.height)&&A.mapPass.setSize(A.map.width,A.map.height),u.uniforms.shadow_pass.value=A.map.depthTexture,u.uniforms.resolution.value.set(A.map.width,A.map.height),u.uniforms.radius.value=A.radius,i.setRenderTarget(A.mapPass),i.clear(),i.renderBufferDirect(y,null,M,u,v,null),f.uniforms.shadow_pass.value=A.mapPass.texture,f.uniforms.resolution.value.set(A.map.width,A.map.height),f.uniforms.radius.value=A.radius,i.setRenderTarget(A.map),i.clear(),i.renderBufferDirect(y,null,M,f,v,null)}function w(A,y,M,D){let I=null,L=M.isPointLight===!0?A.customDistanceMaterial:A.customDepthMaterial;if(L!==void 0)I=L;else if(I=M.isPointLight===!0?l:a,i.localClippingEnabled&&y.clipShadows===!0&&Array.isArray(y.clippingPlanes)&&y.clippingPlanes.length!==0||y.displacementMap&&y.displacementScale!==0||y.alphaMap&&y.alphaTest>0||y.map&&y.alphaTest>0||y.alphaToCoverage===!0){let U=I.uuid,q=y.uuid,R=c[U];R===void 0&&(R={},c[U]=R);let G=R[q];G===void 0&&(G=I.clone(),R[q]=G,y.addEventListener("dispose",T)),I=G}if(I.visible=y.visible,I.wireframe=y.wireframe,D===vs?I.side=y.shadowSide!==null?y.shadowSide:y.side:I.side=y.shadowSide!==null?y.shadowSide:d[y.side],I.alphaMap=y.alphaMap,I.alphaTest=y.alphaToCoverage===!0?.5:y.alphaTest,I.map=y.map,I.clipShadows=y.clipShadows,I.clippingPlanes=y.clippingPlanes,I.clipIntersection=y.clipIntersection,I.displacementMap=y.displacementMap,I.displacementScale=y.displacementScale,I.displacementBias=y.displacementBias,I.wireframeLinewidth=y.wireframeLinewidth,I.linewidth=y.linewidth,M.isPointLight===!0&&I.isMeshDistanceMaterial===!0){let U=i.properties.get(I);U.light=M}return I}function _(A,y,M,D,I,L){if(A.visible===!1)return;if(A.layers.test(I)&&(A.isMesh||A.isLine||A.isPoints)&&(A.castShadow||A.receiveShadow&&L===vs)&&(!A.frustumCulled||A.intersectsFrustum(n))){A.modelViewMatrix.multiplyMatrices(M.matrixWorldInverse,A.matrixWorld);let R=e.update(A),G=A.material;if(Array.isArray(G)){let W=R.groups;for(let O=0,ee=W.length;O<ee;O++){let H=W[O],J=G[H.materialIndex];if(J&&J.visible){let te=w(A,J,D,L);A.onBeforeShadow(i,A,y,M,R,te,H),i.renderBufferDirect(M,null,R,te,A,H),A.onAfterShadow(i,A,y,M,R,te,H)}}}else if(G.visible){let W=w(A,G,D,L);A.onBeforeShadow(i,A,y,M,R,W,null),i.renderBufferDirect(M,null,R,W,A,null),A.onAfterShadow(i,A,y,M,R,W,null)}}let q=A.children;for(let R=0,G=q.length;R<G;R++)_(q[R],y,M,D,I,L)}function T(A){A.target.removeEventListener("dispose",T);for(let M in c){let D=c[M],I=A.target.uuid;I in D&&(D[I].dispose(),delete D[I])}}}function aS(i,e){function t(){let P=!1,j=new lt,Y=null,ce=new lt(0,0,0,0);return{setMask:function(se){Y!==se&&!P&&(i.colorMask(se,se,se,se),Y=se)},setLocked:function(se){P=se},setClear:function(se,ae,Ae,ze,ie){ie===!0&&(se*=ze,ae*=ze,Ae*=ze),j.set(se,ae,Ae,ze),ce.equals(j)===!1&&(i.clearColor(se,ae,Ae,ze),ce.copy(j))},reset:function(){P=!1,Y=null,ce.set(-1,0,0,0)}}}function n(){let P=!1,j=!1,Y=null,ce=null,se=null;return{setReversed:function(ae){if(j!==ae){let Ae=e.get("EXT_clip_control");ae?Ae.clipControlEXT(Ae.LOWER_LEFT_EXT,Ae.ZERO_TO_ONE_EXT):Ae.clipControlEXT(Ae.LOWER_LEFT_EXT,Ae.NEGATIVE_ONE_TO_ONE_EXT),j=ae;let ze=se;se=null,this.setClear(ze)}},getReversed:function(){return j},setTest:function(ae){ae?fe(i.DEPTH_TEST):Le(i.DEPTH_TEST)},setMask:function(ae){Y!==ae&&!P&&(i.depthMask(ae),Y=ae)},setFunc:function(ae){if(j&&(ae=fm[ae]),ce!==ae){switch(ae){case Za:i.depthFunc(i.NEVER);break;case Ka:i.depthFunc(i.ALWAYS);break;case ja:i.depthFunc(i.LESS);break;case cs:i.depthFunc(i.LEQUAL);break;case Qa:i.depthFunc(i.EQUAL);break;case el:i.depthFunc(i.GEQUAL);break;case hs:i.depthFunc(i.GREATER);break;case tl:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}ce=ae}},setLocked:function(ae){P=ae},setClear:function(ae){se!==ae&&(se=ae,j&&(ae=1-ae),i.clearDepth(ae))},reset:function(){P=!1,Y=null,ce=null,se=null,j=!1}}}function r(){let P=!1,j=null,Y=null,ce=null,se=null,ae=null,Ae=null,ze=null,ie=null;return{setTest:function(Ee){P||(Ee?fe(i.STENCIL_TEST):Le(i.STENCIL_TEST))},setMask:function(Ee){j!==Ee&&!P&&(i.stencilMask(Ee),j=Ee)},setFunc:function(Ee,ke,ge){(Y!==Ee||ce!==ke||se!==ge)&&(i.stencilFunc(Ee,ke,ge),Y=Ee,ce=ke,se=ge)},setOp:function(Ee,ke,ge){(ae!==Ee||Ae!==ke||ze!==ge)&&(i.stencilOp(Ee,ke,ge),ae=Ee,Ae=ke,ze=ge)},setLocked:function(Ee){P=Ee},setClear:function(Ee){ie!==Ee&&(i.clearStencil(Ee),ie=Ee)},reset:function(){P=!1,j=null,Y=null,ce=null,se=null,ae=null,Ae=null,ze=null,ie=null}}}let s=new t,o=new n,a=new r,l={},c=new WeakMap,h={},d={},u={},f=new WeakMap,p=[],v=null,g=!1,m=null,x=null,w=null,_=null,T=null,A=null,y=null,M=new Ve(0,0,0),D=0,I=!1,L=null,U=null,q=null,R=null,G=null,W=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),O=!1,ee=0,H=i.getParameter(i.VERSION);H.indexOf("WebGL")!==-1?(ee=parseFloat(/^WebGL (\d)/.exec(H)[1]),O=ee>=1):H.indexOf("OpenGL ES")!==-1&&(ee=parseFloat(/^OpenGL ES (\d)/.exec(H)[1]),O=ee>=2);let J=null,te={},ve=i.getParameter(i.SCISSOR_BOX),Te=i.getParameter(i.VIEWPORT),$=new lt().fromArray(ve),re=new lt().fromArray(Te);function me(P,j,Y,ce){let se=new Uint8Array(4),ae=i.createTexture();i.bindTexture(P,ae),i.texParameteri(P,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(P,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Ae=0;Ae<Y;Ae++)P===i.TEXTURE_3D||P===i.TEXTURE_2D_ARRAY?i.texImage3D(j,0,i.RGBA,1,1,ce,0,i.RGBA,i.UNSIGNED_BYTE,se):i.texImage2D(j+Ae,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,se);return ae}let Me={};Me[i.TEXTURE_2D]=me(i.TEXTURE_2D,i.TEXTURE_2D,1),Me[i.TEXTURE_CUBE_MAP]=me(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Me[i.TEXTURE_2D_ARRAY]=me(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Me[i.TEXTURE_3D]=me(i.TEXTURE_3D,i.TEXTURE_3D,1,1),s.setClear(0,0,0,1),o.setClear(1),a.setClear(0),fe(i.DEPTH_TEST),o.setFunc(cs),en(!1),mt(du),fe(i.CULL_FACE),Ut(wr);function fe(P){h[P]!==!0&&(i.enable(P),h[P]=!0)}function Le(P){h[P]!==!1&&(i.disable(P),h[P]=!1)}function dt(P,j){return u[P]!==j?(i.bindFramebuffer(P,j),u[P]=j,P===i.DRAW_FRAMEBUFFER&&(u[i.FRAMEBUFFER]=j),P===i.FRAMEBUFFER&&(u[i.DRAW_FRAMEBUFFER]=j),!0):!1}function Ce(P,j){let Y=p,ce=!1;if(P){Y=f.get(j),Y===void 0&&(Y=[],f.set(j,Y));let se=P.textures;if(Y.length!==se.length||Y[0]!==i.COLOR_ATTACHMENT0){for(let ae=0,Ae=se.length;ae<Ae;ae++)Y[ae]=i.COLOR_ATTACHMENT0+ae;Y.length=se.length,ce=!0}}else Y[0]!==i.BACK&&(Y[0]=i.BACK,ce=!0);ce&&i.drawBuffers(Y)}function Ze(P){return v!==P?(i.useProgram(P),v=P,!0):!1}let Qe={[Ar]:i.FUNC_ADD,[Up]:i.FUNC_SUBTRACT,[Op]:i.FUNC_REVERSE_SUBTRACT};Qe[kp]=i.MIN,Qe[Bp]=i.MAX;let We={[zp]:i.ZERO,[Vp]:i.ONE,[Hp]:i.SRC_COLOR,[gu]:i.SRC_ALPHA,[Yp]:i.SRC_ALPHA_SATURATE,[Xp]:i.DST_COLOR,[Wp]:i.DST_ALPHA,[Gp]:i.ONE_MINUS_SRC_COLOR,[yu]:i.ONE_MINUS_SRC_ALPHA,[$p]:i.ONE_MINUS_DST_COLOR,[qp]:i.ONE_MINUS_DST_ALPHA,[Jp]:i.CONSTANT_COLOR,[Zp]:i.ONE_MINUS_CONSTANT_COLOR,[Kp]:i.CONSTANT_ALPHA,[jp]:i.ONE_MINUS_CONSTANT_ALPHA};function Ut(P,j,Y,ce,se,ae,Ae,ze,ie,Ee){if(P===wr){g===!0&&(Le(i.BLEND),g=!1);return}if(g===!1&&(fe(i.BLEND),g=!0),P!==Fp){if(P!==m||Ee!==I){if((x!==Ar||T!==Ar)&&(i.blendEquation(i.FUNC_ADD),x=Ar,T=Ar),Ee)switch(P){case bs:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case fu:i.blendFunc(i.ONE,i.ONE);break;case pu:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case mu:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:Ne("WebGLState: Invalid blending: ",P);break}else switch(P){case bs:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case fu:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case pu:Ne("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case mu:Ne("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:Ne("WebGLState: Invalid blending: ",P);break}w=null,_=null,A=null,y=null,M.set(0,0,0),D=0,m=P,I=Ee}return}se=se||j,ae=ae||Y,Ae=Ae||ce,(j!==x||se!==T)&&(i.blendEquationSeparate(Qe[j],Qe[se]),x=j,T=se),(Y!==w||ce!==_||ae!==A||Ae!==y)&&(i.blendFuncSeparate(We[Y],We[ce],We[ae],We[Ae]),w=Y,_=ce,A=ae,y=Ae),(ze.equals(M)===!1||ie!==D)&&(i.blendColor(ze.r,ze.g,ze.b,ie),M.copy(ze),D=ie),m=P,I=!1}function Mt(P,j){P.side===Rn?Le(i.CULL_FACE):fe(i.CULL_FACE);let Y=P.side===jt;j&&(Y=!Y),en(Y),P.blending===bs&&P.transparent===!1?Ut(wr):Ut(P.blending,P.blendEquation,P.blendSrc,P.blendDst,P.blendEquationAlpha,P.blendSrcAlpha,P.blendDstAlpha,P.blendColor,P.blendAlpha,P.premultipliedAlpha),o.setFunc(P.depthFunc),o.setTest(P.depthTest),o.setMask(P.depthWrite),s.setMask(P.colorWrite);let ce=P.stencilWrite;a.setTest(ce),ce&&(a.setMask(P.stencilWriteMask),a.setFunc(P.stencilFunc,P.stencilRef,P.stencilFuncMask),a.setOp(P.stencilFail,P.stencilZFail,P.stencilZPass)),It(P.polygonOffset,P.polygonOffsetFactor,P.polygonOffsetUnits),P.alphaToCoverage===!0?fe(i.SAMPLE_ALPHA_TO_COVERAGE):Le(i.SAMPLE_ALPHA_TO_COVERAGE)}function en(P){L!==P&&(P?i.frontFace(i.CW):i.frontFace(i.CCW),L=P)}function mt(P){P!==Lp?(fe(i.CULL_FACE),P!==U&&(P===du?i.cullFace(i.BACK):P===Np?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Le(i.CULL_FACE),U=P}function Wn(P){P!==q&&(O&&i.lineWidth(P),q=P)}function It(P,j,Y){P?(fe(i.POLYGON_OFFSET_FILL),(R!==j||G!==Y)&&(R=j,G=Y,o.getReversed()&&(j=-j,Y=-Y),i.polygonOffset(j,Y))):Le(i.POLYGON_OFFSET_FILL)}function xn(P){P?fe(i.SCISSOR_TEST):Le(i.SCISSOR_TEST)}function vn(P){P===void 0&&(P=i.TEXTURE0+W-1),J!==P&&(i.activeTexture(P),J=P)}function bn(P,j,Y){Y===void 0&&(J===null?Y=i.TEXTURE0+W-1:Y=J);let ce=te[Y];ce===void 0&&(ce={type:void 0,texture:void 0},te[Y]=ce),(ce.type!==P||ce.texture!==j)&&(J!==Y&&(i.activeTexture(Y),J=Y),i.bindTexture(P,j||Me[P]),ce.type=P,ce.texture=j)}function F(){let P=te[J];P!==void 0&&P.type!==void 0&&(i.bindTexture(P.type,null),P.type=void 0,P.texture=void 0)}function _n(){try{i.compressedTexImage2D(...arguments)}catch(P){Ne("WebGLState:",P)}}function ft(){try{i.compressedTexImage3D(...arguments)}catch(P){Ne("WebGLState:",P)}}function pt(){try{i.texSubImage2D(...arguments)}catch(P){Ne("WebGLState:",P)}}function pe(){try{i.texSubImage3D(...arguments)}catch(P){Ne("WebGLState:",P)}}function wt(){try{i.compressedTexSubImage2D(...arguments)}catch(P){Ne("WebGLState:",P)}}function Re(){try{i.compressedTexSubImage3D(...arguments)}catch(P){Ne("WebGLState:",P)}}function Ue(){try{i.texStorage2D(...arguments)}catch(P){Ne("WebGLState:",P)}}function E(){try{i.texStorage3D(...arguments)}catch(P){Ne("WebGLState:",P)}}function b(){try{i.texImage2D(...arguments)}catch(P){Ne("WebGLState:",P)}}function z(){try{i.texImage3D(...arguments)}catch(P){Ne("WebGLState:",P)}}function ne(P){return d[P]!==void 0?d[P]:i.getParameter(P)}function Q(P,j){d[P]!==j&&(i.pixelStorei(P,j),d[P]=j)}function oe(P){$.equals(P)===!1&&(i.scissor(P.x,P.y,P.z,P.w),$.copy(P))}function ue(P){re.equals(P)===!1&&(i.viewport(P.x,P.y,P.z,P.w),re.copy(P))}function Z(P,j){let Y=c.get(j);Y===void 0&&(Y=new WeakMap,c.set(j,Y));let ce=Y.get(P);ce===void 0&&(ce=i.getUniformBlockIndex(j,P.name),i.uniformBlockBinding(j,ce,ce),Y.set(P,ce))}function K(P,j,Y){let se=c.get(j).get(P);l[se]!==Y&&(i.bindBufferBase(i.UNIFORM_BUFFER,se,Y),l[se]=Y)}function le(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),h={},d={},J=null,te={},u={},l={},f=new WeakMap,p=[],v=null,g=!1,m=null,x=null,w=null,_=null,T=null,A=null,y=null,M=new Ve(0,0,0),D=0,I=!1,L=null,U=null,q=null,R=null,G=null,$.set(0,0,i.canvas.width,i.canvas.height),re.set(0,0,i.canvas.width,i.canvas.height),s.reset(),o.reset(),a.reset()}return{buffers:{color:s,depth:o,stencil:a},enable:fe,disable:Le,bindFramebuffer:dt,drawBuffers:Ce,useProgram:Ze,setBlending:Ut,setMaterial:Mt,setFlipSided:en,setCullFace:mt,setLineWidth:Wn,setPolygonOffset:It,setScissorTest:xn,activeTexture:vn,bindTexture:bn,unbindTexture:F,compressedTexImage2D:_n,compressedTexImage3D:ft,texImage2D:b,texImage3D:z,pixelStorei:Q,getParameter:ne,updateUBOMapping:Z,uniformBlockBinding:K,texStorage2D:Ue,texStorage3D:E,texSubImage2D:pt,texSubImage3D:pe,compressedTexSubImage2D:wt,compressedTexSubImage3D:Re,scissor:oe,viewport:ue,reset:le}}function lS(i,e,t,n,r,s,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Ge,h=new WeakMap,d=new Set,u,f=new WeakMap,p=new Set,v=new FinalizationRegistry(E=>p.delete(E)),g=!1;try{g=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(E,b){return g?new OffscreenCanvas(E,b):ao("canvas")}function x(E,b,z){let ne=1,Q=Ue(E);if((Q.width>z||Q.height>z)&&(ne=z/Math.max(Q.width,Q.height)),ne<1)if(typeof HTMLImageElement<"u"&&E instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&E instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&E instanceof ImageBitmap||typeof VideoFrame<"u"&&E instanceof VideoFrame){let oe=Math.floor(ne*Q.width),ue=Math.floor(ne*Q.height);u===void 0&&(u=m(oe,ue));let Z=b?m(oe,ue):u;return Z.width=oe,Z.height=ue,Z.getContext("2d").drawImage(E,0,0,oe,ue),Ie("WebGLRenderer: Texture has been resized from ("+Q.width+"x"+Q.height+") to ("+oe+"x"+ue+")."),Z}else return"data"in E&&Ie("WebGLRenderer: Image in DataTexture is too big ("+Q.width+"x"+Q.height+")."),E;return E}function w(E){return E.generateMipmaps}function _(E){i.generateMipmap(E)}function T(E){return E.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:E.isWebGL3DRenderTarget?i.TEXTURE_3D:E.isWebGLArrayRenderTarget||E.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function A(E,b,z,ne,Q,oe=!1){if(E!==null){if(i[E]!==void 0)return i[E];Ie("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+E+"'")}let ue;ne&&(ue=e.get("EXT_texture_norm16"),ue||Ie("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let Z=b;if(b===i.RED&&(z===i.FLOAT&&(Z=i.R32F),z===i.HALF_FLOAT&&(Z=i.R16F),z===i.UNSIGNED_BYTE&&(Z=i.R8),z===i.UNSIGNED_SHORT&&ue&&(Z=ue.R16_EXT),z===i.SHORT&&ue&&(Z=ue.R16_SNORM_EXT)),b===i.RED_INTEGER&&(z===i.UNSIGNED_BYTE&&(Z=i.R8UI),z===i.UNSIGNED_SHORT&&(Z=i.R16UI),z===i.UNSIGNED_INT&&(Z=i.R32UI),z===i.BYTE&&(Z=i.R8I),z===i.SHORT&&(Z=i.R16I),z===i.INT&&(Z=i.R32I)),b===i.RG&&(z===i.FLOAT&&(Z=i.RG32F),z===i.HALF_FLOAT&&(Z=i.RG16F),z===i.UNSIGNED_BYTE&&(Z=i.RG8),z===i.UNSIGNED_SHORT&&ue&&(Z=ue.RG16_EXT),z===i.SHORT&&ue&&(Z=ue.RG16_SNORM_EXT)),b===i.RG_INTEGER&&(z===i.UNSIGNED_BYTE&&(Z=i.RG8UI),z===i.UNSIGNED_SHORT&&(Z=i.RG16UI),z===i.UNSIGNED_INT&&(Z=i.RG32UI),z===i.BYTE&&(Z=i.RG8I),z===i.SHORT&&(Z=i.RG16I),z===i.INT&&(Z=i.RG32I)),b===i.RGB_INTEGER&&(z===i.UNSIGNED_BYTE&&(Z=i.RGB8UI),z===i.UNSIGNED_SHORT&&(Z=i.RGB16UI),z===i.UNSIGNED_INT&&(Z=i.RGB32UI),z===i.BYTE&&(Z=i.RGB8I),z===i.SHORT&&(Z=i.RGB16I),z===i.INT&&(Z=i.RGB32I)),b===i.RGBA_INTEGER&&(z===i.UNSIGNED_BYTE&&(Z=i.RGBA8UI),z===i.UNSIGNED_SHORT&&(Z=i.RGBA16UI),z===i.UNSIGNED_INT&&(Z=i.RGBA32UI),z===i.BYTE&&(Z=i.RGBA8I),z===i.SHORT&&(Z=i.RGBA16I),z===i.INT&&(Z=i.RGBA32I)),b===i.RGB&&(z===i.UNSIGNED_SHORT&&ue&&(Z=ue.RGB16_EXT),z===i.SHORT&&ue&&(Z=ue.RGB16_SNORM_EXT),z===i.UNSIGNED_INT_5_9_9_9_REV&&(Z=i.RGB9_E5),z===i.UNSIGNED_INT_10F_11F_11F_REV&&(Z=i.R11F_G11F_B10F)),b===i.RGBA){let K=oe?so:Ye.getTransfer(Q);z===i.FLOAT&&(Z=i.RGBA32F),z===i.HALF_FLOAT&&(Z=i.RGBA16F),z===i.UNSIGNED_BYTE&&(Z=K===nt?i.SRGB8_ALPHA8:i.RGBA8),z===i.UNSIGNED_SHORT&&ue&&(Z=ue.RGBA16_EXT),z===i.SHORT&&ue&&(Z=ue.RGBA16_SNORM_EXT),z===i.UNSIGNED_SHORT_4_4_4_4&&(Z=i.RGBA4),z===i.UNSIGNED_SHORT_5_5_5_1&&(Z=i.RGB5_A1)}return(Z===i.R16F||Z===i.R32F||Z===i.RG16F||Z===i.RG32F||Z===i.RGBA16F||Z===i.RGBA32F)&&e.get("EXT_color_buffer_float"),Z}function y(E,b){let z;return E?b===null||b===Hn||b===Er?z=i.DEPTH24_STENCIL8:b===gn?z=i.DEPTH32F_STENCIL8:b===Ss&&(z=i.DEPTH24_STENCIL8,Ie("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):b===null||b===Hn||b===Er?z=i.DEPTH_COMPONENT24:b===gn?z=i.DEPTH_COMPONENT32F:b===Ss&&(z=i.DEPTH_COMPONENT16),z}function M(E,b){return w(E)===!0||E.isFramebufferTexture&&E.minFilter!==St&&E.minFilter!==Ft?Math.log2(Math.max(b.width,b.height))+1:E.mipmaps.length>0?E.mipmaps.length:E.isCompressedTexture&&Array.isArray(E.image)?b.mipmaps.length:1}function D(E){let b=new WeakRef(E);n.get(E).__ref=b,p.add(b),v.register(E,b,b)}function I(E){let b=n.get(E).__ref;b!==void 0&&(p.delete(b),v.unregister(b))}function L(E){q(E.target)}function U(E){R(E.target)}function q(E){E.removeEventListener("dispose",L),I(E),W(E),E.isVideoTexture&&h.delete(E),E.isHTMLTexture&&d.delete(E)}function R(E){E.removeEventListener("dispose",U),I(E),ee(E)}function G(){for(let E of p){let b=E.deref();b!==void 0&&(b.isRenderTarget===!0?R(b):q(b))}p.clear(),d.clear()}function W(E){let b=n.get(E);if(b.__webglInit===void 0)return;let z=E.source,ne=f.get(z);if(ne){let Q=ne[b.__cacheKey];Q.usedTimes--,Q.usedTimes===0&&O(E),Object.keys(ne).length===0&&f.delete(z)}n.remove(E)}function O(E){let b=n.get(E);i.deleteTexture(b.__webglTexture);let z=E.source,ne=f.get(z);delete ne[b.__cacheKey],o.memory.textures--}function ee(E){let b=n.get(E);b.__depthDisposeCallback&&b.__depthDisposeCallback();let z=E.depthTexture;if(z&&z.renderTarget===E&&q(z),E.isWebGLCubeRenderTarget)for(let Q=0;Q<6;Q++){if(Array.isArray(b.__webglFramebuffer[Q]))for(let oe=0;oe<b.__webglFramebuffer[Q].length;oe++)i.deleteFramebuffer(b.__webglFramebuffer[Q][oe]);else i.deleteFramebuffer(b.__webglFramebuffer[Q]);b.__webglDepthbuffer&&i.deleteRenderbuffer(b.__webglDepthbuffer[Q])}else{if(Array.isArray(b.__webglFramebuffer))for(let Q=0;Q<b.__webglFramebuffer.length;Q++)i.deleteFramebuffer(b.__webglFramebuffer[Q]);else i.deleteFramebuffer(b.__webglFramebuffer);if(b.__webglDepthbuffer&&i.deleteRenderbuffer(b.__webglDepthbuffer),b.__webglMultisampledFramebuffer&&i.deleteFramebuffer(b.__webglMultisampledFramebuffer),b.__webglColorRenderbuffer)for(let Q=0;Q<b.__webglColorRenderbuffer.length;Q++)b.__webglColorRenderbuffer[Q]&&i.deleteRenderbuffer(b.__webglColorRenderbuffer[Q]);b.__webglDepthRenderbuffer&&i.deleteRenderbuffer(b.__webglDepthRenderbuffer)}let ne=E.textures;for(let Q=0,oe=ne.length;Q<oe;Q++){let ue=n.get(ne[Q]);ue.__webglTexture&&(i.deleteTexture(ue.__webglTexture),o.memory.textures--),n.remove(ne[Q])}n.remove(E)}let H=0;function J(){H=0}function te(){return H}function ve(E){H=E}function Te(){let E=H;return E>=r.maxTextures&&Ie("WebGLTextures: Trying to use "+(E+1)+" texture units while this GPU supports only "+r.maxTextures),H+=1,E}function $(E){let b=[];return b.push(E.wrapS),b.push(E.wrapT),b.push(E.wrapR||0),b.push(E.magFilter),b.push(E.minFilter),b.push(E.anisotropy),b.push(E.internalFormat),b.push(E.format),b.push(E.type),b.push(E.generateMipmaps),b.push(E.mipmapsAutoUpdate),b.push(E.premultiplyAlpha),b.push(E.flipY),b.push(E.unpackAlignment),b.push(E.colorSpace),b.join()}function re(E,b){let z=n.get(E);if(E.isVideoTexture&&wt(E),E.isRenderTargetTexture===!1&&E.isExternalTexture!==!0&&E.version>0&&z.__version!==E.version){let ne=E.image;if(ne===null)Ie("WebGLRenderer: Texture marked for update but no image data found.");else if(ne.complete===!1)Ie("WebGLRenderer: Texture marked for update but image is incomplete");else{Mt(z,E,b);return}}else E.isExternalTexture&&(z.__webglTexture=E.sourceTexture?E.sourceTexture:null);t.bindTexture(i.TEXTURE_2D,z.__webglTexture,i.TEXTURE0+b)}function me(E,b){let z=n.get(E);if(E.isRenderTargetTexture===!1&&E.version>0&&z.__version!==E.version){Mt(z,E,b);return}else E.isExternalTexture&&(z.__webglTexture=E.sourceTexture?E.sourceTexture:null);t.bindTexture(i.TEXTURE_2D_ARRAY,z.__webglTexture,i.TEXTURE0+b)}function Me(E,b){let z=n.get(E);if(E.isRenderTargetTexture===!1&&E.version>0&&z.__version!==E.version){Mt(z,E,b);return}t.bindTexture(i.TEXTURE_3D,z.__webglTexture,i.TEXTURE0+b)}function fe(E,b){let z=n.get(E);if(E.version>0&&z.__version!==E.version){en(z,E,b);return}t.bindTexture(i.TEXTURE_CUBE_MAP,z.__webglTexture,i.TEXTURE0+b)}let Le={[nl]:i.REPEAT,[ri]:i.CLAMP_TO_EDGE,[il]:i.MIRRORED_REPEAT},dt={[St]:i.NEAREST,[tm]:i.NEAREST_MIPMAP_NEAREST,[To]:i.NEAREST_MIPMAP_LINEAR,[Ft]:i.LINEAR,[Rl]:i.LINEAR_MIPMAP_NEAREST,[Ei]:i.LINEAR_MIPMAP_LINEAR},Ce={[sm]:i.NEVER,[Uu]:i.ALWAYS,[om]:i.LESS,[Du]:i.LEQUAL,[am]:i.EQUAL,[Fu]:i.GEQUAL,[lm]:i.GREATER,[cm]:i.NOTEQUAL};function Ze(E,b){if(b.type===gn&&e.has("OES_texture_float_linear")===!1&&(b.magFilter===Ft||b.magFilter===Rl||b.magFilter===To||b.magFilter===Ei||b.minFilter===Ft||b.minFilter===Rl||b.minFilter===To||b.minFilter===Ei)&&Ie("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(E,i.TEXTURE_WRAP_S,Le[b.wrapS]),i.texParameteri(E,i.TEXTURE_WRAP_T,Le[b.wrapT]),(E===i.TEXTURE_3D||E===i.TEXTURE_2D_ARRAY)&&i.texParameteri(E,i.TEXTURE_WRAP_R,Le[b.wrapR]),i.texParameteri(E,i.TEXTURE_MAG_FILTER,dt[b.magFilter]),i.texParameteri(E,i.TEXTURE_MIN_FILTER,dt[b.minFilter]),b.compareFunction&&(i.texParameteri(E,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(E,i.TEXTURE_COMPARE_FUNC,Ce[b.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(b.magFilter===St||b.minFilter!==To&&b.minFilter!==Ei||b.type===gn&&e.has("OES_texture_float_linear")===!1)return;if(b.anisotropy>1||n.get(b).__currentAnisotropy){let z=e.get("EXT_texture_filter_anisotropic");i.texParameterf(E,z.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(b.anisotropy,r.getMaxAnisotropy())),n.get(b).__currentAnisotropy=b.anisotropy}}}function Qe(E,b){let z=!1;E.__webglInit===void 0&&(E.__webglInit=!0,b.addEventListener("dispose",L),D(b));let ne=b.source,Q=f.get(ne);Q===void 0&&(Q={},f.set(ne,Q));let oe=$(b);if(oe!==E.__cacheKey){Q[oe]===void 0&&(Q[oe]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,z=!0),Q[oe].usedTimes++;let ue=Q[E.__cacheKey];ue!==void 0&&(Q[E.__cacheKey].usedTimes--,ue.usedTimes===0&&O(b)),E.__cacheKey=oe,E.__webglTexture=Q[oe].texture}return z}function We(E,b,z){return Math.floor(Math.floor(E/z)/b)}function Ut(E,b,z,ne){let oe=E.updateRanges;if(oe.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,b.width,b.height,z,ne,b.data);else{oe.sort((P,j)=>P.start-j.start);let ue=0;for(let P=1;P<oe.length;P++){let j=oe[ue],Y=oe[P],ce=j.start+j.count,se=We(Y.start,b.width,4),ae=We(j.start,b.width,4);Y.start<=ce+1&&se===ae&&We(Y.start+Y.count-1,b.width,4)===se?j.count=Math.max(j.count,Y.start+Y.count-j.start):(++ue,oe[ue]=Y)}oe.length=ue+1;let Z=t.getParameter(i.UNPACK_ROW_LENGTH),K=t.getParameter(i.UNPACK_SKIP_PIXELS),le=t.getParameter(i.UNPACK_SKIP_ROWS);t.pixelStorei(i.UNPACK_ROW_LENGTH,b.width);for(let P=0,j=oe.length;P<j;P++){let Y=oe[P],ce=Math.floor(Y.start/4),se=Math.ceil(Y.count/4),ae=ce%b.width,Ae=Math.floor(ce/b.width),ze=se,ie=1;t.pixelStorei(i.UNPACK_SKIP_PIXELS,ae),t.pixelStorei(i.UNPACK_SKIP_ROWS,Ae),t.texSubImage2D(i.TEXTURE_2D,0,ae,Ae,ze,ie,z,ne,b.data)}E.clearUpdateRanges(),t.pixelStorei(i.UNPACK_ROW_LENGTH,Z),t.pixelStorei(i.UNPACK_SKIP_PIXELS,K),t.pixelStorei(i.UNPACK_SKIP_ROWS,le)}}function Mt(E,b,z){let ne=i.TEXTURE_2D;(b.isDataArrayTexture||b.isCompressedArrayTexture)&&(ne=i.TEXTURE_2D_ARRAY),b.isData3DTexture&&(ne=i.TEXTURE_3D);let Q=Qe(E,b),oe=b.source;t.bindTexture(ne,E.__webglTexture,i.TEXTURE0+z);let ue=n.get(oe);if(oe.version!==ue.__version||Q===!0){if(t.activeTexture(i.TEXTURE0+z),(typeof ImageBitmap<"u"&&b.image instanceof ImageBitmap)===!1){let ie=Ye.getPrimaries(Ye.workingColorSpace),Ee=b.colorSpace===Ri?null:Ye.getPrimaries(b.colorSpace),ke=b.colorSpace===Ri||ie===Ee?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,b.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,b.premultiplyAlpha),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,ke)}t.pixelStorei(i.UNPACK_ALIGNMENT,b.unpackAlignment);let K=x(b.image,!1,r.maxTextureSize);K=Re(b,K);let le=s.convert(b.format,b.colorSpace),P=s.convert(b.type),j=A(b.internalFormat,le,P,b.normalized,b.colorSpace,b.isVideoTexture);Ze(ne,b);let Y,ce=b.mipmaps,se=b.isVideoTexture!==!0,ae=ue.__version===void 0||Q===!0,Ae=oe.dataReady,ze=M(b,K);if(b.isDepthTexture)j=y(b.format===Ci,b.type),ae&&(se?t.texStorage2D(i.TEXTURE_2D,1,j,K.width,K.height):t.texImage2D(i.TEXTURE_2D,0,j,K.width,K.height,0,le,P,null));else if(b.isDataTexture)if(ce.length>0){se&&ae&&t.texStorage2D(i.TEXTURE_2D,ze,j,ce[0].width,ce[0].height);for(let ie=0,Ee=ce.length;ie<Ee;ie++)Y=ce[ie],se?Ae&&t.texSubImage2D(i.TEXTURE_2D,ie,0,0,Y.width,Y.height,le,P,Y.data):t.texImage2D(i.TEXTURE_2D,ie,j,Y.width,Y.height,0,le,P,Y.data);b.generateMipmaps=!1}else se?(ae&&t.texStorage2D(i.TEXTURE_2D,ze,j,K.width,K.height),Ae&&Ut(b,K,le,P)):t.texImage2D(i.TEXTURE_2D,0,j,K.width,K.height,0,le,P,K.data);else if(b.isCompressedTexture)if(b.isCompressedArrayTexture){se&&ae&&t.texStorage3D(i.TEXTURE_2D_ARRAY,ze,j,ce[0].width,ce[0].height,K.depth);for(let ie=0,Ee=ce.length;ie<Ee;ie++)if(Y=ce[ie],b.format!==yn)if(le!==null)if(se){if(Ae)if(b.layerUpdates.size>0){let ke=Vu(Y.width,Y.height,b.format,b.type);for(let ge of b.layerUpdates){let it=Y.data.subarray(ge*ke/Y.data.BYTES_PER_ELEMENT,(ge+1)*ke/Y.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ie,0,0,ge,Y.width,Y.height,1,le,it)}}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ie,0,0,0,Y.width,Y.height,K.depth,le,Y.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,ie,j,Y.width,Y.height,K.depth,0,Y.data,0,0);else Ie("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else se?Ae&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,ie,0,0,0,Y.width,Y.height,K.depth,le,P,Y.data):t.texImage3D(i.TEXTURE_2D_ARRAY,ie,j,Y.width,Y.height,K.depth,0,le,P,Y.data);b.layerUpdates.size>0&&b.clearLayerUpdates()}else{se&&ae&&t.texStorage2D(i.TEXTURE_2D,ze,j,ce[0].width,ce[0].height);for(let ie=0,Ee=ce.length;ie<Ee;ie++)Y=ce[ie],b.format!==yn?le!==null?se?Ae&&t.compressedTexSubImage2D(i.TEXTURE_2D,ie,0,0,Y.width,Y.height,le,Y.data):t.compressedTexImage2D(i.TEXTURE_2D,ie,j,Y.width,Y.height,0,Y.data):Ie("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):se?Ae&&t.texSubImage2D(i.TEXTURE_2D,ie,0,0,Y.width,Y.height,le,P,Y.data):t.texImage2D(i.TEXTURE_2D,ie,j,Y.width,Y.height,0,le,P,Y.data)}else if(b.isDataArrayTexture)if(se){if(ae&&t.texStorage3D(i.TEXTURE_2D_ARRAY,ze,j,K.width,K.height,K.depth),Ae)if(b.layerUpdates.size>0){let ie=Vu(K.width,K.height,b.format,b.type);for(let Ee of b.layerUpdates){let ke=K.data.subarray(Ee*ie/K.data.BYTES_PER_ELEMENT,(Ee+1)*ie/K.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,Ee,K.width,K.height,1,le,P,ke)}b.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,K.width,K.height,K.depth,le,P,K.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,j,K.width,K.height,K.depth,0,le,P,K.data);else if(b.isData3DTexture)se?(ae&&t.texStorage3D(i.TEXTURE_3D,ze,j,K.width,K.height,K.depth),Ae&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,K.width,K.height,K.depth,le,P,K.data)):t.texImage3D(i.TEXTURE_3D,0,j,K.width,K.height,K.depth,0,le,P,K.data);else if(b.isFramebufferTexture){if(ae)if(se)t.texStorage2D(i.TEXTURE_2D,ze,j,K.width,K.height);else{let ie=K.width,Ee=K.height;for(let ke=0;ke<ze;ke++)t.texImage2D(i.TEXTURE_2D,ke,j,ie,Ee,0,le,P,null),ie>>=1,Ee>>=1}}else if(b.isHTMLTexture){if("texElementImage2D"in i){let ie=i.canvas;if(ie.hasAttribute("layoutsubtree")||ie.setAttribute("layoutsubtree","true"),K.parentNode!==ie){ie.appendChild(K),d.add(b),ie.onpaint=Ee=>{let ke=Ee.changedElements;for(let ge of d)ke.includes(ge.image)&&(ge.needsUpdate=!0)},ie.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,K);else{let ke=i.RGBA,ge=i.RGBA,it=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,ke,ge,it,K)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(ce.length>0){if(se&&ae){let ie=Ue(ce[0]);t.texStorage2D(i.TEXTURE_2D,ze,j,ie.width,ie.height)}for(let ie=0,Ee=ce.length;ie<Ee;ie++)Y=ce[ie],se?Ae&&t.texSubImage2D(i.TEXTURE_2D,ie,0,0,le,P,Y):t.texImage2D(i.TEXTURE_2D,ie,j,le,P,Y);b.generateMipmaps=!1}else if(se){if(ae){let ie=Ue(K);t.texStorage2D(i.TEXTURE_2D,ze,j,ie.width,ie.height)}Ae&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,le,P,K)}else t.texImage2D(i.TEXTURE_2D,0,j,le,P,K);w(b)&&b.mipmapsAutoUpdate===!0&&_(ne),ue.__version=oe.version,b.onUpdate&&b.onUpdate(b)}E.__version=b.version}function en(E,b,z){if(b.image.length!==6)return;let ne=Qe(E,b),Q=b.source;t.bindTexture(i.TEXTURE_CUBE_MAP,E.__webglTexture,i.TEXTURE0+z);let oe=n.get(Q);if(Q.version!==oe.__version||ne===!0){t.activeTexture(i.TEXTURE0+z);let ue=Ye.getPrimaries(Ye.workingColorSpace),Z=b.colorSpace===Ri?null:Ye.getPrimaries(b.colorSpace),K=b.colorSpace===Ri||ue===Z?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,b.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,b.premultiplyAlpha),t.pixelStorei(i.UNPACK_ALIGNMENT,b.unpackAlignment),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,K);let le=b.isCompressedTexture||b.image[0].isCompressedTexture,P=b.image[0]&&b.image[0].isDataTexture,j=[];for(let ge=0;ge<6;ge++)!le&&!P?j[ge]=x(b.image[ge],!0,r.maxCubemapSize):j[ge]=P?b.image[ge].image:b.image[ge],j[ge]=Re(b,j[ge]);let Y=j[0],ce=s.convert(b.format,b.colorSpace),se=s.convert(b.type),ae=A(b.internalFormat,ce,se,b.normalized,b.colorSpace),Ae=b.isVideoTexture!==!0,ze=oe.__version===void 0||ne===!0,ie=Q.dataReady,Ee=M(b,Y);Ze(i.TEXTURE_CUBE_MAP,b);let ke;if(b.isDepthTexture){if(ae=y(b.format===Ci,b.type),ze)if(Ae)t.texStorage2D(i.TEXTURE_CUBE_MAP,1,ae,Y.width,Y.height);else for(let ge=0;ge<6;ge++)t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,0,ae,Y.width,Y.height,0,ce,se,null)}else if(le){Ae&&ze&&t.texStorage2D(i.TEXTURE_CUBE_MAP,Ee,ae,Y.width,Y.height);for(let ge=0;ge<6;ge++){ke=j[ge].mipmaps;for(let it=0;it<ke.length;it++){let Lt=ke[it];b.format!==yn?ce!==null?Ae?ie&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,it,0,0,Lt.width,Lt.height,ce,Lt.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,it,ae,Lt.width,Lt.height,0,Lt.data):Ie("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Ae?ie&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,it,0,0,Lt.width,Lt.height,ce,se,Lt.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,it,ae,Lt.width,Lt.height,0,ce,se,Lt.data)}}}else{if(ke=b.mipmaps,Ae&&ze){ke.length>0&&Ee++;let ge=Ue(j[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,Ee,ae,ge.width,ge.height)}for(let ge=0;ge<6;ge++)if(P){Ae?ie&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,0,0,0,j[ge].width,j[ge].height,ce,se,j[ge].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,0,ae,j[ge].width,j[ge].height,0,ce,se,j[ge].data);for(let it=0;it<ke.length;it++){let Ii=ke[it].image[ge].image;Ae?ie&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,it+1,0,0,Ii.width,Ii.height,ce,se,Ii.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,it+1,ae,Ii.width,Ii.height,0,ce,se,Ii.data)}}else{Ae?ie&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,0,0,0,ce,se,j[ge]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,0,ae,ce,se,j[ge]);for(let it=0;it<ke.length;it++){let Lt=ke[it];Ae?ie&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,it+1,0,0,ce,se,Lt.image[ge]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,it+1,ae,ce,se,Lt.image[ge])}}}w(b)&&b.mipmapsAutoUpdate===!0&&_(i.TEXTURE_CUBE_MAP),oe.__version=Q.version,b.onUpdate&&b.onUpdate(b)}E.__version=b.version}function mt(E,b,z,ne,Q,oe){let ue=s.convert(z.format,z.colorSpace),Z=s.convert(z.type),K=A(z.internalFormat,ue,Z,z.normalized,z.colorSpace),le=n.get(b),P=n.get(z);if(P.__renderTarget=b,!le.__hasExternalTextures){let j=Math.max(1,b.width>>oe),Y=Math.max(1,b.height>>oe);Q===i.TEXTURE_3D||Q===i.TEXTURE_2D_ARRAY?t.texImage3D(Q,oe,K,j,Y,b.depth,0,ue,Z,null):t.texImage2D(Q,oe,K,j,Y,0,ue,Z,null)}t.bindFramebuffer(i.FRAMEBUFFER,E),pe(b)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ne,Q,P.__webglTexture,0,pt(b)):(Q===i.TEXTURE_2D||Q>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&Q<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,ne,Q,P.__webglTexture,oe),t.bindFramebuffer(i.FRAMEBUFFER,null)}function Wn(E,b,z){if(i.bindRenderbuffer(i.RENDERBUFFER,E),b.depthBuffer){let ne=b.depthTexture,Q=ne&&ne.isDepthTexture?ne.type:null,oe=y(b.stencilBuffer,Q),ue=b.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;pe(b)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,pt(b),oe,b.width,b.height):z?i.renderbufferStorageMultisample(i.RENDERBUFFER,pt(b),oe,b.width,b.height):i.renderbufferStorage(i.RENDERBUFFER,oe,b.width,b.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,ue,i.RENDERBUFFER,E)}else{let ne=b.textures;for(let Q=0;Q<ne.length;Q++){let oe=ne[Q],ue=s.convert(oe.format,oe.colorSpace),Z=s.convert(oe.type),K=A(oe.internalFormat,ue,Z,oe.normalized,oe.colorSpace);pe(b)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,pt(b),K,b.width,b.height):z?i.renderbufferStorageMultisample(i.RENDERBUFFER,pt(b),K,b.width,b.height):i.renderbufferStorage(i.RENDERBUFFER,K,b.width,b.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function It(E,b,z){let ne=b.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(i.FRAMEBUFFER,E),!(b.depthTexture&&b.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let Q=n.get(b.depthTexture);Q.__renderTarget=b;let oe=ne?b.depthTexture.image[0]:b.depthTexture.image;(!Q.__webglTexture||oe.width!==b.width||oe.height!==b.height)&&(oe.width=b.width,oe.height=b.height,b.depthTexture.needsUpdate=!0),ne?fe(b.depthTexture,0):re(b.depthTexture,0);let ue=Q.__webglTexture,Z=pt(b),K=ne?i.TEXTURE_CUBE_MAP_POSITIVE_X+z:i.TEXTURE_2D,le=b.depthTexture.format===Ci?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(b.depthTexture.format===Ai)pe(b)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,le,K,ue,0,Z):i.framebufferTexture2D(i.FRAMEBUFFER,le,K,ue,0);else if(b.depthTexture.format===Ci)pe(b)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,le,K,ue,0,Z):i.framebufferTexture2D(i.FRAMEBUFFER,le,K,ue,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function xn(E){let b=n.get(E),z=E.isWebGLCubeRenderTarget===!0;if(b.__boundDepthTexture!==E.depthTexture){let ne=E.depthTexture;if(b.__depthDisposeCallback&&b.__depthDisposeCallback(),ne){let Q=()=>{delete b.__boundDepthTexture,delete b.__depthDisposeCallback,ne.removeEventListener("dispose",Q)};ne.addEventListener("dispose",Q),b.__depthDisposeCallback=Q}b.__boundDepthTexture=ne}if(E.depthTexture&&!b.__autoAllocateDepthBuffer)if(z)for(let ne=0;ne<6;ne++)It(b.__webglFramebuffer[ne],E,ne);else E.texture.mipmaps.length>0?It(b.__webglFramebuffer[0],E,0):It(b.__webglFramebuffer,E,0);else if(z){b.__webglDepthbuffer=[];for(let ne=0;ne<6;ne++)if(t.bindFramebuffer(i.FRAMEBUFFER,b.__webglFramebuffer[ne]),b.__webglDepthbuffer[ne]===void 0)b.__webglDepthbuffer[ne]=i.createRenderbuffer(),Wn(b.__webglDepthbuffer[ne],E,!1);else{let Q=E.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,oe=b.__webglDepthbuffer[ne];i.bindRenderbuffer(i.RENDERBUFFER,oe),i.framebufferRenderbuffer(i.FRAMEBUFFER,Q,i.RENDERBUFFER,oe)}}else if(E.texture.mipmaps.length>0?t.bindFramebuffer(i.FRAMEBUFFER,b.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,b.__webglFramebuffer),b.__webglDepthbuffer===void 0)b.__webglDepthbuffer=i.createRenderbuffer(),Wn(b.__webglDepthbuffer,E,!1);else{let Q=E.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,oe=b.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,oe),i.framebufferRenderbuffer(i.FRAMEBUFFER,Q,i.RENDERBUFFER,oe)}t.bindFramebuffer(i.FRAMEBUFFER,null)}function vn(E,b,z){let ne=n.get(E);b!==void 0&&mt(ne.__webglFramebuffer,E,E.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),z!==void 0&&xn(E)}function bn(E){let b=E.texture,z=n.get(E),ne=n.get(b);E.addEventListener("dispose",U),D(E);let Q=E.textures,oe=E.isWebGLCubeRenderTarget===!0,ue=Q.length>1;if(ue||(ne.__webglTexture===void 0&&(ne.__webglTexture=i.createTexture()),ne.__version=b.version,o.memory.textures++),oe){z.__webglFramebuffer=[];for(let Z=0;Z<6;Z++)if(b.mipmaps.length>0){z.__webglFramebuffer[Z]=[];for(let K=0;K<b.mipmaps.length;K++)z.__webglFramebuffer[Z][K]=i.createFramebuffer()}else z.__webglFramebuffer[Z]=i.createFramebuffer()}else{if(b.mipmaps.length>0){z.__webglFramebuffer=[];for(let Z=0;Z<b.mipmaps.length;Z++)z.__webglFramebuffer[Z]=i.createFramebuffer()}else z.__webglFramebuffer=i.createFramebuffer();if(ue)for(let Z=0,K=Q.length;Z<K;Z++){let le=n.get(Q[Z]);le.__webglTexture===void 0&&(le.__webglTexture=i.createTexture(),o.memory.textures++)}if(E.samples>0&&pe(E)===!1){z.__webglMultisampledFramebuffer=i.createFramebuffer(),z.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,z.__webglMultisampledFramebuffer);for(let Z=0;Z<Q.length;Z++){let K=Q[Z];z.__webglColorRenderbuffer[Z]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,z.__webglColorRenderbuffer[Z]);let le=s.convert(K.format,K.colorSpace),P=s.convert(K.type),j=A(K.internalFormat,le,P,K.normalized,K.colorSpace,E.isXRRenderTarget===!0),Y=pt(E);i.renderbufferStorageMultisample(i.RENDERBUFFER,Y,j,E.width,E.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Z,i.RENDERBUFFER,z.__webglColorRenderbuffer[Z])}i.bindRenderbuffer(i.RENDERBUFFER,null),E.depthBuffer&&(z.__webglDepthRenderbuffer=i.createRenderbuffer(),Wn(z.__webglDepthRenderbuffer,E,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(oe){t.bindTexture(i.TEXTURE_CUBE_MAP,ne.__webglTexture),Ze(i.TEXTURE_CUBE_MAP,b);for(let Z=0;Z<6;Z++)if(b.mipmaps.length>0)for(let K=0;K<b.mipmaps.length;K++)mt(z.__webglFramebuffer[Z][K],E,b,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+Z,K);else mt(z.__webglFramebuffer[Z],E,b,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+Z,0);w(b)?_(i.TEXTURE_CUBE_MAP):b.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,b.mipmaps.length-1),t.unbindTexture()}else if(ue){for(let Z=0,K=Q.length;Z<K;Z++){let le=Q[Z],P=n.get(le),j=i.TEXTURE_2D;(E.isWebGL3DRenderTarget||E.isWebGLArrayRenderTarget)&&(j=E.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(j,P.__webglTexture),Ze(j,le),mt(z.__webglFramebuffer,E,le,i.COLOR_ATTACHMENT0+Z,j,0),w(le)&&_(j)}t.unbindTexture()}else{let Z=i.TEXTURE_2D;if((E.isWebGL3DRenderTarget||E.isWebGLArrayRenderTarget)&&(Z=E.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(Z,ne.__webglTexture),Ze(Z,b),b.mipmaps.length>0)for(let K=0;K<b.mipmaps.length;K++)mt(z.__webglFramebuffer[K],E,b,i.COLOR_ATTACHMENT0,Z,K);else mt(z.__webglFramebuffer,E,b,i.COLOR_ATTACHMENT0,Z,0);w(b)?_(Z):b.mipmaps.length>0&&i.texParameteri(Z,i.TEXTURE_MAX_LEVEL,b.mipmaps.length-1),t.unbindTexture()}E.depthBuffer&&xn(E)}function F(E){let b=E.textures;for(let z=0,ne=b.length;z<ne;z++){let Q=b[z];if(w(Q)&&Q.mipmapsAutoUpdate===!0){let oe=T(E),ue=n.get(Q).__webglTexture;t.bindTexture(oe,ue),_(oe),t.unbindTexture()}}}let _n=[];function ft(E){if(E.samples>0){if(pe(E)===!1){let b=E.textures,z=E.width,ne=E.height,Q=i.COLOR_BUFFER_BIT,oe=E.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ue=n.get(E),Z=b.length>1;if(Z)for(let le=0;le<b.length;le++)t.bindFramebuffer(i.FRAMEBUFFER,ue.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+le,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,ue.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+le,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,ue.__webglMultisampledFramebuffer),E.texture.mipmaps.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ue.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ue.__webglFramebuffer);for(let le=0;le<b.length;le++){if(E.resolveDepthBuffer&&(E.depthBuffer&&(Q|=i.DEPTH_BUFFER_BIT),E.stencilBuffer&&E.resolveStencilBuffer&&(Q|=i.STENCIL_BUFFER_BIT)),Z){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,ue.__webglColorRenderbuffer[le]);let P=n.get(b[le]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,P,0)}i.blitFramebuffer(0,0,z,ne,0,0,z,ne,Q,i.NEAREST),l===!0&&(_n.length=0,_n.push(i.COLOR_ATTACHMENT0+le),E.depthBuffer&&E.storeMultisampledDepthBuffer===!1&&_n.push(oe),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,_n))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),Z)for(let le=0;le<b.length;le++){t.bindFramebuffer(i.FRAMEBUFFER,ue.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+le,i.RENDERBUFFER,ue.__webglColorRenderbuffer[le]);let P=n.get(b[le]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,ue.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+le,i.TEXTURE_2D,P,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ue.__webglMultisampledFramebuffer)}else if(E.depthBuffer&&E.storeMultisampledDepthBuffer===!1&&l){let b=E.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[b])}}}function pt(E){return Math.min(r.maxSamples,E.samples)}function pe(E){let b=n.get(E);return E.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&b.__useRenderToTexture!==!1}function wt(E){let b=o.render.frame;h.get(E)!==b&&(h.set(E,b),E.update())}function Re(E,b){let z=E.colorSpace,ne=E.format,Q=E.type;return E.isCompressedTexture===!0||E.isVideoTexture===!0||z!==ro&&z!==Ri&&(Ye.getTransfer(z)===nt?(ne!==yn||Q!==Qt)&&Ie("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):Ne("WebGLTextures: Unsupported texture color space:",z)),b}function Ue(E){return typeof HTMLImageElement<"u"&&E instanceof HTMLImageElement?(c.width=E.naturalWidth||E.width,c.height=E.naturalHeight||E.height):typeof VideoFrame<"u"&&E instanceof VideoFrame?(c.width=E.displayWidth,c.height=E.displayHeight):(c.width=E.width,c.height=E.height),c}this.allocateTextureUnit=Te,this.resetTextureUnits=J,this.getTextureUnits=te,this.setTextureUnits=ve,this.setTexture2D=re,this.setTexture2DArray=me,this.setTexture3D=Me,this.setTextureCube=fe,this.rebindTextures=vn,this.setupRenderTarget=bn,this.updateRenderTargetMipmap=F,this.updateMultisampleRenderTarget=ft,this.setupDepthRenderbuffer=xn,this.setupFrameBufferTexture=mt,this.useMultisampledRTT=pe,this.dispose=G}function cS(i,e){function t(n,r=Ri){let s,o=Ye.getTransfer(r);if(n===Qt)return i.UNSIGNED_BYTE;if(n===Il)return i.UNSIGNED_SHORT_4_4_4_4;if(n===Ll)return i.UNSIGNED_SHORT_5_5_5_1;if(n===Ru)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===Pu)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===Eu)return i.BYTE;if(n===Cu)return i.SHORT;if(n===Ss)return i.UNSIGNED_SHORT;if(n===Pl)return i.INT;if(n===Hn)return i.UNSIGNED_INT;if(n===gn)return i.FLOAT;if(n===Gn)return i.HALF_FLOAT;if(n===Iu)return i.ALPHA;if(n===Lu)return i.RGB;if(n===yn)return i.RGBA;if(n===Ai)return i.DEPTH_COMPONENT;if(n===Ci)return i.DEPTH_STENCIL;if(n===Eo)return i.RED;if(n===Nl)return i.RED_INTEGER;if(n===tr)return i.RG;if(n===Dl)return i.RG_INTEGER;if(n===Fl)return i.RGBA_INTEGER;if(n===Co||n===Ro||n===Po||n===Io)if(o===nt)if(s=e.get("WEBGL_compressed_texture_s3tc_srgb"),s!==null){if(n===Co)return s.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===Ro)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Po)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===Io)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(s=e.get("WEBGL_compressed_texture_s3tc"),s!==null){if(n===Co)return s.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===Ro)return s.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Po)return s.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===Io)return s.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===Ul||n===Ol||n===kl||n===Bl)if(s=e.get("WEBGL_compressed_texture_pvrtc"),s!==null){if(n===Ul)return s.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===Ol)return s.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===kl)return s.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===Bl)return s.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===zl||n===Vl||n===Hl||n===Gl||n===Wl||n===Lo||n===ql)if(s=e.get("WEBGL_compressed_texture_etc"),s!==null){if(n===zl||n===Vl)return o===nt?s.COMPRESSED_SRGB8_ETC2:s.COMPRESSED_RGB8_ETC2;if(n===Hl)return o===nt?s.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:s.COMPRESSED_RGBA8_ETC2_EAC;if(n===Gl)return s.COMPRESSED_R11_EAC;if(n===Wl)return s.COMPRESSED_SIGNED_R11_EAC;if(n===Lo)return s.COMPRESSED_RG11_EAC;if(n===ql)return s.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===Xl||n===$l||n===Yl||n===Jl||n===Zl||n===Kl||n===jl||n===Ql||n===ec||n===tc||n===nc||n===ic||n===rc||n===sc)if(s=e.get("WEBGL_compressed_texture_astc"),s!==null){if(n===Xl)return o===nt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:s.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===$l)return o===nt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:s.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===Yl)return o===nt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:s.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===Jl)return o===nt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:s.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===Zl)return o===nt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:s.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===Kl)return o===nt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:s.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===jl)return o===nt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:s.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===Ql)return o===nt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:s.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===ec)return o===nt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:s.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===tc)return o===nt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:s.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===nc)return o===nt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:s.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===ic)return o===nt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:s.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===rc)return o===nt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:s.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===sc)return o===nt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:s.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===oc||n===ac||n===lc)if(s=e.get("EXT_texture_compression_bptc"),s!==null){if(n===oc)return o===nt?s.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:s.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===ac)return s.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===lc)return s.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===cc||n===hc||n===No||n===uc)if(s=e.get("EXT_texture_compression_rgtc"),s!==null){if(n===cc)return s.COMPRESSED_RED_RGTC1_EXT;if(n===hc)return s.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===No)return s.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===uc)return s.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===Er?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}var hS=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,uS=`
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

}`,Zu=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new vo(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new $t({vertexShader:hS,fragmentShader:uS,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Xt(new bo(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Ku=class extends si{constructor(e,t){super();let n=this,r=null,s=1,o=null,a="local-floor",l=1,c=null,h=null,d=null,u=null,f=null,p=null,v=typeof XRWebGLBinding<"u",g=new Zu,m={},x=t.getContextAttributes(),w=null,_=null,T=[],A=[],y=new Ge,M=null,D=null,I=new qt;I.viewport=new lt;let L=new qt;L.viewport=new lt;let U=[I,L],q=new Tl,R=null,G=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function($){let re=T[$];return re===void 0&&(re=new fs,T[$]=re),re.getTargetRaySpace()},this.getControllerGrip=function($){let re=T[$];return re===void 0&&(re=new fs,T[$]=re),re.getGripSpace()},this.getHand=function($){let re=T[$];return re===void 0&&(re=new fs,T[$]=re),re.getHandSpace()};function W($){let re=A.indexOf($.inputSource);if(re===-1)return;let me=T[re];me!==void 0&&(me.update($.inputSource,$.frame,c||o),me.dispatchEvent({type:$.type,data:$.inputSource}))}function O(){r.removeEventListener("select",W),r.removeEventListener("selectstart",W),r.removeEventListener("selectend",W),r.removeEventListener("squeeze",W),r.removeEventListener("squeezestart",W),r.removeEventListener("squeezeend",W),r.removeEventListener("end",O),r.removeEventListener("inputsourceschange",ee);for(let $=0;$<T.length;$++){let re=A[$];re!==null&&(A[$]=null,T[$].disconnect(re))}R=null,G=null,g.reset();for(let $ in m)delete m[$];if(e.setRenderTarget(w),f=null,u=null,d=null,r=null,_=null,Te.stop(),n.isPresenting=!1,e.setPixelRatio(M),e.setSize(y.width,y.height,!1),D!==null){let $=D.camera;$.fov=D.fov,$.zoom=D.zoom,$.updateProjectionMatrix(),D=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function($){s=$,n.isPresenting===!0&&Ie("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function($){a=$,n.isPresenting===!0&&Ie("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function($){c=$},this.getBaseLayer=function(){return u!==null?u:f},this.getBinding=function(){return d===null&&v&&(d=new XRWebGLBinding(r,t)),d},this.getFrame=function(){return p},this.getSession=function(){return r},this.setSession=async function($){if(r=$,r!==null){if(w=e.getRenderTarget(),r.addEventListener("select",W),r.addEventListener("selectstart",W),r.addEventListener("selectend",W),r.addEventListener("squeeze",W),r.addEventListener("squeezestart",W),r.addEventListener("squeezeend",W),r.addEventListener("end",O),r.addEventListener("inputsourceschange",ee),x.xrCompatible!==!0&&await t.makeXRCompatible(),M=e.getPixelRatio(),e.getSize(y),v&&"createProjectionLayer"in XRWebGLBinding.prototype){let me=null,Me=null,fe=null;x.depth&&(fe=x.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,me=x.stencil?Ci:Ai,Me=x.stencil?Er:Hn);let Le={colorFormat:t.RGBA8,depthFormat:fe,scaleFactor:s};d=this.getBinding(),u=d.createProjectionLayer(Le),r.updateRenderState({layers:[u]}),e.setPixelRatio(1),e.setSize(u.textureWidth,u.textureHeight,!1),_=new fn(u.textureWidth,u.textureHeight,{format:yn,type:Qt,depthTexture:new Ti(u.textureWidth,u.textureHeight,Me,void 0,void 0,void 0,void 0,void 0,void 0,me),stencilBuffer:x.stencil,colorSpace:e.outputColorSpace,samples:x.antialias?4:0,resolveDepthBuffer:u.ignoreDepthValues===!1,resolveStencilBuffer:u.ignoreDepthValues===!1,storeMultisampledDepthBuffer:u.ignoreDepthValues===!1,storeMultisampledStencilBuffer:u.ignoreDepthValues===!1})}else{let me={antialias:x.antialias,alpha:!0,depth:x.depth,stencil:x.stencil,framebufferScaleFactor:s};f=new XRWebGLLayer(r,t,me),r.updateRenderState({baseLayer:f}),e.setPixelRatio(1),e.setSize(f.framebufferWidth,f.framebufferHeight,!1),_=new fn(f.framebufferWidth,f.framebufferHeight,{format:yn,type:Qt,colorSpace:e.outputColorSpace,stencilBuffer:x.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}_.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await r.requestReferenceSpace(a),Te.setContext(r),Te.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(r!==null)return r.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function ee($){for(let re=0;re<$.removed.length;re++){let me=$.removed[re],Me=A.indexOf(me);Me>=0&&(A[Me]=null,T[Me].disconnect(me))}for(let re=0;re<$.added.length;re++){let me=$.added[re],Me=A.indexOf(me);if(Me===-1){for(let Le=0;Le<T.length;Le++)if(Le>=A.length){A.push(me),Me=Le;break}else if(A[Le]===null){A[Le]=me,Me=Le;break}if(Me===-1)break}let fe=T[Me];fe&&fe.connect(me)}}function H($,re){re===null?$.matrixWorld.copy($.matrix):$.matrixWorld.multiplyMatrices(re.matrixWorld,$.matrix),$.matrixWorldInverse.copy($.matrixWorld).invert()}this.updateCamera=function($){if(r===null)return;let re=$.near,me=$.far;g.texture!==null&&(g.depthNear>0&&(re=g.depthNear),g.depthFar>0&&(me=g.depthFar)),q.near=L.near=I.near=re,q.far=L.far=I.far=me,(R!==q.near||G!==q.far)&&(r.updateRenderState({depthNear:q.near,depthFar:q.far}),R=q.near,G=q.far),q.layers.mask=$.layers.mask|6,I.layers.mask=q.layers.mask&-5,L.layers.mask=q.layers.mask&-3;let Me=$.parent,fe=q.cameras;H(q,Me);for(let Le=0;Le<fe.length;Le++)H(fe[Le],Me);q.projectionMatrix.copy(I.projectionMatrix),q.projectionMatrixInverse.copy(I.projectionMatrixInverse),D===null&&$.isPerspectiveCamera&&(D={camera:$,fov:$.fov,zoom:$.zoom}),J($,q,Me)};function J($,re,me){me===null?$.matrix.copy(re.matrixWorld):($.matrix.copy(me.matrixWorld),$.matrix.invert(),$.matrix.multiply(re.matrixWorld)),$.matrix.decompose($.position,$.quaternion,$.scale),$.updateMatrixWorld(!0),$.projectionMatrix.copy(re.projectionMatrix),$.projectionMatrixInverse.copy(re.projectionMatrixInverse),$.isPerspectiveCamera&&($.fov=sl*2*Math.atan(1/$.projectionMatrix.elements[5]),$.zoom=1)}this.getCamera=function(){return q},this.getFoveation=function(){if(!(u===null&&f===null))return l},this.setFoveation=function($){l=$,u!==null&&(u.fixedFoveation=$),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=$)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(q)},this.getCameraTexture=function($){return m[$]};let te=null;function ve($,re){if(h=re.getViewerPose(c||o),p=re,h!==null){let me=h.views;f!==null&&(e.setRenderTargetFramebuffer(_,f.framebuffer),e.setRenderTarget(_));let Me=!1;me.length!==q.cameras.length&&(q.cameras.length=0,Me=!0);for(let Ce=0;Ce<me.length;Ce++){let Ze=me[Ce],Qe=null;if(f!==null)Qe=f.getViewport(Ze);else{let Ut=d.getViewSubImage(u,Ze);Qe=Ut.viewport,Ce===0&&(e.setRenderTargetTextures(_,Ut.colorTexture,Ut.depthStencilTexture),e.setRenderTarget(_))}let We=U[Ce];We===void 0&&(We=new qt,We.layers.enable(Ce),We.viewport=new lt,U[Ce]=We),We.matrix.fromArray(Ze.transform.matrix),We.matrix.decompose(We.position,We.quaternion,We.scale),We.projectionMatrix.fromArray(Ze.projectionMatrix),We.projectionMatrixInverse.copy(We.projectionMatrix).invert(),We.viewport.set(Qe.x,Qe.y,Qe.width,Qe.height),Ce===0&&(q.matrix.copy(We.matrix),q.matrix.decompose(q.position,q.quaternion,q.scale)),Me===!0&&q.cameras.push(We)}let fe=r.enabledFeatures;if(fe&&fe.includes("depth-sensing")&&r.depthUsage=="gpu-optimized"&&v){d=n.getBinding();let Ce=d.getDepthInformation(me[0]);Ce&&Ce.isValid&&Ce.texture&&g.init(Ce,r.renderState)}if(fe&&fe.includes("camera-access")&&v){e.state.unbindTexture(),d=n.getBinding();for(let Ce=0;Ce<me.length;Ce++){let Ze=me[Ce].camera;if(Ze){let Qe=m[Ze];Qe||(Qe=new vo,m[Ze]=Qe);let We=d.getCameraImage(Ze);Qe.sourceTexture=We}}}}for(let me=0;me<T.length;me++){let Me=A[me],fe=T[me];Me!==null&&fe!==void 0&&fe.update(Me,re,c||o)}te&&te($,re),re.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:re}),p=null}let Te=new Hm;Te.setAnimationLoop(ve),this.setAnimationLoop=function($){te=$},this.dispose=function(){}}},dS=new ut,jm=new Fe;jm.set(-1,0,0,0,1,0,0,0,1);function fS(i,e){function t(g,m){g.matrixAutoUpdate===!0&&g.updateMatrix(),m.value.copy(g.matrix)}function n(g,m){m.color.getRGB(g.fogColor.value,ku(i)),m.isFog?(g.fogNear.value=m.near,g.fogFar.value=m.far):m.isFogExp2&&(g.fogDensity.value=m.density)}function r(g,m,x,w,_){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?s(g,m):m.isMeshLambertMaterial?(s(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(s(g,m),d(g,m)):m.isMeshPhongMaterial?(s(g,m),h(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(s(g,m),u(g,m),m.isMeshPhysicalMaterial&&f(g,m,_)):m.isMeshMatcapMaterial?(s(g,m),p(g,m)):m.isMeshDepthMaterial?s(g,m):m.isMeshDistanceMaterial?(s(g,m),v(g,m)):m.isMeshNormalMaterial?s(g,m):m.isLineBasicMaterial?(o(g,m),m.isLineDashedMaterial&&a(g,m)):m.isPointsMaterial?l(g,m,x,w):m.isSpriteMaterial?c(g,m):m.isShadowMaterial?(g.color.value.copy(m.color),g.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function s(g,m){g.opacity.value=m.opacity,m.color&&g.diffuse.value.copy(m.color),m.emissive&&g.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(g.map.value=m.map,t(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,t(m.alphaMap,g.alphaMapTransform)),m.bumpMap&&(g.bumpMap.value=m.bumpMap,t(m.bumpMap,g.bumpMapTransform),g.bumpScale.value=m.bumpScale,m.side===jt&&(g.bumpScale.value*=-1)),m.normalMap&&(g.normalMap.value=m.normalMap,t(m.normalMap,g.normalMapTransform),g.normalScale.value.copy(m.normalScale),m.side===jt&&g.normalScale.value.negate()),m.displacementMap&&(g.displacementMap.value=m.displacementMap,t(m.displacementMap,g.displacementMapTransform),g.displacementScale.value=m.displacementScale,g.displacementBias.value=m.displacementBias),m.emissiveMap&&(g.emissiveMap.value=m.emissiveMap,t(m.emissiveMap,g.emissiveMapTransform)),m.specularMap&&(g.specularMap.value=m.specularMap,t(m.specularMap,g.specularMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest);let x=e.get(m),w=x.envMap,_=x.envMapRotation;w&&(g.envMap.value=w,g.envMapRotation.value.setFromMatrix4(dS.makeRotationFromEuler(_)).transpose(),w.isCubeTexture&&w.isRenderTargetTexture===!1&&g.envMapRotation.value.premultiply(jm),g.reflectivity.value=m.reflectivity,g.ior.value=m.ior,g.refractionRatio.value=m.refractionRatio),m.lightMap&&(g.lightMap.value=m.lightMap,g.lightMapIntensity.value=m.lightMapIntensity,t(m.lightMap,g.lightMapTransform)),m.aoMap&&(g.aoMap.value=m.aoMap,g.aoMapIntensity.value=m.aoMapIntensity,t(m.aoMap,g.aoMapTransform))}function o(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,m.map&&(g.map.value=m.map,t(m.map,g.mapTransform))}function a(g,m){g.dashSize.value=m.dashSize,g.totalSize.value=m.dashSize+m.gapSize,g.scale.value=m.scale}function l(g,m,x,w){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.size.value=m.size*x,g.scale.value=w*.5,m.map&&(g.map.value=m.map,t(m.map,g.uvTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,t(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}function c(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.rotation.value=m.rotation,m.map&&(g.map.value=m.map,t(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,t(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}function h(g,m){g.specular.value.copy(m.specular),g.shininess.value=Math.max(m.shininess,1e-4)}function d(g,m){m.gradientMap&&(g.gradientMap.value=m.gradientMap)}function u(g,m){g.metalness.value=m.metalness,m.metalnessMap&&(g.metalnessMap.value=m.metalnessMap,t(m.metalnessMap,g.metalnessMapTransform)),g.roughness.value=m.roughness,m.roughnessMap&&(g.roughnessMap.value=m.roughnessMap,t(m.roughnessMap,g.roughnessMapTransform)),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)}function f(g,m,x){g.ior.value=m.ior,m.diffuseRoughness>0&&(g.diffuseRoughness.value=m.diffuseRoughness,m.diffuseRoughnessMap&&(g.diffuseRoughnessMap.value=m.diffuseRoughnessMap,t(m.diffuseRoughnessMap,g.diffuseRoughnessMapTransform))),m.sheen>0&&(g.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),g.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(g.sheenColorMap.value=m.sheenColorMap,t(m.sheenColorMap,g.sheenColorMapTransform)),m.sheenRoughnessMap&&(g.sheenRoughnessMap.value=m.sheenRoughnessMap,t(m.sheenRoughnessMap,g.sheenRoughnessMapTransform))),m.clearcoat>0&&(g.clearcoat.value=m.clearcoat,g.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(g.clearcoatMap.value=m.clearcoatMap,t(m.clearcoatMap,g.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,t(m.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(g.clearcoatNormalMap.value=m.clearcoatNormalMap,t(m.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===jt&&g.clearcoatNormalScale.value.negate())),m.dispersion>0&&(g.dispersion.value=m.dispersion),m.retroreflectivity>0&&(g.retroreflectivity.value=m.retroreflectivity),m.iridescence>0&&(g.iridescence.value=m.iridescence,g.iridescenceIOR.value=m.iridescenceIOR,g.iridescenceThicknessMinimum.value=m.iridescenceThicknessMinimum,g.iridescenceThicknessMaximum.value=m.iridescenceThicknessMaximum,m.iridescenceMap&&(g.iridescenceMap.value=m.iridescenceMap,t(m.iridescenceMap,g.iridescenceMapTransform)),m.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=m.iridescenceThicknessMap,t(m.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),m.transmission>0&&(g.transmission.value=m.transmission,g.transmissionSamplerMap.value=x.texture,g.transmissionSamplerSize.value.set(x.width,x.height),m.transmissionMap&&(g.transmissionMap.value=m.transmissionMap,t(m.transmissionMap,g.transmissionMapTransform)),g.thickness.value=m.thickness,m.thicknessMap&&(g.thicknessMap.value=m.thicknessMap,t(m.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=m.attenuationDistance,g.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(g.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(g.anisotropyMap.value=m.anisotropyMap,t(m.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=m.specularIntensity,g.specularColor.value.copy(m.specularColor),m.specularColorMap&&(g.specularColorMap.value=m.specularColorMap,t(m.specularColorMap,g.specularColorMapTransform)),m.specularIntensityMap&&(g.specularIntensityMap.value=m.specularIntensityMap,t(m.specularIntensityMap,g.specularIntensityMapTransform))}function p(g,m){m.matcap&&(g.matcap.value=m.matcap)}function v(g,m){let x=e.get(m).light;g.referencePosition.value.setFromMatrixPosition(x.matrixWorld),g.nearDistance.value=x.shadow.camera.near,g.farDistance.value=x.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:r}}function pS(i,e,t,n){let r={},s={};function o(x,w){let _=w.program;n.uniformBlockBinding(x,_,r[x.id])}function a(x,w){let _=r[x.id];_===void 0&&(p(x),_=l(x),r[x.id]=_,x.addEventListener("dispose",g));let T=w.program;n.updateUBOMapping(x,T);let A=e.render.frame;s[x.id]!==A&&(c(x),s[x.id]=A)}function l(x){let w=i.createBuffer(),_=x.__size,T=x.usage;return i.bindBuffer(i.UNIFORM_BUFFER,w),i.bufferData(i.UNIFORM_BUFFER,_,T),i.bindBuffer(i.UNIFORM_BUFFER,null),w}function c(x){let w=r[x.id],_=x.uniforms,T=x.__cache;i.bindBuffer(i.UNIFORM_BUFFER,w);for(let A=0,y=_.length;A<y;A++){let M=_[A];if(Array.isArray(M))for(let D=0,I=M.length;D<I;D++)h(M[D],A,D,T);else h(M,A,0,T)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function h(x,w,_,T){if(u(x,w,_,T)===!0){let A=x.__offset,y=x.value;if(Array.isArray(y)){let M=0;for(let D=0;D<y.length;D++){let I=y[D],L=v(I,!0);d(I,x.__data,M),M+=L.storage/Float32Array.BYTES_PER_ELEMENT}}else d(y,x.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,A,x.__data)}}function d(x,w,_){typeof x=="number"||typeof x=="boolean"?w[_]=x:x.isMatrix3?(w[_]=x.elements[0],w[_+1]=x.elements[1],w[_+2]=x.elements[2],w[_+3]=0,w[_+4]=x.elements[3],w[_+5]=x.elements[4],w[_+6]=x.elements[5],w[_+7]=0,w[_+8]=x.elements[6],w[_+9]=x.elements[7],w[_+10]=x.elements[8],w[_+11]=0):ArrayBuffer.isView(x)?w.set(x.subarray(0,w.length-_),_):x.toArray(w,_)}function u(x,w,_,T){let A=x.value,y=w+"_"+_;if(Array.isArray(A)){T[y]===void 0&&(T[y]=[]);let M=T[y],D=!1;for(let I=0;I<A.length;I++)f(A[I],M,I)===!0&&(D=!0);return D}return f(A,T,y)}function f(x,w,_){if(w[_]===void 0)return typeof x=="number"||typeof x=="boolean"?w[_]=x:ArrayBuffer.isView(x)?w[_]=x.slice():w[_]=x.clone(),!0;{let T=w[_];if(typeof x=="number"||typeof x=="boolean"){if(T!==x)return w[_]=x,!0}else{if(ArrayBuffer.isView(x))return!0;if(T.equals(x)===!1)return T.copy(x),!0}}return!1}function p(x){let w=x.uniforms,_=0,T=16;for(let y=0,M=w.length;y<M;y++){let D=Array.isArray(w[y])?w[y]:[w[y]];for(let I=0,L=D.length;I<L;I++){let U=D[I],q=Array.isArray(U.value)?U.value:[U.value],R=Array.isArray(w[y])||Array.isArray(U.value),G=_;for(let O=0,ee=q.length;O<ee;O++){let H=q[O],J=v(H,R),te=_%T,ve=te%J.boundary,Te=te+ve;_+=ve,Te!==0&&T-Te<J.storage&&(_+=T-Te),O===0&&(G=_),_+=J.storage}let W=U.type==="int"?Int32Array:U.type==="uint"?Uint32Array:Float32Array;U.__data=new W((_-G)/Float32Array.BYTES_PER_ELEMENT),U.__offset=G}}let A=_%T;return A>0&&(_+=T-A),x.__size=_,x.__cache={},this}function v(x,w){let _={boundary:0,storage:0};return typeof x=="number"||typeof x=="boolean"?(_.boundary=4,_.storage=4):x.isVector2?(_.boundary=8,_.storage=8):x.isVector3||x.isColor?(_.boundary=16,_.storage=12):x.isVector4?(_.boundary=16,_.storage=16):x.isMatrix3?(_.boundary=16,_.storage=48):x.isMatrix4?(_.boundary=16,_.storage=64):x.isTexture?Ie("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(x)?(_.boundary=16,_.storage=x.byteLength):Ie("WebGLRenderer: Unsupported uniform value type.",x),w===!0&&(_.boundary=16,_.storage=Math.ceil(_.storage/16)*16),_}function g(x){let w=x.target;w.removeEventListener("dispose",g),i.deleteBuffer(r[w.id]),delete r[w.id],delete s[w.id]}function m(){for(let x in r)i.deleteBuffer(r[x]);r={},s={}}return{bind:o,update:a,dispose:m}}var mS=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),li=null;function gS(){return li===null&&(li=new Sr(mS,16,16,tr,Gn),li.name="DFG_LUT",li.minFilter=Ft,li.magFilter=Ft,li.wrapS=ri,li.wrapT=ri,li.generateMipmaps=!1,li.needsUpdate=!0),li}var gc=class{constructor(e={}){let{canvas:t=hm(),context:n=null,depth:r=!0,stencil:s=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:d=!1,reversedDepthBuffer:u=!1,outputBufferType:f=Qt}=e;this.isWebGLRenderer=!0;let p;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=n.getContextAttributes().alpha}else p=o;let v=f,g=new Set([Fl,Dl,Nl]),m=new Set([Qt,Hn,Ss,Er,Il,Ll]),x=new Uint32Array(4),w=new Int32Array(4),_={textures:[],min:[],max:[],resolution:[]},T=null,A=null,y=[],M=[],D=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=ai,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let I=this,L=!1,U=null,q=null,R=null,G=null;this._outputColorSpace=dn;let W=0,O=0,ee=null,H=-1,J=null,te=new lt,ve=new lt,Te=null,$=new Ve(0),re=0,me=t.width,Me=t.height,fe=1,Le=null,dt=null,Ce=new lt(0,0,me,Me),Ze=new lt(0,0,me,Me),Qe=!1,We=new Mr,Ut=new ul,Mt=!1,en=!1,mt=new ut,Wn=new B,It=new lt,xn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},vn=!1;function bn(){return ee===null?fe:1}let F=n;function _n(S,N){return t.getContext(S,N)}let ft,pt,pe,wt,Re,Ue,E,b,z,ne,Q,oe,ue,Z,K,le,P,j,Y,ce,se,ae,Ae;try{let S={alpha:!0,depth:r,stencil:s,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:d};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",Ee,!1),t.addEventListener("webglcontextrestored",ke,!1),t.addEventListener("webglcontextcreationerror",ge,!1),F===null){let N="webgl2";if(F=_n(N,S),F===null)throw _n(N)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}ze()}catch(S){throw t.removeEventListener("webglcontextlost",Ee,!1),t.removeEventListener("webglcontextrestored",ke,!1),t.removeEventListener("webglcontextcreationerror",ge,!1),Ne("WebGLRenderer: "+S.message),S}function ze(){ft=new Eb(F),ft.init(),se=new cS(F,ft),pt=new gb(F,ft,e,se),pe=new aS(F,ft),pt.reversedDepthBuffer&&u&&pe.buffers.depth.setReversed(!0),q=F.createFramebuffer(),R=F.createFramebuffer(),G=F.createFramebuffer(),wt=new Pb(F),Re=new $_,Ue=new lS(F,ft,pe,Re,pt,se,wt),E=new Tb(I),b=new Ly(F),ae=new pb(F,b),z=new Cb(F,b,wt,ae),ne=new Lb(F,z,b,ae,wt),j=new Ib(F,pt,Ue),K=new yb(Re),Q=new X_(I,E,ft,pt,ae,K),oe=new fS(I,Re),ue=new J_,Z=new tS(ft),P=new fb(I,E,pe,ne,p,l),le=new oS(I,ne,pt),Ae=new pS(F,wt,pt,pe),Y=new mb(F,ft,wt),ce=new Rb(F,ft,wt),wt.programs=Q.programs,I.capabilities=pt,I.extensions=ft,I.properties=Re,I.renderLists=ue,I.shadowMap=le,I.state=pe,I.info=wt}v!==Qt&&(D=new Db(v,t.width,t.height,a,r,s));let ie=new Ku(I,F);this.xr=ie,this.getContext=function(){return F},this.getContextAttributes=function(){return F.getContextAttributes()},this.forceContextLoss=function(){let S=ft.get("WEBGL_lose_context");S&&S.loseContext()},this.forceContextRestore=function(){let S=ft.get("WEBGL_lose_context");S&&S.restoreContext()},this.getPixelRatio=function(){return fe},this.setPixelRatio=function(S){S!==void 0&&(fe=S,this.setSize(me,Me,!1))},this.getSize=function(S){return S.set(me,Me)},this.setSize=function(S,N,X=!0){if(ie.isPresenting){Ie("WebGLRenderer: Can't change size while VR device is presenting.");return}me=S,Me=N,t.width=Math.floor(S*fe),t.height=Math.floor(N*fe),X===!0&&(t.style.width=S+"px",t.style.height=N+"px"),D!==null&&D.setSize(t.width,t.height),this.setViewport(0,0,S,N)},this.getDrawingBufferSize=function(S){return S.set(me*fe,Me*fe).floor()},this.setDrawingBufferSize=function(S,N,X){me=S,Me=N,fe=X,t.width=Math.floor(S*X),t.height=Math.floor(N*X),this.setViewport(0,0,S,N)},this.setEffects=function(S){if(v===Qt){Ne("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(S){for(let N=0;N<S.length;N++)if(S[N].isOutputPass===!0){Ie("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}D.setEffects(S||[])},this.getCurrentViewport=function(S){return S.copy(te)},this.getViewport=function(S){return S.copy(Ce)},this.setViewport=function(S,N,X,k){S.isVector4?Ce.set(S.x,S.y,S.z,S.w):Ce.set(S,N,X,k),pe.viewport(te.copy(Ce).multiplyScalar(bn()).round())},this.getScissor=function(S){return S.copy(Ze)},this.setScissor=function(S,N,X,k){S.isVector4?Ze.set(S.x,S.y,S.z,S.w):Ze.set(S,N,X,k),pe.scissor(ve.copy(Ze).multiplyScalar(bn()).round())},this.getScissorTest=function(){return Qe},this.setScissorTest=function(S){pe.setScissorTest(Qe=S)},this.setOpaqueSort=function(S){Le=S},this.setTransparentSort=function(S){dt=S},this.getClearColor=function(S){return S.copy(P.getClearColor())},this.setClearColor=function(){P.setClearColor(...arguments)},this.getClearAlpha=function(){return P.getClearAlpha()},this.setClearAlpha=function(){P.setClearAlpha(...arguments)},this.clear=function(S=!0,N=!0,X=!0){let k=0;if(S){let V=!1;if(ee!==null){let de=ee.texture.format;V=g.has(de)}if(V){let de=ee.texture.type,be=m.has(de),he=P.getClearColor(),xe=P.getClearAlpha(),we=he.r,Oe=he.g,qe=he.b;be?(x[0]=we,x[1]=Oe,x[2]=qe,x[3]=xe,F.clearBufferuiv(F.COLOR,0,x)):(w[0]=we,w[1]=Oe,w[2]=qe,w[3]=xe,F.clearBufferiv(F.COLOR,0,w))}else k|=F.COLOR_BUFFER_BIT}N&&(k|=F.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),X&&(k|=F.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),k!==0&&F.clear(k)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(S){S.setRenderer(this),U=S},this.dispose=function(){t.removeEventListener("webglcontextlost",Ee,!1),t.removeEventListener("webglcontextrestored",ke,!1),t.removeEventListener("webglcontextcreationerror",ge,!1),P.dispose(),ue.dispose(),Z.dispose(),Ue.dispose(),Re.dispose(),E.dispose(),ne.dispose(),z.dispose(),ae.dispose(),Ae.dispose(),Q.dispose(),ie.dispose(),ie.removeEventListener("sessionstart",dd),ie.removeEventListener("sessionend",fd),sr.stop()};function Ee(S){S.preventDefault(),lo("WebGLRenderer: Context Lost."),L=!0}function ke(){lo("WebGLRenderer: Context Restored."),L=!1;let S=wt.autoReset,N=le.enabled,X=le.autoUpdate,k=le.needsUpdate,V=le.type;ze(),wt.autoReset=S,le.enabled=N,le.autoUpdate=X,le.needsUpdate=k,le.type=V}function ge(S){Ne("WebGLRenderer: A WebGL context could not be created. Reason: ",S.statusMessage)}function it(S){let N=S.target;N.removeEventListener("dispose",it),Lt(N)}function Lt(S){Ii(S),Re.remove(S)}function Ii(S){let N=Re.get(S).programs;N!==void 0&&(N.forEach(function(X){Q.releaseProgram(X)}),S.isShaderMaterial&&Q.releaseShaderCache(S))}this.renderBufferDirect=function(S,N,X,k,V,de){N===null&&(N=xn);let be=V.isMesh&&V.matrixWorld.determinantAffine()<0,he=zg(S,N,X,k,V);pe.setMaterial(k,be);let xe=X.index,we=1;if(k.wireframe===!0){if(xe=z.getWireframeAttribute(X),xe===void 0)return;we=2}let Oe=X.drawRange,qe=X.attributes.position,_e=Oe.start*we,Xe=(Oe.start+Oe.count)*we;de!==null&&(_e=Math.max(_e,de.start*we),Xe=Math.min(Xe,(de.start+de.count)*we)),xe!==null?(_e=Math.max(_e,0),Xe=Math.min(Xe,xe.count)):qe!=null&&(_e=Math.max(_e,0),Xe=Math.min(Xe,qe.count));let xt=Xe-_e;if(xt<0||xt===1/0)return;ae.setup(V,k,he,X,xe);let ct,ot=Y;if(xe!==null&&(ct=b.get(xe),ot=ce,ot.setIndex(ct)),V.isMesh)k.wireframe===!0?(pe.setLineWidth(k.wireframeLinewidth*bn()),ot.setMode(F.LINES)):ot.setMode(F.TRIANGLES);else if(V.isLine){let zt=k.linewidth;zt===void 0&&(zt=1),pe.setLineWidth(zt*bn()),V.isLineSegments?ot.setMode(F.LINES):V.isLineLoop?ot.setMode(F.LINE_LOOP):ot.setMode(F.LINE_STRIP)}else V.isPoints?ot.setMode(F.POINTS):V.isSprite&&ot.setMode(F.TRIANGLES);if(V.isBatchedMesh)if(ft.get("WEBGL_multi_draw"))ot.renderMultiDraw(V._multiDrawStarts,V._multiDrawCounts,V._multiDrawCount);else{let zt=V._multiDrawStarts,Se=V._multiDrawCounts,Jt=V._multiDrawCount,et=xe?b.get(xe).bytesPerElement:1,or=Re.get(k).currentProgram.getUniforms();for(let Vt=0;Vt<Jt;Vt++)or.setValue(F,"_gl_DrawID",Vt),ot.render(zt[Vt]/et,Se[Vt])}else if(V.isInstancedMesh)ot.renderInstances(_e,xt,V.count);else if(X.isInstancedBufferGeometry){let zt=X._maxInstanceCount!==void 0?X._maxInstanceCount:1/0,Se=Math.min(X.instanceCount,zt);ot.renderInstances(_e,xt,Se)}else ot.render(_e,xt)};function ud(S,N,X,k){U!==null&&S.isNodeMaterial&&U.setObject(k,S),Mt===!0&&K.setState(S,X,!1),S.transparent===!0&&S.side===Rn&&S.forceSinglePass===!1?(S.side=jt,S.needsUpdate=!0,Cs(S,N,k),S.side=er,S.needsUpdate=!0,Cs(S,N,k),S.side=Rn):Cs(S,N,k)}this.compile=function(S,N,X=null){X===null&&(X=S),U!==null&&U.renderStart(S,N,X),A=Z.get(X),A.init(N),M.push(A),X.traverseVisible(function(V){V.isLight&&V.layers.test(N.layers)&&(A.pushLight(V),V.castShadow&&A.pushShadow(V))}),S!==X&&S.traverseVisible(function(V){V.isLight&&V.layers.test(N.layers)&&(A.pushLight(V),V.castShadow&&A.pushShadow(V))}),A.setupLights(),U!==null&&U.updateLights(A.state.lightsArray),en=this.localClippingEnabled,Mt=K.init(this.clippingPlanes,en),Mt===!0&&K.setGlobalState(this.clippingPlanes,N),U!==null&&le.render(A.state.shadowsArray,X,N);let k=new Set;return S.traverse(function(V){if(!(V.isMesh||V.isPoints||V.isLine||V.isSprite))return;let de=V.material;if(de)if(Array.isArray(de))for(let be=0;be<de.length;be++){let he=de[be];ud(he,X,N,V),k.add(he)}else ud(de,X,N,V),k.add(de)}),A=M.pop(),U!==null&&U.renderEnd(),k},this.compileAsync=function(S,N,X=null){let k=this.compile(S,N,X);return new Promise(V=>{function de(){if(k.forEach(function(be){let xe=Re.get(be).currentProgram;(xe===void 0||xe.isReady())&&k.delete(be)}),k.size===0){V(S);return}setTimeout(de,10)}ft.get("KHR_parallel_shader_compile")!==null?de():setTimeout(de,10)})};let Xc=null;function kg(S){Xc&&Xc(S)}function dd(){sr.stop()}function fd(){sr.start()}let sr=new Hm;sr.setAnimationLoop(kg),typeof self<"u"&&sr.setContext(self),this.setAnimationLoop=function(S){Xc=S,ie.setAnimationLoop(S),S===null?sr.stop():sr.start()},ie.addEventListener("sessionstart",dd),ie.addEventListener("sessionend",fd),this.render=function(S,N){if(N!==void 0&&N.isCamera!==!0){Ne("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(L===!0)return;U!==null&&U.renderStart(S,N);let X=ie.enabled===!0&&ie.isPresenting===!0,k=D!==null&&(ee===null||X)&&D.begin(I,ee);if(S.matrixWorldAutoUpdate===!0&&S.updateMatrixWorld(),N.parent===null&&N.matrixWorldAutoUpdate===!0&&N.updateMatrixWorld(),ie.enabled===!0&&ie.isPresenting===!0&&(D===null||D.isCompositing()===!1)&&(ie.cameraAutoUpdate===!0&&ie.updateCamera(N),N=ie.getCamera()),S.isScene===!0&&S.onBeforeRender(I,S,N,ee),A=Z.get(S,M.length),A.init(N),A.state.textureUnits=Ue.getTextureUnits(),M.push(A),mt.multiplyMatrices(N.projectionMatrix,N.matrixWorldInverse),N.isArrayCamera?Ut.setFromArrayCamera(N):We.setFromProjectionMatrix(mt,En,N.reversedDepth),en=this.localClippingEnabled,Mt=K.init(this.clippingPlanes,en),T=ue.get(S,y.length),T.init(),y.push(T),this.info.render.frame++,ie.enabled===!0&&ie.isPresenting===!0){let be=I.xr.getDepthSensingMesh();be!==null&&$c(be,N,-1/0,I.sortObjects)}$c(S,N,0,I.sortObjects),T.finish(),U!==null&&U.updateLights(A.state.lightsArray),I.sortObjects===!0&&T.sort(Le,dt),vn=ie.enabled===!1||ie.isPresenting===!1||ie.hasDepthSensing()===!1,vn&&P.addToRenderList(T,S),this.info.autoReset===!0&&this.info.reset(),Mt===!0&&K.beginShadows();let V=A.state.shadowsArray;if(le.render(V,S,N),Mt===!0&&K.endShadows(),(k&&D.hasRenderPass())===!1){let be=T.opaque,he=T.transmissive;if(A.setupLights(),N.isArrayCamera){let xe=N.cameras;if(he.length>0)for(let we=0,Oe=xe.length;we<Oe;we++){let qe=xe[we];md(be,he,S,qe)}vn&&P.render(S);for(let we=0,Oe=xe.length;we<Oe;we++){let qe=xe[we];pd(T,S,qe,qe.viewport)}}else he.length>0&&md(be,he,S,N),vn&&P.render(S),pd(T,S,N)}ee!==null&&O===0&&(Ue.updateMultisampleRenderTarget(ee),Ue.updateRenderTargetMipmap(ee)),k&&D.end(I),S.isScene===!0&&S.onAfterRender(I,S,N),ae.resetDefaultState(),H=-1,J=null,M.pop(),M.length>0?(A=M[M.length-1],Ue.setTextureUnits(A.state.textureUnits),Mt===!0&&K.setGlobalState(I.clippingPlanes,A.state.camera)):A=null,y.pop(),y.length>0?T=y[y.length-1]:T=null,U!==null&&U.renderEnd()};function $c(S,N,X,k){if(S.visible===!1)return;if(S.layers.test(N.layers)){if(S.isGroup)X=S.renderOrder;else if(S.isLOD)S.autoUpdate===!0&&S.update(N);else if(S.isLight)A.pushLight(S),S.castShadow&&A.pushShadow(S);else if(S.isSprite){let be=N.isArrayCamera?Ut:We;if(!S.frustumCulled||S.intersectsFrustum(be)){k&&It.setFromMatrixPosition(S.matrixWorld).applyMatrix4(mt);let he=ne.update(S),xe=S.material;xe.visible&&T.push(S,he,xe,X,It.z,null,N)}}else if(S.isMesh||S.isLine||S.isPoints){let be=N.isArrayCamera?Ut:We;if(!S.frustumCulled||S.intersectsFrustum(be)){let he=ne.update(S),xe=S.material;if(k&&(S.boundingSphere!==void 0?(S.boundingSphere===null&&S.computeBoundingSphere(),It.copy(S.boundingSphere.center)):(he.boundingSphere===null&&he.computeBoundingSphere(),It.copy(he.boundingSphere.center)),It.applyMatrix4(S.matrixWorld).applyMatrix4(mt)),Array.isArray(xe)){let we=he.groups;for(let Oe=0,qe=we.length;Oe<qe;Oe++){let _e=we[Oe],Xe=xe[_e.materialIndex];Xe&&Xe.visible&&T.push(S,he,Xe,X,It.z,_e,N)}}else xe.visible&&T.push(S,he,xe,X,It.z,null,N)}}}let de=S.children;for(let be=0,he=de.length;be<he;be++)$c(de[be],N,X,k)}function pd(S,N,X,k){let{opaque:V,transmissive:de,transparent:be}=S;A.setupLightsView(X),Mt===!0&&K.setGlobalState(I.clippingPlanes,X),k&&pe.viewport(te.copy(k)),V.length>0&&qo(V,N,X),de.length>0&&qo(de,N,X),be.length>0&&qo(be,N,X),pe.buffers.depth.setTest(!0),pe.buffers.depth.setMask(!0),pe.buffers.color.setMask(!0),pe.setPolygonOffset(!1)}function md(S,N,X,k){if((X.isScene===!0?X.overrideMaterial:null)!==null)return;if(A.state.transmissionRenderTarget[k.id]===void 0){let _e=ft.has("EXT_color_buffer_half_float")||ft.has("EXT_color_buffer_float");A.state.transmissionRenderTarget[k.id]=new fn(1,1,{generateMipmaps:!0,type:_e?Gn:Qt,minFilter:Ei,samples:Math.max(4,pt.samples),stencilBuffer:s,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:Ye.workingColorSpace})}let de=A.state.transmissionRenderTarget[k.id],be=k.viewport||te;de.setSize(be.z*I.transmissionResolutionScale,be.w*I.transmissionResolutionScale);let he=I.getRenderTarget(),xe=I.getActiveCubeFace(),we=I.getActiveMipmapLevel();I.setRenderTarget(de),I.getClearColor($),re=I.getClearAlpha(),re<1&&I.setClearColor(16777215,.5),I.clear(),vn&&P.render(X);let Oe=I.toneMapping;I.toneMapping=ai;let qe=k.viewport;if(k.viewport!==void 0&&(k.viewport=void 0),A.setupLightsView(k),Mt===!0&&K.setGlobalState(I.clippingPlanes,k),qo(S,X,k),Ue.updateMultisampleRenderTarget(de),Ue.updateRenderTargetMipmap(de),ft.has("WEBGL_multisampled_render_to_texture")===!1){let _e=!1;for(let Xe=0,xt=N.length;Xe<xt;Xe++){let ct=N[Xe],{object:ot,geometry:zt,material:Se,group:Jt}=ct;if(Se.side===Rn&&ot.layers.test(k.layers)){let et=Se.side;Se.side=jt,Se.needsUpdate=!0,gd(ot,X,k,zt,Se,Jt),Se.side=et,Se.needsUpdate=!0,_e=!0}}_e===!0&&(Ue.updateMultisampleRenderTarget(de),Ue.updateRenderTargetMipmap(de))}I.setRenderTarget(he,xe,we),I.setClearColor($,re),qe!==void 0&&(k.viewport=qe),I.toneMapping=Oe}function qo(S,N,X){let k=N.isScene===!0?N.overrideMaterial:null;for(let V=0,de=S.length;V<de;V++){let be=S[V],{object:he,geometry:xe,group:we}=be,Oe=be.material;Oe.allowOverride===!0&&k!==null&&(Oe=k),he.layers.test(X.layers)&&gd(he,N,X,xe,Oe,we)}}function gd(S,N,X,k,V,de){U!==null&&V.isNodeMaterial&&U.setObject(S,V),S.onBeforeRender(I,N,X,k,V,de),S.modelViewMatrix.multiplyMatrices(X.matrixWorldInverse,S.matrixWorld),S.normalMatrix.getNormalMatrix(S.modelViewMatrix),V.onBeforeRender(I,N,X,k,S,de),V.transparent===!0&&V.side===Rn&&V.forceSinglePass===!1?(V.side=jt,V.needsUpdate=!0,I.renderBufferDirect(X,N,k,V,S,de),V.side=er,V.needsUpdate=!0,I.renderBufferDirect(X,N,k,V,S,de),V.side=Rn):I.renderBufferDirect(X,N,k,V,S,de),S.onAfterRender(I,N,X,k,V,de)}function yd(S){let N=0;for(let X of S)X.texture!==null&&N++;return N}function Cs(S,N,X){N.isScene!==!0&&(N=xn);let k=Re.get(S),V=A.state.lights,de=A.state.shadowsArray,be=V.state.version,he=Q.getParameters(S,V.state,de,N,X,A.state.lightProbeGridArray),xe=Q.getProgramCacheKey(he),we=k.programs;k.environment=S.isMeshStandardMaterial||S.isMeshLambertMaterial||S.isMeshPhongMaterial?N.environment:null,k.fog=N.fog;let Oe=S.isMeshStandardMaterial||S.isMeshLambertMaterial&&!S.envMap||S.isMeshPhongMaterial&&!S.envMap;k.envMap=E.get(S.envMap||k.environment,Oe),k.envMapRotation=k.environment!==null&&S.envMap===null?N.environmentRotation:S.envMapRotation,we===void 0&&(S.addEventListener("dispose",it),we=new Map,k.programs=we,k.programVariants=new Map);let qe=we.get(xe);if(qe!==void 0){if(k.currentProgram===qe&&k.lightsStateVersion===be)return vd(S,he),qe}else he.uniforms=Q.getUniforms(S),U!==null&&S.isNodeMaterial&&U.build(S,X,he),S.onBeforeCompile(he,I),qe=Q.acquireProgram(he,xe),we.set(xe,qe),k.uniforms=he.uniforms;let _e=k.uniforms;return(!S.isShaderMaterial&&!S.isRawShaderMaterial||S.clipping===!0)&&(_e.clippingPlanes=K.uniform),vd(S,he),k.needsLights=Hg(S),k.lightsStateVersion=be,k.needsLights&&(_e.ambientLightColor.value=V.state.ambient,_e.lightProbe.value=V.state.probe,_e.sunLights.value=V.state.sun,_e.sunLightShadows.value=V.state.sunShadow,_e.directionalLights.value=V.state.directional,_e.directionalLightShadows.value=V.state.directionalShadow,_e.spotLights.value=V.state.spot,_e.spotLightShadows.value=V.state.spotShadow,_e.rectAreaLights.value=V.state.rectArea,_e.ltc_1.value=V.state.rectAreaLTC1,_e.ltc_2.value=V.state.rectAreaLTC2,_e.pointLights.value=V.state.point,_e.pointLightShadows.value=V.state.pointShadow,_e.hemisphereLights.value=V.state.hemi,_e.sunShadowMatrix.value=V.state.sunShadowMatrix,_e.sunShadowCascade.value=V.state.sunShadowCascade,_e.directionalShadowMatrix.value=V.state.directionalShadowMatrix,_e.spotLightMatrix.value=V.state.spotLightMatrix,_e.spotLightMap.value=V.state.spotLightMap,_e.pointShadowMatrix.value=V.state.pointShadowMatrix),k.numLightProbeGrids=yd(A.state.lightProbeGridArray),k.currentProgram=qe,k.uniformsList=null,qe}function Bg(S,N,X,k,V){let de=Re.get(S),be=de.currentProgram.id+","+k+","+V,he=de.programVariants.get(be);return he===void 0?(he=Cs(S,N,X),de.programVariants.set(be,he)):(de.currentProgram=he,de.uniformsList=null,de.outputColorSpace=k,de.toneMapping=V),he}function xd(S){if(S.uniformsList===null){let N=S.currentProgram.getUniforms();S.uniformsList=ws.seqWithValue(N.seq,S.uniforms)}return S.uniformsList}function vd(S,N){let X=Re.get(S);X.outputColorSpace=N.outputColorSpace,X.batching=N.batching,X.batchingColor=N.batchingColor,X.instancing=N.instancing,X.instancingColor=N.instancingColor,X.instancingMorph=N.instancingMorph,X.skinning=N.skinning,X.morphTargets=N.morphTargets,X.morphNormals=N.morphNormals,X.morphColors=N.morphColors,X.morphTargetsCount=N.morphTargetsCount,X.numClippingPlanes=N.numClippingPlanes,X.numIntersection=N.numClipIntersection,X.vertexAlphas=N.vertexAlphas,X.vertexTangents=N.vertexTangents,X.toneMapping=N.toneMapping}function zg(S,N,X,k,V){N.isScene!==!0&&(N=xn),Ue.resetTextureUnits();let de=N.fog,be=k.isMeshStandardMaterial||k.isMeshLambertMaterial||k.isMeshPhongMaterial?N.environment:null,he=ee===null?I.outputColorSpace:ee.isXRRenderTarget===!0?ee.texture.colorSpace:Ye.workingColorSpace,xe=k.isMeshStandardMaterial||k.isMeshLambertMaterial&&!k.envMap||k.isMeshPhongMaterial&&!k.envMap,we=E.get(k.envMap||be,xe),Oe=k.vertexColors===!0&&!!X.attributes.color&&X.attributes.color.itemSize===4,qe=!!X.attributes.tangent&&(!!k.normalMap||k.anisotropy>0),_e=!!X.morphAttributes.position,Xe=!!X.morphAttributes.normal,xt=!!X.morphAttributes.color,ct=ai;k.toneMapped&&(ee===null||ee.isXRRenderTarget===!0)&&(ct=I.toneMapping);let ot=X.morphAttributes.position||X.morphAttributes.normal||X.morphAttributes.color,zt=ot!==void 0?ot.length:0,Se=Re.get(k),Jt=A.state.lights;if(Mt===!0&&(en===!0||S!==J)){let gt=S===J&&k.id===H;K.setState(k,S,gt)}let et=!1,or=!1;k.version===Se.__version?Se.needsLights&&Se.lightsStateVersion!==Jt.state.version||V.isBatchedMesh&&Se.batching===!1||!V.isBatchedMesh&&Se.batching===!0||V.isBatchedMesh&&Se.batchingColor===!0&&V._colorsTexture===null||V.isBatchedMesh&&Se.batchingColor===!1&&V._colorsTexture!==null||V.isInstancedMesh&&Se.instancing===!1||!V.isInstancedMesh&&Se.instancing===!0||V.isSkinnedMesh&&Se.skinning===!1||!V.isSkinnedMesh&&Se.skinning===!0||V.isInstancedMesh&&Se.instancingColor===!0&&V.instanceColor===null||V.isInstancedMesh&&Se.instancingColor===!1&&V.instanceColor!==null||V.isInstancedMesh&&Se.instancingMorph===!0&&V.morphTexture===null||V.isInstancedMesh&&Se.instancingMorph===!1&&V.morphTexture!==null||Se.envMap!==we||k.fog===!0&&Se.fog!==de||Se.numClippingPlanes!==void 0&&(Se.numClippingPlanes!==K.numPlanes||Se.numIntersection!==K.numIntersection)||Se.vertexAlphas!==Oe||Se.vertexTangents!==qe||Se.morphTargets!==_e||Se.morphNormals!==Xe||Se.morphColors!==xt||Se.morphTargetsCount!==zt||Se.numLightProbeGrids!==yd(A.state.lightProbeGridArray)?et=!0:(Se.outputColorSpace!==he||Se.toneMapping!==ct)&&(or=!0):(et=!0,Se.__version=k.version);let Vt=Se.currentProgram;(et===!0||or===!0)&&(Vt=or===!0?Bg(k,N,V,he,ct):Cs(k,N,V),U&&k.isNodeMaterial&&U.onUpdateProgram(k,Vt,Se));let Xo=!1,Li=!1,ar=!1,Ke=Vt.getUniforms(),Ot=Se.uniforms;if(pe.useProgram(Vt.program)&&(Xo=!0,Li=!0,ar=!0),k.id!==H&&(H=k.id,Li=!0),Xo||J!==S){pe.buffers.depth.getReversed()&&S.reversedDepth!==!0&&(S._reversedDepth=!0,S.updateProjectionMatrix()),Ke.setValue(F,"projectionMatrix",S.projectionMatrix),Ke.setValue(F,"viewMatrix",S.matrixWorldInverse);let Nt=Ke.map.cameraPosition;Nt!==void 0&&Nt.setValue(F,Wn.setFromMatrixPosition(S.matrixWorld)),pt.logarithmicDepthBuffer&&Ke.setValue(F,"logDepthBufFC",2/(Math.log(S.far+1)/Math.LN2)),(k.isMeshPhongMaterial||k.isMeshToonMaterial||k.isMeshLambertMaterial||k.isMeshBasicMaterial||k.isMeshStandardMaterial||k.isShaderMaterial)&&Ke.setValue(F,"isOrthographic",S.isOrthographicCamera===!0),J!==S&&(J=S,Li=!0,ar=!0)}if(Se.needsLights&&(Jt.state.sunShadowMap.length>0&&Ke.setValue(F,"sunShadowMap",Jt.state.sunShadowMap,Ue),Jt.state.directionalShadowMap.length>0&&Ke.setValue(F,"directionalShadowMap",Jt.state.directionalShadowMap,Ue),Jt.state.spotShadowMap.length>0&&Ke.setValue(F,"spotShadowMap",Jt.state.spotShadowMap,Ue),Jt.state.pointShadowMap.length>0&&Ke.setValue(F,"pointShadowMap",Jt.state.pointShadowMap,Ue)),V.isSkinnedMesh){Ke.setOptional(F,V,"bindMatrix"),Ke.setOptional(F,V,"bindMatrixInverse");let gt=V.skeleton;gt&&(gt.boneTexture===null&&gt.computeBoneTexture(),Ke.setValue(F,"boneTexture",gt.boneTexture,Ue))}V.isBatchedMesh&&(Ke.setOptional(F,V,"batchingTexture"),Ke.setValue(F,"batchingTexture",V._matricesTexture,Ue),Ke.setOptional(F,V,"batchingIdTexture"),Ke.setValue(F,"batchingIdTexture",V._indirectTexture,Ue),Ke.setOptional(F,V,"batchingColorTexture"),V._colorsTexture!==null&&Ke.setValue(F,"batchingColorTexture",V._colorsTexture,Ue));let In=X.morphAttributes;if((In.position!==void 0||In.normal!==void 0||In.color!==void 0)&&j.update(V,X,Vt),(Li||Se.receiveShadow!==V.receiveShadow)&&(Se.receiveShadow=V.receiveShadow,Ke.setValue(F,"receiveShadow",V.receiveShadow)),(k.isMeshStandardMaterial||k.isMeshLambertMaterial||k.isMeshPhongMaterial)&&k.envMap===null&&N.environment!==null&&(Ot.envMapIntensity.value=N.environmentIntensity),Ot.dfgLUT!==void 0&&(Ot.dfgLUT.value=gS()),Li){if(Ke.setValue(F,"toneMappingExposure",I.toneMappingExposure),Se.needsLights&&Vg(Ot,ar),de&&k.fog===!0&&oe.refreshFogUniforms(Ot,de),oe.refreshMaterialUniforms(Ot,k,fe,Me,A.state.transmissionRenderTarget[S.id]),Se.needsLights&&Se.numLightProbeGrids>0){let gt=_,Nt=0;for(let hi of A.state.lightProbeGridArray)hi.texture!==null&&(gt.textures[Nt]=hi.texture,gt.min[Nt]=hi.boundingBox.min,gt.max[Nt]=hi.boundingBox.max,gt.resolution[Nt]=hi.resolution,Nt++);for(let hi in gt)gt[hi].length=Nt;Ot.probesSH.value=gt.textures,Ot.probesMin.value=gt.min,Ot.probesMax.value=gt.max,Ot.probesResolution.value=gt.resolution}ws.upload(F,xd(Se),Ot,Ue)}if(k.isShaderMaterial&&k.uniformsNeedUpdate===!0&&(ws.upload(F,xd(Se),Ot,Ue),k.uniformsNeedUpdate=!1),k.isSpriteMaterial&&Ke.setValue(F,"center",V.center),Ke.setValue(F,"modelViewMatrix",V.modelViewMatrix),Ke.setValue(F,"normalMatrix",V.normalMatrix),Ke.setValue(F,"modelMatrix",V.matrixWorld),k.uniformsGroups!==void 0){let gt=k.uniformsGroups;for(let Nt=0,hi=gt.length;Nt<hi;Nt++){let _d=gt[Nt];Ae.update(_d,Vt),Ae.bind(_d,Vt)}}return Vt}function Vg(S,N){S.ambientLightColor.needsUpdate=N,S.lightProbe.needsUpdate=N,S.sunLights.needsUpdate=N,S.sunLightShadows.needsUpdate=N,S.directionalLights.needsUpdate=N,S.directionalLightShadows.needsUpdate=N,S.pointLights.needsUpdate=N,S.pointLightShadows.needsUpdate=N,S.spotLights.needsUpdate=N,S.spotLightShadows.needsUpdate=N,S.rectAreaLights.needsUpdate=N,S.hemisphereLights.needsUpdate=N}function Hg(S){return S.isMeshLambertMaterial||S.isMeshToonMaterial||S.isMeshPhongMaterial||S.isMeshStandardMaterial||S.isShadowMaterial||S.isShaderMaterial&&S.lights===!0}this.getActiveCubeFace=function(){return W},this.getActiveMipmapLevel=function(){return O},this.getRenderTarget=function(){return ee},this.setRenderTargetTextures=function(S,N,X){let k=Re.get(S);k.__autoAllocateDepthBuffer=S.resolveDepthBuffer===!1,k.__autoAllocateDepthBuffer===!1&&(k.__useRenderToTexture=!1),Re.get(S.texture).__webglTexture=N,Re.get(S.depthTexture).__webglTexture=k.__autoAllocateDepthBuffer?void 0:X,k.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(S,N){let X=Re.get(S);X.__webglFramebuffer=N,X.__useDefaultFramebuffer=N===void 0},this.setRenderTarget=function(S,N=0,X=0){ee=S,W=N,O=X;let k=null,V=!1,de=!1;if(S){let he=Re.get(S);if(he.__useDefaultFramebuffer!==void 0){pe.bindFramebuffer(F.FRAMEBUFFER,he.__webglFramebuffer),te.copy(S.viewport),ve.copy(S.scissor),Te=S.scissorTest,pe.viewport(te),pe.scissor(ve),pe.setScissorTest(Te),H=-1;return}else if(he.__webglFramebuffer===void 0)Ue.setupRenderTarget(S);else if(he.__hasExternalTextures)Ue.rebindTextures(S,Re.get(S.texture).__webglTexture,Re.get(S.depthTexture).__webglTexture);else if(S.depthBuffer){let Oe=S.depthTexture;if(he.__boundDepthTexture!==Oe){if(Oe!==null&&Re.has(Oe)&&(S.width!==Oe.image.width||S.height!==Oe.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Ue.setupDepthRenderbuffer(S)}}let xe=S.texture;(xe.isData3DTexture||xe.isDataArrayTexture||xe.isCompressedArrayTexture)&&(de=!0);let we=Re.get(S).__webglFramebuffer;S.isWebGLCubeRenderTarget?(Array.isArray(we[N])?k=we[N][X]:k=we[N],V=!0):S.samples>0&&Ue.useMultisampledRTT(S)===!1?k=Re.get(S).__webglMultisampledFramebuffer:Array.isArray(we)?k=we[X]:k=we,te.copy(S.viewport),ve.copy(S.scissor),Te=S.scissorTest}else te.copy(Ce).multiplyScalar(fe).floor(),ve.copy(Ze).multiplyScalar(fe).floor(),Te=Qe;if(X!==0&&(k=q),pe.bindFramebuffer(F.FRAMEBUFFER,k)&&pe.drawBuffers(S,k),pe.viewport(te),pe.scissor(ve),pe.setScissorTest(Te),V){let he=Re.get(S.texture);F.framebufferTexture2D(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_CUBE_MAP_POSITIVE_X+N,he.__webglTexture,X)}else if(de){let he=N;for(let xe=0;xe<S.textures.length;xe++){let we=Re.get(S.textures[xe]);F.framebufferTextureLayer(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0+xe,we.__webglTexture,X,he)}}else if(S!==null&&X!==0){let he=Re.get(S.texture);F.framebufferTexture2D(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,he.__webglTexture,X)}H=-1};function bd(S){let N=Re.get(S);return(N.__readFormat!==S.format||N.__readType!==S.type)&&(N.__readFormat=S.format,N.__readType=S.type,N.__formatReadable=pt.textureFormatReadable(S.format),N.__typeReadable=pt.textureTypeReadable(S.type)),N}this.readRenderTargetPixels=function(S,N,X,k,V,de,be,he=0){if(!(S&&S.isWebGLRenderTarget)){Ne("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let xe=Re.get(S).__webglFramebuffer;if(S.isWebGLCubeRenderTarget&&be!==void 0&&(xe=xe[be],Array.isArray(xe)&&(xe=xe[0])),xe){pe.bindFramebuffer(F.FRAMEBUFFER,xe);try{let we=S.textures[he],Oe=we.format,qe=we.type;S.textures.length>1&&F.readBuffer(F.COLOR_ATTACHMENT0+he);let _e=bd(we);if(_e.__formatReadable===!1){Ne("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(_e.__typeReadable===!1){Ne("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}N>=0&&N<=S.width-k&&X>=0&&X<=S.height-V&&F.readPixels(N,X,k,V,se.convert(Oe),se.convert(qe),de)}finally{let we=ee!==null?Re.get(ee).__webglFramebuffer:null;pe.bindFramebuffer(F.FRAMEBUFFER,we)}}},this.readRenderTargetPixelsAsync=async function(S,N,X,k,V,de,be,he=0){if(!(S&&S.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let xe=Re.get(S).__webglFramebuffer;if(S.isWebGLCubeRenderTarget&&be!==void 0&&(xe=xe[be],Array.isArray(xe)&&(xe=xe[0])),xe)if(N>=0&&N<=S.width-k&&X>=0&&X<=S.height-V){pe.bindFramebuffer(F.FRAMEBUFFER,xe);let we=S.textures[he],Oe=we.format,qe=we.type;S.textures.length>1&&F.readBuffer(F.COLOR_ATTACHMENT0+he);let _e=bd(we);if(_e.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(_e.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let Xe=F.createBuffer();F.bindBuffer(F.PIXEL_PACK_BUFFER,Xe),F.bufferData(F.PIXEL_PACK_BUFFER,de.byteLength,F.STREAM_READ),F.readPixels(N,X,k,V,se.convert(Oe),se.convert(qe),0),F.bindBuffer(F.PIXEL_PACK_BUFFER,null);let xt=ee!==null?Re.get(ee).__webglFramebuffer:null;pe.bindFramebuffer(F.FRAMEBUFFER,xt);let ct=F.fenceSync(F.SYNC_GPU_COMMANDS_COMPLETE,0);return F.flush(),await dm(F,ct,4),F.bindBuffer(F.PIXEL_PACK_BUFFER,Xe),F.getBufferSubData(F.PIXEL_PACK_BUFFER,0,de),F.bindBuffer(F.PIXEL_PACK_BUFFER,null),F.deleteBuffer(Xe),F.deleteSync(ct),de}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(S,N=null,X=0){let k=Math.pow(2,-X),V=Math.floor(S.image.width*k),de=Math.floor(S.image.height*k),be=N!==null?N.x:0,he=N!==null?N.y:0;Ue.setTexture2D(S,0),F.copyTexSubImage2D(F.TEXTURE_2D,X,0,0,be,he,V,de),pe.unbindTexture()},this.copyTextureToTexture=function(S,N,X=null,k=null,V=0,de=0){let be,he,xe,we,Oe,qe,_e,Xe,xt,ct=S.isCompressedTexture?S.mipmaps[de]:S.image;if(X!==null)be=X.max.x-X.min.x,he=X.max.y-X.min.y,xe=X.isBox3?X.max.z-X.min.z:1,we=X.min.x,Oe=X.min.y,qe=X.isBox3?X.min.z:0;else{let Ke=Math.pow(2,-V);be=Math.floor(ct.width*Ke),he=Math.floor(ct.height*Ke),S.isDataArrayTexture?xe=ct.depth:S.isData3DTexture?xe=Math.floor(ct.depth*Ke):xe=1,we=0,Oe=0,qe=0}k!==null?(_e=k.x,Xe=k.y,xt=k.z):(_e=0,Xe=0,xt=0);let ot=se.convert(N.format),zt=se.convert(N.type),Se;N.isData3DTexture?(Ue.setTexture3D(N,0),Se=F.TEXTURE_3D):N.isDataArrayTexture||N.isCompressedArrayTexture?(Ue.setTexture2DArray(N,0),Se=F.TEXTURE_2D_ARRAY):(Ue.setTexture2D(N,0),Se=F.TEXTURE_2D),pe.activeTexture(F.TEXTURE0),pe.pixelStorei(F.UNPACK_FLIP_Y_WEBGL,N.flipY),pe.pixelStorei(F.UNPACK_PREMULTIPLY_ALPHA_WEBGL,N.premultiplyAlpha),pe.pixelStorei(F.UNPACK_ALIGNMENT,N.unpackAlignment);let Jt=pe.getParameter(F.UNPACK_ROW_LENGTH),et=pe.getParameter(F.UNPACK_IMAGE_HEIGHT),or=pe.getParameter(F.UNPACK_SKIP_PIXELS),Vt=pe.getParameter(F.UNPACK_SKIP_ROWS),Xo=pe.getParameter(F.UNPACK_SKIP_IMAGES);pe.pixelStorei(F.UNPACK_ROW_LENGTH,ct.width),pe.pixelStorei(F.UNPACK_IMAGE_HEIGHT,ct.height),pe.pixelStorei(F.UNPACK_SKIP_PIXELS,we),pe.pixelStorei(F.UNPACK_SKIP_ROWS,Oe),pe.pixelStorei(F.UNPACK_SKIP_IMAGES,qe);let Li=S.isDataArrayTexture||S.isData3DTexture,ar=N.isDataArrayTexture||N.isData3DTexture;if(S.isDepthTexture){let Ke=Re.get(S),Ot=Re.get(N),In=Re.get(Ke.__renderTarget),gt=Re.get(Ot.__renderTarget);pe.bindFramebuffer(F.READ_FRAMEBUFFER,In.__webglFramebuffer),pe.bindFramebuffer(F.DRAW_FRAMEBUFFER,gt.__webglFramebuffer);for(let Nt=0;Nt<xe;Nt++)Li&&(F.framebufferTextureLayer(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,Re.get(S).__webglTexture,V,qe+Nt),F.framebufferTextureLayer(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,Re.get(N).__webglTexture,de,xt+Nt)),F.blitFramebuffer(we,Oe,we+be,Oe+he,_e,Xe,_e+be,Xe+he,F.DEPTH_BUFFER_BIT,F.NEAREST);pe.bindFramebuffer(F.READ_FRAMEBUFFER,null),pe.bindFramebuffer(F.DRAW_FRAMEBUFFER,null)}else if(V!==0||S.isRenderTargetTexture||Re.has(S)){let Ke=Re.get(S),Ot=Re.get(N);pe.bindFramebuffer(F.READ_FRAMEBUFFER,R),pe.bindFramebuffer(F.DRAW_FRAMEBUFFER,G);for(let In=0;In<xe;In++)Li?F.framebufferTextureLayer(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,Ke.__webglTexture,V,qe+In):F.framebufferTexture2D(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,Ke.__webglTexture,V),ar?F.framebufferTextureLayer(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,Ot.__webglTexture,de,xt+In):F.framebufferTexture2D(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,Ot.__webglTexture,de),V!==0?F.blitFramebuffer(we,Oe,we+be,Oe+he,_e,Xe,_e+be,Xe+he,F.COLOR_BUFFER_BIT,F.NEAREST):ar?F.copyTexSubImage3D(Se,de,_e,Xe,xt+In,we,Oe,be,he):F.copyTexSubImage2D(Se,de,_e,Xe,we,Oe,be,he);pe.bindFramebuffer(F.READ_FRAMEBUFFER,null),pe.bindFramebuffer(F.DRAW_FRAMEBUFFER,null)}else ar?S.isDataTexture||S.isData3DTexture?F.texSubImage3D(Se,de,_e,Xe,xt,be,he,xe,ot,zt,ct.data):N.isCompressedArrayTexture?F.compressedTexSubImage3D(Se,de,_e,Xe,xt,be,he,xe,ot,ct.data):F.texSubImage3D(Se,de,_e,Xe,xt,be,he,xe,ot,zt,ct):S.isDataTexture?F.texSubImage2D(F.TEXTURE_2D,de,_e,Xe,be,he,ot,zt,ct.data):S.isCompressedTexture?F.compressedTexSubImage2D(F.TEXTURE_2D,de,_e,Xe,ct.width,ct.height,ot,ct.data):F.texSubImage2D(F.TEXTURE_2D,de,_e,Xe,be,he,ot,zt,ct);pe.pixelStorei(F.UNPACK_ROW_LENGTH,Jt),pe.pixelStorei(F.UNPACK_IMAGE_HEIGHT,et),pe.pixelStorei(F.UNPACK_SKIP_PIXELS,or),pe.pixelStorei(F.UNPACK_SKIP_ROWS,Vt),pe.pixelStorei(F.UNPACK_SKIP_IMAGES,Xo),de===0&&N.generateMipmaps===!0&&N.mipmapsAutoUpdate===!0&&F.generateMipmap(Se),pe.unbindTexture()},this.initRenderTarget=function(S){Re.get(S).__webglFramebuffer===void 0&&Ue.setupRenderTarget(S)},this.initTexture=function(S){S.isCubeTexture?Ue.setTextureCube(S,0):S.isData3DTexture?Ue.setTexture3D(S,0):S.isDataArrayTexture||S.isCompressedArrayTexture?Ue.setTexture2DArray(S,0):Ue.setTexture2D(S,0),pe.unbindTexture()},this.resetState=function(){W=0,O=0,ee=null,pe.reset(),ae.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return En}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=Ye._getDrawingBufferColorSpace(e),t.unpackColorSpace=Ye._getUnpackColorSpace()}};function bc(i,e,t,n){let r=new Float64Array(12);for(let s=0;s<e-1;s++)for(let o=0;o<e-1;o++){let a=s*e+o,l=[a,a+e,a+e+1,a+1],c=i(l[0]),h=i(l[1]),d=i(l[2]),u=i(l[3]);if(!(Math.min(c,h,d,u)<0&&Math.max(c,h,d,u)>0))continue;let f=0;f=vc(t,l[0],l[1],c,h,r,f),f=vc(t,l[1],l[2],h,d,r,f),f=vc(t,l[2],l[3],d,u,r,f),f=vc(t,l[3],l[0],u,c,r,f);for(let p=0;p+1<f;p+=2)n.segment(r[3*p],r[3*p+1],r[3*p+2],r[3*p+3],r[3*p+4],r[3*p+5])}}function vc(i,e,t,n,r,s,o){if(n<0==r<0||o>3)return o;let a=n/(n-r);for(let l=0;l<3;l++)s[3*o+l]=i[3*e+l]+a*(i[3*t+l]-i[3*e+l]);return o+1}var yS=`
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
}`,xS=`
precision highp float;
in float across;
uniform vec4 colour;
uniform float width;
uniform float veil;
layout(location = 0) out vec4 pixel;
void main() {
  float edge = 1.0 - smoothstep(0.5 * width - 0.25, 0.5 * width + 0.75, abs(across));
  pixel = vec4(colour.rgb, colour.a * veil * edge);
}`,_c=class{constructor(e,t,n=1,r=!1,s=0){this.width=t;let o=new Ve().setStyle(e,"srgb-linear");this.material=new $t({glslVersion:Pi,vertexShader:yS,fragmentShader:xS,transparent:!0,depthWrite:!1,depthTest:!r,uniforms:{viewport:{value:new Ge(1,1)},width:{value:t},colour:{value:new lt(o.r,o.g,o.b,n)},lift:{value:r?0:4e-4},veil:{value:1}}}),this.geometry=this.allocate(),this.mesh=new Xt(this.geometry,this.material),this.mesh.frustumCulled=!1,this.mesh.renderOrder=r?3:2,this.behind=s?Qm(this.mesh,this.material,s):null}width;mesh;material;behind;data=new Float32Array(6*256);count=0;geometry;set colour(e){let t=new Ve().setStyle(e,"srgb-linear"),n=this.material.uniforms.colour.value;n.set(t.r,t.g,t.b,n.w)}resize(e,t,n,r){this.material.uniforms.viewport.value.set(.5*e,.5*t),this.material.uniforms.width.value=r*n}get drawn(){let{x:e,y:t,z:n,w:r}=this.material.uniforms.colour.value;return{ends:this.data.subarray(0,6*this.count),colour:`rgb(${[e,t,n].map(s=>Math.round(255*s)).join(" ")})`,width:this.width,opacity:r}}begin(){this.count=0}segment(e,t,n,r,s,o){let a=6*this.count;if(e-e+t-t+n-n+r-r+s-s+o-o!==0)return;if(a+6>this.data.length){let c=new Float32Array(2*this.data.length);c.set(this.data),this.data=c,this.geometry.dispose(),this.geometry=this.allocate(),this.mesh.geometry=this.geometry,this.behind&&(this.behind.geometry=this.geometry)}let l=this.data;l[a]=e,l[a+1]=t,l[a+2]=n,l[a+3]=r,l[a+4]=s,l[a+5]=o,this.count++}join(e,t){this.segment(e[0],e[1],e[2],t[0],t[1],t[2])}end(){this.geometry.instanceCount=this.count,this.mesh.visible=this.count>0;let e=this.geometry.getAttribute("start");e.data.needsUpdate=!0}dispose(){this.geometry.dispose(),this.material.dispose()}allocate(){let e=new Mo,t=new Float32Array([0,-1,0,1,-1,0,1,1,0,0,-1,0,1,1,0,0,1,0]);e.setAttribute("position",new _t(t,3));let n=new wo(this.data,6,1);return n.setUsage(Ms),e.setAttribute("start",new ps(n,3,0)),e.setAttribute("end",new ps(n,3,3)),e}};function Qm(i,{uniforms:e,vertexShader:t,fragmentShader:n},r){let s=new $t({glslVersion:Pi,vertexShader:t,fragmentShader:n,transparent:!0,depthWrite:!1,depthFunc:hs,uniforms:{...e,veil:{value:r}}}),o=i instanceof Xt?new Xt(i.geometry,s):new ms(i.geometry,s);return o.frustumCulled=!1,o.renderOrder=i.renderOrder,i.add(o),o}var vS=`
in vec4 tint;
uniform float size;
uniform float lift;
out vec4 shade_;
void main() {
  shade_ = tint;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  gl_Position.z -= lift * gl_Position.w;
  gl_PointSize = size * (tint.a > 1.5 ? 1.45 : 1.0);
}`,bS=`
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
}`,ko=class{mesh;material;geometry=new sn;constructor(e=!1){this.material=new $t({glslVersion:Pi,vertexShader:vS,fragmentShader:bS,transparent:!0,depthTest:!e,depthWrite:!1,uniforms:{size:{value:10},lift:{value:.002},veil:{value:1},rim:{value:new Ve(1,1,1)}}}),this.mesh=new ms(this.geometry,this.material),this.mesh.frustumCulled=!1,this.mesh.renderOrder=e?5:4,e||Qm(this.mesh,this.material,.3)}resize(e){this.material.uniforms.size.value=11*e}get drawn(){let e=t=>this.geometry.getAttribute(t)?.array??[];return{places:e("position"),tints:e("tint")}}fill(e,t){this.geometry.setAttribute("position",new _t(Float32Array.from(e.flat()),3)),this.geometry.setAttribute("tint",new _t(Float32Array.from(t.flat()),4)),this.mesh.visible=e.length>0}dispose(){this.geometry.dispose(),this.material.dispose()}};var Sc=Math.PI/180,eg=.34,Bo={x:[0,0],y:[90,0],z:[0,90]};function Ts({sectionAzimuth:i,sectionTilt:e}){let[t,n]=ju(e),[r,s]=ju(i);return[t*r,t*s,n]}function Pr(i,e){return[...Ts(i),i.sectionAt*e.scale]}function Ir(i,e){let[t,n,r,s]=Pr(i,e),o=a=>[t*a,n*a,r*a];return{move:o(s),tilt:o(s+eg)}}function tg(i,e,t,n){let[r,s,o]=e;if(i==="move"){let[h,d,u]=Ts(t);return{sectionAt:Number(((h*r+d*s+u*o)/n.scale).toPrecision(6))}}let a=t.sectionAt*n.scale+eg<0?-1:1,l=Math.hypot(r,s);return{sectionAzimuth:l>.02?Math.round(Math.atan2(a*s,a*r)/Sc):t.sectionAzimuth,sectionTilt:Math.round(Math.atan2(a*o,l)/Sc)}}function ng(i,e){let[t,n,r,s]=Pr(i,e),o=e.half.map(m=>1.06*m+.04),a=m=>t*m[0]+n*m[1]+r*m[2]-s,l=Array.from({length:8},(m,x)=>o.map((w,_)=>x>>_&1?w:-w)),c=l.flatMap((m,x)=>[1,2,4].filter(w=>!(x&w)).flatMap(w=>{let _=l[x|w],T=a(m),A=a(_);return T<0==A<0?[]:[m.map((y,M)=>y+T/(T-A)*(_[M]-y))]})),h=[0,1,2].map(m=>c.reduce((x,w)=>x+w[m],0)/c.length),[d,u]=ju(i.sectionAzimuth),f=[-u,d,0],p=[-r*d,-r*u,t*d+n*u],v=(m,x)=>m.reduce((w,_,T)=>w+(_-h[T])*x[T],0),g=m=>Math.atan2(v(m,p),v(m,f));return c.sort((m,x)=>g(m)-g(x))}function ju(i){return i%90?[Math.cos(i*Sc),Math.sin(i*Sc)]:[[1,0],[0,1],[-1,0],[0,-1]][(i/90%4+4)%4]}var nr={net:{width:1.25,light:"#44566c",dark:"#c3d0e0",opacity:.75,hidden:.35},first:{width:1.75,light:"#101418",dark:"#ffffff",opacity:.95},second:{width:1.25,light:"#7a4b00",dark:"#ffd28a",opacity:.95},normals:{width:1.5,light:"#00785a",dark:"#58dcae",opacity:.95},teethU:{width:1,light:"#0060a8",dark:"#7cc4ff",opacity:.55},teethV:{width:1,light:"#b04500",dark:"#ffae70",opacity:.55},combU:{width:1.75,light:"#0060a8",dark:"#7cc4ff",opacity:1},combV:{width:1.75,light:"#b04500",dark:"#ffae70",opacity:1},zeroK:{width:2.75,light:"#101418",dark:"#ffffff",opacity:1},zeroH:{width:2.75,light:"#a3008f",dark:"#ff9cf2",opacity:1},edge:{width:2.5,light:"#c4007a",dark:"#ff7ac8",opacity:1},plane:{width:1.25,light:"#c2102e",dark:"#ff6b81",opacity:.55},arm:{width:1.75,light:"#c2102e",dark:"#ff6b81",opacity:.8,onTop:!0},section:{width:3,light:"#c2102e",dark:"#ff6b81",opacity:1}},Lr=Object.keys(nr),ig=Lr.filter(i=>i!=="net"&&i!=="edge"),ed=(i,e)=>nr[i][e?"dark":"light"],rg=[.76,.06,.18,1],sg=Wr.relative,Mc=class{group=new Mi;points=new ko;grips=new ko(!0);netPoints=[];lines=Object.fromEntries(Lr.map(e=>[e,new _c(nr[e].light,nr[e].width,nr[e].opacity,nr[e].onTop,nr[e].hidden)]));constructor(){for(let e of Lr)this.group.add(this.lines[e].mesh);this.group.add(this.points.mesh,this.grips.mesh),this.grips.fill([],[])}get drawn(){return{lines:Lr.map(e=>this.lines[e].drawn),points:[this.points.drawn,this.grips.drawn]}}resize(e,t,n){for(let r of Lr)this.lines[r].resize(e,t,n,nr[r].width);this.points.resize(n),this.grips.resize(n)}theme(e){for(let t of Lr)this.lines[t].colour=ed(t,e)}update(e,t,n,r){let s=e.side;for(let o of ig)this.lines[o].begin();if(s>1){t.directions&&this.directions(e),t.normals&&this.normals(e),(t.combs==="u"||t.combs==="both")&&this.combs(e,!0,r),(t.combs==="v"||t.combs==="both")&&this.combs(e,!1,r);let{planes:o,stride:a}=e.grid,l=(c,h)=>d=>{if(!e.covered[d])return NaN;let u=o[c*a+d],f=o[De.curvedness*a+d];return Math.abs(u)<=sg*f**h?0:u};if(t.zeroK&&bc(l(De.gaussian,2),s,e.position,this.lines.zeroK),t.zeroH&&bc(l(De.mean,1),s,e.position,this.lines.zeroH),t.section){let[c,h,d,u]=Pr(t,n),f=e.position;bc(p=>e.covered[p]?c*f[3*p]+h*f[3*p+1]+d*f[3*p+2]-u:NaN,s,f,this.lines.section),this.showPlane(t,n)}else this.grips.fill([],[])}for(let o of ig)this.lines[o].end()}showPlane(e,t){let n=ng(e,t),{move:r,tilt:s}=Ir(e,t);n.forEach((o,a)=>this.lines.plane.join(o,n[(a+1)%n.length])),this.lines.arm.join(r,s),this.grips.fill([r,s],[rg,[...rg.slice(0,3),.5]])}net(e,t,n,r){let{net:s}=this.lines;s.begin(),this.netPoints=[];for(let a of e){let l=a.map(c=>rn(r,c));this.netPoints.push(...l);for(let c=0;c+1<l.length;c++)s.join(l[c],l[c+1])}s.end();let o=a=>a.id===n?[.93,.42,.05,2]:a.mirrored?[.25,.38,.55,.5]:[...a.tint,1];this.points.fill(t.map(a=>rn(r,a.position)),t.map(o))}edge(e,t){let{edge:n}=this.lines;n.begin();for(let r of e){let s=r.map(o=>rn(t,o));for(let o=0;o+1<s.length;o++)n.join(s[o],s[o+1])}n.end()}dispose(){for(let e of Lr)this.lines[e].dispose();this.points.dispose(),this.grips.dispose()}directions(e){let{planes:t,stride:n,size:r}=e.grid;og(e,(s,o)=>{let a=t[De.radius*n+s];if(!(a>sg*t[De.curvedness*n+s]&&t[De.curvedness*n+s]*r>1e-9))return;sa(t[s],t[n+s],t[2*n+s],a);let l=e.position.subarray(3*s,3*s+3),c=.36*o,h=[0,0,0],d=[0,0,0];for(let f=0;f<3;f++){let p=t[(De.e1+f)*n+s],v=t[(De.e2+f)*n+s];h[f]=c*(dr*p+fr*v),d[f]=c*(dr*v-fr*p)}let u=(f,p)=>f.segment(l[0]-p[0],l[1]-p[1],l[2]-p[2],l[0]+p[0],l[1]+p[1],l[2]+p[2]);u(this.lines.first,h),u(this.lines.second,d)})}normals(e){let{planes:t,stride:n}=e.grid;og(e,(r,s)=>{let o=e.position.subarray(3*r,3*r+3),a=.9*s,l=c=>a*t[(De.normal+c)*n+r];this.lines.normals.segment(o[0],o[1],o[2],o[0]+l(0),o[1]+l(1),o[2]+l(2))})}combs(e,t,n){let{planes:r,stride:s,nu:o}=e.grid,a=t?this.lines.teethU:this.lines.teethV,l=t?this.lines.combU:this.lines.combV,c=Qu,h=Math.max(1,Math.round((o-1)/60)),d=(u,f)=>{let p=Math.round(u*(o-1)/(c-1));return t?f*o+p:p*o+f};for(let u=0;u<c;u++){let f=null;for(let p=0;p<o;p+=h){let v=d(u,Math.min(p,o-1)),g=e.position.subarray(3*v,3*v+3),m=-n*ag(e,t,v),x=[0,1,2].map(w=>g[w]+m*r[(De.normal+w)*s+v]);if(!e.covered[v]||x.some(Number.isNaN)){f=null;continue}a.segment(g[0],g[1],g[2],x[0],x[1],x[2]),f&&l.join(f,x),f=x}}}},Qu=7;function ag(i,e,t){let{planes:n,stride:r}=i.grid,s=De.forms+(e?0:2);return n[(s+3)*r+t]/n[s*r+t]}function lg(i,e,t){let n=0,r=0;for(let s of i){let o=s.grid.nu;r=Math.max(r,s.grid.size);for(let a=0;a<Qu;a++){let l=Math.round(a*(o-1)/(Qu-1));for(let c=0;c<o;c+=3){let h=(d,u)=>s.covered[u]&&Math.abs(ag(s,d,u))||0;e.combs!=="v"&&(n=Math.max(n,h(!0,c*o+l))),e.combs!=="u"&&(n=Math.max(n,h(!1,l*o+c)))}}}return n*r>1e-9?.22*e.combScale*r*t.scale/n:0}function og(i,e){let t=i.side,n=Math.min(t,17),r=i.position,s=u=>[r[3*u],r[3*u+1],r[3*u+2]],[o,a,l,c]=[s(0),s(t*(t-1)),s(t-1),s(t*t-1)],h=(u,f)=>Math.hypot(u[0]-f[0],u[1]-f[1],u[2]-f[2]),d=Math.min(.1,Math.max(.035,(h(o,a)+h(o,l)+h(l,c)+h(a,c))/(4*(n-1))));for(let u=0;u<n;u++)for(let f=0;f<n;f++){let p=Math.round(u*(t-1)/(n-1))*t+Math.round(f*(t-1)/(n-1));i.covered[p]&&e(p,d)}}var _S={4:[["\\alpha_1","alpha 1"],["\\zeta_1","zeta 1"],["\\alpha_2","alpha 2"],["\\zeta_2","zeta 2"]],2:[["\\alpha","alpha"],["\\zeta","zeta"]]},wc=class{constructor(e){this.store=e;this.element.append(Vi("Shape",!0,this.shape),Vi("Colour",!0,...this.colour()),Vi("Show",!0,...this.overlays()),Vi("Light lines",!0,...this.stripes()),Vi("Section",!1,...this.cut())),e.subscribe((t,n)=>{(t.model!==n.model||t.patch!==n.patch)&&this.showShape(t)})}store;element=C("aside",{class:"panel right","aria-label":"Shape and analysis"});shape=C("div",{class:"shape"});fixed=C("p",{class:"hint",hidden:!0},"Four sets are shown side by side; choose “One” to set the shape.");bindings=[];controls=[];shapeFor="";fields=[];refresh(e,t){for(let n of this.bindings)n(e.settings,t);this.showShape(e)}showShape(e){let t=at(e),n=an(t),r=t.unchecked_shape===!0,s=Object.entries(At[t.kind].fields).filter(([,c])=>c.type==="number"||c.type==="positive").map(([c])=>c),o=`${t.kind} ${n.length} ${r}`;o!==this.shapeFor&&(this.shapeFor=o,this.build(t,n.length,s,r)),n.forEach((c,h)=>this.controls[h]?.update(c));for(let{key:c,control:h}of this.fields)h.update($e(t,c));let a=e.compare==="sets"&&Xs(n.length).length>0;this.fixed.hidden=!a;for(let{element:c}of this.controls)for(let h of c.querySelectorAll("input"))h.disabled=a;for(let c of this.shape.querySelectorAll(".chip"))c.disabled=a;let l=JSON.stringify(n);for(let c of this.shape.querySelectorAll(".chip"))c.setAttribute("aria-pressed",String(c.dataset.shape===l))}build(e,t,n,r){let{store:s}=this,o=(h,d)=>{let u=at(s.state);s.editPatch({...u,shape:an(u).map((f,p)=>p===h?d:f)},`shape ${h}`)};this.controls=t===0?[]:_S[t].map(([h,d],u)=>Un({label:ti(h),name:d,min:gi[0],max:gi[1],step:.01,marks:[-4,-3,-2,-1,0,1],hard:!r,onInput:f=>o(u,f),onSettle:()=>s.settle()}));let a=t===4?e.kind==="ruled"?["first curve","second curve"]:["along u","along v"]:[""],l=[];this.controls.forEach((h,d)=>{d%2===0&&a[d/2]&&l.push(C("div",{class:"subtitle"},a[d/2])),l.push(h.element)}),this.fields=n.map(h=>{let d=(f,p)=>s.editPatch({...at(s.state),[h]:f},p);if(h==="scale"){let f=Un({label:ti("\\lambda"),name:"lambda",min:.1,max:4,step:.01,marks:[1,1.5,3],onInput:p=>d(p,"scale"),onSettle:()=>s.settle()});return{key:h,control:f}}let u=At[e.kind].fields[h].type==="positive";return{key:h,control:ei({label:Ct(h),name:Ct(h),positive:u,step:.1,onChange:f=>d(f,null)})}}),this.fields.length&&l.push(C("div",{class:"subtitle"},e.kind==="swung"?"scale of the trajectory":"dimensions"),...this.fields.map(h=>h.control.element));let c=Xs(t);c.length&&l.push(C("div",{class:"subtitle"},"sets of the thesis"),C("div",{class:"chips"},...[...c,Array.from({length:t},()=>0)].map(h=>{let d=je(`(${h.join(", ").replaceAll("-","−")})`,`Set the shape parameters to ${h.join(", ")}`,()=>s.editPatch({...at(s.state),shape:h}),"chip");return d.dataset.shape=JSON.stringify(h),d}))),l.length||l.push(C("p",{class:"hint"},Jn($e(e,"basis"))?"This surface has no shape parameters: drag its control points.":"The shape parameters of this basis are changed in the model file.")),this.shape.replaceChildren(this.fixed,...l)}colour(){let{store:e}=this,t=(u,f)=>({label:u,options:jn.filter(p=>p.colour!=="vector"&&f(p)).map(p=>({value:p.key,label:`${Ct(p.name)}${p.colour==="classes"?"":`  ${p.symbol}`}`}))}),n=u=>"EFGLMN".includes(u.key),r=u=>/^(beta|gamma)\d/.test(u.key),s=$s("Colour by",[{label:"",options:[{value:"none",label:"No colour"}]},t("Curvature",u=>u.colour!=="classes"&&!n(u)&&!r(u)),t("Types",u=>u.colour==="classes"),t("Invariants, plane metric",u=>r(u)&&!u.key.endsWith("_surface")),t("Invariants, surface metric",u=>u.key.endsWith("_surface")),t("Fundamental forms",n)],u=>e.setting({quantity:u,range:e.state.settings.range==="fixed"?"robust":e.state.settings.range})),o=An("Range of colours",[{value:"robust",label:"Percentiles",title:"Leave out a few extreme values at either end"},{value:"full",label:"All",title:"From the least to the greatest value"},{value:"fixed",label:"Fixed",title:"Ends given by hand"}],u=>e.setting({range:u})),a=Un({label:"cut",name:"Percentile cut at either end",min:0,max:20,step:.5,marks:[2,5,10],hard:!0,onInput:u=>e.setting({percentile:u})}),l=ei({label:"from",name:"Lowest colour",onChange:u=>e.setting({low:u})}),c=ei({label:"to",name:"Highest colour",onChange:u=>e.setting({high:u})}),h=C("div",{class:"pair"},l.element,c.element),d=cn("Contour lines",u=>e.setting({contours:u}),void 0,"Ten steps from end to end");return this.bindings.push(u=>{let f=jn.find(v=>v.key===u.quantity),p=f!==void 0&&f.colour!=="classes";s.update(u.quantity),o.update(u.range),a.update(u.percentile),l.update(u.low),c.update(u.high),d.update(u.contours),o.element.hidden=d.element.hidden=!p,a.element.hidden=!p||u.range!=="robust",h.hidden=!p||u.range!=="fixed"}),[s.element,o.element,a.element,h,d.element]}overlays(){let{store:e}=this,t=(...a)=>{let l=C("span",{class:"keys"},...a.map(()=>C("span",{class:"key"})));return this.bindings.push((c,h)=>a.forEach((d,u)=>l.children[u].style.background=ed(d,h))),l},n=(a,l,c,h="")=>{let d=cn(l,u=>e.setting({[a]:u}),c,h);return this.bindings.push(u=>d.update(u[a])),d.element},r=(a,...l)=>C("span",{},ti(a),...l),s=An("Combs along iso-curves",[{value:"off",label:"Off"},{value:"u",label:C("i",{},"u")},{value:"v",label:C("i",{},"v")},{value:"both",label:"Both"}],a=>e.setting({combs:a})),o=Un({label:"size",name:"Size of the combs",min:.1,max:3,step:.1,marks:[1],onInput:a=>e.setting({combScale:a})});return this.bindings.push(a=>{s.update(a.combs),o.update(a.combScale),o.element.hidden=a.combs==="off"}),[C("div",{class:"switches"},n("net","Control net",t("net")),n("curves","Iso-curves"),n("directions","Directions",t("first","second"),"Principal directions. Strong: of κ1; light: of κ2"),n("normals","Normals",t("normals")),n("zeroK",r("K"," = 0"),t("zeroK"),"Parabolic lines"),n("zeroH",r("H"," = 0"),t("zeroH")),n("minRadius","Smallest radius"),n("wireframe","Wireframe")),C("div",{class:"row"},C("span",{class:"caption"},"Combs"),s.element),o.element]}stripes(){let{store:e}=this,t=An("Light lines",[{value:"none",label:"Off"},{value:"zebra",label:"Zebra",title:"Stripes of a striped room, reflected"},{value:"isophotes",label:"Isophotes",title:"Lines of equal angle between normal and light"},{value:"reflection",label:"Reflect",title:"Reflections of parallel tube lights"},{value:"highlight",label:"Highlight",title:"Highlight lines: where the normal meets a tube light; the same from everywhere"}],c=>e.setting({stripes:c})),n=Un({label:"lines",name:"Number of lines",min:4,max:80,step:1,onInput:c=>e.setting({density:c}),onSettle:()=>e.settle()}),r=Un({label:"turn",name:"Azimuth of the light in degrees",min:-180,max:180,step:1,marks:[-90,0,90],onInput:c=>e.setting({lightAzimuth:c})}),s=Un({label:"height",name:"Height of the light in degrees",min:-90,max:90,step:1,marks:[0,45],onInput:c=>e.setting({lightElevation:c})}),o=C("div",{class:"light-ball",title:"Drag the light"},C("span",{})),a=c=>{let h=o.getBoundingClientRect(),d=(c.clientX-h.left)/h.width*2-1,u=1-(c.clientY-h.top)/h.height*2,f=Math.min(1,Math.hypot(d,u));e.setting({lightAzimuth:Math.round(Math.atan2(u,d)*180/Math.PI),lightElevation:Math.round(Math.acos(f)*180/Math.PI)})};o.addEventListener("pointerdown",c=>{o.setPointerCapture(c.pointerId),a(c)}),o.addEventListener("pointermove",c=>{o.hasPointerCapture(c.pointerId)&&a(c)});let l=C("div",{class:"light"},o,C("div",{class:"stack"},r.element,s.element));return this.bindings.push(c=>{t.update(c.stripes),n.update(c.density),r.update(c.lightAzimuth),s.update(c.lightElevation),n.element.hidden=l.hidden=c.stripes==="none";let h=c.lightAzimuth*Math.PI/180,d=Math.cos(c.lightElevation*Math.PI/180),u=o.firstElementChild;u.style.left=`${50+50*d*Math.cos(h)}%`,u.style.top=`${50-50*d*Math.sin(h)}%`,u.classList.toggle("under",c.lightElevation<0)}),[t.element,n.element,l]}cut(){let{store:e}=this,t=cn("Section by a plane",h=>e.setting({section:h})),n=cn("Cut the front away",h=>e.setting({clip:h})),r=An("Normal of the plane",["x","y","z"].map(h=>({value:h,label:C("i",{},h),title:`Plane across ${h}`})),h=>e.setting({sectionAzimuth:Bo[h][0],sectionTilt:Bo[h][1],sectionAt:0})),s=Un({label:"turn",name:"Azimuth of the plane's normal in degrees",min:-180,max:180,step:1,marks:[-90,0,90],onInput:h=>e.setting({sectionAzimuth:h})}),o=Un({label:"tilt",name:"Tilt of the plane's normal in degrees",min:-90,max:90,step:1,marks:[-45,0,45],hard:!0,onInput:h=>e.setting({sectionTilt:h})}),a=C("p",{class:"hint"}),l=Un({label:"at",name:"Place of the section plane",min:-1,max:1,step:.01,onInput:h=>e.setting({sectionAt:h-this.middle})}),c=[C("div",{class:"row"},C("span",{class:"caption"},"Across"),r.element),s.element,o.element,l.element,a,n.element];return this.bindings.push(h=>{t.update(h.section),n.update(h.clip);let d=["x","y","z"].find(u=>h.sectionTilt===Bo[u][1]&&(u==="z"||h.sectionAzimuth===Bo[u][0]));r.update(d??"free"),s.update(h.sectionAzimuth),o.update(h.sectionTilt);for(let u of c)u.hidden=!h.section;h.section&&(a.textContent=`${this.showOffset(h,l)}; drag the red points in the picture`)}),[t.element,...c]}middle=0;box={low:[0,0,0],high:[1,1,1]};sectionBox(e){this.box=e}showOffset(e,t){let n=Ts(e),{low:r,high:s}=this.box;this.middle=n.reduce((h,d,u)=>h+.5*d*(r[u]+s[u]),0);let o=n.reduce((h,d,u)=>h+.5*Math.abs(d)*(s[u]-r[u]),0)||1;t.bounds(this.middle-o,this.middle+o,10**Math.floor(Math.log10(o/500)));let a=this.middle+e.sectionAt,{unit:l}=this.store.state.model;return t.update(Number(a.toPrecision(5))),`${n.map((h,d)=>[Number(h.toFixed(3)),"xyz"[d]]).filter(([h])=>h!==0).map(([h,d],u)=>`${h<0?"− ":u?"+ ":""}${Math.abs(h)===1?"":`${Math.abs(h)} `}${d}`).join(" ")} = ${rt(a)}${l?` ${l}`:""}`}};var cg=256,Nr=zo(Be.palette.undefined),Ac=zo(Be.palette.front),Es=zo(Be.palette.back),LC=Be.palette.series;function ir(i){let e=(i.colour==="diverging"?Be.palette.diverging:Be.palette.sequential).map(zo);return Array.from({length:cg},(t,n)=>{let r=n/(cg-1)*(e.length-1),s=Math.min(Math.floor(r),e.length-2);return[0,1,2].map(o=>Math.round(e[s][o]+(r-s)*(e[s+1][o]-e[s][o])))})}var rr=i=>Be.palette.classes[i].map(zo),hg=i=>Uint8Array.from(i.flatMap(e=>[...e,255])),Pn=([i,e,t])=>`rgb(${i} ${e} ${t})`;function zo(i){return[1,3,5].map(e=>parseInt(i.slice(e,e+2),16))}var Ec=class{element=C("figure",{class:"legend","aria-label":"Legend"});bar=C("canvas",{class:"colours",width:1,height:256});plot=C("canvas",{class:"histogram",width:64,height:192,"aria-hidden":"true"});shown="";ticks=[];note=C("figcaption",{});real(e,t,n,r){this.element.hidden=!1;let s=st[e],o=np(Math.max(Math.abs(t.low),Math.abs(t.high)));if(this.shown!==`${e} ${n} ${o}`){this.shown=`${e} ${n} ${o}`;let u=this.bar.getContext("2d");ir(s).forEach((p,v,g)=>{u.fillStyle=Pn(p),u.fillRect(0,g.length-1-v,1,1)}),this.ticks=Array.from({length:5},()=>C("span",{class:"tick"}));let f=`${o?`10${Eh(o)} `:""}${ni(s,n)}`.trim();this.element.replaceChildren(C("div",{class:"legend-title"},C("span",{},Ct(s.name)),C("span",{class:"legend-symbol"},ti(s.latex),f?C("span",{class:"unit"},f):null)),C("div",{class:"scale"},this.plot,this.bar,C("div",{class:"ticks"},...this.ticks)),this.note)}let{low:a,high:l}=t,c=u=>rt(Math.abs(u)<=t.noise?0:u/10**o,3);this.ticks.forEach((u,f)=>{let p=f/(this.ticks.length-1);u.textContent=c(a+(l-a)*p),u.style.bottom=`${100*p}%`}),this.histogram(t,r);let h=t.finite?[C("dl",{class:"facts"},C("dt",{},"max"),C("dd",{},c(t.most)),C("dt",{},"mean"),C("dd",{},c(t.mean)),C("dt",{},"min"),C("dd",{},c(t.least)))]:["no point has a finite value"];t.below+t.above>0&&h.push(C("div",{},`${Ch(t.below+t.above)} beyond ends`));let d=[[t.missing-t.infinite,"undefined"],[t.infinite,"infinite"]];for(let[u,f]of d)u&&h.push(C("div",{class:"missing"},Tc(Pn(Nr)),`${u} ${f}`));this.note.replaceChildren(...h)}classes(e,t){this.shown="",this.element.hidden=!1;let n=st[e],r=rr(e),s=r.map((l,c)=>t.reduce((h,d)=>h+(d[c]??0),0)),o=s.reduce((l,c)=>l+c,0),a=n.classes.map((l,c)=>({name:l,code:c})).filter(({code:l})=>l>0||s[0]>0);this.element.replaceChildren(C("div",{class:"legend-title"},C("span",{},Ct(n.name))),C("ul",{class:"types"},...a.map(({name:l,code:c})=>C("li",{class:s[c]?"":"absent",title:oa(e,c)||!1},Tc(Pn(r[c])),C("span",{},l),C("span",{class:"share"},s[c]?Ch(s[c]/o):"–")))))}plain(e){this.element.hidden=e,this.shown!=="plain"&&(this.shown="plain",this.element.replaceChildren(C("ul",{class:"types"},C("li",{},Tc(Pn(Ac)),C("span",{},"side the normal points to")),C("li",{},Tc(Pn(Es)),C("span",{},"other side")))))}histogram(e,t){let{width:n,height:r}=this.plot,s=this.plot.getContext("2d");s.clearRect(0,0,n,r);let o=Math.max(...e.histogram,1),a=r/e.histogram.length;s.fillStyle=t?"rgb(255 255 255 / 38%)":"rgb(20 30 45 / 30%)",e.histogram.forEach((l,c)=>{let h=l?Math.max(2,Math.sqrt(l/o)*n):0;s.fillRect(n-h,r-(c+1)*a,h,a-1)})}},Tc=i=>{let e=C("span",{class:"swatch"});return e.style.background=i,e};function nd(i,e){if(e===i.kind)return i;let t=SS(i);if(!t)return null;let n=i.kind==="nurbs"||$e(i,"basis")==="bernstein",{name:r}=i,s=td(i,"flip");if(e==="tensor")return{kind:e,name:r,points:t,...td(i,"shape"),...td(i,"unchecked_shape"),...n?{basis:"bernstein"}:{},...s};if(e!=="nurbs"||!n)return null;let o=[t.length-1,t[0].length-1];return{kind:e,name:r,degrees:o,knots:o.map(ug),points:t,...s}}function SS(i){let e=t=>$e(i,t);switch(i.kind){case"tensor":return e("points");case"symmetric":{let t=e("points"),n=$e(i,"mirror");return[...t,...t.map(r=>r.map(s=>Vr(s,n))).reverse()]}case"swept":return e("section").map(t=>e("trajectory").map(n=>t.map((r,s)=>r+n[s])));case"swung":{let t=$e(i,"scale");return e("profile").map(([n,r])=>e("trajectory").map(([s,o])=>[t*n*s,t*n*o,r]))}case"ruled":{let t=e("first"),n=e("second");return $e(i,"basis")==="bernstein"&&t.length===n.length?t.map((r,s)=>[r,n[s]]):null}case"nurbs":return MS(i)?e("points"):null;default:return null}}function MS(i){let e=$e(i,"weights")?.flat()??[],t=$e(i,"degrees"),n=$e(i,"knots"),r=$e(i,"trim");return e.every(s=>s===e[0])&&!r?.length&&t.every(s=>s<=63)&&t.every((s,o)=>String(n[o])===String(ug(s)))}var ug=i=>[...Array(i+1).fill(0),...Array(i+1).fill(1)],td=(i,e)=>i[e]===void 0?{}:{[e]:i[e]};var Cc=class{constructor(e){this.store=e;let t=[{label:"Constructions",options:id(n=>n.construction)},{label:"Closed forms",options:id(n=>!n.construction&&!n.fields.points)},{label:"From CAD",options:id(n=>!n.construction&&!!n.fields.points)}];this.kind=$s("Construction",t,n=>{this.become(n)}),this.unit=$s("Unit of length",[{label:"",options:[{value:"",label:"no unit"},...Qo.map(n=>({value:n,label:n}))]}],n=>e.edit({...e.state.model,unit:n})),this.flip=cn("Turn the normal",n=>e.editPatch({...at(e.state),flip:n}),void 0,"The signs of H, κ1, κ2 and S follow the normal"),this.basis=An("Basis",[{value:"trigonometric",label:"Trigonometric",title:"Quintic trigonometric Bézier basis"},{value:"bernstein",label:"Bernstein",title:"The classical basis on the same points, to compare with"}],n=>e.editPatch({...at(e.state),basis:n})),this.locks=["x","y","z"].map((n,r)=>cn(n,s=>{let o=[...e.state.settings.locks];o[r]=s,e.setting({locks:o})},void 0,`Keep ${n} while dragging`)),this.snap=cn("Snap to",n=>e.setting({snap:n}),void 0,"Round coordinates while dragging"),this.step=ei({label:"",name:"Snap step",positive:!0,onChange:n=>e.setting({snapStep:n})}),this.element.append(this.patches,C("div",{class:"stack"},C("label",{class:"row"},C("span",{class:"caption"},"Construction"),this.kind.element),this.about,C("label",{class:"row"},C("span",{class:"caption"},"Unit"),this.unit.element),C("div",{class:"row basis"},C("span",{class:"caption"},"Basis"),this.basis.element),this.flip.element),Vi("Control points",!0,this.points,C("div",{class:"drag-tools"},C("div",{class:"locks",role:"group","aria-label":"Axes kept while dragging"},C("span",{class:"caption"},"Keep"),...this.locks.map(n=>n.element)),C("div",{class:"snap"},this.snap.element,this.step.element)))),e.subscribe((n,r)=>{(n.model!==r.model||n.patch!==r.patch||n.selected!==r.selected||n.settings!==r.settings)&&this.refresh(n)})}store;element=C("aside",{class:"panel left","aria-label":"Model"});patches=C("div",{class:"patches",role:"listbox","aria-label":"Patches"});kind;unit;flip;basis;about=C("p",{class:"hint"});points=C("div",{class:"points"});locks;snap;step;names="";list=[];shownPatch=null;tab="";coordinates=[];form=null;refresh(e){let t=at(e),n=At[t.kind];this.kind.update(t.kind),this.unit.update(e.model.unit),this.flip.update($e(t,"flip")===!0),this.basis.update(String($e(t,"basis")??"")),this.basis.element.parentElement.hidden=!n.fields.basis||!Jn($e(t,"basis")),this.about.textContent=Ct(n.title),e.settings.locks.forEach((s,o)=>this.locks[o].update(s)),this.snap.update(e.settings.snap),this.step.update(e.settings.snapStep),this.patches.hidden=e.model.patches.length<2;let r=JSON.stringify([e.patch,e.model.patches.map(s=>[s.name,s.kind])]);r!==this.names&&this.patches.replaceChildren(...e.model.patches.map((s,o)=>C("button",{type:"button",class:"patch",role:"option","aria-selected":o===e.patch,on:{click:()=>this.store.set({patch:o,selected:null})}},C("span",{},s.name),C("small",{},s.kind.replaceAll("_"," "))))),this.names=r,this.showPoints(e,t)}showPoints(e,t){if(t!==this.shownPatch){try{this.list=Qn(t,Et(t)).filter(p=>!p.mirrored)}catch{this.list=[]}this.shownPatch=t}let n=this.points.parentElement.parentElement;if(n.hidden=!this.list.length,!this.list.length)return;let r=this.list.find(p=>p.id===e.selected?.replace("′","")),s=[...new Set(this.list.map(p=>p.key))];r&&(this.tab=r.key),s.includes(this.tab)||(this.tab=s[0]);let o={patch:t,chosen:r?.id,tab:this.tab};if(o.patch===this.form?.patch&&o.chosen===this.form.chosen&&o.tab===this.form.tab)return;this.form=o;let a=An("Which points",s.map(p=>({value:p,label:Ct(p)})),p=>{this.tab=p,this.store.set({selected:null}),this.showPoints(this.store.state,t)});a.update(this.tab);let l=this.list.filter(p=>p.key===this.tab),c=Math.max(...l.map(p=>p.index.at(-1)))+1,h=C("div",{class:"net",role:"group","aria-label":`${Ct(this.tab)}: choose one`},...l.map((p,v)=>C("button",{type:"button",class:"knob",title:p.label,"aria-label":p.label,"aria-pressed":p===r,tabindex:p===r||!r&&v===0?0:-1,on:{click:()=>this.store.set({selected:p===r?null:p.id})}},p.index.length>1?"":p.index[0])));h.style.setProperty("--columns",String(c)),h.addEventListener("keydown",p=>this.walk(p,l,c));let d=this.points.getRootNode().activeElement,u=d?.classList.contains("knob")??!1,f=this.coordinates.findIndex(p=>p.element.contains(d));this.coordinates=r?this.fields(r):[],this.points.replaceChildren(s.length>1?a.element:"",h,r?C("div",{class:"coordinates"},C("span",{class:"caption"},r.label),...this.coordinates.map(p=>p.element)):C("p",{class:"hint"},`${l.length} points: choose one here, or drag one in the picture`)),u&&h.querySelector('[tabindex="0"]')?.focus(),f>=0&&this.coordinates[f]?.element.querySelector("input")?.focus()}fields(e){let t=at(this.store.state),n=$e(t,e.key);for(let o of e.index)n=n[o];let r=n,s=e.along?["a","b","c","d"]:t.kind==="swung"?e.key==="profile"?["r","z"]:["x","y"]:["x","y","z"];return r.map((o,a)=>{let l=ei({label:C("i",{class:"math"},s[a]),name:`${e.label} ${s[a]}`,onChange:c=>this.store.editPatch(ua(at(this.store.state),e.key,e.index,r.map((h,d)=>d===a?c:h)))});return l.update(o),l})}walk(e,t,n){let r={ArrowRight:1,ArrowLeft:-1,ArrowDown:n,ArrowUp:-n}[e.key];if(!r)return;e.preventDefault(),e.stopPropagation();let s=t.findIndex(a=>a.id===this.store.state.selected),o=t[Math.min(t.length-1,Math.max(0,s+r))];this.store.set({selected:o.id})}async become(e){let{store:t}=this,n=at(t.state),{patch:r,opened:s}=t.state,o=nd(n,e);if(!o){let l=this.element.closest(".studio");await On(l,"Another surface?",[C("p",{},`“${n.name}” cannot be kept exactly as “${fg(e)}”: a new surface to start from would take its place.`)],[["stay","Keep it"],["replace","Start anew"]])==="replace"&&(o={...ya(e).patches[0],name:n.name})}let a=t.state.patch===r&&t.state.opened===s&&at(t.state)===n;if(!o||!a)return this.kind.update(at(t.state).kind);t.set({selected:null}),t.editPatch(o)}};function dg(i,e){let t=at(i.state),n=Qn(t,Et(t)).find(r=>r.id===i.state.selected);n&&i.editPatch(fa(t,n,n.position.map((r,s)=>r+e[s])),`nudge ${n.id}`)}var id=i=>Object.entries(At).filter(([,e])=>i(e)).map(([e])=>({value:e,label:Ct(fg(e))})),fg=i=>i==="nurbs"?"NURBS":i.replaceAll("_"," ");var Rc=class{constructor(e){this.store=e;this.element.append(this.left,this.warning,C("span",{class:"spacer"}),this.right),e.subscribe(t=>{t.message!==this.shown&&this.say(t.message)})}store;element=C("footer",{class:"status"});banner=C("div",{class:"banners"});left=C("span",{});warning=C("span",{class:"warning"});right=C("span",{class:"quiet"});shown=null;timer=0;refresh(e,t){let{unit:n}=e.model;this.left.replaceChildren(...t.surface?["Normal ",Br(t.surface)," ",C("i",{class:"math"},"S"),C("sub",{},"u")," × ",C("i",{class:"math"},"S"),C("sub",{},"v")]:["No surface"],n?` · lengths in ${n}`:" · no unit",t.sharp?` · smallest radius ${rt(t.sharp.radius)}${n?` ${n}`:""} at u = ${rt(t.sharp.u)}, v = ${rt(t.sharp.v)}`:"");let r=t.singular===t.points&&!t.warning?"No point has a tangent plane: this is a curve":"",s=!t.singular||t.singular===t.points?r:`${t.singular} of ${t.points} points singular (grey)`;this.warning.textContent=[s,t.warning].filter(Boolean).join(" · "),this.right.textContent=`${t.side} × ${t.side} points, ${t.cost.toFixed(1)} ms`}offer(e,t,n,r,s){let o=C("div",{class:"banner",role:"alert"},C("span",{},e));return o.append(je(t,t,()=>{o.remove(),n()},"button primary"),je(r,r,()=>{o.remove(),s()})),this.banner.append(o),()=>o.remove()}warn(e){this.store.set({message:{kind:"error",text:e}})}say(e){this.shown=e,clearTimeout(this.timer),this.banner.querySelector(".message")?.remove(),e&&(this.banner.append(C("div",{class:`banner message ${e.kind}`,role:e.kind==="error"?"alert":"status"},C("div",{},e.text,e.lines?.length?C("ul",{},...e.lines.map(t=>C("li",{},t))):null),...(e.actions??[]).map(({label:t,act:n})=>je(t,t,n)),je(yt(vt.close),"Close",()=>this.store.set({message:null}),"tiny"))),e.kind==="note"&&!e.lines&&!e.actions&&(this.timer=window.setTimeout(()=>this.store.set({message:null}),4e3)))}};var Pc=class{element;name;dirty=C("span",{class:"dirty",title:"Not saved"});undo;redo;compare;constructor(e,t,n,r,s,o){this.name=C("input",{class:"name","aria-label":"Name of the model",spellcheck:"false",maxlength:200}),Sa(this.name,()=>{this.name.value=e.state.model.name}),this.name.addEventListener("change",()=>{let c=this.name.value.trim();if(!c)return void(this.name.value=e.state.model.name);let{model:h}=e.state,d=h.patches.length===1?[{...h.patches[0],name:c}]:h.patches;e.edit({...h,name:c,patches:d})}),this.undo=je(yt(vt.undo),"Undo (Ctrl Z)",()=>e.undo(),"button square"),this.redo=je(yt(vt.redo),"Redo (Ctrl Shift Z)",()=>e.redo(),"button square");let a=()=>["Presets",...ga.map(c=>({label:c.name,hint:c.patches[0].kind.replaceAll("_"," "),act:()=>{t.start(c)}})),"Starters",...Object.entries(At).filter(([,c])=>c.construction).map(([c,{title:h}])=>({label:Ct(c),hint:h,act:()=>{t.start(ya(c))}}))];this.compare=An("Compare",[{value:"off",label:"One",title:"The model alone"},{value:"before",label:"Before | now",title:"As last saved or opened, beside the model now"},{value:"sets",label:"Four sets",title:"The four sets of shape parameters of the thesis, on one scale"},{value:"kept",label:"Kept",title:"The model beside those you kept"}],c=>c==="kept"&&!e.state.kept.length?Dh(e):e.set({compare:c}));let l=je("Keep","Keep the model as it is now, to compare with",()=>Dh(e),"button quiet");this.element=C("header",{class:"bar"},o?null:C("span",{class:"brand",title:"quintrig"},wS(),C("span",{},"quintrig")),je(yt(vt.side),"Construction and control points",s,"button square drawer"),this.name,this.dirty,C("div",{class:"group"},Ys(C("span",{},"Models",yt(vt.down)),"Models: presets and starters",a),Ys(C("span",{},yt(vt.open),C("span",{class:"word"},"Open"),yt(vt.down)),"Open a model",()=>t.openItems()),Ys(C("span",{},yt(vt.save),C("span",{class:"word"},"Save"),yt(vt.down)),"Save the model",()=>t.saveItems())),C("div",{class:"group tight"},this.undo,this.redo),C("div",{class:"group tight"},this.compare.element,l),C("span",{class:"spacer"}),C("div",{class:"group tight last"},je(yt(vt.picture),"Save a picture",()=>{t.picture()},"button square"),Ys(yt(vt.export),"Export",()=>t.exportItems(),"button square",()=>t.lookAtFormats()),je(yt(vt.sun),"Light or dark",n,"button square theme"),je(yt(vt.help),"Keys and pointer (?)",r,"button square")))}refresh(e){gr(this.name)||(this.name.value=e.model.name),this.name.style.setProperty("--letters",String(Math.min(30,Math.max(6,this.name.value.length)))),this.dirty.hidden=e.model===e.saved,this.undo.disabled=!e.canUndo,this.redo.disabled=!e.canRedo,this.compare.update(e.compare)}};function wS(){let i=yt("M2 11c3-6 9-1 12-7M2 11c2 3 5 3 6.5 2.2M14 4c.3 3-1.500 7.200-5.500 9.200M5.500 7.700c1 2.500 3 4 5.600 3.700M9.500 6.600c.7 1.900 1.900 3 3.400 3.100");return i.classList.add("mark-icon"),i}function pg(i,e,t,n,r,s,o){let a=i.getContext("2d"),{width:l,height:c}=i,h=Math.max(11,Math.min(l,c)/48);a.fillStyle=a.strokeStyle=o?"#e8edf3":"#1c232c",a.textBaseline="middle",a.font=`600 ${h}px Helvetica, Arial, sans-serif`;let d=r.length?Math.max(...r.map(_=>_.x+_.width)):1;if(s.forEach((_,T)=>{let A=r[T];A&&_&&a.fillText(_,A.x/d*l+h,A.y/d*l+1.4*h)}),!e.legend)return i;let u=r[0]?.pieces[t.patch]?.surface,f=u?`normal ${Br(u)} Su × Sv`:"no surface";a.font=`${.85*h}px Helvetica, Arial, sans-serif`,a.fillText(`${t.model.name} · ${f}${t.model.unit?` · lengths in ${t.model.unit}`:""}`,h,c-1.2*h);let p=st[t.settings.quantity];if(!p)return i;let v=ni(p,t.model.unit),g=`${Ct(p.name)}${p.colour==="classes"?"":` ${p.symbol}`}${v?` (${v})`:""}`,m=l-h,x=a.measureText(g).width;if(a.textAlign="right",a.fillText(g,m,1.4*h),a.textAlign="left",n){let _=2.6*h,T=Math.min(14*h,c*.5),A=m-Math.max(4.6*h,.3*x),y=ir(p);y.forEach((M,D)=>{a.fillStyle=Pn(M),a.fillRect(A,_+T*(1-(D+1)/y.length),h,T/y.length+.6)}),a.fillStyle=o?"#e8edf3":"#1c232c";for(let M=0;M<5;M++)a.fillText(rt(n.low+(n.high-n.low)*M/4,3),A+1.4*h,_+T*(1-M/4));return i}let w=rr(p.key);return p.classes.slice(1).forEach((_,T)=>{let A=(2.9+1.4*T)*h;a.fillStyle=Pn(w[T+1]),a.fillRect(m-h,A-.5*h,h,h),a.fillStyle=o?"#e8edf3":"#1c232c",a.textAlign="right",a.fillText(_,m-1.5*h,A),a.textAlign="left"}),i}var{sameColour:rd,noise:AS}=Be.limits,Ic=48,Lc=new Float32Array(0),mg=new WeakMap;function TS(i,e){let t=mg.get(i);if(t?.version===i.version)return t;let{values:n,repeated:r,covered:s}=i,o=new Float32Array(n.length),a=0,l=0,c=0,h=0;for(let u=0;u<n.length;u++){if(!s[u])continue;let f=n[u];f-f===0?(o[a++]=f,l+=f):r[u]||(h++,f===f&&c++)}let d={version:i.version,sorted:o.subarray(0,a).sort(),sum:l,missing:h,infinite:c,scale:CS(i,e)};return mg.set(i,d),d}function yg(i,e,t){let n=i.map(v=>TS(v,e)),r=n.map(v=>v.sorted).filter(v=>v.length),s=v=>n.reduce((g,m)=>g+v(m),0),o=s(v=>v.sorted.length),a=Math.max(...n.map(v=>v.scale)),l=Math.min(...r.map(v=>v[0])),c=Math.max(...r.map(v=>v.at(-1))),[h,d]=ES(r,o,l,c,e,t,a);d>h||([h,d]=[h-.5*(Math.abs(h)||1),h+.5*(Math.abs(h)||1)]);let u=Array.from({length:Ic+1},(v,g)=>Nc(r,h+(d-h)*g/Ic,g===Ic)),f=u.slice(1).map((v,g)=>v-u[g]),p=o?1/o:0;return{low:h,high:d,below:u[0]*p,above:(o-u[Ic])*p,least:l,most:c,mean:o?s(v=>v.sum)/o:NaN,finite:o,missing:s(v=>v.missing),infinite:s(v=>v.infinite),histogram:f,noise:AS*a}}function ES(i,e,t,n,r,s,o){if(s.range==="fixed")return[s.low,s.high];if(r.key==="shape_index")return[-1,1];if(!e)return r.colour==="diverging"?[-1,1]:[0,1];let a=s.range==="robust",l=s.percentile/100,c=v=>Math.round(v*(e-1));if(r.colour==="diverging"){let v=Math.max(-t,n),g=v;return a&&(g=sd(gg(0,v,c(1-l),m=>Nc(i,m,!0)-Nc(i,-m)),v)),(g<=rd*o||g===0)&&(g=o>0?o:1),[-g,g]}let h=v=>gg(t,n,c(v),g=>Nc(i,g,!0)),d=a?h(l):t,u=a?h(1-l):n,f=.5*(d+u);if(a&&(d=f-sd(f-d,f-t),u=f+sd(u-f,n-f)),d>=0&&d<=.4*u&&(d=0),u>d&&u-d>=Math.max(.02*Math.abs(f),rd*o))return[d,u];let p=Math.abs(f)>rd*o?.5*Math.abs(f):o||1;return[f-p,f+p]}function Nc(i,e,t=!1){let n=0;for(let r of i){let s=0,o=r.length;for(;s<o;){let a=s+o>>1,l=r[a];l<e||t&&l===e?s=a+1:o=a}n+=s}return n}function gg(i,e,t,n){if(n(i)>t)return i;for(;;){let r=Math.fround(.5*i+.5*e);if(r<=i||r>=e)return e;n(r)>t?e=r:i=r}}var sd=(i,e)=>e<=1.5*i?e:i;function CS(i,e){let{size:t,planes:n,stride:r,count:s}=i.grid;if(e.power===0||!(t>0))return 1;if(e.power>0)return t**e.power;Lc.length<s&&(Lc=new Float32Array(s));let o=0;for(let a=0;a<s;a+=7){let l=n[De.curvedness*r+a];i.covered[a]&&l<1/0&&(Lc[o++]=l)}return Math.max(o?RS(Lc.subarray(0,o),.98):0,1/t)**-e.power}function RS(i,e){let t=Math.round(e*(i.length-1)),n=0,r=i.length-1;for(;n<r;){let s=i[n+r>>1],o=n,a=r;for(;o<=a;){for(;i[o]<s;)o++;for(;i[a]>s;)a--;if(o<=a){let l=i[o];i[o++]=i[a],i[a--]=l}}if(t<=a)r=a;else if(t>=o)n=o;else break}return i[t]}var Dc={iso:[-55,26],top:[-90,90],side:[-90,0],back:[0,0],front:[180,0],bottom:[-90,-90]},xg=14*Math.PI/180,od=Math.PI/180;function PS(i,e){let t=i*od,n=e*od;return{right:new B(-Math.sin(t),Math.cos(t),0),up:new B(-Math.sin(n)*Math.cos(t),-Math.sin(n)*Math.sin(t),Math.cos(n)),towards:new B(Math.cos(n)*Math.cos(t),Math.cos(n)*Math.sin(t),Math.sin(n))}}var Vo=class{azimuth=Dc.iso[0];elevation=Dc.iso[1];span=1.1;target=new B;chosen="perspective";straight=!1;moved=!1;perspective=new qt(2*xg/od,1,.01,100);orthographic=new ys;goal=null;from={azimuth:0,elevation:0,span:1,target:new B};get projection(){return this.straight?"orthographic":this.chosen}camera(e){let t=this.projection==="perspective"?this.perspective:this.orthographic,n=this.span/Math.min(1,e),r=n/Math.tan(xg),{right:s,up:o,towards:a}=this.axes();return t.position.copy(this.target).addScaledVector(a,r),t.matrixWorld.copy(new ut().makeBasis(s,o,a)).setPosition(t.position),t.matrixWorld.decompose(t.position,t.quaternion,t.scale),t instanceof qt?(t.aspect=e,t.near=Math.max(r-6,.02*r),t.far=r+12):(t.left=-n*e,t.right=n*e,t.top=n,t.bottom=-n,t.near=r-12,t.far=r+12),t.updateProjectionMatrix(),t.updateMatrixWorld(!0),t}axes(){return PS(this.azimuth,this.elevation)}turn(e,t){this.goal=null,this.moved=!0,this.straight=!1,this.azimuth-=e*.35,this.elevation=Math.max(-90,Math.min(90,this.elevation+t*.35))}pan(e,t,n=1){this.goal=null,this.moved=!0;let{right:r,up:s}=this.axes(),o=2*this.span/Math.min(1,n);this.target.addScaledVector(r,-e*o).addScaledVector(s,t*o)}zoom(e,t=0,n=0,r=1){this.goal=null;let s=this.span;this.span=Math.max(1e-4,Math.min(20,this.span*e));let o=s/this.span-1;this.pan(-t*o,-n*o,r)}go(e,t,n,r,s){if(this.moved=!1,s){this.azimuth=e,this.elevation=t,this.span=n,this.target.copy(r);return}let o=(e-this.azimuth)%360;o>180&&(o-=360),o<-180&&(o+=360),this.from={azimuth:this.azimuth,elevation:this.elevation,span:this.span,target:this.target.clone()},this.goal={azimuth:this.azimuth+o,elevation:t,span:n,target:r.clone(),start:performance.now()}}step(e){if(!this.goal)return!1;let t=Math.min(1,Math.max(0,(e-this.goal.start)/260)),n=1-(1-t)**3,r=(s,o)=>s+(o-s)*n;return this.azimuth=r(this.from.azimuth,this.goal.azimuth),this.elevation=r(this.from.elevation,this.goal.elevation),this.span=r(this.from.span,this.goal.span),this.target.lerpVectors(this.from.target,this.goal.target,n),t>=1&&(this.goal=null),t<1}};var vg=`
out vec3 place;
out vec3 way;
out vec2 parameters;
void main() {
  place = position;
  way = normal;
  parameters = uv;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`,bg=`
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
}`;var IS=1e38,_g=new Map,Fc=class{grid=new $r;material;mesh;values=new Float32Array(0);version=0;covered=new Uint8Array(0);repeated=new Uint8Array(0);places=0;singular=0;box=[];trim;counted=null;buffers=new Map;current=null;constructor(){this.material=new $t({glslVersion:Pi,vertexShader:vg,fragmentShader:bg,side:Rn,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1,uniforms:{mode:{value:0},field:{value:null},colours:{value:null},range:{value:new Ge(-1,1)},contour:{value:0},cells:{value:new Ge(2,2)},front:{value:new B},back:{value:new B},undefinedColour:{value:new B},stripes:{value:0},density:{value:20},light:{value:new B(0,0,1)},curves:{value:0},cut:{value:new lt},clipped:{value:!1},wire:{value:!1},shade:{value:1},towards:{value:new B(0,0,1)},faded:{value:0},face:{value:null},trimmed:{value:!1}}}),this.mesh=new Xt(void 0,this.material),this.mesh.frustumCulled=!1}update(e,t,n,r){let s=this.current=this.prepare(t),{grid:o}=this;o.evaluate(e,t,t),this.cut(e,t);let{planes:a,stride:l,count:c}=o;this.singular=this.places=0,this.repeated.length!==c&&(this.repeated=new Uint8Array(c));let h=[1/0,1/0,1/0],d=[-1/0,-1/0,-1/0],u=s.position,f=(v,g)=>u[3*v]===u[3*g]&&u[3*v+1]===u[3*g+1]&&u[3*v+2]===u[3*g+2];this.repeated.fill(0);for(let v=0;v<c;v++){for(let x=0;x<3;x++){s.position[3*v+x]=(a[(De.point+x)*l+v]-r.centre[x])*r.scale;let w=a[(De.normal+x)*l+v];s.normal[3*v+x]=w===w?w:0;let _=u[3*v+x];_<h[x]&&(h[x]=_),_>d[x]&&(d[x]=_)}if(!this.covered[v])continue;let g=v%t>0&&f(v,v-1)||v>=t&&f(v,v-t);if(this.repeated[v]=g?1:0,g)continue;this.places++;let m=a[De.gaussian*l+v];m!==m&&this.singular++}this.box.splice(0,6,...h,...d),s.geometry.attributes.position.needsUpdate=!0,s.geometry.attributes.normal.needsUpdate=!0,this.mesh.geometry=s.geometry,this.material.uniforms.cells.value.set(t,t),this.paint(n)}cut(e,t){if(this.trim===e.trim&&this.covered.length===t*t)return;this.covered=la(e,this.grid.u,this.grid.v);let n=this.material.uniforms;this.trim!==e.trim&&(n.face.value?.dispose(),n.face.value=e.trim?.length?LS(e):null,n.trimmed.value=n.face.value!==null),this.trim=e.trim}paint(e){let t=this.current;if(this.version++,!t)return;let n=this.material.uniforms,r=st[e];if(n.mode.value=r?r.colour==="classes"?2:1:0,this.values=r?t.values:new Float32Array(0),r){this.grid.quantity(e,t.values,Wr);let s=t.texture.image.data;for(let o=0;o<s.length;o++){let a=t.values[o];s[o]=a-a===0?a:IS}t.texture.needsUpdate=!0,n.field.value=t.texture,n.colours.value=NS(e)}}get counts(){if(this.counted?.version===this.version)return this.counted.counts;let e=[];for(let t=0;t<this.values.length;t++)this.covered[t]&&!this.repeated[t]&&(e[this.values[t]]=(e[this.values[t]]??0)+1);return this.counted={version:this.version,counts:e},e}get position(){return this.current?.position??new Float32Array(0)}get side(){return this.current?this.grid.nu:0}dispose(){for(let e of this.buffers.values())e.geometry.dispose(),e.texture.dispose();this.material.uniforms.face.value?.dispose(),this.material.dispose()}prepare(e){let t=this.buffers.get(e);if(t)return t;if(this.buffers.size>5){let h=this.buffers.keys().next().value;this.buffers.get(h).geometry.dispose(),this.buffers.get(h).texture.dispose(),this.buffers.delete(h)}let n=new sn,r=new Float32Array(3*e*e),s=new Float32Array(3*e*e),o=new Float32Array(2*e*e);for(let h=0,d=0;h<e;h++)for(let u=0;u<e;u++,d+=2)o.set([h/(e-1),u/(e-1)],d);let a=new Uint32Array(6*(e-1)*(e-1));for(let h=0,d=0;h<e-1;h++)for(let u=0;u<e-1;u++){let f=h*e+u;a[d++]=f,a[d++]=f+e,a[d++]=f+e+1,a[d++]=f,a[d++]=f+e+1,a[d++]=f+1}n.setIndex(new _t(a,1)),n.setAttribute("position",new _t(r,3).setUsage(Ms)),n.setAttribute("normal",new _t(s,3).setUsage(Ms)),n.setAttribute("uv",new _t(o,2));let l=new Sr(new Float32Array(e*e),e,e,Eo,gn),c={geometry:n,position:r,normal:s,values:new Float32Array(e*e),texture:l};return this.buffers.set(e,c),c}},Ho=1024;function LS(i){let e=document.createElement("canvas"),[t,n,r,s]=Bi(i);e.width=e.height=Ho;let o=e.getContext("2d");o.fillRect(0,0,Ho,Ho),o.fillStyle="#ffffff",o.beginPath();for(let l of i.trim)l.forEach(([c,h],d)=>{let u=[Ho*(c-t)/(r-t),Ho*(1-(h-n)/(s-n))];d?o.lineTo(...u):o.moveTo(...u)}),o.closePath();o.fill("evenodd");let a=new yo(e);return a.minFilter=a.magFilter=Ft,a.generateMipmaps=!1,a}var Sg=([i,e,t])=>new B(i/255,e/255,t/255);function NS(i){let e=st[i],t=e.colour==="classes"?i:e.colour,n=_g.get(t);if(!n){let r=e.colour==="classes"?rr(i):ir(e);n=new Sr(hg(r),r.length,1,yn,Qt),n.magFilter=n.minFilter=e.colour==="classes"?St:Ft,n.needsUpdate=!0,_g.set(t,n)}return n}var ad=class{mesh=new Fc;overlays=new Mc;patch=null;surface=null;side=0;frame=null;quantity="";lines="";net=""},Uc=class{scene=new uo;pieces=[];x=0;y=0;width=1;height=1;resizePieces(e){for(;this.pieces.length>e;){let t=this.pieces.pop();this.scene.remove(t.mesh.mesh,t.overlays.group),t.mesh.dispose(),t.overlays.dispose()}for(;this.pieces.length<e;){let t=new ad;this.pieces.push(t),this.scene.add(t.mesh.mesh,t.overlays.group)}}};function Mg(i,e,t){let n=-1/0,r=1/0;for(let s=0;s<3;s++){let o=(i[s]-1e-5-e[s])/t[s],a=(i[s+3]+1e-5-e[s])/t[s];n=Math.max(n,Math.min(o,a)||n),r=Math.min(r,Math.max(o,a)||r)}return n<=r}function wg(i,e,t,n,r){let s=1/0,o=0,a=0,[l,c,h]=t,[d,u,f]=n;for(let v=0;v<e-1;v++)for(let g=0;g<e-1;g++){let m=3*(v*e+g);for(let x=0;x<2;x++){let w=x===0?m+3*e:m+3*e+3,_=x===0?m+3*e+3:m+3,T=i[m],A=i[m+1],y=i[m+2],M=i[w]-T,D=i[w+1]-A,I=i[w+2]-y,L=i[_]-T,U=i[_+1]-A,q=i[_+2]-y,R=u*q-f*U,G=f*L-d*q,W=d*U-u*L,O=M*R+D*G+I*W;if(O===0)continue;let ee=l-T,H=c-A,J=h-y,te=(ee*R+H*G+J*W)/O;if(te<-1e-9||te>1+1e-9)continue;let ve=H*I-J*D,Te=J*M-ee*I,$=ee*D-H*M,re=(d*ve+u*Te+f*$)/O;if(re<-1e-9||te+re>1+1e-9)continue;let me=(L*ve+U*Te+q*$)/O;if(me>=s)continue;let Me=(v+(x===0?te+re:te))/(e-1),fe=(g+(x===0?re:te+re))/(e-1);r(l+me*d,c+me*u,h+me*f,Me,fe)&&([s,o,a]=[me,Me,fe])}}if(s===1/0)return null;let p=v=>Math.min(1,Math.max(0,v));return{u:p(o),v:p(a),distance:s}}function Ag(){let i=document.createElement("canvas").getContext("webgl2"),e=i?.getExtension("WEBGL_debug_renderer_info"),t=e?String(i.getParameter(e.UNMASKED_RENDERER_WEBGL)):"";return i?.getExtension("WEBGL_lose_context")?.loseContext(),/swiftshader|llvmpipe|softpipe|software|basic render/i.test(t)}var DS=64;function Tg(i,e,t,n,r,s){let o=i.getContext("2d");o.setTransform(n,0,0,n,0,0),o.clearRect(0,0,i.width,i.height);let a=st[r],l=a?a.colour==="classes"?rr(r):ir(a):[],c=f=>a?f-f!==0?Nr:a.colour==="classes"||!s?l[f]??Nr:l[Math.round(255*Math.min(1,Math.max(0,(f-s.low)/(s.high-s.low))))]:Es,{right:h,up:d,towards:u}=t.axes();for(let f of e){let p=t.span/Math.min(1,f.width/f.height),v=f.height/(2*p),g=[];for(let{mesh:m}of f.pieces){let x=m.side,w=m.position,_=Math.max(1,Math.ceil((x-1)/DS)),T=y=>{let M=[w[3*y]-t.target.x,w[3*y+1]-t.target.y,w[3*y+2]-t.target.z],D=I=>M[0]*I.x+M[1]*I.y+M[2]*I.z;return[f.x+f.width/2+v*D(h),f.y+f.height/2-v*D(d),D(u)]},A=Array.from({length:Math.ceil((x-1)/_)},(y,M)=>M*_);for(let y of A)for(let M of A){let D=Math.min(x-1,y+_),I=Math.min(x-1,M+_),[L,U,q,R]=[T(y*x+M),T(D*x+M),T(D*x+I),T(y*x+I)],G=(y+D>>1)*x+(M+I>>1);if(!m.covered[G])continue;let W=m.grid.planes,O=m.grid.stride,ee=Math.abs(W[3*O+G]*u.x+W[4*O+G]*u.y+W[5*O+G]*u.z);g.push({depth:L[2]+U[2]+q[2]+R[2],corners:[L[0],L[1],U[0],U[1],q[0],q[1],R[0],R[1]],colour:c(m.values[G]??NaN),lit:ee||.5})}}o.save(),o.beginPath(),o.rect(f.x,f.y,f.width,f.height),o.clip();for(let m of g.sort((x,w)=>x.depth-w.depth)){let x=.68+.32*m.lit;o.fillStyle=o.strokeStyle=Pn(m.colour.map(w=>Math.round(w*x))),o.beginPath(),o.moveTo(m.corners[0],m.corners[1]);for(let w=2;w<8;w+=2)o.lineTo(m.corners[w],m.corners[w+1]);o.closePath(),o.fill(),o.stroke()}for(let{overlays:m}of f.pieces)FS(o,m,(x,w,_)=>{let T=[x-t.target.x,w-t.target.y,_-t.target.z],A=y=>T[0]*y.x+T[1]*y.y+T[2]*y.z;return[f.x+f.width/2+v*A(h),f.y+f.height/2-v*A(d)]});o.restore()}}function FS(i,e,t){let{lines:n,points:r}=e.drawn;for(let{ends:s,colour:o,width:a,opacity:l}of n){i.strokeStyle=o,i.lineWidth=a,i.globalAlpha=l,i.beginPath();for(let c=0;c<s.length;c+=6)i.moveTo(...t(s[c],s[c+1],s[c+2])),i.lineTo(...t(s[c+3],s[c+4],s[c+5]));i.stroke()}i.globalAlpha=1,i.lineWidth=1.5,i.strokeStyle="#ffffff";for(let{places:s,tints:o}of r)for(let a=0;3*a<s.length;a++)i.fillStyle=Pn([0,1,2].map(l=>Math.round(255*o[4*a+l]))),i.beginPath(),i.arc(...t(s[3*a],s[3*a+1],s[3*a+2]),o[4*a+3]>1.5?6:4,0,7),i.fill(),i.stroke()}var US=6,Oc=class{constructor(e){this.canvas=e;this.software=Ag();let t=e.getContext("webgl2",{antialias:!this.software,alpha:!0,powerPreference:"high-performance"});this.renderer=t&&new gc({canvas:e,context:t}),this.renderer?.setClearColor(0,0),this.renderer&&(this.renderer.autoClear=!1)}canvas;orbit=new Vo;cells=[];renderer;range=null;quantity="none";width=1;height=1;ratio=1;margin=0;covered=0;software;detail=1;get works(){return this.renderer!==null}resize(e,t,n){this.width=Math.max(1,e),this.height=Math.max(1,t),this.ratio=n,this.renderer?(this.renderer.setPixelRatio(this.pixels),this.renderer.setSize(this.width,this.height,!1)):(this.canvas.width=this.width*n,this.canvas.height=this.height*n),this.arrange()}economy(e){let t=this.software?e?.6:1.5:1;t!==this.detail&&(this.detail=t,this.resize(this.width,this.height,this.ratio))}get pixels(){return this.ratio*this.detail}layout(e,t=0){for(this.margin=t;this.cells.length>e;)this.cells.pop().resizePieces(0);for(;this.cells.length<e;)this.cells.push(new Uc);this.arrange()}arrange(){let e=this.cells.length,t=e>4?3:e>1?2:1,n=Math.ceil(e/t),r=e>1?Math.max(.6*this.width,this.width-this.margin):this.width,s=e>1?this.height-50:this.height;this.cells.forEach((o,a)=>{o.width=r/t,o.height=s/n,o.x=a%t*o.width,o.y=Math.floor(a/t)*o.height;for(let l of o.pieces)l.overlays.resize(o.width*this.pixels,o.height*this.pixels,this.pixels)})}style(e,t,n,r,s){let o=OS(e);this.range=t,this.quantity=e.quantity;let a=Pr(e,r);for(let l of this.cells)l.pieces.forEach((c,h)=>{let d=c.mesh.material.uniforms;ld(d.front.value,Ac),ld(d.back.value,Es),ld(d.undefinedColour.value,Nr),t&&d.range.value.set(t.low,t.high),d.contour.value=t&&e.contours?(t.high-t.low)/10:0,d.stripes.value=["none","zebra","isophotes","reflection","highlight"].indexOf(e.stripes),d.density.value=e.density,d.light.value.copy(o),d.curves.value=e.wireframe?30:e.curves?10:0,d.cut.value.set(...a),d.clipped.value=e.section&&e.clip,d.wire.value=e.wireframe,d.shade.value=e.stripes==="none"?1:.6,d.faded.value=(l.pieces.length>1&&h!==s,0),c.overlays.theme(n),c.overlays.resize(l.width*this.pixels,l.height*this.pixels,this.pixels)});this.orbit.chosen=this.works?e.projection:"orthographic"}draw(){let{renderer:e}=this;if(!e)return Tg(this.canvas,this.cells,this.orbit,this.ratio,this.quantity,this.range);e.setScissorTest(!1),e.setViewport(0,0,this.width,this.height),e.clear(),e.setScissorTest(!0);let t=this.orbit.axes().towards;for(let n of this.cells){let r=this.height-n.y-n.height;e.setViewport(n.x,r,n.width,n.height),e.setScissor(n.x,r,n.width,n.height);for(let s of n.pieces)s.mesh.material.uniforms.towards.value.copy(t);e.render(n.scene,this.orbit.camera(n.width/n.height))}}zoomAt(e,t,n){let r=this.cells[Math.max(0,this.cellAt(t,n))];this.orbit.zoom(e,(t-r.x)/r.height-.5*r.width/r.height,(n-r.y)/r.height-.5,r.width/r.height)}pan(e,t){let{width:n,height:r}=this.cells[0];this.orbit.pan(e/r,t/r,n/r)}cellAt(e,t){return this.cells.findIndex(n=>e>=n.x&&e<n.x+n.width&&t>=n.y&&t<n.y+n.height)}ray(e,t,n){let r=this.cells[e],s=this.orbit.camera(r.width/r.height),o=(t-r.x)/r.width*2-1,a=1-(n-r.y)/r.height*2,l=new B(o,a,-1).unproject(s),h=new B(o,a,1).unproject(s).sub(l).normalize();return{origin:[l.x,l.y,l.z],direction:[h.x,h.y,h.z]}}project(e,t){let n=this.cells[e],r=new B(t[0],t[1],t[2]).project(this.orbit.camera(n.width/n.height));return{x:n.x+(r.x+1)*.5*n.width,y:n.y+(1-r.y)*.5*n.height,depth:r.z}}pick(e,t,n,r){let s=this.cellAt(e,t);if(s<0)return null;let{origin:o,direction:a}=this.ray(s,e,t),[l,c,h,d]=Pr(n,r),u=n.section&&n.clip,f=null;return this.cells[s].pieces.forEach((p,v)=>{let g=p.mesh.side,{surface:m}=p;if(!m||g<2||!Mg(p.mesh.box,o,a))return;let[x,w,_,T]=Bi(m),A=(L,U)=>[x+(_-x)*L,w+(T-w)*U],y=(L,U,q,R,G)=>(!u||l*L+c*U+h*q<=d)&&qr(m,...A(R,G)),M=wg(p.mesh.position,g,o,a,y);if(!M||f&&M.distance>=f.distance)return;let[D,I]=A(M.u,M.v);f={u:D,v:I,distance:M.distance,cell:s,piece:v}}),f}hides(e,t,n,r){let s=this.project(e,t),o=this.pick(s.x,s.y,n,r);if(!o)return!1;let{origin:a}=this.ray(e,s.x,s.y);return o.distance<Math.hypot(...t.map((l,c)=>l-a[c]))-.03}view(e,t,n,r){this.orbit.straight=e!=="iso",this.fit(t,n,r,Dc[e])}fit(e,t,n,[r,s]=[this.orbit.azimuth,this.orbit.elevation]){let o=this.cells[0];if(!o)return;let a=new Vo;a.azimuth=r,a.elevation=s,a.chosen=this.orbit.projection;let{right:l,up:c}=a.axes(),h=o.width/o.height,d=this.cells.length>1,u=o.width<300?10:24,f=!d&&n>.3*o.width,p=1-2*(d||f?u:n+u)/o.width,v=-1+2*(d?u:62+Math.min(this.covered,.5*o.height))/o.height,g=-1+2*u/o.width,m=1-2*(f?Math.min(.3*o.height,150):d?u+22:u)/o.height,x=new B;for(let w=0;w<6;w++){let _=a.camera(h),[T,A,y,M]=[1/0,-1/0,1/0,-1/0],D=(L,U,q)=>{x.set(L,U,q).project(_),T=Math.min(T,x.x),A=Math.max(A,x.x),y=Math.min(y,x.y),M=Math.max(M,x.y)};for(let{pieces:L}of this.cells)for(let{mesh:U,overlays:q}of L){let R=U.position,G=3*Math.max(1,Math.floor(U.side/24));for(let W=0;W+2<R.length;W+=G)U.covered[W/3]&&kS(e,R[W],R[W+1],R[W+2])&&D(R[W],R[W+1],R[W+2]);for(let[W,O,ee]of q.netPoints)Math.hypot(W,O,ee)<US&&D(W,O,ee)}if(!(A>=T))break;let I=a.span/Math.min(1,h);a.target.addScaledVector(l,I*h*(.5*(T+A)-.5*(g+p))).addScaledVector(c,I*(.5*(y+M)-.5*(v+m))),a.span=Math.min(20,Math.max(.02,a.span*Math.max((A-T)/(p-g),(M-y)/(m-v))))}this.orbit.go(r,s,a.span,a.target,t)}async picture(e,t,n){let r={width:this.width,height:this.height,ratio:this.ratio,detail:this.detail};this.detail=this.software&&Math.max(e,t)<=4096?2:1,this.renderer?.setClearColor(n?new Ve().setStyle(n,"srgb-linear"):0,n?1:0),this.resize(e,t,1),this.draw();let s=document.createElement("canvas");return s.width=e,s.height=t,s.getContext("2d").drawImage(this.canvas,0,0,e,t),this.renderer?.setClearColor(0,0),this.detail=r.detail,this.resize(r.width,r.height,r.ratio),this.draw(),s}finish(){let e=this.renderer?.getContext();e?.readPixels(0,0,1,1,e.RGBA,e.UNSIGNED_BYTE,new Uint8Array(4))}dispose(){this.layout(0),this.renderer?.dispose()}};function OS(i){let e=i.lightAzimuth*Math.PI/180,t=i.lightElevation*Math.PI/180;return new B(Math.cos(t)*Math.cos(e),Math.cos(t)*Math.sin(e),Math.sin(t))}var kS=({half:[i,e,t]},n,r,s)=>Math.abs(n)<=i+.04&&Math.abs(r)<=e+.04&&Math.abs(s)<=t+.04;function ld(i,e){i.copy(Sg(e))}var Eg="quintrig:draft:",BS=3,kc=class{constructor(e){this.place=e;let t=Math.random().toString(36).slice(2,10);this.key=`${Eg}${e}:${t}`,navigator.locks?.request(this.key,()=>new Promise(()=>{})).catch(()=>{})}place;key;offers=[];watch(e,t){let n=0,r=()=>this.keep(e.state);e.subscribe((s,o)=>{s.opened!==o.opened&&this.offer(e,t,s.source),!(s.model===o.model&&s.saved===o.saved&&s.source===o.source)&&(clearTimeout(n),s.model===s.saved?r():n=window.setTimeout(r,400))}),window.addEventListener("pagehide",r),this.offer(e,t)}async offer(e,t,n){for(let a of this.offers.splice(0))a();let{opened:r}=e.state,s=await this.left();if(e.state.opened!==r)return;let o=n===void 0?s:s.filter(a=>n&&a.source?.name===n.name);this.offers=o.slice(0,BS).map(a=>{let l=new Date(a.when).toLocaleString([],{dateStyle:"medium",timeStyle:"short"}),c=a.source?` (${a.source.name})`:"";return t.offer(`Unsaved work on “${a.model.name}”${c} from ${l} was kept.`,"Restore it",()=>{e.resume(a),this.keep(e.state)&&cd(a.key)},"Discard",()=>cd(a.key))})}keep({model:e,saved:t,source:n}){try{return e===t?localStorage.removeItem(this.key):localStorage.setItem(this.key,JSON.stringify({when:Date.now(),model:wn(e),saved:wn(t),source:n})),!0}catch{return!1}}async left(){let e=new Set((await navigator.locks?.query().catch(()=>null))?.held?.map(n=>n.name)??[]),t=[];for(let n of zS())if(!(!n.startsWith(`${Eg}${this.place}:`)||n===this.key||e.has(n)))try{let{when:r,model:s,saved:o,source:a}=JSON.parse(localStorage.getItem(n)),l=Tt(s);t.push({key:n,when:r,model:l,saved:o?Tt(o):{...l},source:a??null})}catch{cd(n)}return t.sort((n,r)=>r.when-n.when)}};function cd(i){localStorage.removeItem(i)}function zS(){try{return Object.keys(localStorage)}catch{return[]}}var VS=16*2**20,HS=15e3,Bc=class{constructor(e,t,n,r,s,o){this.store=e;this.host=t;this.root=n;this.draw=r;this.size=s;this.ends=o;this.look()}store;host;root;draw;size;ends;known=[];formats=[];asked="";lost=!1;async look(){try{this.known=await this.host.list()}catch{this.known=[]}}async lookAtFormats(){let{state:e}=this.store,t=at(e).name,n=`${t}
${yi(e.model)}`;if(n===this.asked)return!1;this.asked=n;try{this.formats=await this.host.formats(e.model,t)}catch{this.asked=""}return!0}openItems(){let e=this.known.map(t=>({label:t,act:()=>{this.load(t)}}));return[{label:"From this computer …",hint:"or drop a file on the picture",act:()=>this.choose()},...e.length?["In the folder",...e]:[]]}saveItems(){let{model:e,source:t}=this.store.state;return[...this.host.kind==="live"?[{label:t?`Save ${t.name}`:"Save …",hint:"Ctrl S",act:()=>{this.save()}},{label:"Save as …",act:()=>{this.saveAs()}}]:[],{label:"Download TOML",act:()=>Zn(`${Kn(e.name)}.toml`,yi(e))},{label:"Download JSON",act:()=>Zn(`${Kn(e.name)}.json`,`${JSON.stringify(wn(e),null,1)}
`,"application/json")}]}exportItems(){return this.host.kind!=="live"?[{label:"Exports need the live studio",hint:"quintrig view MODEL",disabled:!0,act:()=>{}}]:this.formats.length?[...new Set(this.formats.map(t=>t.family))].flatMap(t=>[t,...this.formats.filter(n=>n.family===t).map(n=>({label:n.label,hint:n.suffix,...n.reason?{disabled:!0,reason:n.reason}:{},act:()=>{this.guard(()=>this.export(n))}}))]):[{label:"Asking what this model can be written as …",disabled:!0,act:()=>{}}]}async export(e){let{model:t,settings:n}=this.store.state,r=at(this.store.state).name,s=this.ends(),o=st[n.quantity],a=o?`${o.name}${s?`, ${rt(s[0])} to ${rt(s[1])} ${aa(o,t.unit)}`:""}`.trim():"none",l=e.takes?await rp(this.root(),e.label,t.unit,e.takes==="tolerance"?"":a):{tolerance:null};if(!l)return;this.store.set({message:{kind:"note",text:`Writing ${e.label} …`,lines:[]}});let c={model:t,patch:r,colour:o?n.quantity:"",low:s?.[0]??null,high:s?.[1]??null,...l},{name:h,notes:d}=await this.host.export(c,e);this.store.set({message:{kind:"note",text:`Exported ${h}`,lines:d}})}async start(e){await this.leave()&&this.store.open(e,null)}async load(e){await this.guard(async()=>{let{model:t,source:n}=await this.host.load(e);await this.leave()&&this.store.open(t,n)})}choose(){let e=C("input",{type:"file",accept:".toml,.json"});e.addEventListener("change",()=>{let t=e.files?.[0];t&&this.take(t)}),e.click()}async take(e){await this.guard(async()=>{if(e.size>VS)throw new Error(`${e.name}: expected at most 16 MB, found ${Math.round(e.size/2**20)} MB; is this a model?`);let t=await this.host.read(e.name,await e.text());await this.leave()&&this.store.open(t,null)})}receive(e){e.addEventListener("dragover",t=>{t.preventDefault(),e.classList.add("receiving")}),e.addEventListener("dragleave",()=>e.classList.remove("receiving")),e.addEventListener("drop",t=>{t.preventDefault(),e.classList.remove("receiving");let n=t.dataTransfer?.files[0];n&&this.take(n)})}async save(){let{source:e}=this.store.state;e?await this.write(e.name,e.tag):await this.saveAs()}async saveAs(){let e=this.host.kind==="live"?await ip(this.root(),"Save as",`${Kn(this.store.state.model.name)}.toml`):this.store.state.model.name;e&&await this.write(e,"")}async picture(){let[e,t]=this.size(),n=await sp(this.root(),2*e,2*t);if(!n)return;(await this.draw(n)).toBlob(s=>s&&Zn(`${Kn(this.store.state.model.name)}.png`,s),"image/png")}async write(e,t){let{model:n,opened:r}=this.store.state;try{let s=await this.host.save(e,n,t);this.store.written(r,n,s),this.store.set({message:{kind:"note",text:s?`Saved ${s.name}`:"Downloaded"}}),this.look()}catch(s){if(!(s instanceof Ws))return this.fail(s);let o=await On(this.root(),"The file is another one now",[C("p",{},s.message)],[["other","Save under another name"],["over","Overwrite it"],["cancel","Cancel"]]);o==="over"&&await this.write(e,null),o==="other"&&await this.saveAs()}}async leave(){let{model:e,saved:t}=this.store.state;return e===t?!0:await On(this.root(),"Leave this model?",[C("p",{},`The changes to “${e.name}” are not saved.`)],[["stay","Go on working"],["leave","Leave them"]])==="leave"}async guard(e){try{await e()}catch(t){this.fail(t)}}watch(){let e=()=>{this.connected()};window.addEventListener("focus",e),setInterval(()=>document.visibilityState==="visible"&&e(),HS)}async connected(){try{await this.host.list(),this.lost&&this.store.set({message:{kind:"note",text:"Connected to the studio's server again"}}),this.lost&&this.look(),this.lost=!1}catch(e){e instanceof ur&&!this.lost&&this.fail(e)}}fail(e){let{message:t}=e;if(!(e instanceof ur))return this.store.set({message:{kind:"error",text:t}});this.lost=!0;let{source:n}=this.store.state;this.store.set({message:{kind:"error",text:t,lines:[`To reconnect: ${e.stopped?`run “quintrig view ${n?.name??"MODEL"}” in a terminal, `:""}open the address that quintrig view printed in this browser, then try again here.`,"Or download the model, and open it in the new tab."],actions:[{label:"Download the model",act:()=>this.download()},{label:"Try again",act:()=>{this.again()}}]}})}async again(){this.store.set({message:null}),await this.guard(async()=>{await this.host.list()}),await this.connected()}download(){let{model:e,source:t}=this.store.state;Zn(t?.name.replace(/\.\w+$/,".toml")??`${Kn(e.name)}.toml`,yi(e))}};var GS={1:"iso",2:"top",3:"side",4:"back",5:"front",6:"bottom"},WS={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]},qS="input:not([type=checkbox], [type=range], [type=radio]), select, textarea, [contenteditable]",XS="input[type=range], input[type=radio], [role=radio], .knob";function Cg(i,e){let{store:t,stage:n}=e,{settings:r}=t.state,s=i.composedPath()[0];if(!(s instanceof HTMLElement))return!1;if(i.ctrlKey||i.metaKey){let l=i.key.toLowerCase();if(l==="s")e.files.save();else if(l==="o")e.files.choose();else{if(gr(s))return!1;if(l==="z"&&i.shiftKey)t.redo();else if(l==="z")t.undo();else if(l==="y")t.redo();else return!1}return!0}if(i.altKey||s.matches(qS))return!1;let o=GS[i.key],a=WS[i.key];if(a&&s.matches(XS))return!1;if(o)e.view(o);else if(a)$S(a,i.shiftKey,e);else if(i.key==="+"||i.key==="=")n.orbit.zoom(.85);else if(i.key==="-")n.orbit.zoom(1/.85);else switch(i.key.length===1?i.key.toLowerCase():i.key){case"p":{let l=n.orbit.projection==="perspective"?"orthographic":"perspective";n.orbit.straight=!1,t.setting({projection:l});break}case"f":e.fit();break;case"n":t.setting({net:!r.net});break;case"i":t.setting({curves:!r.curves});break;case"w":t.setting({wireframe:!r.wireframe});break;case"z":t.setting({stripes:r.stripes==="zebra"?"none":"zebra"});break;case"c":{let l=["off","before","sets","kept"];t.set({compare:l[(l.indexOf(t.state.compare)+1)%l.length]});break}case"[":case"]":YS(t,i.key==="]"?1:-1);break;case"Escape":t.set({selected:null,message:null});break;case"?":e.help();break;case"Enter":{if(!s.matches("canvas"))return!1;let l=n.cells[0],c=n.pick(l.x+l.width/2,l.y+l.height/2,r,e.frame());c&&t.set({pins:[...t.state.pins,{patch:c.piece,u:Math.round(c.u*1e4)/1e4,v:Math.round(c.v*1e4)/1e4}]});break}default:return!1}return e.redraw(),!0}function $S([i,e],t,n){let{store:r,stage:s}=n;if(!r.state.selected){t?s.orbit.pan(-.03*i,.03*e):s.orbit.turn(-12*i,-12*e);return}let o=s.orbit.axes(),a=i?o.right:o.up,l=i||e,c=[a.x,a.y,a.z],h=c.map(Math.abs).indexOf(Math.max(...c.map(Math.abs))),d=r.state.settings.snapStep*(t?10:1)*l*Math.sign(c[h]);dg(r,[0,1,2].map(u=>u===h?d:0)),r.settle()}function YS(i,e){let t=at(i.state),n=Qn(t,Et(t)).filter(s=>!s.mirrored);if(!n.length)return;let r=n.findIndex(s=>s.id===i.state.selected);i.set({selected:n[(r+e+n.length)%n.length].id})}function Rg(i,e){let{planes:t,stride:n,count:r,nu:s,nv:o}=e.grid,a=0,l=-1;for(let f=0;f<r;f++){let p=Math.abs(t[De.mean*n+f])+t[De.radius*n+f];p>a&&p<1/0&&e.covered[f]&&(a=p,l=f)}if(l<0||!(a*e.grid.size>1e-9))return null;let c=e.grid.u[Math.floor(l/o)],h=e.grid.v[l%o],d=[],u=f=>Math.min(1,Math.max(0,f));for(let f=.5/(s-1);f>1e-6;f*=.5){let p=[-1,0,1].map(x=>x*f),v=p.map(x=>u(c+x)),g=p.map(x=>u(h+x)),m=Fn(i,v,g,!1,["k1","k2","point"]);for(let x=0;x<9;x++){if(!qr(i,v[Math.floor(x/3)],g[x%3]))continue;let w=Math.max(Math.abs(m.k1[x]),Math.abs(m.k2[x]));(w>=a||x===4&&!d.length)&&(a=Math.max(a,w),c=v[Math.floor(x/3)],h=g[x%3],d=Array.from(m.point.subarray(3*x,3*x+3)))}}return{u:c,v:h,point:d,radius:1/a}}var JS=9,ZS=20,KS=40,zc=36,jS=[1,.7,.5,.35,.25],Vc=class{constructor(e,t){this.stage=e;this.fail=t}stage;fail;cost=0;side=0;coarse=75;drawable=1/0;get meshes(){return this.stage.cells.flatMap(e=>e.pieces.map(t=>t.mesh))}evaluate(e,{settings:t,moving:n},r){this.side=this.points(t,n,e.length);let s=performance.now(),o=0;e.forEach(({model:l},c)=>{let h=this.stage.cells[c];h.resizePieces(l.patches.length),l.patches.forEach((d,u)=>o+=this.piece(h.pieces[u],d,t,r))});let a=performance.now()-s;return o&&this.pace(a,o,t.resolution),a}waited(e){e>KS?this.drawable=Math.max(zc,.75*this.side):e<ZS&&(this.drawable*=1.06)}decorate(e,t,n){let r=t.settings.combs==="off"?0:lg(this.meshes,t.settings,n);e.forEach(({editable:s},o)=>this.overlay(this.stage.cells[o],t,n,s,r))}sharpest(){return this.stage.cells.flatMap(({pieces:e},t)=>{let r=e.map(s=>s.surface?Rg(s.surface,s.mesh):null).filter(s=>s!==null).sort((s,o)=>s.radius-o.radius)[0];return r?[{cell:t,at:r}]:[]})}piece(e,t,n,r){let{side:s}=this,o=e.patch===t&&e.side===s&&e.frame===r;if(o&&e.quantity!==n.quantity&&e.mesh.paint(n.quantity),e.quantity=n.quantity,o)return 0;try{e.patch!==t&&(e.surface=Et(t))}catch(a){return this.fail(a.message),0}return e.patch=t,e.side=s,e.frame=r,e.lines=e.net="",e.mesh.update(e.surface,s,n.quantity,r),s*s}overlay(e,t,n,r,s){e.pieces.forEach((o,a)=>{if(!o.surface||!o.patch)return;let l=QS(t.settings,s),c=t.settings.net,h=c&&r&&a===t.patch;o.lines!==l&&o.overlays.update(o.mesh,t.settings,n,s),o.lines=l;let d=`${c} ${h} ${h?t.selected:""} ${t.moving}`;o.net!==d&&(o.net=d,o.overlays.net(c?Vf(o.patch,o.surface):[],h?Qn(o.patch,o.surface):[],t.selected,n),o.overlays.edge(t.moving?[]:eM(o.patch,o.surface),n))})}points(e,t,n){if(t){let r=Math.min(this.coarse,this.drawable),s=jS.map(o=>Math.max(zc,Math.round(o*e.resolution)));return Math.min(e.resolution,s.find(o=>o<=r)??zc)}return st[e.quantity]?.colour==="classes"&&n===1?2*e.resolution:e.resolution}pace(e,t,n){this.cost=e;let r=e/t,s=this.stage.cells.reduce((a,l)=>a+l.pieces.length,0),o=Math.sqrt(JS/r/Math.max(1,s));this.coarse=o>=n?n:Math.max(zc,Math.min(n,Math.round(o)))}},QS=(i,e)=>JSON.stringify([e,i.directions,i.normals,i.combs,i.zeroK,i.zeroH,i.section,i.section&&[i.sectionAzimuth,i.sectionTilt,i.sectionAt]]),Pg=new WeakMap;function eM(i,e){if(i.kind!=="developable")return[];let t=Pg.get(e);if(t)return t;let n=Jo(e).map(({u:r,v:s})=>{let{point:o}=Fn(e,r,s,!0,["point"]);return r.map((a,l)=>Array.from(o.subarray(3*l,3*l+3)))});return Pg.set(e,n),n}var Hc=class{constructor(e,t){this.stage=e;this.redraw=t}stage;redraw;down=new Map;busy=!1;touch(e,t){return this.down.set(e,t),this.busy||=this.down.size>1,this.busy}move(e,t){if(!this.busy||!this.down.has(e))return!1;let n=this.span();this.down.set(e,t);let r=this.span();return n&&r&&(this.stage.zoomAt(n.apart/r.apart,n.middle.x,n.middle.y),this.stage.pan(r.middle.x-n.middle.x,r.middle.y-n.middle.y),this.redraw()),!0}lift(e){let t=this.down.delete(e)&&this.busy;return this.down.size||(this.busy=!1),t}span(){let[e,t]=[...this.down.values()];return!e||!t?null:{apart:Math.max(8,Math.hypot(e.x-t.x,e.y-t.y)),middle:{x:.5*(e.x+t.x),y:.5*(e.y+t.y)}}}};var Gc=11,tM=24;function Ig(i,e){let{store:t,stage:n}=e,r=null,s=!1,o=new Hc(n,()=>e.redraw()),a=m=>{let x=i.getBoundingClientRect();return{x:m.clientX-x.left,y:m.clientY-x.top}},l=()=>da(at(t.state)),c=(m,x,w)=>{let _=n.cellAt(m,x),T=t.state.settings.net&&l().find(y=>y.id===t.state.selected);if(!T||T.along||_!==va(t.state,n.cells.length))return null;let A=ep(ba(n,_,rn(e.frame(),T.position),h(T)),m,x,w);return A&&{handle:T,axes:A.axes}},h=m=>m.free.map((x,w)=>x&&!t.state.settings.locks[w]),d=(m,x,w)=>{let _=n.cellAt(m,x),{settings:T}=t.state;if(_<0||!T.section)return null;let A=Ir(T,e.frame()),y=M=>{let D=n.project(_,A[M]);return Math.hypot(D.x-m,D.y-x)};return y("tilt")<w?"tilt":y("move")<w?"move":null},u=(m,x,w)=>{let _=n.cellAt(m,x);if(_<0||!t.state.settings.net||!e.editable(_))return null;let T=null,A=w;for(let y of l()){let M=n.project(_,rn(e.frame(),y.position)),D=Math.hypot(M.x-m,M.y-x)-(y.id===t.state.selected?2:0);D<A&&(A=D,T=y)}return T};i.addEventListener("pointerdown",m=>{let{x,y:w}=a(m),_=m.pointerType==="touch",T=m.button!==0||m.shiftKey,A=_?tM:Gc;if(iM(i,m.pointerId),i.focus({preventScroll:!0,focusVisible:!1}),m.preventDefault(),_&&o.touch(m.pointerId,{x,y:w}))return r=null,t.settle();let y=T?null:d(x,w,A),M=T||y?null:u(x,w,A),D=T||y||M?null:c(x,w,.6*A),I=M??D?.handle??null,L=n.cellAt(x,w);r={kind:T?"pan":y?"section":I?"move":"turn",cell:L,handle:I,grip:y,axes:D?.axes??null,settings:t.state.settings,from:L<0?null:n.ray(L,x,w),x,y:w,far:0},I&&t.set({selected:I.id,hover:null})}),i.addEventListener("pointermove",m=>{let{x,y:w}=a(m);if(o.move(m.pointerId,{x,y:w}))return;if(!r){if(i.classList.toggle("grab",u(x,w,Gc)!==null||d(x,w,Gc)!==null||c(x,w,.6*Gc)!==null),s||m.pointerType==="touch")return;s=!0,requestAnimationFrame(()=>{s=!1,r||p(x,w)});return}let _=x-r.x,T=w-r.y;r.far+=Math.abs(_)+Math.abs(T),r.kind==="turn"?n.orbit.turn(_,T):r.kind==="pan"?n.pan(_,T):r.kind==="section"?v(r,x,w):r.far>2&&g(r,x,w,m.altKey),r.x=x,r.y=w,(r.kind==="turn"||r.kind==="pan")&&e.redraw()});let f=m=>{if(o.lift(m.pointerId)||!r)return;let x=r;if(r=null,t.settle(),m.type==="pointercancel"||x.far>4||x.kind!=="turn"||m.button!==0)return;let w=n.pick(x.x,x.y,t.state.settings,e.frame());if(w){let _=w.piece===t.state.patch?t.state.selected:null;t.set({hover:null,patch:w.piece,selected:_,pins:[...t.state.pins,{patch:w.piece,u:Wc(w.u),v:Wc(w.v)}]})}else t.set({selected:null})};i.addEventListener("pointerup",f),i.addEventListener("pointercancel",f),i.addEventListener("pointerleave",()=>{!r&&t.state.hover&&t.set({hover:null})}),i.addEventListener("contextmenu",m=>m.preventDefault()),i.addEventListener("dblclick",()=>{e.fit()}),i.addEventListener("wheel",m=>{if(!e.ownsWheel()&&!m.ctrlKey)return;m.preventDefault();let{x,y:w}=a(m);n.zoomAt(Math.exp(Math.max(-60,Math.min(60,m.deltaY*(m.deltaMode?16:1)))*.0022),x,w),e.redraw()},{passive:!1});function p(m,x){let w=n.pick(m,x,t.state.settings,e.frame());w?t.set({hover:{patch:w.piece,u:Wc(w.u),v:Wc(w.v),x:m,y:x,cell:w.cell}}):t.state.hover&&t.set({hover:null})}function v({grip:m,settings:x,from:w,cell:_},T,A){let y=e.frame(),M=Ir(x,y)[m],D=n.ray(_,T,A),I=m==="move"?ca(M,Ts(x),w,D):Rf(Math.hypot(...M),D,M);t.setting(tg(m,I,x,y))}function g({handle:m,from:x,cell:w,axes:_},T,A,y){if(!m||!x||!l().some(H=>H.id===m.id))return;let{settings:M}=t.state,D=e.frame(),I=rn(D,m.position),L=n.ray(w,T,A),{towards:U}=n.orbit.axes(),q=_?[0,1,2].map(H=>_.includes(H)):h(m),R=[U.x,U.y,U.z],G=m.along?{line:m.along}:Pf(q,y?R:m.plane,R),W=jf(D,If(G,I,x,L)),O=M.snap?M.snapStep:10**Math.floor(Math.log10(Th(n,w,I)/D.scale)),ee=m.along?nM(m.along,W,O):Lf(G,m.position,W,O,M.snap);t.editPatch(fa(at(t.state),m,ee),`drag ${m.id}`)}}function nM(i,e,t){let n=s=>s.reduce((o,a,l)=>o+a*i[l],0),r=(-n(e)-Math.round(-n(e)/t)*t)/n(i);return e.map((s,o)=>s+r*i[o])}var Wc=i=>Math.round(i*1e4)/1e4,Lg=()=>matchMedia("(prefers-reduced-motion: reduce)").matches;function iM(i,e){try{i.setPointerCapture(e)}catch{}}function Ng(i,e){let t=at(i);if(e&&zr(e).size===0)return"A single point: it has no size, no tangent plane and no curvature";if(an(t).some(s=>s<gi[0]||s>gi[1]))return"Shape parameters outside [−4, 1]: the convex-hull property is lost";if(t.trim?.length)return"A trimmed face: meshes and CAD files take the whole of its surface";if(t.kind!=="developable"||i.moving||!e)return"";let n=Jo(e);return n.length?`The edge of regression (magenta) lies inside the strip for u = ${n.map(({u:s})=>`${s[0].toFixed(3)} to ${s.at(-1).toFixed(3)}`).join(", ")}: the surface is singular there`:""}var Dg=160,Dr=class{constructor(e,t,n){this.container=e;this.host=t;let r={...Wf(),...n.quantity?{quantity:n.quantity}:{}};this.store=new ma({model:n.model,saved:n.model,source:n.source,patch:0,selected:null,settings:r,compare:"off",kept:[],pins:[],hover:null,canUndo:!1,canRedo:!1,moving:!1,message:null,opened:1});let{store:s}=this;this.stage=new Oc(this.canvas),this.painter=new Vc(this.stage,l=>this.status.warn(l)),this.files=new Bc(s,t,()=>this.root,l=>this.picture(l),()=>[this.centre.clientWidth,this.centre.clientHeight],()=>this.range&&[this.range.low,this.range.high]),this.bar=new Pc(s,this.files,()=>this.switchTheme(),()=>{Ih(this.root)},()=>this.root.classList.toggle("with-left"),t.kind!=="live"),this.model=new Cc(s),this.inspector=new wc(s),this.probe=new wa(s,()=>this.plan()),this.status=new Rc(s),this.hud=new Aa(s,this.stage,{fit:()=>this.fit(),view:l=>this.view(l)}),this.centre.append(this.hud.element,this.legend.element),this.root=C("div",{class:`studio ${t.kind}`},this.bar.element,this.model.element,C("main",{class:"centre"},this.status.banner,this.centre,this.probe.element),this.inspector.element,this.status.element),e.append(this.root),this.drafts=new kc(t.place),Ig(this.canvas,{store:s,stage:this.stage,frame:()=>this.frame,fit:()=>this.fit(),editable:l=>xa(s.state)[l]?.editable??!1,redraw:()=>this.plan(),ownsWheel:()=>t.kind==="live"||this.canvas.matches(":focus")}),(t.kind==="live"?document:this.root).addEventListener("keydown",l=>{!(l instanceof KeyboardEvent)||this.root.querySelector("dialog[open]")||Cg(l,{store:s,stage:this.stage,files:this.files,frame:()=>this.frame,fit:()=>this.fit(),view:c=>this.view(c),redraw:()=>this.plan(),help:()=>{Ih(this.root)}})&&l.preventDefault()}),this.files.receive(this.root),this.canvas.addEventListener("webglcontextrestored",()=>this.plan(!0)),new ResizeObserver(()=>{this.resize(),this.hurry()}).observe(this.centre),new ResizeObserver(()=>{this.stage.covered=Math.max(0,this.probe.element.offsetHeight-(this.root.querySelector(".centre").clientHeight-this.centre.clientHeight)),this.centre.style.setProperty("--covered",`${this.stage.covered}px`)}).observe(this.probe.element),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>this.plan(!0)),s.subscribe((l,c)=>this.changed(l,c,n)),this.stage.works||this.status.warn("This browser has no WebGL: you see still pictures. Everything else works."),this.resize(),this.plan(!0),t.kind!=="notebook"&&this.drafts.watch(s,this.status),t.kind==="live"&&this.files.watch()}container;host;store;root;stage;canvas=C("canvas",{class:"view",tabindex:0,role:"application","aria-label":"The surface. Arrow keys turn it; ? lists all keys."});centre=C("div",{class:"picture"},this.canvas);legend=new Ec;hud;bar;inspector;model;probe;status;files;drafts;frame=Zf;range=null;sharp=[];painter;surfaces=0;planned=0;shownAt=0;settling=0;dark=!1;stale=!0;refit=!0;fitAfter=!1;changed(e,t,n){e.model!==t.model&&(n.onModel?.(e.model),(e.model.patches.some((s,o)=>s.kind!==t.model.patches[o]?.kind)||e.model.patches.length!==t.model.patches.length)&&(this.refit=!0)),e.opened!==t.opened&&(this.refit=!0);let r=t.compare!==e.compare;e.hover!==t.hover&&e.model===t.model&&e.settings===t.settings&&this.hud.refresh(e,this.frame,this.sharp),(e.model!==t.model||e.settings!==t.settings||e.patch!==t.patch||r||e.kept!==t.kept||e.saved!==t.saved||e.moving!==t.moving||e.selected!==t.selected)&&this.plan(!0),(e.message!==t.message||e.pins!==t.pins)&&this.plan()}plan(e=!1){if(this.stale||=e,this.planned)return;let t=performance.now();this.planned=requestAnimationFrame(n=>{this.planned=0,this.store.state.moving&&this.painter.waited(performance.now()-t),this.show(n)})}hurry(){this.planned&&(cancelAnimationFrame(this.planned),this.planned=0,this.show(performance.now()))}show(e){let t=this.store.state.moving||e-this.shownAt<Dg;this.shownAt=e,this.stage.economy(t),clearTimeout(this.settling),t&&this.stage.software&&(this.settling=window.setTimeout(()=>this.plan(),Dg+40));let n=this.stage.orbit.step(e),r=performance.now();this.surfaces=0,this.stale&&(this.stale=!1,this.work());let s=performance.now();this.stage.draw(),this.hud.refresh(this.store.state,this.frame,this.sharp),this.root.dispatchEvent(new CustomEvent("drawn",{detail:{start:r,surfaces:this.surfaces,evaluated:s-r,drawn:performance.now()-s}})),n&&this.plan()}work(){let{state:e}=this.store,{settings:t}=e;this.dark=t.theme==="dark"||t.theme==="auto"&&this.darkAround(),this.root.dataset.theme=this.dark?"dark":"light";let n=xa(this.store.state);this.stage.cells.length!==n.length&&(this.fitAfter=!0),this.stage.layout(n.length,this.margin()),this.refit&&this.reframe(n),this.surfaces=this.painter.evaluate(n,e,this.frame);let{meshes:r}=this.painter,s=st[t.quantity];this.range=s&&s.colour!=="classes"?yg(r,s,t):null,s?this.range?this.legend.real(s.key,this.range,e.model.unit,this.dark):this.legend.classes(s.key,r.map(a=>a.counts)):this.legend.plain(t.stripes!=="none"),this.stage.style(t,this.range,this.dark,this.frame,e.patch),this.painter.decorate(n,e,this.frame),this.fitAfter&&this.stage.fit(this.frame,!0,this.margin()),this.fitAfter=!1,this.sharp=t.minRadius&&!e.moving?this.painter.sharpest():[],this.bar.refresh(e),this.inspector.refresh(e,this.dark),this.model.refresh(e),this.hud.labels(n.map(a=>a.label),e);let o=this.stage.cells[0]?.pieces[e.patch]?.surface??null;this.status.refresh(e,{side:this.painter.side,cost:this.painter.cost,singular:r.reduce((a,l)=>a+l.singular,0),points:r.reduce((a,l)=>a+l.places,0),sharp:this.sharp[0]?.at??null,surface:o,warning:Ng(e,o)})}reframe(e){this.refit=!1;let t=Jf(e);t&&(this.frame=Kf(t.low,t.high),this.inspector.sectionBox(t),this.store.setting({sectionAt:0,snapStep:10**Math.round(Math.log10(Math.max(2/this.frame.scale,1e-30)/100))}),this.fitAfter=!0)}margin(){return this.legend.element.offsetWidth+10}view(e){this.stage.view(e,this.frame,Lg(),this.margin()),this.plan()}fit(){this.refit=!0,this.plan(!0)}resize(){let{clientWidth:e,clientHeight:t}=this.centre;!e||!t||(this.stage.resize(e,t,Math.min(2,devicePixelRatio||1)),this.fitAfter||=!this.stage.orbit.moved,this.plan(!0))}darkAround(){return this.host.kind==="notebook"&&document.body.dataset.jpThemeLight?document.body.dataset.jpThemeLight==="false":matchMedia("(prefers-color-scheme: dark)").matches&&(this.host.kind==="live"||getComputedStyle(document.documentElement).colorScheme.includes("dark"))}switchTheme(){this.store.setting({theme:this.dark?"light":"dark"})}async picture(e){let t=getComputedStyle(this.root),n=e.background==="white"?"#ffffff":e.background==="theme"?t.getPropertyValue("--ground-flat").trim():null,r=await this.stage.picture(e.width,e.height,n),{state:s}=this.store;return pg(r,e,s,this.range,this.stage.cells,xa(this.store.state).map(o=>o.label),this.dark&&e.background==="theme")}locate(e){let{state:t}=this.store,n=t.model.patches[t.patch],r=Ir(t.settings,this.frame),s=Qn(n,Et(n)).find(l=>l.id===e);if(!s&&e!=="move"&&e!=="tilt")return null;let o=this.stage.project(0,s?rn(this.frame,s.position):r[e]),a=this.canvas.getBoundingClientRect();return{x:a.left+o.x,y:a.top+o.y}}receive(e){this.store.open(e,null)}dispose(){cancelAnimationFrame(this.planned),clearTimeout(this.settling),this.stage.dispose(),this.container.replaceChildren()}};function qc(i){let{model:e,saved:t}=i.state;if(e.patches.every(hr))return;let n={...e,patches:e.patches.map(r=>hr(r)?r:{...r})};i.set({model:n,saved:t===e?n:t})}var Fg=`/* One sheet for the whole studio, inside a shadow root. Lengths in px; colours as variables, one set a theme. */
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
`;function Go(i){let e=i.shadowRoot??i.attachShadow({mode:"open"}),t=new CSSStyleSheet;t.replaceSync(Fg),e.adoptedStyleSheets=[t];let n=document.createElement("div");return n.className="place",e.replaceChildren(n),n}function Wo(i,e){return Object.assign(i,{studio:e}).studio}var sM=60,hd=240,Ug=4e3;function oM(i){let e=new Map;return(t,n)=>{e.size||setTimeout(()=>{for(let[r,s]of e)i.set(r,s());e.clear(),i.save_changes()},sM),e.set(t,n)}}function aM(i,e){let t=null;return e("msg:custom",n=>{let{built:r}=n??{};r&&t?.(r)}),n=>new Promise(r=>{t=r,i.send?.({build:n})})}function Og({model:i,el:e}){let t=oM(i),n=[],r=(m,x)=>{n.push([m,x]),i.on(m,x)},s=(m,x)=>r(`change:${m}`,x),o=i.get("brought")??{};lr(o),zs(o.built??[]);let a=null,l=jo(aM(i,r),()=>a&&qc(a.store)),c=m=>JSON.stringify(wn(m)),h=()=>String(i.get("quantity")),d="",u=Wo(e,new Dr(Go(e),new Gr("notebook","notebook"),{model:Tt(i.get("model")),source:null,quantity:h(),onModel(m){let x=c(m);x!==d&&(d=x,t("model",()=>JSON.parse(d)))}}));a=u;let{store:f}=u;d=c(f.state.model),s("model",()=>{let m=Tt(i.get("model")),x=c(m);x!==d&&(d=x,f.edit(m))}),f.subscribe(({settings:{quantity:m}},x)=>{m!==x.settings.quantity&&m!==h()&&t("quantity",()=>f.state.settings.quantity)}),s("quantity",()=>{let m=h(),{settings:x}=f.state;m!==x.quantity&&(m==="none"||st[m])&&f.setting({quantity:m,range:x.range==="fixed"?"robust":x.range})}),Object.assign(e.style,{resize:"vertical",overflow:"hidden",minHeight:`${hd}px`,maxHeight:`${Ug}px`});let p=()=>Math.min(Ug,Math.max(hd,Math.round(parseFloat(e.style.height)||hd))),v=()=>{e.style.height=`${Number(i.get("height"))}px`};v(),s("height",v);let g=new ResizeObserver(()=>{p()!==i.get("height")&&t("height",p)});return g.observe(e),()=>{for(let[m,x]of n)i.off(m,x);l(),g.disconnect(),u.dispose()}}function lM(i,e){lr(e.installed??{});let t=new Gr("embedded",e.place??location.pathname);return Wo(i,new Dr(Go(i),t,{model:Tt(e.model),source:null,...e.quantity?{quantity:e.quantity}:{}}))}async function cM(i,e){lr(JSON.parse(document.getElementById("quintrig-installed")?.textContent??"{}"));let t=new ia(e),n=null;jo(h=>t.build(h),()=>n&&qc(n.store)),location.search&&history.replaceState(null,"",location.pathname);let r=await cf(t),s=await fetch("api/model"),{model:o,source:a}=r??(s.ok?xh(await s.json()):{model:ga[0],source:null}),l=n=new Dr(Go(i),t,{model:o,source:a});if(!r&&!s.ok&&s.status!==404){let{error:h}=await s.json().catch(()=>({}));l.store.set({message:{kind:"error",text:h??`the server answered ${s.status}`}})}let c=()=>{let{model:h,saved:d}=l.store.state;document.title=`${h===d?"":"● "}${h.name} – quintrig`};return l.store.subscribe(c),lf(t,l.store),c(),Wo(i,l)}var GP={render:Og};if(typeof document<"u"){let i=document.querySelector("[data-quintrig]");i?.dataset.quintrig==="live"&&cM(i,i.dataset.place??"").catch(e=>i.textContent=String(e));for(let e of document.querySelectorAll("[data-quintrig=embedded]")){let t=document.getElementById(e.dataset.model??"")?.textContent??"null";lM(e,JSON.parse(t))}}export{Yo as BASES,rh as BUILDERS,Kd as FAMILIES,At as KINDS,jn as QUANTITIES,st as QUANTITY,Fn as analyse,ra as besl,Et as build,nd as converted,GP as default,lM as embed,Tt as fromDict,gh as fromToml,ks as functionsOf,lr as install,cM as live,vh as pointType,bh as shapeClass,wn as toDict};
