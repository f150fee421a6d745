ls new.tif
