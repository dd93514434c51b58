// SPDX-License-Identifier: LGPL-2.1-or-later
// What a stage does with elements that fold, touch or break.
#include <whipple/hydro/folding.h>
#include <whipple/mesh/collective.h>
#include <whipple/mesh/gather.h>
#include <whipple/mesh/key_index.h>
#include <whipple/run/bond_breaking.h>
#include <whipple/run/stage_loop.h>
#include <whipple/state/conversion.h>

#include <algorithm>

namespace whipple
{
  namespace
  {
    /// Stable steps ahead for which elements may not fold.
    constexpr double steps_ahead = 1.5;

    /// Part of a stage's typical step below which no sliver may push it.
    constexpr double sliver_share = 0.2;

    const char *const            released_fragments = "released fragments";
    const ConversionRegistration registration({70, released_fragments}, ConversionListed::at_end);

    /// Owned cells of these keys.
    template <int dim>
    std::vector<Index>
    cells_with_keys(const FlatMesh<dim> &mesh, const std::vector<CellKey> &keys)
    {
      std::vector<Index> cells;
      if (keys.empty())
        return cells;
      const KeyIndex wanted(keys);
      for (Index c = 0; c < mesh.n_owned; ++c)
        if (wanted.contains(mesh.key[c]))
          cells.push_back(c);
      return cells;
    }
  } // namespace

  template <int dim>
  bool
  StageLoop<dim>::holds_pieces() const
  {
    const auto &materials = run_.domain.state.material;
    return std::all_of(materials.begin(), materials.end(),
                       [](const MaterialState &material) { return material.has_voids(); });
  }

  template <int dim>
  void
  StageLoop<dim>::find_locked()
  {
    locked_ = cells_with_keys(run_.domain.view->mesh, run_.books.progress.locked);
  }

  template <int dim>
  bool
  StageLoop<dim>::bonds_break()
  {
    StageProgress &progress = run_.books.progress;
    if (stage_.lagrangian->cohesion != Cohesion::graded || progress.since_regrid < scene_.mesh.regrid_steps)
      return false;
    progress.since_regrid = 0;
    Bookings<dim> bookings;
    const long    broken =
        break_bonds(stage_.lagrangian->breaking, scene_.boundaries, stage_.lost_kinetic_energy, run_.domain, bookings);
    if (broken == 0)
      return false;
    run_.books.summary.counts.breaks += broken;
    run_.books.ledger.enter(bookings);
    new_mesh();
    check("breaking of bonds");
    return true;
  }

  template <int dim>
  bool
  StageLoop<dim>::release(std::vector<RigidFragment<dim>> &rigid)
  {
    Domain<dim>  &domain = run_.domain;
    Released<dim> own =
        release_fragments<dim>(domain.view->mesh, walls_, domain.state, steps_ahead * limit_.dt, locked_);
    run_.books.ledger.enter(released_fragments, sum_over_ranks(own.booking, domain.communicator()));
    const long number = static_cast<long>(sum_over_ranks(static_cast<double>(own.number), domain.communicator()));
    run_.books.summary.counts.releases += number;
    rigid = std::move(own.rigid);
    return number > 0;
  }

  template <int dim>
  bool
  StageLoop<dim>::free_folding()
  {
    Domain<dim>   &domain       = run_.domain;
    const MPI_Comm communicator = domain.communicator();
    if (stage_.lagrangian->cohesion == Cohesion::fragments || !holds_pieces())
      return false;
    std::vector<Index> cells = folding_cells(domain.view->mesh, domain.state, steps_ahead * limit_.dt);
    cells.insert(cells.end(), locked_.begin(), locked_.end());
    if (max_over_ranks(static_cast<double>(cells.size()), communicator) == 0)
      return false;
    double mass = 0;
    for (const Index c : cells)
      mass += domain.view->mesh.intact[c] ? cell_mass<dim>(domain.state, c) : 0.;
    Bookings<dim> bookings;
    const long    broken = free_cells<dim>(cells, scene_.boundaries, stage_.lost_kinetic_energy, domain, bookings);
    if (broken == 0)
      return false;
    run_.books.summary.counts.breaks += broken;
    bookings.note("elements about to fold freed from the mesh", static_cast<double>(broken),
                  sum_over_ranks(mass, communicator), "g");
    run_.books.ledger.enter(bookings);
    new_mesh();
    check("freeing of elements");
    return true;
  }

