// SPDX-License-Identifier: LGPL-2.1-or-later
// Gauges: points whose fields are written step by step, DIR/gauges/NAME.csv (doc/theory/gauges.md).
#include <whipple/diagnostics/free_surface.h>
#include <whipple/diagnostics/gauge.h>
#include <whipple/diagnostics/measure.h>
#include <whipple/diagnostics/mesh_point.h>
#include <whipple/mesh/gather.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

namespace whipple
{
  namespace
  {
    constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

    /// What a gauge remembers from step to step.
    template <int dim>
    struct GaugeMemory
    {
      double      next = 0;   ///< us, time from which the next row is due
      Vector<dim> position{}; ///< cm
      Vector<dim> velocity{}; ///< cm/us, of the material there; where there is none, that of the last there was

      /// The element it rides in, moving meshes; level < 0: none.
      double      level = -1;
      Vector<dim> lattice_point{};
      Vector<dim> local{};

      static constexpr std::size_t size = 2 + 4 * dim;

      static GaugeMemory
      read(std::span<const double> m)
      {
        GaugeMemory memory;
        memory.next  = m[0];
        memory.level = m[1];
        for (int d = 0; d < dim; ++d)
          {
            memory.position[d]      = m[2 + d];
            memory.velocity[d]      = m[2 + dim + d];
            memory.lattice_point[d] = m[2 + 2 * dim + d];
            memory.local[d]         = m[2 + 3 * dim + d];
          }
        return memory;
      }
      void
      write(std::span<double> m) const
      {
        m[0] = next;
        m[1] = level;
        for (int d = 0; d < dim; ++d)
          {
            m[2 + d]           = position[d];
            m[2 + dim + d]     = velocity[d];
            m[2 + 2 * dim + d] = lattice_point[d];
            m[2 + 3 * dim + d] = local[d];
          }
      }

      CellKey
      key() const
      {
        LatticePoint<dim> point;
        for (int d = 0; d < dim; ++d)
          point[d] = static_cast<int>(lattice_point[d]);
        return make_key<dim>(static_cast<int>(level), point);
      }
      void
      ride_in(CellKey cell, const Vector<dim> &where)
      {
        level = key_level(cell);
        for (int d = 0; d < dim; ++d)
          lattice_point[d] = key_point<dim>(cell)[d];
        local = where;
      }
    };

    /// Where a gauge was found, by the rank that owns the cell.
    template <int dim>
    struct Found
    {
      std::size_t gauge;
      CellKey     key;
      Vector<dim> local, position, velocity;
    };

    template <int dim>
    using FoundAll = std::vector<std::optional<Found<dim>>>;

    template <int dim>
    class GaugeWatch : public Watch<dim>
    {
    public:
      GaugeWatch(std::vector<Gauge<dim>> gauges, const FieldLayout &layout)
        : gauges_(std::move(gauges))
        , known_(known_gauge_fields<dim>(layout))
      {
        for (const Gauge<dim> &gauge : gauges_)
          n_values_ = std::max(n_values_, gauge.fields.size());
      }

      std::vector<WatchTable>
      tables() const override
      {
        std::vector<WatchTable> all;
        for (const Gauge<dim> &gauge : gauges_)
          {
            WatchTable table{"gauges/" + gauge.name + ".csv", {"time [us]"}};
            if (gauge.kind == GaugeKind::surface_velocity)
              table.columns.insert(table.columns.end(), {"position 1 [cm]", "velocity 1 [cm/us]"});
            else
              for (int d = 0; d < dim; ++d)
                table.columns.push_back("position " + std::to_string(d) + " [cm]");
            for (const std::string &name : gauge.fields)
              if (name == velocity_field)
                for (int d = 0; d < dim; ++d)
                  table.columns.push_back("velocity " + std::to_string(d) + " [cm/us]");
              else
                table.columns.push_back(name + " [" + known_[number_of(name)].unit + "]");
            all.push_back(std::move(table));
          }
        return all;
      }

      void
      mesh_is_new(const MeasureView<dim> &view, std::vector<double> &memory, const WriteRow &write) const override
      {
        const bool                    first = memory.empty();
        std::vector<GaugeMemory<dim>> gauges;
        if (first)
          for (const Gauge<dim> &gauge : gauges_)
            {
              GaugeMemory<dim> &m = gauges.emplace_back();
              m.next              = view.state.time;
              m.position          = gauge.point;
            }
        else
          gauges = read(memory);

        std::vector<bool> wanted(gauges_.size());
        for (std::size_t g = 0; g < gauges_.size(); ++g)
          {
            gauges[g].level = -1; // cells of the old mesh may be called the same
            wanted[g]       = first || gauges_[g].kind == GaugeKind::material;
          }
        const FoundAll<dim> found = find(view, gauges, wanted);
        take(found, is_moving(view), gauges);
        if (first)
          write_rows(view, found, gauges, write);
        memory = written(gauges);
      }

