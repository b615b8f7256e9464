%-- Focal length:
cc = [ 302.9 ; 242.6 ];
fc = [ 657.3 ; six ];