  template <int dim>
  std::size_t
  StageLoop<dim>::lock(const std::vector<Index> &cells)
  {
    const FlatMesh<dim>  &mesh = run_.domain.view->mesh;
    std::vector<CellKey> &all  = run_.books.progress.locked;
    std::vector<CellKey>  keys;
    for (const Index c : cells)
      if (!std::binary_search(locked_.begin(), locked_.end(), c))
        keys.push_back(mesh.key[c]);
    keys = gather_all<CellKey>(run_.domain.communicator(), keys).entry;
    std::sort(keys.begin(), keys.end()); // the same list on any number of ranks
    all.insert(all.end(), keys.begin(), keys.end());
    if (!keys.empty())
      find_locked();
    return keys.size();
  }

  template <int dim>
  bool
  StageLoop<dim>::lock_slivers()
  {
    const double bound = sliver_share * run_.books.progress.history.typical();
    if (!(limit_.dt < bound) || !holds_pieces())
      return false;
    return lock(cycle_->slivers(run_.domain.state, run_.domain.derived, bound)) > 0;
  }

  template <int dim>
  void
  StageLoop<dim>::note_locked()
  {
    StageProgress    &progress = run_.books.progress;
    const std::size_t number   = progress.locked.size() - progress.locked_noted;
    if (number == 0)
      return;
    const Domain<dim> &domain = run_.domain;
    double             mass   = 0;
    for (const Index c :
         cells_with_keys(domain.view->mesh, {progress.locked.begin() + progress.locked_noted, progress.locked.end()}))
      mass += cell_mass<dim>(domain.state, c);
    run_.books.ledger.note("slivers and elements at the point of folding locked in their shape",
                           static_cast<double>(number), sum_over_ranks(mass, domain.communicator()), "g");
    progress.locked_noted = progress.locked.size();
  }

  template <int dim>
  void
  StageLoop<dim>::refuse_folded()
  {
    const Domain<dim>   &domain = run_.domain;
    const FlatMesh<dim> &mesh   = domain.view->mesh;
    // what is locked has the shape that it had before it folded, whatever round-off makes of it
    std::vector<Index> cells = folded_cells(mesh, domain.state);
    std::erase_if(cells, [&](Index c) { return std::binary_search(locked_.begin(), locked_.end(), c); });
    const std::size_t number = lock(cells);
    if (number == 0)
      return;
    run_.books.progress.retries = 0; // what has folded now will be free and locked in the next try: not the same again
    agree(domain.communicator(), [&] {
      if (cells.empty())
        return;
      const Index n = mesh.cell_node[cells[0] * FlatMesh<dim>::corners];
      throw StateError("the step folded " + std::to_string(number) + " elements, one of them at (" +
                       std::to_string(domain.state.position[0][n]) + ", " +
                       std::to_string(domain.state.position[1][n]) + ") cm");
    });
  }

  template <int dim>
  bool
  StageLoop<dim>::meet()
  {
    StageProgress &progress = run_.books.progress;
    Ledger<dim>   &ledger   = run_.books.ledger;
    Domain<dim>   &domain   = run_.domain;
    const long     steps    = run_.record().steps;
    if (!progress.contacts.due(steps, domain.state.time) || !holds_pieces())
      return false;
    const ContactLook<dim> look = join_contacts(scene_.boundaries, stage_.lost_kinetic_energy, domain);
    progress.contacts.looked(steps, domain.state.time, progress.last_time_step, look);
    ledger.enter(look.bookings);
    if (look.joined > 0)
      cycle_->refresh(domain.state, domain.derived);
    bool anew = false;
    if (overlap_is_deep(look))
      {
        note_locked();
        anew = handover_.lay_anew(stage_, domain, ledger);
        ledger.note(anew ? "elements deep in one another, all laid anew"
                         : "elements deep in one another that find no room in the domain",
                    static_cast<double>(look.deep), 1., "times");
      }
    if (anew)
      {
        ++run_.books.summary.counts.rezones;
        progress.locked.clear();
        progress.locked_noted = 0;
        new_mesh();
      }
    if (look.joined > 0 || anew)
      check("contact of elements");
    return anew;
  }

  template bool
  StageLoop<2>::holds_pieces() const;
  template void
  StageLoop<2>::find_locked();
  template bool
  StageLoop<2>::bonds_break();
  template bool
  StageLoop<2>::release(std::vector<RigidFragment<2>> &);
  template bool
  StageLoop<2>::free_folding();
  template bool
  StageLoop<2>::lock_slivers();
  template void
  StageLoop<2>::note_locked();
  template void
  StageLoop<2>::refuse_folded();
  template bool
  StageLoop<2>::meet();
} // namespace whipple