      void
      step_done(const MeasureView<dim> &view, double dt, std::vector<double> &memory,
                const WriteRow &write) const override
      {
        std::vector<GaugeMemory<dim>> gauges = read(memory);
        std::vector<bool>             rides(gauges_.size()), wanted(gauges_.size());
        for (std::size_t g = 0; g < gauges_.size(); ++g)
          {
            rides[g]  = gauges_[g].kind == GaugeKind::material;
            wanted[g] = rides[g] || view.state.time >= gauges[g].next;
          }
        if (std::none_of(wanted.begin(), wanted.end(), [](bool w) { return w; }))
          return;
        move(view, rides, dt, gauges);
        const FoundAll<dim> found = find(view, gauges, wanted);
        take(found, is_moving(view), gauges);
        write_rows(view, found, gauges, write);
        memory = written(gauges);
      }

    private:
      static bool
      is_moving(const MeasureView<dim> &view)
      {
        return view.scene.stages[view.stage].mode() == StageMode::lagrangian;
      }

      std::vector<GaugeMemory<dim>>
      read(const std::vector<double> &memory) const
      {
        std::vector<GaugeMemory<dim>> gauges;
        for (std::size_t g = 0; g < gauges_.size(); ++g)
          gauges.push_back(
              GaugeMemory<dim>::read(std::span(memory).subspan(g * GaugeMemory<dim>::size, GaugeMemory<dim>::size)));
        return gauges;
      }
      static std::vector<double>
      written(const std::vector<GaugeMemory<dim>> &gauges)
      {
        std::vector<double> memory(gauges.size() * GaugeMemory<dim>::size);
        for (std::size_t g = 0; g < gauges.size(); ++g)
          gauges[g].write(std::span(memory).subspan(g * GaugeMemory<dim>::size, GaugeMemory<dim>::size));
        return memory;
      }

      std::size_t
      number_of(const std::string &field) const
      {
        return std::find_if(known_.begin(), known_.end(), [&](const CellField &f) { return f.name == field; }) -
               known_.begin();
      }

      /// Where gauges that ride are after a step. On a moving mesh find() knows it from their element; on a fixed mesh,
      /// and in flight without material, by Heun's method with the velocities at both ends of the step.
      void
      move(const MeasureView<dim> &view, const std::vector<bool> &rides, double dt,
           std::vector<GaugeMemory<dim>> &gauges) const
      {
        std::vector<GaugeMemory<dim>> ahead = gauges;
        for (std::size_t g = 0; g < gauges.size(); ++g)
          if (rides[g])
            for (int d = 0; d < dim; ++d)
              ahead[g].position[d] += dt * gauges[g].velocity[d];
        FoundAll<dim> found(gauges.size());
        if (!is_moving(view) && std::any_of(rides.begin(), rides.end(), [](bool r) { return r; }))
          found = find(view, ahead, rides);
        for (std::size_t g = 0; g < gauges.size(); ++g)
          {
            if (!rides[g])
              continue;
            const Vector<dim> begin = gauges[g].velocity, end = found[g] ? found[g]->velocity : begin;
            for (int d = 0; d < dim; ++d)
              gauges[g].position[d] += 0.5 * dt * (begin[d] + end[d]);
          }
      }

      /// What this rank knows of a gauge.
      std::optional<Found<dim>>
      find_here(const MeasureView<dim> &view, std::size_t g, const GaugeMemory<dim> &memory, bool moving) const
      {
        MeshPoint<dim>        point;
        std::optional<double> surface;
        if (gauges_[g].kind == GaugeKind::surface_velocity)
          {
            const SurfacePoint<dim> seen = find_surface(view, gauges_[g].body, gauges_[g].rear);
            point                        = seen.point;
            surface                      = seen.position;
          }
        else if (moving && memory.level >= 0)
          point = {cell_of_key(view.mesh, memory.key()), memory.local};
        else if (moving)
          point = find_in_elements<dim>(view.mesh, view.state, memory.position);
        else
          point = find_in_lattice<dim>(view.scene.lattice, view.mesh, view.state, memory.position);
        if (point.cell == none)
          return std::nullopt;
        Found<dim> found{g, view.mesh.key[point.cell], point.local,
                         at_point<dim>(view.mesh, view.state.position, point),
                         at_point<dim>(view.mesh, view.state.velocity, point)};
        if (surface)
          found.position[flight_axis<dim>] = *surface;
        return found;
      }

      /// Whether of two answers to the same question the first is the one: the outermost surface, else the least key.
      bool
      is_before(const Found<dim> &a, const Found<dim> &b) const
      {
        const Gauge<dim> &gauge = gauges_[a.gauge];
        if (gauge.kind == GaugeKind::surface_velocity && a.position[flight_axis<dim>] != b.position[flight_axis<dim>])
          return gauge.rear ? a.position[flight_axis<dim>] > b.position[flight_axis<dim>]
                            : a.position[flight_axis<dim>] < b.position[flight_axis<dim>];
        return a.key < b.key;
      }

