#include "BenchRun.h"

#include "BenchFront.h"
#include "BenchMachine.h"
#include "BenchProgress.h"

namespace flatblock::benchmarks
{
namespace
{
class Sweep
{
public:
  Sweep(Subject& subject, const std::vector<Point>& points, Results& results, Progress& progress)
    : Name(subject.Name), Measurer(subject), Points(points), Out(results), Shown(progress)
  {
  }

  void Run()
  {
    for (const Point& point : this->Points)
    {
      this->Shown.Step(this->Name + "/" + point.GetName());
      this->Measure(point);
    }
    const Selected records = SelectScene(this->Out.Records, this->Name);
    for (const Record* peer : SelectSide(records, false))
    {
      this->Shown.Step(this->Name + ": the same error as " + peer->GetName());
      this->Out.Equal.push_back(this->Compare(*peer, FindAsClose(records, peer->GetPSNR())));
    }
  }

private:
  void Measure(const Point& point)
  {
    try
    {
      this->Out.Records.push_back(this->Measurer.Measure(point));
    }
    catch (const std::exception& error)
    {
      this->Out.LeftOut.push_back(this->Name + "/" + point.GetName() + ": " + error.what());
    }
  }

  EqualError Compare(const Record& peer, const Record* ours)
  {
    EqualError equal{ this->Name, peer.GetName(), "", peer.GetPSNR() };
    if (ours)
    {
      equal.Ours = ours->Knob + "=" + ours->Value;
      equal.OurPSNR = ours->GetPSNR();
      equal.Times =
        this->Measurer.TimeInTurns(this->Find(peer.GetName()), this->Find(ours->GetName()));
    }
    return equal;
  }

  const Point& Find(const std::string& name) const
  {
    return *std::find_if(this->Points.begin(), this->Points.end(),
      [&name](const Point& point) { return point.GetName() == name; });
  }

  std::string Name;
  Bench Measurer;
  const std::vector<Point>& Points;
  Results& Out;
  Progress& Shown;
};

// A duel for each point of a peer.
std::size_t CountSteps(const std::vector<SelectedScene>& scenes)
{
  std::size_t steps = 0;
  for (const SelectedScene& scene : scenes)
  {
    for (const Point& point : scene.Points)
    {
      steps += point.IsOurs() ? 1 : 2;
    }
  }
  return steps;
}
} // namespace

Results RunSweeps(const BenchOptions& options, const std::vector<SelectedScene>& scenes,
  const std::function<void(const Results&)>& keep)
{
  Results results;
  results.Options = options;
  results.Date = GetToday();
  results.Processor = GetProcessor();
  Progress progress(CountSteps(scenes));
  for (const SelectedScene& scene : scenes)
  {
    progress.BeginScene(scene.Scene.Name);
    const auto subject = PrepareScene(scene.Scene, options);
    if (!subject)
    {
      results.LeftOut.push_back(scene.Scene.Name + ": its file is not installed");
      continue;
    }
    results.OpenGL = GetOpenGL(subject->Shown.Window);
    results.Scenes.push_back({ subject->Name, subject->Description });
    Sweep(*subject, scene.Points, results, progress).Run();
    keep(results);
  }
  progress.End();
  return results;
}
} // namespace flatblock::benchmarks
