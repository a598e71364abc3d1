width = 1100; height = 520
load 'style.gp'
load 'common/time_response.gp'