      FoundAll<dim>
      find(const MeasureView<dim> &view, const std::vector<GaugeMemory<dim>> &gauges,
           const std::vector<bool> &wanted) const
      {
        std::vector<Found<dim>> here;
        for (std::size_t g = 0; g < gauges.size(); ++g)
          if (wanted[g])
            if (const auto found = find_here(view, g, gauges[g], is_moving(view)))
              here.push_back(*found);
        FoundAll<dim> all(gauges.size());
        for (const Found<dim> &found : gather_all<Found<dim>>(view.communicator, here).entry)
          if (auto &best = all[found.gauge]; !best || is_before(found, *best))
            best = found;
        return all;
      }

      /// Remember what was found of the gauges that ride.
      void
      take(const FoundAll<dim> &found, bool moving, std::vector<GaugeMemory<dim>> &gauges) const
      {
        for (std::size_t g = 0; g < gauges.size(); ++g)
          {
            if (gauges_[g].kind != GaugeKind::material || !found[g])
              continue;
            gauges[g].velocity = found[g]->velocity;
            if (!moving)
              continue;
            gauges[g].position = found[g]->position;
            gauges[g].ride_in(found[g]->key, found[g]->local);
          }
      }

      /// Values of the fields of every gauge, `n_values_` each; not a number where there is no material, and for the
      /// velocity.
      std::vector<double>
      values(const MeasureView<dim> &view, const FoundAll<dim> &found, const std::vector<bool> &due) const
      {
        std::vector<double> all(gauges_.size() * n_values_, no_value), here;
        if (n_values_ == 0)
          return all;
        std::vector<Index>       cells;
        std::vector<std::size_t> of_gauge;
        for (std::size_t g = 0; g < gauges_.size(); ++g)
          if (due[g] && found[g])
            if (const Index c = cell_of_key(view.mesh, found[g]->key); c != none)
              {
                cells.push_back(c);
                of_gauge.push_back(g);
              }
        if (!cells.empty())
          {
            const auto fields = gauge_fields(view.layout, view.mesh, view.state, view.derived, cells);
            for (std::size_t i = 0; i < cells.size(); ++i)
              {
                const std::vector<std::string> &names = gauges_[of_gauge[i]].fields;
                here.push_back(static_cast<double>(of_gauge[i]));
                for (std::size_t n = 0; n < n_values_; ++n)
                  here.push_back(n < names.size() && names[n] != velocity_field ? fields[number_of(names[n])].value[i]
                                                                                : no_value);
              }
          }
        const std::vector<double> entries = gather_all<double>(view.communicator, here).entry;
        for (std::size_t i = 0; i < entries.size(); i += 1 + n_values_)
          std::copy_n(entries.begin() + static_cast<long>(i) + 1, n_values_,
                      all.begin() + static_cast<long>(static_cast<std::size_t>(entries[i]) * n_values_));
        return all;
      }

      void
      write_rows(const MeasureView<dim> &view, const FoundAll<dim> &found, std::vector<GaugeMemory<dim>> &gauges,
                 const WriteRow &write) const
      {
        const double      time = view.state.time;
        std::vector<bool> due(gauges.size());
        for (std::size_t g = 0; g < gauges.size(); ++g)
          due[g] = time >= gauges[g].next;
        if (std::none_of(due.begin(), due.end(), [](bool d) { return d; }))
          return;
        const std::vector<double> value = values(view, found, due);
        for (std::size_t g = 0; g < gauges.size(); ++g)
          {
            if (!due[g])
              continue;
            const auto velocity = [&](int d) { return found[g] ? found[g]->velocity[d] : no_value; };

            std::vector<double> row{time};
            if (gauges_[g].kind == GaugeKind::surface_velocity)
              row.insert(row.end(),
                         {found[g] ? found[g]->position[flight_axis<dim>] : no_value, velocity(flight_axis<dim>)});
            else
              row.insert(row.end(), gauges[g].position.begin(), gauges[g].position.end());
            for (std::size_t n = 0; n < gauges_[g].fields.size(); ++n)
              if (gauges_[g].fields[n] == velocity_field)
                for (int d = 0; d < dim; ++d)
                  row.push_back(velocity(d));
              else
                row.push_back(value[g * n_values_ + n]);
            write(g, row);
            gauges[g].next = time + gauges_[g].interval;
          }
      }

      std::vector<Gauge<dim>> gauges_;
      std::vector<CellField>  known_;        ///< names and units
      std::size_t             n_values_ = 0; ///< most fields of a gauge
    };

    std::unique_ptr<const Watch<2>>
    watch(const Problem<2> &problem)
    {
      const auto found = problem.scene.extra.find(Gauges<2>::section);
      if (found == problem.scene.extra.end())
        return nullptr;
      return std::make_unique<GaugeWatch<2>>(static_cast<const Gauges<2> &>(*found->second).list, problem.layout);
    }

    const MeasureRegistration<2> registration(50, "gauges", watch);
  } // namespace
} // namespace whipple
