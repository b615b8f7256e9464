% as saved by hand from Calib_Results_stereo.mat
fc_left = [533.52325; 533.52700];
cc_left = [341.60375; 235.19275];
fc_left_error = [0.831; 0.84];
cc_left_error = [1.239; 1.203];
fc_right = [536.81375; 536.47650]; % right
cc_right = [326.28650; 250.10125];
nx = 640; n_ima = 4;
ny = 480;   % rows
T = [ -99.849
        0.822
        0.436 ];
