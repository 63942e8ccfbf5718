/* SPDX-License-Identifier: Apache-2.0
 *
 * The RenderMan Interface as calls from C (RI 3.2, appendix A), by Candela.
 *
 * RiBegin(NULL) renders what is called up to RiEnd, each world at its RiWorldEnd. RiBegin("x.rib")
 * writes it down as RIB, RiBegin("x.rib.gz") packed by gzip, RiBegin("|command") into a command.
 *
 * Calls with parameters come in two forms: RiSphere(1, -1, 1, 360, "Cs", colors, RI_NULL), and
 * RiSphereV() with their number and arrays of tokens and of pointers to values. Floats and colours
 * are RtFloats, integers RtInts, strings RtStrings; how many of them a call reads follows from the
 * token's declaration, by RiDeclare or as part of the token, and from the primitive.
 *
 * The RenderMan (R) Interface Procedures and Protocol are:
 * Copyright 1988, 1989, 2000, Pixar. All Rights Reserved. RenderMan (R) is a registered trademark
 * of Pixar. Candela is compatible with the RenderMan Interface and is neither made nor endorsed by
 * Pixar.
 */
#ifndef CANDELA_RI_H
#define CANDELA_RI_H

#ifdef __cplusplus
extern "C" {
#endif
#ifdef __GNUC__
#pragma GCC visibility push(default)
#endif

#define RI_VERSION 32

typedef short RtBoolean;
typedef int RtInt;
typedef float RtFloat;
typedef const char *RtToken;
typedef const char *RtString;
typedef void *RtPointer;
#define RtVoid void
typedef RtFloat RtColor[3];
typedef RtFloat RtPoint[3];
typedef RtFloat RtVector[3];
typedef RtFloat RtNormal[3];
typedef RtFloat RtHpoint[4];
typedef RtFloat RtMatrix[4][4];
typedef RtFloat RtBasis[4][4];
typedef RtFloat RtBound[6];

typedef RtFloat (*RtFilterFunc)(RtFloat x, RtFloat y, RtFloat xWidth, RtFloat yWidth);
typedef RtVoid (*RtErrorHandler)(RtInt code, RtInt severity, char *message);
typedef RtVoid (*RtProcSubdivFunc)(RtPointer data, RtFloat detail);
typedef RtVoid (*RtProcFreeFunc)(RtPointer data);

typedef RtVoid (*RtArchiveCallback)(RtToken type, char *format, ...);

typedef RtPointer RtObjectHandle;
typedef RtPointer RtLightHandle;
typedef RtPointer RtContextHandle;

#define RI_FALSE 0
#define RI_TRUE 1
#define RI_INFINITY ((RtFloat)1.0e38)
#define RI_EPSILON ((RtFloat)1.0e-10)
#define RI_NULL ((RtToken)0)

#define RI_FRAMEBUFFER "framebuffer"
#define RI_FILE "file"
#define RI_RGB "rgb"
#define RI_RGBA "rgba"
#define RI_RGBZ "rgbz"
#define RI_RGBAZ "rgbaz"
#define RI_A "a"
#define RI_Z "z"
#define RI_AZ "az"
#define RI_PERSPECTIVE "perspective"
#define RI_ORTHOGRAPHIC "orthographic"
#define RI_HIDDEN "hidden"
#define RI_PAINT "paint"
#define RI_CONSTANT "constant"
#define RI_SMOOTH "smooth"
#define RI_FLATNESS "flatness"
#define RI_FOV "fov"
#define RI_AMBIENTLIGHT "ambientlight"
#define RI_POINTLIGHT "pointlight"
#define RI_DISTANTLIGHT "distantlight"
#define RI_SPOTLIGHT "spotlight"
#define RI_INTENSITY "intensity"
#define RI_LIGHTCOLOR "lightcolor"
#define RI_FROM "from"
#define RI_TO "to"
#define RI_CONEANGLE "coneangle"
#define RI_CONEDELTAANGLE "conedeltaangle"
#define RI_BEAMDISTRIBUTION "beamdistribution"
#define RI_MATTE "matte"
#define RI_METAL "metal"
#define RI_SHINYMETAL "shinymetal"
#define RI_PLASTIC "plastic"
#define RI_PAINTEDPLASTIC "paintedplastic"
#define RI_KA "Ka"
#define RI_KD "Kd"
#define RI_KS "Ks"
#define RI_ROUGHNESS "roughness"
#define RI_KR "Kr"
#define RI_TEXTURENAME "texturename"
#define RI_SPECULARCOLOR "specularcolor"
#define RI_DEPTHCUE "depthcue"
#define RI_FOG "fog"
#define RI_BUMPY "bumpy"
#define RI_MINDISTANCE "mindistance"
#define RI_MAXDISTANCE "maxdistance"
#define RI_BACKGROUND "background"
#define RI_DISTANCE "distance"
#define RI_AMPLITUDE "amplitude"
#define RI_RASTER "raster"
#define RI_SCREEN "screen"
#define RI_CAMERA "camera"
#define RI_WORLD "world"
#define RI_OBJECT "object"
#define RI_INSIDE "inside"
#define RI_OUTSIDE "outside"
#define RI_LH "lh"
#define RI_RH "rh"
#define RI_P "P"
#define RI_PZ "Pz"
#define RI_PW "Pw"
#define RI_N "N"
#define RI_NP "Np"
#define RI_CS "Cs"
#define RI_OS "Os"
#define RI_S "s"
#define RI_T "t"
#define RI_ST "st"
#define RI_WIDTH "width"
#define RI_CONSTANTWIDTH "constantwidth"
#define RI_BILINEAR "bilinear"
#define RI_BICUBIC "bicubic"
#define RI_LINEAR "linear"
#define RI_CUBIC "cubic"
#define RI_PRIMITIVE "primitive"
#define RI_INTERSECTION "intersection"
#define RI_UNION "union"
#define RI_DIFFERENCE "difference"
#define RI_PERIODIC "periodic"
#define RI_NONPERIODIC "nonperiodic"
#define RI_CLAMP "clamp"
#define RI_BLACK "black"
#define RI_IGNORE "ignore"
#define RI_PRINT "print"
#define RI_ABORT "abort"
#define RI_HANDLER "handler"
#define RI_ORIGIN "origin"
#define RI_IDENTIFIER "identifier"
#define RI_NAME "name"
#define RI_COMMENT "comment"
#define RI_STRUCTURE "structure"
#define RI_VERBATIM "verbatim"
#define RI_CATMULLCLARK "catmull-clark"
#define RI_HOLE "hole"
#define RI_CREASE "crease"
#define RI_CORNER "corner"
#define RI_INTERPOLATEBOUNDARY "interpolateboundary"
#define RI_ATTRIBUTES "attributes"

/* Steps of the bases below. */
#define RI_BEZIERSTEP ((RtInt)3)
#define RI_BSPLINESTEP ((RtInt)1)
#define RI_CATMULLROMSTEP ((RtInt)1)
#define RI_HERMITESTEP ((RtInt)2)
#define RI_POWERSTEP ((RtInt)4)
extern RtBasis RiBezierBasis, RiBSplineBasis, RiCatmullRomBasis, RiHermiteBasis, RiPowerBasis;

/* The context */
RtVoid RiBegin(RtToken name);
RtVoid RiEnd(void);
RtContextHandle RiGetContext(void);
RtVoid RiContext(RtContextHandle context);
RtToken RiDeclare(RtToken name, RtToken declaration);

/* Errors. Handlers are given RIE_CONSISTENCY where no better code is known. */
extern RtInt RiLastError;
RtVoid RiErrorHandler(RtErrorHandler handler);
RtVoid RiErrorIgnore(RtInt code, RtInt severity, char *message);
RtVoid RiErrorPrint(RtInt code, RtInt severity, char *message);
RtVoid RiErrorAbort(RtInt code, RtInt severity, char *message);
#define RIE_NOERROR 0
#define RIE_NOMEM 1
#define RIE_SYSTEM 2
#define RIE_NOFILE 3
#define RIE_BADFILE 4
#define RIE_VERSION 5
#define RIE_INCAPABLE 11
#define RIE_UNIMPLEMENT 12
#define RIE_LIMIT 13
#define RIE_BUG 14
#define RIE_NOTSTARTED 23
#define RIE_NESTING 24
#define RIE_NOTOPTIONS 25
#define RIE_NOTATTRIBS 26
#define RIE_NOTPRIMS 27
#define RIE_ILLSTATE 28
#define RIE_BADMOTION 29
#define RIE_BADSOLID 30
#define RIE_BADTOKEN 41
#define RIE_RANGE 42
#define RIE_CONSISTENCY 43
#define RIE_BADHANDLE 44
#define RIE_NOSHADER 45
#define RIE_MISSINGDATA 46
#define RIE_SYNTAX 47
#define RIE_MATH 61
#define RIE_INFO 0
#define RIE_WARNING 1
#define RIE_ERROR 2
#define RIE_SEVERE 3

/* Filters of RiPixelFilter */
RtFloat RiBoxFilter(RtFloat x, RtFloat y, RtFloat xWidth, RtFloat yWidth);
RtFloat RiTriangleFilter(RtFloat x, RtFloat y, RtFloat xWidth, RtFloat yWidth);
RtFloat RiCatmullRomFilter(RtFloat x, RtFloat y, RtFloat xWidth, RtFloat yWidth);
RtFloat RiGaussianFilter(RtFloat x, RtFloat y, RtFloat xWidth, RtFloat yWidth);
RtFloat RiSincFilter(RtFloat x, RtFloat y, RtFloat xWidth, RtFloat yWidth);

/* What gives a handle back, archives, bases and procedurals */
RtObjectHandle RiObjectBegin(void);
RtLightHandle RiLightSource(RtToken name, ...);
RtLightHandle RiLightSourceV(RtToken name, RtInt n, RtToken tokens[], RtPointer values[]);
RtLightHandle RiAreaLightSource(RtToken name, ...);
RtLightHandle RiAreaLightSourceV(RtToken name, RtInt n, RtToken tokens[], RtPointer values[]);
RtVoid RiMotionBegin(RtInt n, ...);
RtToken RiArchiveBegin(RtToken name, ...);
RtToken RiArchiveBeginV(RtToken name, RtInt n, RtToken tokens[], RtPointer values[]);
/* "comment", "structure" or "verbatim" (RIB), with a format as printf() has it. */
RtVoid RiArchiveRecord(RtToken type, RtToken format, ...);
/* The callback hears the comments of the archive (not of those that it reads, nor of
 * RiArchiveBegin): "comment" or "structure", "%s" and what stands behind the # or ##. */
RtVoid RiReadArchive(RtToken name, RtArchiveCallback callback, ...);
RtVoid RiReadArchiveV(RtToken name, RtArchiveCallback callback, RtInt n, RtToken tokens[],
                      RtPointer values[]);
RtVoid RiBasis(RtBasis uBasis, RtInt uStep, RtBasis vBasis, RtInt vStep);
/* A function of one's own is called at once, in an attribute block, and then its data freed. */
RtVoid RiProcedural(RtPointer data, const RtBound bound, RtProcSubdivFunc subdivide,
                    RtProcFreeFunc release);
RtVoid RiProcDelayedReadArchive(RtPointer data, RtFloat detail);
RtVoid RiProcRunProgram(RtPointer data, RtFloat detail);
RtVoid RiProcDynamicLoad(RtPointer data, RtFloat detail);
RtVoid RiProcFree(RtPointer data);

/* Blocks */
RtVoid RiFrameBegin(RtInt number);
RtVoid RiFrameEnd(void);
RtVoid RiWorldBegin(void);
RtVoid RiWorldEnd(void);
RtVoid RiAttributeBegin(void);
RtVoid RiAttributeEnd(void);
RtVoid RiTransformBegin(void);
RtVoid RiTransformEnd(void);
RtVoid RiSolidBegin(RtToken operation);
RtVoid RiSolidEnd(void);
RtVoid RiResourceBegin(void);
RtVoid RiResourceEnd(void);
RtVoid RiResource(RtToken handle, RtToken type, ...);
RtVoid RiResourceV(RtToken handle, RtToken type, RtInt n, RtToken tokens[], RtPointer values[]);
RtVoid RiObjectEnd(void);
RtVoid RiObjectInstance(RtObjectHandle handle);
RtVoid RiMotionBeginV(RtInt n, const RtFloat times[]);
RtVoid RiMotionEnd(void);
RtVoid RiArchiveEnd(void);
RtVoid RiIfBegin(RtToken expression, ...);
RtVoid RiIfBeginV(RtToken expression, RtInt n, RtToken tokens[], RtPointer values[]);
RtVoid RiElseIf(RtToken expression, ...);
RtVoid RiElseIfV(RtToken expression, RtInt n, RtToken tokens[], RtPointer values[]);
RtVoid RiElse(void);
RtVoid RiIfEnd(void);

/* Options */
RtVoid RiFormat(RtInt xResolution, RtInt yResolution, RtFloat pixelAspectRatio);
RtVoid RiFrameAspectRatio(RtFloat ratio);
RtVoid RiScreenWindow(RtFloat left, RtFloat right, RtFloat bottom, RtFloat top);
RtVoid RiCropWindow(RtFloat xMin, RtFloat xMax, RtFloat yMin, RtFloat yMax);
RtVoid RiProjection(RtToken name, ...);
RtVoid RiProjectionV(RtToken name, RtInt n, RtToken tokens[], RtPointer values[]);
RtVoid RiClipping(RtFloat hither, RtFloat yon);
RtVoid RiClippingPlane(RtFloat x, RtFloat y, RtFloat z, RtFloat nx, RtFloat ny, RtFloat nz);
RtVoid RiDepthOfField(RtFloat fStop, RtFloat focalLength, RtFloat focalDistance);
RtVoid RiShutter(RtFloat opening, RtFloat closing);
RtVoid RiPixelVariance(RtFloat variation);
RtVoid RiPixelSamples(RtFloat x, RtFloat y);
RtVoid RiPixelFilter(RtFilterFunc filter, RtFloat xWidth, RtFloat yWidth);
RtVoid RiExposure(RtFloat gain, RtFloat gamma);
RtVoid RiImager(RtToken name, ...);
RtVoid RiImagerV(RtToken name, RtInt n, RtToken tokens[], RtPointer values[]);
RtVoid RiQuantize(RtToken type, RtInt one, RtInt minimum, RtInt maximum, RtFloat ditherAmplitude);
RtVoid RiDisplay(RtToken name, RtToken type, RtToken mode, ...);
RtVoid RiDisplayV(RtToken name, RtToken type, RtToken mode, RtInt n, RtToken tokens[],
                  RtPointer values[]);
RtVoid RiDisplayChannel(RtToken channel, ...);
RtVoid RiDisplayChannelV(RtToken channel, RtInt n, RtToken tokens[], RtPointer values[]);
RtVoid RiHider(RtToken type, ...);
RtVoid RiHiderV(RtToken type, RtInt n, RtToken tokens[], RtPointer values[]);
RtVoid RiColorSamples(RtInt n, const RtFloat nRGB[], const RtFloat RGBn[]);
RtVoid RiRelativeDetail(RtFloat detail);
RtVoid RiOption(RtToken name, ...);
RtVoid RiOptionV(RtToken name, RtInt n, RtToken tokens[], RtPointer values[]);

/* Attributes */
RtVoid RiAttribute(RtToken name, ...);
RtVoid RiAttributeV(RtToken name, RtInt n, RtToken tokens[], RtPointer values[]);
RtVoid RiColor(const RtColor color);
RtVoid RiOpacity(const RtColor color);
RtVoid RiTextureCoordinates(RtFloat s1, RtFloat t1, RtFloat s2, RtFloat t2, RtFloat s3, RtFloat t3,
                            RtFloat s4, RtFloat t4);
RtVoid RiIlluminate(RtLightHandle light, RtBoolean on);
RtVoid RiSurface(RtToken name, ...);
RtVoid RiSurfaceV(RtToken name, RtInt n, RtToken tokens[], RtPointer values[]);
RtVoid RiDisplacement(RtToken name, ...);
RtVoid RiDisplacementV(RtToken name, RtInt n, RtToken tokens[], RtPointer values[]);
RtVoid RiAtmosphere(RtToken name, ...);
RtVoid RiAtmosphereV(RtToken name, RtInt n, RtToken tokens[], RtPointer values[]);
RtVoid RiInterior(RtToken name, ...);
RtVoid RiInteriorV(RtToken name, RtInt n, RtToken tokens[], RtPointer values[]);
RtVoid RiExterior(RtToken name, ...);
RtVoid RiExteriorV(RtToken name, RtInt n, RtToken tokens[], RtPointer values[]);
RtVoid RiDeformation(RtToken name, ...);
RtVoid RiDeformationV(RtToken name, RtInt n, RtToken tokens[], RtPointer values[]);
RtVoid RiShadingRate(RtFloat size);
RtVoid RiShadingInterpolation(RtToken type);
RtVoid RiMatte(RtBoolean on);
RtVoid RiBound(const RtBound bound);
RtVoid RiDetail(const RtBound bound);
RtVoid RiDetailRange(RtFloat minVisible, RtFloat lowerTransition, RtFloat upperTransition,
                     RtFloat maxVisible);
RtVoid RiGeometricApproximation(RtToken type, RtFloat value);
RtVoid RiGeometricRepresentation(RtToken type);
RtVoid RiOrientation(RtToken orientation);
RtVoid RiReverseOrientation(void);
RtVoid RiSides(RtInt sides);
RtVoid RiTrimCurve(RtInt loops, const RtInt curves[], const RtInt orders[], const RtFloat knots[],
                   const RtFloat minima[], const RtFloat maxima[], const RtInt points[],
                   const RtFloat u[], const RtFloat v[], const RtFloat w[]);

/* Transformations */
RtVoid RiIdentity(void);
RtVoid RiTransform(RtMatrix matrix);
RtVoid RiConcatTransform(RtMatrix matrix);
RtVoid RiPerspective(RtFloat fieldOfView);
RtVoid RiTranslate(RtFloat dx, RtFloat dy, RtFloat dz);
RtVoid RiRotate(RtFloat angle, RtFloat dx, RtFloat dy, RtFloat dz);
RtVoid RiScale(RtFloat sx, RtFloat sy, RtFloat sz);
RtVoid RiSkew(RtFloat angle, RtFloat dx1, RtFloat dy1, RtFloat dz1, RtFloat dx2, RtFloat dy2,
              RtFloat dz2);
RtVoid RiCoordinateSystem(RtToken name);
RtVoid RiScopedCoordinateSystem(RtToken name);
RtVoid RiCoordSysTransform(RtToken name);
/* In place. NULL, and the points as they were, if one of the systems is not known ("camera",
 * "world" in a world, those that have been named, "current") or RIB is written. */
RtPoint *RiTransformPoints(RtToken fromSpace, RtToken toSpace, RtInt n, RtPoint points[]);

/* Geometric primitives */
RtVoid RiSphere(RtFloat radius, RtFloat zMin, RtFloat zMax, RtFloat thetaMax, ...);
RtVoid RiSphereV(RtFloat radius, RtFloat zMin, RtFloat zMax, RtFloat thetaMax, RtInt n,
                 RtToken tokens[], RtPointer values[]);
RtVoid RiCone(RtFloat height, RtFloat radius, RtFloat thetaMax, ...);
RtVoid RiConeV(RtFloat height, RtFloat radius, RtFloat thetaMax, RtInt n, RtToken tokens[],
               RtPointer values[]);
RtVoid RiCylinder(RtFloat radius, RtFloat zMin, RtFloat zMax, RtFloat thetaMax, ...);
RtVoid RiCylinderV(RtFloat radius, RtFloat zMin, RtFloat zMax, RtFloat thetaMax, RtInt n,
                   RtToken tokens[], RtPointer values[]);
RtVoid RiHyperboloid(const RtPoint point1, const RtPoint point2, RtFloat thetaMax, ...);
RtVoid RiHyperboloidV(const RtPoint point1, const RtPoint point2, RtFloat thetaMax, RtInt n,
                      RtToken tokens[], RtPointer values[]);
RtVoid RiParaboloid(RtFloat rMax, RtFloat zMin, RtFloat zMax, RtFloat thetaMax, ...);
RtVoid RiParaboloidV(RtFloat rMax, RtFloat zMin, RtFloat zMax, RtFloat thetaMax, RtInt n,
                     RtToken tokens[], RtPointer values[]);
RtVoid RiDisk(RtFloat height, RtFloat radius, RtFloat thetaMax, ...);
RtVoid RiDiskV(RtFloat height, RtFloat radius, RtFloat thetaMax, RtInt n, RtToken tokens[],
               RtPointer values[]);
RtVoid RiTorus(RtFloat majorRadius, RtFloat minorRadius, RtFloat phiMin, RtFloat phiMax,
               RtFloat thetaMax, ...);
RtVoid RiTorusV(RtFloat majorRadius, RtFloat minorRadius, RtFloat phiMin, RtFloat phiMax,
                RtFloat thetaMax, RtInt n, RtToken tokens[], RtPointer values[]);
RtVoid RiPolygon(RtInt vertices, ...);
RtVoid RiPolygonV(RtInt vertices, RtInt n, RtToken tokens[], RtPointer values[]);
RtVoid RiGeneralPolygon(RtInt loops, const RtInt vertexCounts[], ...);
RtVoid RiGeneralPolygonV(RtInt loops, const RtInt vertexCounts[], RtInt n, RtToken tokens[],
                         RtPointer values[]);
RtVoid RiPointsPolygons(RtInt polygons, const RtInt vertexCounts[], const RtInt vertices[], ...);
RtVoid RiPointsPolygonsV(RtInt polygons, const RtInt vertexCounts[], const RtInt vertices[],
                         RtInt n, RtToken tokens[], RtPointer values[]);
RtVoid RiPointsGeneralPolygons(RtInt polygons, const RtInt loopCounts[], const RtInt vertexCounts[],
                               const RtInt vertices[], ...);
RtVoid RiPointsGeneralPolygonsV(RtInt polygons, const RtInt loopCounts[],
                                const RtInt vertexCounts[], const RtInt vertices[], RtInt n,
                                RtToken tokens[], RtPointer values[]);
RtVoid RiPatch(RtToken type, ...);
RtVoid RiPatchV(RtToken type, RtInt n, RtToken tokens[], RtPointer values[]);
RtVoid RiPatchMesh(RtToken type, RtInt uVertices, RtToken uWrap, RtInt vVertices, RtToken vWrap,
                   ...);
RtVoid RiPatchMeshV(RtToken type, RtInt uVertices, RtToken uWrap, RtInt vVertices, RtToken vWrap,
                    RtInt n, RtToken tokens[], RtPointer values[]);
RtVoid RiNuPatch(RtInt uVertices, RtInt uOrder, const RtFloat uKnots[], RtFloat uMin, RtFloat uMax,
                 RtInt vVertices, RtInt vOrder, const RtFloat vKnots[], RtFloat vMin, RtFloat vMax,
                 ...);
RtVoid RiNuPatchV(RtInt uVertices, RtInt uOrder, const RtFloat uKnots[], RtFloat uMin, RtFloat uMax,
                  RtInt vVertices, RtInt vOrder, const RtFloat vKnots[], RtFloat vMin, RtFloat vMax,
                  RtInt n, RtToken tokens[], RtPointer values[]);
RtVoid RiSubdivisionMesh(RtToken scheme, RtInt faces, const RtInt vertexCounts[],
                         const RtInt vertices[], RtInt tagCount, const RtToken tags[],
                         const RtInt argumentCounts[], const RtInt integers[],
                         const RtFloat floats[], ...);
RtVoid RiSubdivisionMeshV(RtToken scheme, RtInt faces, const RtInt vertexCounts[],
                          const RtInt vertices[], RtInt tagCount, const RtToken tags[],
                          const RtInt argumentCounts[], const RtInt integers[],
                          const RtFloat floats[], RtInt n, RtToken tokens[], RtPointer values[]);
RtVoid RiPoints(RtInt points, ...);
RtVoid RiPointsV(RtInt points, RtInt n, RtToken tokens[], RtPointer values[]);
RtVoid RiCurves(RtToken type, RtInt curves, const RtInt vertexCounts[], RtToken wrap, ...);
RtVoid RiCurvesV(RtToken type, RtInt curves, const RtInt vertexCounts[], RtToken wrap, RtInt n,
                 RtToken tokens[], RtPointer values[]);
RtVoid RiBlobby(RtInt leaves, RtInt codeCount, const RtInt codes[], RtInt floatCount,
                const RtFloat numbers[], RtInt stringCount, const RtToken strings[], ...);
RtVoid RiBlobbyV(RtInt leaves, RtInt codeCount, const RtInt codes[], RtInt floatCount,
                 const RtFloat numbers[], RtInt stringCount, const RtToken strings[], RtInt n,
                 RtToken tokens[], RtPointer values[]);
RtVoid RiGeometry(RtToken type, ...);
RtVoid RiGeometryV(RtToken type, RtInt n, RtToken tokens[], RtPointer values[]);

/* Textures from pictures */
RtVoid RiMakeTexture(RtToken picture, RtToken texture, RtToken sWrap, RtToken tWrap,
                     RtFilterFunc filter, RtFloat sWidth, RtFloat tWidth, ...);
RtVoid RiMakeTextureV(RtToken picture, RtToken texture, RtToken sWrap, RtToken tWrap,
                      RtFilterFunc filter, RtFloat sWidth, RtFloat tWidth, RtInt n,
                      RtToken tokens[], RtPointer values[]);
RtVoid RiMakeBump(RtToken picture, RtToken texture, RtToken sWrap, RtToken tWrap,
                  RtFilterFunc filter, RtFloat sWidth, RtFloat tWidth, ...);
RtVoid RiMakeBumpV(RtToken picture, RtToken texture, RtToken sWrap, RtToken tWrap,
                   RtFilterFunc filter, RtFloat sWidth, RtFloat tWidth, RtInt n, RtToken tokens[],
                   RtPointer values[]);
RtVoid RiMakeLatLongEnvironment(RtToken picture, RtToken texture, RtFilterFunc filter,
                                RtFloat sWidth, RtFloat tWidth, ...);
RtVoid RiMakeLatLongEnvironmentV(RtToken picture, RtToken texture, RtFilterFunc filter,
                                 RtFloat sWidth, RtFloat tWidth, RtInt n, RtToken tokens[],
                                 RtPointer values[]);
RtVoid RiMakeCubeFaceEnvironment(RtToken px, RtToken nx, RtToken py, RtToken ny, RtToken pz,
                                 RtToken nz, RtToken texture, RtFloat fieldOfView,
                                 RtFilterFunc filter, RtFloat sWidth, RtFloat tWidth, ...);
RtVoid RiMakeCubeFaceEnvironmentV(RtToken px, RtToken nx, RtToken py, RtToken ny, RtToken pz,
                                  RtToken nz, RtToken texture, RtFloat fieldOfView,
                                  RtFilterFunc filter, RtFloat sWidth, RtFloat tWidth, RtInt n,
                                  RtToken tokens[], RtPointer values[]);
RtVoid RiMakeShadow(RtToken picture, RtToken texture, ...);
RtVoid RiMakeShadowV(RtToken picture, RtToken texture, RtInt n, RtToken tokens[],
                     RtPointer values[]);

/* Of Candela and of later RenderMan */
RtVoid RiPushFilter(RtToken name, ...);
RtVoid RiPushFilterV(RtToken name, RtInt n, RtToken tokens[], RtPointer values[]);
RtVoid RiPopFilter(void);
RtVoid RiProcedural2(RtToken generator, RtToken bound, ...);
RtVoid RiProcedural2V(RtToken generator, RtToken bound, RtInt n, RtToken tokens[],
                      RtPointer values[]);
RtVoid RiBxdf(RtToken name, RtToken handle, ...);
RtVoid RiBxdfV(RtToken name, RtToken handle, RtInt n, RtToken tokens[], RtPointer values[]);
RtLightHandle RiLight(RtToken name, RtToken handle, ...);
RtLightHandle RiLightV(RtToken name, RtToken handle, RtInt n, RtToken tokens[], RtPointer values[]);
RtVoid RiShaderLayer(RtToken type, RtToken name, RtToken layer, ...);
RtVoid RiShaderLayerV(RtToken type, RtToken name, RtToken layer, RtInt n, RtToken tokens[],
                      RtPointer values[]);
/* Each tag has three counts: of its integers, floats and strings. */
RtVoid RiHierarchicalSubdivisionMesh(RtToken scheme, RtInt faces, const RtInt vertexCounts[],
                                     const RtInt vertices[], RtInt tagCount, const RtToken tags[],
                                     const RtInt argumentCounts[], const RtInt integers[],
                                     const RtFloat floats[], const RtToken strings[], ...);
RtVoid RiHierarchicalSubdivisionMeshV(RtToken scheme, RtInt faces, const RtInt vertexCounts[],
                                      const RtInt vertices[], RtInt tagCount, const RtToken tags[],
                                      const RtInt argumentCounts[], const RtInt integers[],
                                      const RtFloat floats[], const RtToken strings[], RtInt n,
                                      RtToken tokens[], RtPointer values[]);

/* Of other renderers: RIB that is written has them; Candela leaves them out, with a warning. */
RtVoid RiCamera(RtToken name, ...);
RtVoid RiCameraV(RtToken name, RtInt n, RtToken tokens[], RtPointer values[]);
RtVoid RiCameraShutter(RtFloat opening, RtFloat closing);
RtVoid RiConnectShaderLayers(RtToken type, RtToken layer1, RtToken variable1, RtToken layer2,
                             RtToken variable2);
RtVoid RiDisplace(RtToken name, RtToken handle, ...);
RtVoid RiDisplaceV(RtToken name, RtToken handle, RtInt n, RtToken tokens[], RtPointer values[]);
RtVoid RiDisplayFilter(RtToken name, RtToken handle, ...);
RtVoid RiDisplayFilterV(RtToken name, RtToken handle, RtInt n, RtToken tokens[],
                        RtPointer values[]);
RtVoid RiEditAttributeBegin(RtToken name);
RtVoid RiEditAttributeEnd(void);
RtVoid RiEditBegin(RtToken name, ...);
RtVoid RiEditBeginV(RtToken name, RtInt n, RtToken tokens[], RtPointer values[]);
RtVoid RiEditEnd(void);
RtVoid RiEditWorldBegin(RtToken name, ...);
RtVoid RiEditWorldBeginV(RtToken name, RtInt n, RtToken tokens[], RtPointer values[]);
RtVoid RiEditWorldEnd(void);
RtVoid RiEnableLightFilter(RtLightHandle light, RtToken filter, RtBoolean on);
RtVoid RiIntegrator(RtToken name, RtToken handle, ...);
RtVoid RiIntegratorV(RtToken name, RtToken handle, RtInt n, RtToken tokens[], RtPointer values[]);
RtVoid RiLightFilter(RtToken name, RtToken handle, ...);
RtVoid RiLightFilterV(RtToken name, RtToken handle, RtInt n, RtToken tokens[], RtPointer values[]);
RtVoid RiMakeBrickMap(RtInt count, const RtToken clouds[], RtToken map, ...);
RtVoid RiMakeBrickMapV(RtInt count, const RtToken clouds[], RtToken map, RtInt n, RtToken tokens[],
                       RtPointer values[]);
RtVoid RiMakeOcclusion(RtInt count, const RtToken pictures[], RtToken map, ...);
RtVoid RiMakeOcclusionV(RtInt count, const RtToken pictures[], RtToken map, RtInt n,
                        RtToken tokens[], RtPointer values[]);
RtVoid RiPattern(RtToken name, RtToken handle, ...);
RtVoid RiPatternV(RtToken name, RtToken handle, RtInt n, RtToken tokens[], RtPointer values[]);
RtVoid RiPixelSampleImager(RtToken name, ...);
RtVoid RiPixelSampleImagerV(RtToken name, RtInt n, RtToken tokens[], RtPointer values[]);
RtVoid RiSampleFilter(RtToken name, RtToken handle, ...);
RtVoid RiSampleFilterV(RtToken name, RtToken handle, RtInt n, RtToken tokens[], RtPointer values[]);
RtVoid RiShader(RtToken name, RtToken handle, ...);
RtVoid RiShaderV(RtToken name, RtToken handle, RtInt n, RtToken tokens[], RtPointer values[]);
RtVoid RiSystem(RtToken command);
RtVoid RiVPAtmosphere(RtToken name, ...);
RtVoid RiVPAtmosphereV(RtToken name, RtInt n, RtToken tokens[], RtPointer values[]);
RtVoid RiVPInterior(RtToken name, ...);
RtVoid RiVPInteriorV(RtToken name, RtInt n, RtToken tokens[], RtPointer values[]);
RtVoid RiVPSurface(RtToken name, ...);
RtVoid RiVPSurfaceV(RtToken name, RtInt n, RtToken tokens[], RtPointer values[]);
RtVoid RiVolume(RtToken type, const RtBound bound, const RtInt dimensions[], ...);
RtVoid RiVolumeV(RtToken type, const RtBound bound, const RtInt dimensions[], RtInt n,
                 RtToken tokens[], RtPointer values[]);
RtVoid RiVolumePixelSamples(RtFloat x, RtFloat y);

#ifdef __GNUC__
#pragma GCC visibility pop
#endif
#ifdef __cplusplus
}
#endif

#endif
