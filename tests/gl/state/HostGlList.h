#pragma once

/// The GL functions that the tests call as a host would, as (type, name): GL 3.3 core, ...
#define AOLIB_HOST_GL_CORE(X)                                                                      \
    X(PFNGLACTIVETEXTUREPROC, ActiveTexture)                                                       \
    X(PFNGLATTACHSHADERPROC, AttachShader)                                                         \
    X(PFNGLBEGINCONDITIONALRENDERPROC, BeginConditionalRender)                                     \
    X(PFNGLBEGINQUERYPROC, BeginQuery)                                                             \
    X(PFNGLBEGINTRANSFORMFEEDBACKPROC, BeginTransformFeedback)                                     \
    X(PFNGLBINDBUFFERPROC, BindBuffer)                                                             \
    X(PFNGLBINDBUFFERBASEPROC, BindBufferBase)                                                     \
    X(PFNGLBINDBUFFERRANGEPROC, BindBufferRange)                                                   \
    X(PFNGLBINDFRAMEBUFFERPROC, BindFramebuffer)                                                   \
    X(PFNGLBINDRENDERBUFFERPROC, BindRenderbuffer)                                                 \
    X(PFNGLBINDSAMPLERPROC, BindSampler)                                                           \
    X(PFNGLBINDTEXTUREPROC, BindTexture)                                                           \
    X(PFNGLBINDVERTEXARRAYPROC, BindVertexArray)                                                   \
    X(PFNGLBLENDCOLORPROC, BlendColor)                                                             \
    X(PFNGLBLENDEQUATIONPROC, BlendEquation)                                                       \
    X(PFNGLBLENDEQUATIONSEPARATEPROC, BlendEquationSeparate)                                       \
    X(PFNGLBLENDFUNCSEPARATEPROC, BlendFuncSeparate)                                               \
    X(PFNGLBLITFRAMEBUFFERPROC, BlitFramebuffer)                                                   \
    X(PFNGLBUFFERDATAPROC, BufferData)                                                             \
    X(PFNGLCHECKFRAMEBUFFERSTATUSPROC, CheckFramebufferStatus)                                     \
    X(PFNGLCLAMPCOLORPROC, ClampColor)                                                             \
    X(PFNGLCLEARPROC, Clear)                                                                       \
    X(PFNGLCLEARBUFFERFVPROC, ClearBufferfv)                                                       \
    X(PFNGLCLEARCOLORPROC, ClearColor)                                                             \
    X(PFNGLCLEARDEPTHPROC, ClearDepth)                                                             \
    X(PFNGLCLEARSTENCILPROC, ClearStencil)                                                         \
    X(PFNGLCOLORMASKIPROC, ColorMaski)                                                             \
    X(PFNGLCOMPILESHADERPROC, CompileShader)                                                       \
    X(PFNGLCREATEPROGRAMPROC, CreateProgram)                                                       \
    X(PFNGLCREATESHADERPROC, CreateShader)                                                         \
    X(PFNGLCULLFACEPROC, CullFace)                                                                 \
    X(PFNGLDELETEBUFFERSPROC, DeleteBuffers)                                                       \
    X(PFNGLDELETEFRAMEBUFFERSPROC, DeleteFramebuffers)                                             \
    X(PFNGLDELETEPROGRAMPROC, DeleteProgram)                                                       \
    X(PFNGLDELETEQUERIESPROC, DeleteQueries)                                                       \
    X(PFNGLDELETERENDERBUFFERSPROC, DeleteRenderbuffers)                                           \
    X(PFNGLDELETESAMPLERSPROC, DeleteSamplers)                                                     \
    X(PFNGLDELETESHADERPROC, DeleteShader)                                                         \
    X(PFNGLDELETETEXTURESPROC, DeleteTextures)                                                     \
    X(PFNGLDELETEVERTEXARRAYSPROC, DeleteVertexArrays)                                             \
    X(PFNGLDEPTHFUNCPROC, DepthFunc)                                                               \
    X(PFNGLDEPTHMASKPROC, DepthMask)                                                               \
    X(PFNGLDEPTHRANGEPROC, DepthRange)                                                             \
    X(PFNGLDISABLEPROC, Disable)                                                                   \
    X(PFNGLDISABLEVERTEXATTRIBARRAYPROC, DisableVertexAttribArray)                                 \
    X(PFNGLDISABLEIPROC, Disablei)                                                                 \
    X(PFNGLDRAWBUFFERSPROC, DrawBuffers)                                                           \
    X(PFNGLENABLEPROC, Enable)                                                                     \
    X(PFNGLENABLEVERTEXATTRIBARRAYPROC, EnableVertexAttribArray)                                   \
    X(PFNGLENABLEIPROC, Enablei)                                                                   \
    X(PFNGLENDCONDITIONALRENDERPROC, EndConditionalRender)                                         \
    X(PFNGLENDQUERYPROC, EndQuery)                                                                 \
    X(PFNGLENDTRANSFORMFEEDBACKPROC, EndTransformFeedback)                                         \
    X(PFNGLFINISHPROC, Finish)                                                                     \
    X(PFNGLFRAMEBUFFERRENDERBUFFERPROC, FramebufferRenderbuffer)                                   \
    X(PFNGLFRAMEBUFFERTEXTURE2DPROC, FramebufferTexture2D)                                         \
    X(PFNGLFRONTFACEPROC, FrontFace)                                                               \
    X(PFNGLGENBUFFERSPROC, GenBuffers)                                                             \
    X(PFNGLGENFRAMEBUFFERSPROC, GenFramebuffers)                                                   \
    X(PFNGLGENQUERIESPROC, GenQueries)                                                             \
    X(PFNGLGENRENDERBUFFERSPROC, GenRenderbuffers)                                                 \
    X(PFNGLGENSAMPLERSPROC, GenSamplers)                                                           \
    X(PFNGLGENTEXTURESPROC, GenTextures)                                                           \
    X(PFNGLGENVERTEXARRAYSPROC, GenVertexArrays)                                                   \
    X(PFNGLGETBOOLEANI_VPROC, GetBooleani_v)                                                       \
    X(PFNGLGETBOOLEANVPROC, GetBooleanv)                                                           \
    X(PFNGLGETBUFFERPARAMETERIVPROC, GetBufferParameteriv)                                         \
    X(PFNGLGETBUFFERSUBDATAPROC, GetBufferSubData)                                                 \
    X(PFNGLGETDOUBLEVPROC, GetDoublev)                                                             \
    X(PFNGLGETERRORPROC, GetError)                                                                 \
    X(PFNGLGETFLOATVPROC, GetFloatv)                                                               \
    X(PFNGLGETFRAMEBUFFERATTACHMENTPARAMETERIVPROC, GetFramebufferAttachmentParameteriv)           \
    X(PFNGLGETINTEGER64I_VPROC, GetInteger64i_v)                                                   \
    X(PFNGLGETINTEGERI_VPROC, GetIntegeri_v)                                                       \
    X(PFNGLGETINTEGERVPROC, GetIntegerv)                                                           \
    X(PFNGLGETPROGRAMIVPROC, GetProgramiv)                                                         \
    X(PFNGLGETQUERYIVPROC, GetQueryiv)                                                             \
    X(PFNGLGETSAMPLERPARAMETERFVPROC, GetSamplerParameterfv)                                       \
    X(PFNGLGETSTRINGIPROC, GetStringi)                                                             \
    X(PFNGLGETTEXIMAGEPROC, GetTexImage)                                                           \
    X(PFNGLGETTEXLEVELPARAMETERIVPROC, GetTexLevelParameteriv)                                     \
    X(PFNGLGETTEXPARAMETERFVPROC, GetTexParameterfv)                                               \
    X(PFNGLGETUNIFORMLOCATIONPROC, GetUniformLocation)                                             \
    X(PFNGLGETUNIFORMFVPROC, GetUniformfv)                                                         \
    X(PFNGLGETVERTEXATTRIBPOINTERVPROC, GetVertexAttribPointerv)                                   \
    X(PFNGLGETVERTEXATTRIBFVPROC, GetVertexAttribfv)                                               \
    X(PFNGLGETVERTEXATTRIBIVPROC, GetVertexAttribiv)                                               \
    X(PFNGLHINTPROC, Hint)                                                                         \
    X(PFNGLISBUFFERPROC, IsBuffer)                                                                 \
    X(PFNGLISENABLEDPROC, IsEnabled)                                                               \
    X(PFNGLISENABLEDIPROC, IsEnabledi)                                                             \
    X(PFNGLISFRAMEBUFFERPROC, IsFramebuffer)                                                       \
    X(PFNGLISPROGRAMPROC, IsProgram)                                                               \
    X(PFNGLISQUERYPROC, IsQuery)                                                                   \
    X(PFNGLISRENDERBUFFERPROC, IsRenderbuffer)                                                     \
    X(PFNGLISSAMPLERPROC, IsSampler)                                                               \
    X(PFNGLISSHADERPROC, IsShader)                                                                 \
    X(PFNGLISTEXTUREPROC, IsTexture)                                                               \
    X(PFNGLISVERTEXARRAYPROC, IsVertexArray)                                                       \
    X(PFNGLLINEWIDTHPROC, LineWidth)                                                               \
    X(PFNGLLINKPROGRAMPROC, LinkProgram)                                                           \
    X(PFNGLLOGICOPPROC, LogicOp)                                                                   \
    X(PFNGLPIXELSTOREIPROC, PixelStorei)                                                           \
    X(PFNGLPOINTPARAMETERFPROC, PointParameterf)                                                   \
    X(PFNGLPOINTPARAMETERFVPROC, PointParameterfv)                                                 \
    X(PFNGLPOINTPARAMETERIPROC, PointParameteri)                                                   \
    X(PFNGLPOINTSIZEPROC, PointSize)                                                               \
    X(PFNGLPOLYGONMODEPROC, PolygonMode)                                                           \
    X(PFNGLPOLYGONOFFSETPROC, PolygonOffset)                                                       \
    X(PFNGLPRIMITIVERESTARTINDEXPROC, PrimitiveRestartIndex)                                       \
    X(PFNGLPROVOKINGVERTEXPROC, ProvokingVertex)                                                   \
    X(PFNGLREADBUFFERPROC, ReadBuffer)                                                             \
    X(PFNGLREADPIXELSPROC, ReadPixels)                                                             \
    X(PFNGLRENDERBUFFERSTORAGEPROC, RenderbufferStorage)                                           \
    X(PFNGLRENDERBUFFERSTORAGEMULTISAMPLEPROC, RenderbufferStorageMultisample)                     \
    X(PFNGLSAMPLECOVERAGEPROC, SampleCoverage)                                                     \
    X(PFNGLSAMPLEMASKIPROC, SampleMaski)                                                           \
    X(PFNGLSAMPLERPARAMETERFPROC, SamplerParameterf)                                               \
    X(PFNGLSAMPLERPARAMETERIPROC, SamplerParameteri)                                               \
    X(PFNGLSCISSORPROC, Scissor)                                                                   \
    X(PFNGLSHADERSOURCEPROC, ShaderSource)                                                         \
    X(PFNGLSTENCILFUNCSEPARATEPROC, StencilFuncSeparate)                                           \
    X(PFNGLSTENCILMASKSEPARATEPROC, StencilMaskSeparate)                                           \
    X(PFNGLSTENCILOPSEPARATEPROC, StencilOpSeparate)                                               \
    X(PFNGLTEXBUFFERPROC, TexBuffer)                                                               \
    X(PFNGLTEXIMAGE1DPROC, TexImage1D)                                                             \
    X(PFNGLTEXIMAGE2DPROC, TexImage2D)                                                             \
    X(PFNGLTEXIMAGE2DMULTISAMPLEPROC, TexImage2DMultisample)                                       \
    X(PFNGLTEXIMAGE3DPROC, TexImage3D)                                                             \
    X(PFNGLTEXIMAGE3DMULTISAMPLEPROC, TexImage3DMultisample)                                       \
    X(PFNGLTEXPARAMETERFPROC, TexParameterf)                                                       \
    X(PFNGLTEXPARAMETERIPROC, TexParameteri)                                                       \
    X(PFNGLTRANSFORMFEEDBACKVARYINGSPROC, TransformFeedbackVaryings)                               \
    X(PFNGLUNIFORM4FPROC, Uniform4f)                                                               \
    X(PFNGLUSEPROGRAMPROC, UseProgram)                                                             \
    X(PFNGLVERTEXATTRIB4FPROC, VertexAttrib4f)                                                     \
    X(PFNGLVERTEXATTRIBDIVISORPROC, VertexAttribDivisor)                                           \
    X(PFNGLVERTEXATTRIBIPOINTERPROC, VertexAttribIPointer)                                         \
    X(PFNGLVERTEXATTRIBPOINTERPROC, VertexAttribPointer)                                           \
    X(PFNGLVIEWPORTPROC, Viewport)

