% Intrinsic and Extrinsic Camera Parameters
%
% Numbers of our own, laid out as the toolbox does.


%-- Focal length:
fc = [ 657.300000000000011 ; 657.750000000000000 ];

%-- Principal point:
cc = [ 302.985000000000014 ; 242.617500000000007 ];

%-- Skew coefficient:
alpha_c = 0.000000000000000;

%-- Distortion coefficients:
kc = [ -0.255830000000000 ; 0.127580000000000 ; -0.000210000000000 ; 0.000031000000000 ; 0.000000000000000 ];

%-- Focal length uncertainty:
fc_error = [ 0.346500000000000 ; 0.371100000000000 ];

%-- Principal point uncertainty:
cc_error = [ 0.705600000000000 ; 0.645900000000000 ];

%-- Skew coefficient uncertainty:
alpha_c_error = 0.000000000000000;

%-- Image size:
nx = 640;
ny = 480;


%-- Various other variables (may be ignored if you do not use the Matlab Calibration Toolbox):
n_ima = 20;

%-- Image #1:
omc_1 = [ 1.654780e+00 ; 1.651920e+00 ; -6.699e-01 ];
Tc_1  = [ -1.777e+02 ; -8.384e+01 ; 8.52e+02 ];
