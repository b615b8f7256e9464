//! The formats.

/// Who writes such files.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Format {
    /// OpenCV’s FileStorage, and the same names in JSON, YAML or XML.
    OpenCv,
    /// camera_info of ROS: calibration, echo of a topic, or the text of the calibrator (ost.txt).
    Ros,
    /// camchain.yaml.
    Kalibr,
    /// calib.txt of Middlebury and ETH3D.
    Middlebury,
    /// calib.txt and calib_cam_to_cam.txt.
    Kitti,
    /// cameras.txt.
    Colmap,
    /// Settings of ORB-SLAM2 and ORB-SLAM3.
    OrbSlam,
    /// SN*.conf of Stereolabs.
    Zed,
    /// What `rs-enumerate-devices -c` prints.
    RealSense,
    /// sensor.yaml.
    Euroc,
    /// Arrays of NumPy: .npz and .npy.
    NumPy,
    /// teamwebcamcalibrations.xml of FTC robots.
    Ftc,
    /// Cameras of VINS and camodocal, and the settings of VINS-Fusion.
    Vins,
    /// The calibration of an OAK camera, as DepthAI writes it.
    DepthAi,
    /// K.txt of FoundationStereo and BundleSDF.
    FoundationStereo,
    /// fx, fy, cx and cy under their names, or a matrix column by column: Open3D, RealSense, ARKit and others.
    Intrinsics,
    /// transforms.json of nerfstudio and instant-ngp.
    Transforms,
    /// Results of Bouguet’s toolbox for MATLAB, as text.
    Bouguet,
    /// EXIF of a photograph in JPEG.
    Exif,
}

impl Format {
    /// The name that scripts get.
    pub const fn name(self) -> &'static str {
        match self {
            Self::OpenCv => "opencv",
            Self::Ros => "ros",
            Self::Kalibr => "kalibr",
            Self::Middlebury => "middlebury",
            Self::Kitti => "kitti",
            Self::Colmap => "colmap",
            Self::OrbSlam => "orbslam",
            Self::Zed => "zed",
            Self::RealSense => "realsense",
            Self::Euroc => "euroc",
            Self::NumPy => "numpy",
            Self::Ftc => "ftc",
            Self::Vins => "vins",
            Self::DepthAi => "depthai",
            Self::FoundationStereo => "foundationstereo",
            Self::Intrinsics => "intrinsics",
            Self::Transforms => "transforms",
            Self::Bouguet => "bouguet",
            Self::Exif => "exif",
        }
    }

    /// What people call such a file.
    pub const fn title(self) -> &'static str {
        match self {
            Self::OpenCv => "a calibration of OpenCV",
            Self::Ros => "camera_info of ROS",
            Self::Kalibr => "a camchain of Kalibr",
            Self::Middlebury => "a calib.txt of Middlebury",
            Self::Kitti => "a calibration of KITTI",
            Self::Colmap => "cameras.txt of COLMAP",
            Self::OrbSlam => "settings of ORB-SLAM",
            Self::Zed => "a calibration of a ZED camera",
            Self::RealSense => "what rs-enumerate-devices prints",
            Self::Euroc => "a sensor.yaml of EuRoC",
            Self::NumPy => "a file of NumPy",
            Self::Ftc => "a teamwebcamcalibrations.xml of FTC",
            Self::Vins => "a camera file of VINS or camodocal",
            Self::DepthAi => "a calibration of an OAK camera",
            Self::FoundationStereo => "a K.txt of FoundationStereo",
            Self::Intrinsics => "a file of intrinsics",
            Self::Transforms => "a transforms.json of nerfstudio or instant-ngp",
            Self::Bouguet => "a result of Bouguet’s calibration toolbox",
            Self::Exif => "a photograph with EXIF",
        }
    }
}
