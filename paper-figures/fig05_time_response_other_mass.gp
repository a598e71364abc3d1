width = 1100; height = 580
load 'style.gp'
load 'common/time_response.gp'