/// ... newer ones, null where the context is older, ...
#define AOLIB_HOST_GL_NEWER(X)                                                                     \
    X(PFNGLBINDIMAGETEXTUREPROC, BindImageTexture)                                                 \
    X(PFNGLBINDPROGRAMPIPELINEPROC, BindProgramPipeline)                                           \
    X(PFNGLBINDTRANSFORMFEEDBACKPROC, BindTransformFeedback)                                       \
    X(PFNGLBLENDEQUATIONSEPARATEIPROC, BlendEquationSeparatei)                                     \
    X(PFNGLBLENDEQUATIONIPROC, BlendEquationi)                                                     \
    X(PFNGLBLENDFUNCSEPARATEIPROC, BlendFuncSeparatei)                                             \
    X(PFNGLCLIPCONTROLPROC, ClipControl)                                                           \
    X(PFNGLCREATESHADERPROGRAMVPROC, CreateShaderProgramv)                                         \
    X(PFNGLDELETEPROGRAMPIPELINESPROC, DeleteProgramPipelines)                                     \
    X(PFNGLDELETETRANSFORMFEEDBACKSPROC, DeleteTransformFeedbacks)                                 \
    X(PFNGLDEPTHRANGEINDEXEDPROC, DepthRangeIndexed)                                               \
    X(PFNGLGENPROGRAMPIPELINESPROC, GenProgramPipelines)                                           \
    X(PFNGLGENTRANSFORMFEEDBACKSPROC, GenTransformFeedbacks)                                       \
    X(PFNGLGETDOUBLEI_VPROC, GetDoublei_v)                                                         \
    X(PFNGLGETFLOATI_VPROC, GetFloati_v)                                                           \
    X(PFNGLGETPOINTERVPROC, GetPointerv)                                                           \
    X(PFNGLMINSAMPLESHADINGPROC, MinSampleShading)                                                 \
    X(PFNGLPATCHPARAMETERFVPROC, PatchParameterfv)                                                 \
    X(PFNGLPATCHPARAMETERIPROC, PatchParameteri)                                                   \
    X(PFNGLPAUSETRANSFORMFEEDBACKPROC, PauseTransformFeedback)                                     \
    X(PFNGLPOLYGONOFFSETCLAMPPROC, PolygonOffsetClamp)                                             \
    X(PFNGLPOPDEBUGGROUPPROC, PopDebugGroup)                                                       \
    X(PFNGLPUSHDEBUGGROUPPROC, PushDebugGroup)                                                     \
    X(PFNGLSCISSORINDEXEDPROC, ScissorIndexed)                                                     \
    X(PFNGLUSEPROGRAMSTAGESPROC, UseProgramStages)                                                 \
    X(PFNGLVIEWPORTINDEXEDFVPROC, ViewportIndexedfv)

