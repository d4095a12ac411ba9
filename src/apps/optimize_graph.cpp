#include "revisit_slam/backend/solver.h"
#include "revisit_slam/io/g2o.h"
#include "revisit_slam/io/process_usage.h"
#include <iostream>
using namespace revisit_slam;
int main(int argc,char**argv){ SolverConfig c; assign(parametersOf(c),{{"kernel",argv[2]},{"threads",argv[3]}}); if(argc>4) c.function_tolerance=atof(argv[4]); if(argc>5)c.max_iterations=atoi(argv[5]); auto g=readG2o(argv[1]); auto s=solve(g.graph,c); printf("%s: %zu nodes %zu odo %zu loops outcome %d: %.9g -> %.12g (g2o chi2 %.9g -> %.9g), %d it, %.2f s, %.0f MB\n",argv[1],g.ids.size(),g.graph.odometry().size(),g.graph.loops().size(),(int)s.outcome,s.initial_cost,s.final_cost,g2oChi2(g.graph,g.graph.poses()),g2oChi2(g.graph,s.poses),s.iterations,s.seconds,peakMemoryMegabytes());}
