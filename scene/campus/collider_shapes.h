#pragma once

#include <optional>

#include "collision/geometry/shapes.h"
#include "scene/campus/campus_description.h"
#include "scene/campus/enclosing_surface.h"
#include "scene/campus/node_selection.h"

namespace campuswalk::scene {

/// A collision shape and its pose.
struct PlacedShape {
    collision::Shape shape;
    collision::Pose X_world_shape;
    std::size_t zero_area = 0;  ///< triangles of a mesh that were left out
    // Of a mesh that is only a trigger; see EnclosingSurface.
    std::size_t openings = 0;
    std::size_t left_out = 0;
    std::optional<NoInside> no_inside = {};
};

/// What the numbers of a shape refer to: a node's upright_frame (see node_frame.h) and its geometry, or the
/// world frame and no geometry if the shape is placed by numbers alone.
struct ShapeSource {
    collision::Pose frame;
    WorldGeometry geometry;
    bool has_nodes = false;
    collision::TreeKind tree = collision::TreeKind::bvh8;  ///< of a mesh
};

/// Whether a shape needs no node, because every number is given.
bool is_placed_by_numbers(const ShapeDescription& shape);

/// Makes the shape; numbers that are left out are fitted to the source's geometry:
///   box      the geometry's bounds along the frame's axes, turned by `yaw`; given a size only, it keeps the
///            bounds' centre
///   sphere   about the bounds' centre, out to the farthest vertex
///   capsule  upright; its base is the node's origin if that lies in the geometry's bounds (within half a
///            metre), else the middle of the bounds' bottom; its radius covers the bounds' wider side, its
///            height reaches their top
///   wheel    about the bounds' centre along `axis`, as wide and as large as the geometry
/// nullopt if something has to be fitted and there is no triangle.
std::optional<PlacedShape> place_shape(const ShapeDescription& shape, const ShapeSource& source);

/// The mesh of what is only a trigger, `placed` by place_shape from this geometry: as it is if all of it
/// encloses something, else its enclosing_surface.
PlacedShape enclosed(PlacedShape placed, const ShapeSource& source);

}  // namespace campuswalk::scene