/// ... and the compatibility profile's, as (name, parameters), which the core header lacks.
#define AOLIB_HOST_GL_COMPATIBILITY(X)                                                             \
    X(AlphaFunc, GLenum, GLfloat)                                                                  \
    X(ClearAccum, GLfloat, GLfloat, GLfloat, GLfloat)                                              \
    X(ClientActiveTexture, GLenum)                                                                 \
    X(Color4f, GLfloat, GLfloat, GLfloat, GLfloat)                                                 \
    X(ColorMaterial, GLenum, GLenum)                                                               \
    X(DisableClientState, GLenum)                                                                  \
    X(EdgeFlag, GLboolean)                                                                         \
    X(EnableClientState, GLenum)                                                                   \
    X(FogCoordf, GLfloat)                                                                          \
    X(Fogf, GLenum, GLfloat)                                                                       \
    X(Fogfv, GLenum, const GLfloat*)                                                               \
    X(Fogi, GLenum, GLint)                                                                         \
    X(GetLightfv, GLenum, GLenum, GLfloat*)                                                        \
    X(GetMaterialfv, GLenum, GLenum, GLfloat*)                                                     \
    X(GetPixelMapfv, GLenum, GLfloat*)                                                             \
    X(GetPolygonStipple, GLubyte*)                                                                 \
    X(GetTexEnvfv, GLenum, GLenum, GLfloat*)                                                       \
    X(Lightfv, GLenum, GLenum, const GLfloat*)                                                     \
    X(LineStipple, GLint, GLushort)                                                                \
    X(LoadMatrixf, const GLfloat*)                                                                 \
    X(Materialfv, GLenum, GLenum, const GLfloat*)                                                  \
    X(ListBase, GLuint)                                                                            \
    X(MatrixMode, GLenum)                                                                          \
    X(Normal3f, GLfloat, GLfloat, GLfloat)                                                         \
    X(NormalPointer, GLenum, GLsizei, const void*)                                                 \
    X(PixelMapfv, GLenum, GLsizei, const GLfloat*)                                                 \
    X(PixelTransferf, GLenum, GLfloat)                                                             \
    X(PixelTransferi, GLenum, GLint)                                                               \
    X(PixelZoom, GLfloat, GLfloat)                                                                 \
    X(PolygonStipple, const GLubyte*)                                                              \
    X(PopAttrib, void)                                                                             \
    X(PopClientAttrib, void)                                                                       \
    X(PopMatrix, void)                                                                             \
    X(PushAttrib, GLbitfield)                                                                      \
    X(PushClientAttrib, GLbitfield)                                                                \
    X(PushMatrix, void)                                                                            \
    X(RasterPos2f, GLfloat, GLfloat)                                                               \
    X(SecondaryColor3f, GLfloat, GLfloat, GLfloat)                                                 \
    X(ShadeModel, GLenum)                                                                          \
    X(TexCoord4f, GLfloat, GLfloat, GLfloat, GLfloat)                                              \
    X(TexEnvf, GLenum, GLenum, GLfloat)                                                            \
    X(VertexPointer, GLint, GLenum, GLsizei, const void*)
